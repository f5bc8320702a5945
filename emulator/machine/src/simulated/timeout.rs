//! Time-outs for actors that may never act again: PPE threads between two calls, and SPEs that are
//! loaded but not yet running.
//!
//! The emulator can't determine whether a thread that is computing, or sleeps in a system call,
//! will call the library again. So other actors wait for it only for a limited time of the host's
//! clock. This is the only place where the host's time matters. A thread that was given up joins
//! again at its own clock with its next call. SPEs may be ahead of it by then, and its actions take
//! effect at their clocks.
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
/// without a run, is given up. What other programs hold the thread up doesn't count.
pub const TIME_LIMIT: Duration = Duration::from_secs(2);

/// The time-out of an actor.
#[derive(Debug)]
pub(super) struct Timeout {
    since: Instant,
    thread: Option<PathBuf>,
    last: Option<(Instant, Sleep)>,
    /// How long the thread was held up in its life before the first check.
    held_up: Option<Duration>,
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
        Self { since: Instant::now(), thread, last: None, held_up: None, next_look: FIRST_LOOK }
    }

    /// Decides what to do about the actor.
    pub fn look(&mut self, now: Instant) -> Verdict {
        let waited = now.saturating_duration_since(self.since);
        if waited >= self.next_look {
            self.next_look = waited * 2;
            return Verdict::Ask;
        }
        if self.has_expired(now) {
            return Verdict::GiveUp;
        }
        Verdict::Wait((self.next_look - waited).min(POLL_INTERVAL))
    }

    /// Distinguishes this time-out from a later one of the same actor.
    pub fn since(&self) -> Instant {
        self.since
    }

    /// How long the thread was held up since the first check.
    fn held_up(&mut self) -> Duration {
        let Some(now) = self.thread.as_deref().and_then(host_threads::time_preempted) else {
            return Duration::ZERO;
        };
        now.saturating_sub(*self.held_up.get_or_insert(now))
    }

    fn has_expired(&mut self, now: Instant) -> bool {
        let checked = self.last.as_ref().map_or(self.since, |(checked, _)| *checked);
        if now.saturating_duration_since(checked) < POLL_INTERVAL {
            return false;
        }
        let waited = now.saturating_duration_since(self.since);
        if waited.saturating_sub(self.held_up()) >= TIME_LIMIT {
            return true;
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
    use std::fs;
    use std::sync::mpsc;
    use std::thread;

    #[test]
    fn a_thread_that_sleeps_for_long_is_given_up_and_one_that_computes_is_not() {
        let (end, ended) = mpsc::channel::<()>();
        let (sender, receiver) = mpsc::channel();
        let sleeper = thread::spawn(move || {
            sender.send(Timeout::of_this_thread()).unwrap();
            ended.recv().unwrap_err();
        });
        let mut timeout = receiver.recv().unwrap();
        let folder = timeout.thread.clone().unwrap();
        // It may still wake for a moment to give up a lock.
        while host_threads::sleep(&folder).is_none() {
            thread::yield_now();
        }
        let mut waited = Duration::ZERO;
        while !timeout.has_expired(timeout.since + waited) {
            waited += POLL_INTERVAL;
            thread::yield_now();
        }
        assert!(waited >= 2 * POLL_INTERVAL && waited < TIME_LIMIT, "{waited:?}");
        drop(end);
        sleeper.join().unwrap();

        // This thread runs.
        let mut timeout = Timeout::of_this_thread();
        for count in 0..8 {
            assert!(!timeout.has_expired(timeout.since + count * POLL_INTERVAL));
        }
    }

    #[test]
    fn computing_past_the_limit_expires_unless_preempted() {
        let mut timeout = Timeout::without_thread();
        assert!(!timeout.has_expired(timeout.since + TIME_LIMIT - POLL_INTERVAL));
        assert!(timeout.has_expired(timeout.since + TIME_LIMIT));

        let folder = tempfile::tempdir().unwrap();
        let held_up = |millis: u64| {
            let nanos = millis * 1_000_000;
            fs::write(folder.path().join("schedstat"), format!("7 {nanos} 7\n")).unwrap();
        };
        held_up(500);
        let mut timeout = Timeout::of(Some(folder.path().to_owned()));
        assert!(!timeout.has_expired(timeout.since + POLL_INTERVAL));
        held_up(1500);
        let late = timeout.since + TIME_LIMIT + Duration::from_secs(1);
        assert!(!timeout.has_expired(late - POLL_INTERVAL));
        assert!(timeout.has_expired(late));
    }
}
