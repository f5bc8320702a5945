//! A hint for errors that a game's own shader may have caused.

use std::fmt;

use super::settings::Settings;
use crate::spe::Program;

/// Whether a game's own shaders ran unchecked. A shader that breaks the rules damages the tracer's
/// state, which can cause any error later. The text is empty, or a hint to append to a message.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Unchecked(bool);

impl Unchecked {
    /// For a frame with these settings, with Whitted's model or with depth shading.
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
            "; one of the program's own shaders may have caused this by breaking the rules for shaders: \
             --check-shaders (Settings::check_shaders) finds it",
        )
    }
}
