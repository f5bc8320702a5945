//! `cellray fb`: renders a scene to a framebuffer.

use std::fs;
use std::os::unix::fs::FileTypeExt as _;
use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};

use super::options::Options;
use super::{Outcome, run};
use crate::choices::whole;
use crate::framebuffer::{self, Geometry, Interrupted, Mode, Raster};

/// Render a scene to a framebuffer, or to a file in its format.
#[derive(Args)]
pub struct Arguments {
    #[command(flatten)]
    options: Options,
    /// Framebuffer device, or a regular file to write
    #[arg(long, help_heading = "Output", default_value = "/dev/fb0", value_name = "PATH")]
    device: PathBuf,
    /// Width and height in pixels [default: the device's; required for a file]
    #[arg(long, help_heading = "Output", value_name = "WxH", allow_hyphen_values = true)]
    size: Option<Geometry>,
    /// Video mode of ps3fb until the program ends [default: unchanged]
    #[arg(long, help_heading = "Output", value_enum, value_name = "MODE")]
    mode: Option<VideoMode>,
    /// Frames in the device's memory: 2 for double buffering
    ///
    /// With 2, one frame is shown while the next is rendered. With less memory than that, 1 is
    /// used.
    #[arg(long, help_heading = "Output", default_value_t = 2, value_name = "N", allow_negative_numbers = true, value_parser = whole::<u32>(1..=2))]
    buffers: u32,
    /// Show frames without waiting for the vertical blank
    #[arg(long, help_heading = "Output")]
    no_vsync: bool,
    /// Memory in which frames are rendered [default: depends on the device]
    ///
    /// Frames in private memory are copied to the device's memory. The default is the device's
    /// memory for drivers that keep it in main memory, otherwise private memory.
    #[arg(long, help_heading = "Output", value_enum, value_name = "WHERE")]
    made: Option<Made>,
    /// Number of frames [default: until Ctrl-C on a device, 1 in a file]
    #[arg(long, help_heading = "Output", value_name = "N", allow_negative_numbers = true, value_parser = whole::<u32>(1..=u64::from(u32::MAX)))]
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
