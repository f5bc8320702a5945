//! `cellray render`: a scene into a PNG file.

use std::path::PathBuf;

use cellray::framebuffer::{Corners, Framebuffer, Geometry, Memory, Png};
use cellray::scene::Look;
use clap::Args;

use super::{Outcome, run};

/// Trace a scene into a PNG file.
#[derive(Args)]
pub struct Arguments {
    #[command(flatten)]
    options: run::Options,
    /// Pixels across and down [default: the scene's own]
    #[arg(long, value_name = "WxH")]
    size: Option<Geometry>,
    /// Picture to write; without it the frames are traced and only measured
    #[arg(long, value_name = "F.png")]
    out: Option<PathBuf>,
    /// Frames to show: a frame that stands still is traced once, unless --retrace asks for more
    #[arg(long, default_value_t = 1, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    frames: u32,
    /// Eye rays through the corners of the pixels, the four of each averaged, as the Standard Procedural
    /// Databases have it
    #[arg(long)]
    corners: bool,
}

pub fn run(arguments: &Arguments) -> Outcome {
    let look = Look {
        corners: arguments.corners,
        ..arguments.options.look()
    };
    let program = arguments.options.program()?;
    let scene = run::scene(&arguments.options, look, &program)?;
    let geometry = match arguments.size {
        Some(size) => size,
        None => {
            let (width, height) = scene.view().resolution;
            Geometry::new(width, height)?
        }
    };
    let framebuffer: Box<dyn Framebuffer> = match &arguments.out {
        out if arguments.corners => Box::new(Corners::new(out.as_deref(), geometry)?),
        Some(path) => Box::new(Png::new(path, geometry)?),
        None => Box::new(Memory::new(geometry)?),
    };
    let enough = |traced| traced >= arguments.frames as usize;
    run::frames(&arguments.options, program, &scene, framebuffer, enough)
}
