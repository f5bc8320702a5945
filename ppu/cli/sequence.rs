//! Frames of a scene as numbered pictures.

use std::time::Duration;

use signal_hook::low_level::emulate_default_handler;

use super::options::Options;
use super::{Outcome, run};
use crate::framebuffer::{Geometry, Interrupted, Memory};
use crate::game::{FixedSteps, FrameRange, Pictures, Session, Turntable};
use crate::spe::Program;

/// Writes the pictures of a range of frames, except those that exist.
pub fn run(
    options: &Options,
    program: Program,
    turntable: Turntable,
    pictures: &Pictures,
    frames: FrameRange,
    size: Geometry,
) -> Outcome {
    let mut interrupted = Interrupted::install()?;
    let picture = Box::new(Memory::new(size)?);
    let mut session = Session::start(turntable, options.settings(program), picture)?;
    // A turntable's frame depends only on its number, so time doesn't matter.
    let mut clock = FixedSteps(Duration::ZERO);
    let made = pictures.write(&mut session, frames, &mut clock, &mut interrupted)?;
    let what = format!("{} picture(s) written, {} existed already", made.written, made.kept);
    run::report_run(options, &what, session.report().clone())?;
    if let Some(signal) = interrupted.signal() {
        messages::print!("cellray: ended by signal {signal}");
        emulate_default_handler(signal)?;
    }
    Ok(())
}
