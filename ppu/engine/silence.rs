//! The timeout of a frame, and the report about an SPU that doesn't reply.
//!
//! Owns the decision whether a frame can still be expected. A frame's duration is no criterion: on
//! emulated SPUs it may be hours. The criterion is whether any SPU still takes a work unit,
//! finishes one, or replies.

use std::fmt;
use std::time::Duration;

use crate::spe::Instant;

/// The shortest time between two calls that report progress.
const LOOK_EVERY: Duration = Duration::from_millis(250);
/// The shortest sleep that libspe2 supports.
const SHORTEST: Duration = Duration::from_millis(1);
/// How long to sleep at a time. libspe2's clock may differ from this program's: a millisecond of
/// an emulator's may take seconds. So sleeps begin short, and grow only while they take no longer
/// than requested.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pause(Duration);

impl Pause {
    pub fn new() -> Self {
        Self(SHORTEST)
    }

    /// The length of the next sleep, if the timeout is `left` away.
    pub fn length(self, left: Duration) -> Duration {
        self.0.min(left)
    }

    /// Adapts to a sleep of that length that took `took` and ended without an event.
    pub fn slept(&mut self, took: Duration) {
        self.0 = if took > LOOK_EVERY {
            (self.0 / 2).max(SHORTEST)
        } else {
            (self.0 * 2).min(LOOK_EVERY)
        };
    }
}

/// Measures the time since the SPUs last showed a sign of work. The caller passes the time.
pub(super) struct Watchdog {
    timeout: Duration,
    since: Instant,
    done: u64,
}

impl Watchdog {
    /// Starts the timeout.
    pub fn start(timeout: Duration, now: Instant) -> Self {
        Self { timeout, since: now, done: 0 }
    }

    /// Restarts the timeout if the SPUs have done more than before. `done` is any measure of their
    /// work that only grows.
    pub fn observe(&mut self, done: u64, now: Instant) {
        if done != self.done {
            self.done = done;
            self.restart(now);
        }
    }

    /// Restarts the timeout.
    pub fn restart(&mut self, now: Instant) {
        self.since = now;
    }

    /// The time that is left until the timeout.
    pub fn left(&self, now: Instant) -> Duration {
        let waited = now.saturating_duration_since(self.since);
        self.timeout.saturating_sub(waited)
    }
}

/// The state of an SPU that did not reply.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Silence {
    /// How long no SPU has shown a sign of work.
    pub waited: Duration,
    /// The number of the frame's work units that SPUs have taken.
    pub begun: u32,
    /// The number of the frame's work units.
    pub units: u32,
    /// What the SPU was doing.
    pub activity: Activity,
}

/// What an SPU was doing when the frame timed out.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Activity {
    /// It has not read the frame's address from its mailbox: it did not run, or was still busy with
    /// earlier work.
    HasMail,
    /// It ran, and was made to stop.
    Ran {
        /// Local-store address of the next instruction.
        address: u32,
        /// The function that contains the instruction, if the program has symbols.
        function: Option<String>,
    },
    /// It executed no further instruction: it waited for a channel, or did not run.
    Waited,
}

impl fmt::Display for Silence {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { waited, begun, units, activity } = self;
        write!(
            f,
            "has not replied, and for {} s no SPU has taken or finished any work ({begun} of {units} work units \
             were begun); it ",
            waited.as_secs_f64()
        )?;
        match activity {
            Activity::HasMail => write!(f, "has not read its mailbox")?,
            Activity::Waited => write!(f, "waited for a channel, or did not run")?,
            Activity::Ran { address, function } => {
                write!(f, "was at {address:#07x}")?;
                if let Some(function) = function {
                    write!(f, ", {function}")?;
                }
            }
        }
        f.write_str("; if it is only slow, raise --timeout")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sleeps_follow_their_clock() {
        let left = Duration::MAX;
        let mut pause = Pause::new();
        for _ in 0..20 {
            pause.slept(pause.length(left));
        }
        assert_eq!(pause.length(left), LOOK_EVERY);
        assert_eq!(pause.length(SHORTEST), SHORTEST);
        // An emulator's clock may run a thousand times slower.
        let mut pause = Pause::new();
        for _ in 0..20 {
            pause.slept(pause.length(left) * 1000);
            assert_eq!(pause.length(left), SHORTEST);
        }
    }

    #[test]
    fn work_restarts_the_timeout() {
        let start = Instant::now();
        let after = |millis| start + Duration::from_millis(millis);
        let mut watchdog = Watchdog::start(Duration::from_millis(200), start);
        watchdog.observe(1, after(120));
        assert_eq!(watchdog.left(after(240)), Duration::from_millis(80));
        watchdog.observe(1, after(240));
        assert_eq!(watchdog.left(after(320)), Duration::ZERO);
        watchdog.restart(after(320));
        assert_eq!(watchdog.left(after(330)), Duration::from_millis(190));
    }
}
