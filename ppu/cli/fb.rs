//! `cellray fb`: traces a scene into a framebuffer.

use std::fs;
use std::os::unix::fs::FileTypeExt as _;
use std::path::{Path, PathBuf};

use cellray::choices::whole;
use cellray::framebuffer::{self, Geometry, Interrupted, Mode, Raster};
use clap::{Args, ValueEnum};

use super::options::Options;
use super::{Outcome, run};

/// Trace a scene into a framebuffer, or into a file instead.
#[derive(Args)]
pub struct Arguments {
    #[command(flatten)]
    options: Options,
    /// Framebuffer device, or a regular file that is written like one
    #[arg(long, default_value = "/dev/fb0", value_name = "PATH")]
    device: PathBuf,
    /// Width and height in pixels; a file needs it, a device has its own
    #[arg(long, value_name = "WxH", allow_hyphen_values = true)]
    size: Option<Geometry>,
    /// Set ps3fb's video mode until the program ends: with borders, or the full screen [default:
    /// leave the mode unchanged]
    #[arg(long, value_enum, value_name = "MODE")]
    mode: Option<VideoMode>,
    /// How many frames the device's memory holds, if it has room: with 2, one is shown while the
    /// next is made
    #[arg(long, default_value_t = 2, value_name = "N", allow_negative_numbers = true, value_parser = whole::<u32>(1..=2))]
    buffers: u32,
    /// Show a frame without waiting for the vertical blank
    #[arg(long)]
    no_vsync: bool,
    /// Where frames are made: in private memory, to be copied, or in the device's memory [default:
    /// the device's, if that is known to be main memory]
    #[arg(long, value_enum, value_name = "WHERE")]
    made: Option<Made>,
    /// Frames to show [default: 1 into a file; on a device, until Ctrl-C]
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = whole::<u32>(1..=u64::from(u32::MAX)))]
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
    let prepared = run::prepare(&arguments.options, false)?;
    // Signals are caught before the screen is taken over, so that none leaves it taken over.
    let interrupted = Interrupted::install()?;
    let framebuffer = framebuffer::open_with(&arguments.device, arguments.framebuffer())?;
    messages::print!("cellray: {}", framebuffer.describe());
    let frames = arguments.frames.or_else(|| (!is_device(&arguments.device)).then_some(1));
    let enough = |traced: usize| {
        interrupted.signal().is_some() || frames.is_some_and(|frames| traced >= frames as usize)
    };
    let what = arguments.device.display().to_string();
    run::frames(&arguments.options, &prepared, (framebuffer, &what), enough)
}

fn is_device(path: &Path) -> bool {
    fs::metadata(path).is_ok_and(|metadata| metadata.file_type().is_char_device())
}
