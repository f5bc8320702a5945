//! What is said with an error that a shader of a game's own may be behind: how to find out.

use std::fmt;

use super::settings::Settings;
use crate::spe::Program;

/// Whether shaders that do not come with the tracer ran and were not checked. One that does not
/// keep what it must spoils what the tracer's program goes by afterwards, so that any error may
/// come of it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Unchecked(bool);

impl Unchecked {
    /// Of a frame of Whitted's model or of another.
    pub(super) fn of(settings: &Settings, is_whitted: bool) -> Self {
        let shaders = |program: &Program| program.shaders().unwrap_or_default();
        let known = shaders(&Program::tracer());
        let has_own = || {
            let found = shaders(&settings.program);
            found.iter().any(|shader| !known.contains(shader))
        };
        Self(is_whitted && !settings.check_shaders && has_own())
    }
}

impl fmt::Display for Unchecked {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if !self.0 {
            return Ok(());
        }
        f.write_str(
            "; a shader of the program's own that does not keep what it must can be behind this: --check-shaders \
             (Settings::check_shaders) finds it",
        )
    }
}
