//! `cellray fb`: a scene into a framebuffer.

use std::fs;
use std::os::unix::fs::FileTypeExt as _;
use std::path::{Path, PathBuf};

use cellray::framebuffer::{self, Geometry, Interrupted, Mode, Raster};
use clap::{Args, ValueEnum};

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
    #[arg(long, value_name = "WxH", allow_hyphen_values = true)]
    size: Option<Geometry>,
    /// Set ps3fb's video mode until the end: within borders, or of the whole screen [default: as
    /// it is]
    #[arg(long, value_enum, value_name = "MODE")]
    mode: Option<VideoMode>,
    /// Frames that the device's memory is to hold, where it has room: with 2, one is shown while
    /// the next is made
    #[arg(long, default_value_t = 2, value_name = "N", allow_negative_numbers = true, value_parser = clap::value_parser!(u32).range(1..=2))]
    buffers: u32,
    /// Show a frame without waiting for the vertical blank
    #[arg(long)]
    no_vsync: bool,
    /// Make frames in private memory and copy them, or in the device's own [default: in the
    /// device's where that is known to be main memory]
    #[arg(long, value_enum, value_name = "WHERE")]
    made: Option<Made>,
    /// Frames to show [default: 1 into a file; on a device, until Ctrl-C]
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = clap::value_parser!(u32).range(1..))]
    frames: Option<u32>,
}

#[derive(Clone, Copy, ValueEnum)]
enum VideoMode {
    Bordered,
    Full,
}

#[derive(Clone, Copy, ValueEnum)]
enum Made {
    Private,
    Device,
}

impl Arguments {
    fn framebuffer(&self) -> framebuffer::Options {
        framebuffer::Options {
            size: self.size,
            raster: self.mode.map(|mode| match mode {
                VideoMode::Bordered => Raster::Bordered,
                VideoMode::Full => Raster::Full,
            }),
            mode: self.made.map(|made| match made {
                Made::Private => Mode::Shadow,
                Made::Device => Mode::Direct,
            }),
            two_frames: self.buffers == 2,
            vsync: !self.no_vsync,
        }
    }
}

pub fn run(arguments: &Arguments) -> Outcome {
    let options = &arguments.options;
    let program = options.program()?;
    let scene = nff::load(&options.scene)?;
    let scene = run::scene(options, &scene, options.render_options(), &program)?;
    // Before the screen is taken over, so that no signal leaves it that way.
    let interrupted = Interrupted::install()?;
    let framebuffer = framebuffer::open_with(&arguments.device, arguments.framebuffer())?;
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
