//! Where a game's time comes from.

use std::thread;
use std::time::{Duration, Instant};

/// The longest wait for a recorded frame, so that a session that was suspended for a day can still
/// be played back.
const LONGEST_PAUSE: Duration = Duration::from_secs(1);

/// A source of time.
pub trait Clock {
    /// Returns the time since the last call. Called once a frame; may wait until it is time for the
    /// next frame.
    fn tick(&mut self) -> Duration;

    /// Called instead of [`Clock::tick`] when the time is known from a recording. May wait for
    /// `step`.
    fn pace(&mut self, _step: Duration) {}
}

/// Real time, with a bound on the frames a second. Without the bound the loop would run idle for a
/// world that stands still, which takes no time to trace.
#[derive(Clone, Copy, Debug)]
pub struct RealTime {
    minimum: Duration,
    last: Option<Instant>,
}

impl RealTime {
    /// At most `frames_per_second` frames a second; 0 sets no bound.
    #[must_use]
    pub fn at_most(frames_per_second: u32) -> Self {
        Self {
            minimum: Duration::from_secs(1).checked_div(frames_per_second).unwrap_or_default(),
            last: None,
        }
    }

    fn wait(&mut self, step: Duration) -> Duration {
        let before = self.last;
        if let Some(last) = before {
            thread::sleep(step.saturating_sub(last.elapsed()));
        }
        let now = Instant::now();
        self.last = Some(now);
        before.map_or(Duration::ZERO, |before| now - before)
    }
}

impl Default for RealTime {
    /// At most sixty frames a second.
    fn default() -> Self {
        Self::at_most(60)
    }
}

impl Clock for RealTime {
    fn tick(&mut self) -> Duration {
        self.wait(self.minimum)
    }

    fn pace(&mut self, step: Duration) {
        self.wait(step.min(LONGEST_PAUSE));
    }
}

/// The same step for every frame, however long it takes: for pictures and tests.
#[derive(Clone, Copy, Debug)]
pub struct FixedSteps(
    /// The step.
    pub Duration,
);

impl Clock for FixedSteps {
    fn tick(&mut self) -> Duration {
        self.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn real_time_passes_and_limits_frame_rate() {
        let mut clock = RealTime::at_most(100);
        let start = Instant::now();
        assert_eq!(clock.tick(), Duration::ZERO);
        let counted: Duration = (0..5).map(|_| clock.tick()).sum();
        let passed = start.elapsed();
        assert!(
            counted >= Duration::from_millis(50) && counted <= passed,
            "{counted:?} of {passed:?}"
        );

        let start = Instant::now();
        clock.pace(Duration::from_millis(30));
        clock.pace(Duration::from_millis(30));
        assert!(start.elapsed() >= Duration::from_millis(50));
    }

    #[test]
    fn unlimited_rate_does_not_wait() {
        assert_eq!(RealTime::at_most(0).minimum, Duration::ZERO);
    }
}
