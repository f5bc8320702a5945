//! `cellray fb`: a scene into a framebuffer.

use std::fs;
use std::os::unix::fs::FileTypeExt as _;
use std::path::{Path, PathBuf};

use cellray::framebuffer::{self, Geometry, Interrupted};
use clap::Args;

use super::{Outcome, run};

/// Trace a scene into a framebuffer, or a file in the place of one.
#[derive(Args)]
pub struct Arguments {
    #[command(flatten)]
    options: run::Options,
    /// Framebuffer device, or a regular file that is written like one
    #[arg(long, default_value = "/dev/fb0", value_name = "PATH")]
    device: PathBuf,
    /// Pixels across and down: needed for a file, the device's own otherwise
    #[arg(long, value_name = "WxH")]
    size: Option<Geometry>,
    /// Frames to show [default: 1 into a file; on a device, until Ctrl-C]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    frames: Option<u32>,
}

pub fn run(arguments: &Arguments) -> Outcome {
    let options = &arguments.options;
    let program = options.program()?;
    let scene = run::scene(options, options.look(), &program)?;
    // Before the screen is taken over, so that no signal leaves it that way.
    let interrupted = Interrupted::install()?;
    let framebuffer = framebuffer::open(&arguments.device, arguments.size)?;
    eprintln!("cellray: {}", framebuffer.describe());
    let frames = arguments
        .frames
        .or_else(|| (!is_device(&arguments.device)).then_some(1));
    let enough = |traced: usize| {
        interrupted.signal().is_some() || frames.is_some_and(|frames| traced >= frames as usize)
    };
    run::frames(options, program, &scene, framebuffer, enough)
}

fn is_device(path: &Path) -> bool {
    fs::metadata(path).is_ok_and(|metadata| metadata.file_type().is_char_device())
}
