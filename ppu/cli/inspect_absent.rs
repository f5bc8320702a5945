//! `cellray render --inspect` on a console, which has no simulated time to inspect.

use std::path::Path;

use cellray::Scene;
use cellray::framebuffer::{Geometry, Labels};

use super::Outcome;
use super::run::Options;

/// What a PC records; never made here.
pub enum Recording {}

/// Always an error.
pub fn record() -> Result<Recording, Box<dyn std::error::Error>> {
    Err("--inspect needs simulated time, which cellray has only on a PC: run it there".into())
}

/// Never called, because there is no recording.
pub fn frame(
    _: &Options,
    recording: &Recording,
    _: (&Scene, &scenes::Scene),
    _: Geometry,
    _: Option<(&Path, Labels)>,
    _: &Path,
) -> Outcome {
    match *recording {}
}
