//! Time-outs for actors that may never act again: PPE threads between two calls, and SPEs that are
//! loaded but not yet running.
//!
//! The emulator can't know whether a thread that is computing, or sleeps in a system call, will
//! call the library again. So other actors wait for it only for a limited time of the host's
//! clock. This is the only place where the host's time matters. A thread that was given up joins
//! again at its own clock with its next call. SPEs may be ahead of it by then, and its actions
//! take effect at their clocks.
//!
//! Where all threads of the process wait for each other, it is certain that no thread will act
//! before one is given up. That is found at once, does not depend on the host's time, and is not
//! counted among the time-outs.

use std::path::PathBuf;
use std::time::{Duration, Instant};

use super::host_threads::{self, Sleep};

/// How often a waiting actor checks a PPE thread that delays it. The thread is given up if it is
/// asleep at two checks in a row (in a system call, for example) and did not run in between.
pub const POLL_INTERVAL: Duration = Duration::from_millis(25);
/// How long after an actor has begun to wait it first asks whether all threads wait for each other.
/// Most waits are over by then. After that it asks less and less often.
const FIRST_LOOK: Duration = Duration::from_micros(100);
/// A PPE thread that computes this long between two calls, or an SPE that is loaded this long
/// without a run, is given up.
pub const TIME_LIMIT: Duration = Duration::from_secs(2);

/// The time-out of an actor.
#[derive(Debug)]
pub(super) struct Timeout {
    since: Instant,
    /// The thread's folder in /proc.
    thread: Option<PathBuf>,
    last: Option<(Instant, Sleep)>,
    /// When to ask next whether all threads wait for each other.
    next_look: Duration,
}

/// What is to be done about an actor that others wait for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Verdict {
    /// Look again after this time.
    Wait(Duration),
    /// Ask whether all threads wait for each other.
    Ask,
    /// It is waited for no longer.
    GiveUp,
}

impl Timeout {
    pub fn of_this_thread() -> Self {
        // A thread that is ending has no folder, and only the time limit applies to it.
        Self::of(host_threads::this_thread().map(host_threads::folder))
    }

    /// The time-out of an actor that has no thread yet.
    pub fn without_thread() -> Self {
        Self::of(None)
    }

    fn of(thread: Option<PathBuf>) -> Self {
        Self {
            since: Instant::now(),
            thread,
            last: None,
            next_look: FIRST_LOOK,
        }
    }

    /// Decides what to do about the actor.
    pub fn look(&mut self) -> Verdict {
        let waited = self.since.elapsed();
        if waited >= self.next_look {
            self.next_look = waited * 2;
            return Verdict::Ask;
        }
        if self.has_expired() {
            return Verdict::GiveUp;
        }
        Verdict::Wait((self.next_look - waited).min(POLL_INTERVAL))
    }

    /// Distinguishes this time-out from a later one of the same actor.
    pub fn since(&self) -> Instant {
        self.since
    }

    fn has_expired(&mut self) -> bool {
        let now = Instant::now();
        if now.duration_since(self.since) >= TIME_LIMIT {
            return true;
        }
        let checked = self
            .last
            .as_ref()
            .map_or(self.since, |(checked, _)| *checked);
        if now.duration_since(checked) < POLL_INTERVAL {
            return false;
        }
        let Some(sleep) = self.thread.as_deref().and_then(host_threads::sleep) else {
            self.last = None;
            return false;
        };
        let slept_through = self.last.as_ref().is_some_and(|(_, last)| *last == sleep);
        self.last = Some((now, sleep));
        slept_through
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::mpsc;
    use std::thread;

    #[test]
    fn a_thread_that_sleeps_for_long_is_given_up_and_one_that_computes_is_not() {
        let (end, ended) = mpsc::channel::<()>();
        let (tell, told) = mpsc::channel();
        let sleeper = thread::spawn(move || {
            tell.send(Timeout::of_this_thread()).unwrap();
            ended.recv().unwrap_err();
        });
        let mut timeout = told.recv().unwrap();
        assert!(!timeout.has_expired());
        let start = Instant::now();
        while !timeout.has_expired() {
            thread::sleep(POLL_INTERVAL);
            assert!(start.elapsed() < TIME_LIMIT);
        }
        let mut own = Timeout::of_this_thread();
        let start = Instant::now();
        while start.elapsed() < 8 * POLL_INTERVAL {
            assert!(!own.has_expired());
        }
        drop(end);
        sleeper.join().unwrap();
    }
}
