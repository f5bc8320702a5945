//! `cellray render --inspect` on a console, which has no simulated time to inspect.

use std::path::Path;

use super::Outcome;
use super::options::Options;
use super::run::Prepared;
use crate::framebuffer::Geometry;
use crate::scene::Scene;

/// The recording of a PC; never created here.
pub enum Recording {}

/// Always an error.
pub fn record() -> Result<Recording, Box<dyn std::error::Error>> {
    Err("--inspect needs simulated time, which cellray has only on a PC: run it there".into())
}

/// Never called, because there is no recording.
pub fn frame(
    _: &Options,
    recording: &Recording,
    _: &Prepared,
    _: Option<&Scene>,
    _: Geometry,
    _: Option<&Path>,
    _: &Path,
) -> Outcome {
    match *recording {}
}
