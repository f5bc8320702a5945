//! What can be chosen of an engine.

use std::time::Duration;

use crate::spe::Program;
use crate::work::{Skip, Split};

/// How an [`Engine`](super::Engine) works.
#[derive(Clone, Copy, Debug)]
pub struct Settings {
    /// SPUs to use.
    pub spus: u32,
    /// How the frame is split among them.
    pub split: Split,
    /// What the SPUs need not test.
    pub skip: Skip,
    /// Whether what the framebuffer already shows is kept and only what has changed is traced.
    /// With [`Skip::Nothing`] every frame is traced as a whole.
    pub retain: bool,
    /// Whether the SPUs check, at each call of a shader, that it keeps what it must.
    pub check_shaders: bool,
    /// How long none of a frame's SPUs may take a work unit, finish one or answer, before they
    /// count as lost.
    pub timeout: Duration,
    /// What they run.
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
