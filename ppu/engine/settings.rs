//! The engine's settings.

use std::time::Duration;

use crate::spe::Program;
use crate::work::{Skip, Split};

/// How an [`Engine`](super::Engine) works.
#[derive(Clone, Copy, Debug)]
pub struct Settings {
    /// The number of SPUs, from 1 to [`MAX_SPUS`](protocol::layout::MAX_SPUS).
    pub spus: u32,
    /// How the frame is split among the SPUs.
    pub split: Split,
    /// Which tests the SPUs may skip.
    pub skip: Skip,
    /// Whether only tiles that have changed are traced. With [`Skip::Nothing`] every frame is
    /// traced completely.
    pub retain: bool,
    /// Whether the SPUs check at each call of a shader that it keeps the rules of
    /// `docs/shaders.md`.
    pub check_shaders: bool,
    /// The timeout: the SPUs count as lost after this time in which no SPU has taken a work unit,
    /// finished one or replied.
    pub timeout: Duration,
    /// The program that the SPUs run.
    pub program: Program,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            spus: 6,
            split: Split::default(),
            skip: Skip::default(),
            retain: true,
            check_shaders: false,
            timeout: Duration::from_secs(600),
            program: Program::tracer(),
        }
    }
}
