//! How long a frame is waited for, and what is said of an SPU that does not answer.
//!
//! Owns the question whether a frame still comes. It is not how long it takes, which on emulated
//! SPUs may be hours, but whether any SPU still does something: takes a work unit, finishes one,
//! or answers.

use std::fmt;
use std::time::{Duration, Instant};

/// How often the caller of a frame hears of its progress, at most.
const LOOK_EVERY: Duration = Duration::from_millis(250);
/// The shortest sleep that libspe2 knows.
const SHORTEST: Duration = Duration::from_millis(1);
/// How long to sleep at a time. libspe2 may count time by another clock than this program: 1 ms of
/// an emulator's may take seconds. So sleeps begin short, and grow as long as they take no more
/// than they should.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pause(Duration);

impl Pause {
    pub fn new() -> Self {
        Self(SHORTEST)
    }

    /// The next sleep, if there are `left` to the end of all patience.
    pub fn length(self, left: Duration) -> Duration {
        self.0.min(left)
    }

    /// A sleep of that length took so long, and nothing has happened in it.
    pub fn slept(&mut self, took: Duration) {
        self.0 = if took > LOOK_EVERY {
            (self.0 / 2).max(SHORTEST)
        } else {
            (self.0 * 2).min(LOOK_EVERY)
        };
    }
}

/// Since when nothing has happened.
pub(super) struct Watch {
    timeout: Duration,
    since: Instant,
    done: u64,
}

impl Watch {
    /// From now on.
    pub fn start(timeout: Duration) -> Self {
        Self {
            timeout,
            since: Instant::now(),
            done: 0,
        }
    }

    /// What the SPUs have done so far, in any unit that only grows.
    pub fn saw(&mut self, done: u64) {
        if done != self.done {
            self.done = done;
            self.heard();
        }
    }

    /// An SPU has answered.
    pub fn heard(&mut self) {
        self.since = Instant::now();
    }

    /// How long it may yet take until something happens.
    pub fn left(&self) -> Duration {
        self.timeout.saturating_sub(self.since.elapsed())
    }
}

/// Why an SPU counts as lost that has not answered.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Silence {
    /// How long no SPU has done anything that can be seen.
    pub waited: Duration,
    /// Work units of the frame that an SPU has taken.
    pub begun: u32,
    /// Work units of the frame.
    pub units: u32,
    /// What the SPU was doing.
    pub doing: Doing,
}

/// What an SPU was doing that has not answered.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Doing {
    /// It has not even taken the frame's address from its mailbox: it did not run, or was busy
    /// with what was before.
    HasMail,
    /// It ran, and was made to stop.
    Ran {
        /// Local-store address of the instruction that came next.
        address: u32,
        /// The function that it is in, if the program has names.
        function: Option<String>,
    },
    /// It reached no further instruction: it waited for a channel, or did not run.
    Waited,
}

impl fmt::Display for Silence {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self {
            waited,
            begun,
            units,
            doing,
        } = self;
        write!(
            f,
            "has not answered, and for {} s no SPU has taken or finished any work ({begun} of {units} work units \
             were begun): it ",
            waited.as_secs_f64()
        )?;
        match doing {
            Doing::HasMail => write!(f, "has not read its mailbox")?,
            Doing::Waited => write!(f, "waited for a channel, or did not run")?,
            Doing::Ran { address, function } => {
                write!(f, "was at {address:#07x}")?;
                if let Some(function) = function {
                    write!(f, ", {function}")?;
                }
            }
        }
        f.write_str("; if it only is slow, --timeout allows more time")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sleeps_follow_the_clock_that_they_are_counted_by() {
        let left = Duration::MAX;
        let mut pause = Pause::new();
        for _ in 0..20 {
            pause.slept(pause.length(left));
        }
        assert_eq!(pause.length(left), LOOK_EVERY);
        assert_eq!(pause.length(SHORTEST), SHORTEST);
        // Of an emulator's clock that goes a thousand times slower.
        let mut pause = Pause::new();
        for _ in 0..20 {
            pause.slept(pause.length(left) * 1000);
            assert_eq!(pause.length(left), SHORTEST);
        }
    }

    #[test]
    fn work_puts_the_end_off() {
        let mut watch = Watch::start(Duration::from_millis(200));
        std::thread::sleep(Duration::from_millis(120));
        watch.saw(1);
        std::thread::sleep(Duration::from_millis(120));
        assert!(!watch.left().is_zero());
        watch.saw(1);
        std::thread::sleep(Duration::from_millis(120));
        assert!(watch.left().is_zero());
    }
}
