//! The clock that the SPUs run by: a console's, the timing model's, or the host's.

use std::num::NonZero;
use std::thread;

/// The SPUs of a console.
const SPUS: usize = 6;

/// The clock that the SPUs' speed is measured by.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SpuClock {
    /// That of a console, whose SPUs they are.
    Console,
    /// That of the timing model, which counts the cycles of a console.
    Model,
    /// That of this computer, which emulates the SPUs.
    Host,
}

impl SpuClock {
    /// The clock on this machine.
    #[must_use]
    pub fn here() -> Self {
        let timing = std::env::var("LIBSPE2_TIMING");
        Self::of(cfg!(target_arch = "powerpc64"), timing.as_deref().ok())
    }

    /// The clock on a machine. `timing` is the value of `LIBSPE2_TIMING`.
    fn of(is_console: bool, timing: Option<&str>) -> Self {
        match timing {
            _ if is_console => Self::Console,
            Some("1") => Self::Model,
            _ => Self::Host,
        }
    }

    /// How many SPUs a session has that requests no number: a console's six. In the host's time,
    /// more than it has processors would only take turns, and the last tiles of a frame would wait
    /// for theirs.
    #[must_use]
    pub fn usual_spus(self) -> u32 {
        let processors = || thread::available_parallelism().map_or(SPUS, NonZero::get);
        let spus = match self {
            Self::Console | Self::Model => SPUS,
            Self::Host => SPUS.min(processors()),
        };
        spus as u32
    }

    /// Whose speed this clock measures, in words: that of the SPUs alone, without the time spent
    /// waiting for the screen, the game and the player.
    #[must_use]
    pub fn limit(self) -> &'static str {
        match self {
            Self::Console => "SPUs' limit",
            Self::Model => "a console's limit, in simulated time",
            Self::Host => "emulator's limit",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limit_label_depends_on_machine_and_timing() {
        for (is_console, timing, words) in [
            (true, None, "SPUs' limit"),
            (false, Some("1"), "a console's limit, in simulated time"),
            (false, Some("0"), "emulator's limit"),
            (false, None, "emulator's limit"),
        ] {
            assert_eq!(SpuClock::of(is_console, timing).limit(), words);
        }
    }

    #[test]
    fn default_spus_depend_on_host_only_in_real_time() {
        for clock in [SpuClock::Console, SpuClock::Model] {
            assert_eq!(clock.usual_spus(), 6);
        }
        assert!((1..=6).contains(&SpuClock::Host.usual_spus()));
    }
}
