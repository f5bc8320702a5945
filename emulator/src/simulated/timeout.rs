//! Time-outs for actors that may never act again: PPE threads between two calls, and SPEs that are
//! loaded but not yet running.
//!
//! The emulator can't know whether a thread that is computing, or sleeps in a system call, will
//! call the library again. So other actors wait for it only for a limited time of the host's
//! clock. This is the only place where the host's time matters. A thread that was given up joins
//! again at its own clock with its next call. SPEs may be ahead of it by then, and its actions
//! take effect at their clocks.

use std::fs;
use std::path::PathBuf;
use std::time::{Duration, Instant};

/// How often a waiting actor checks a PPE thread that delays it. The thread is given up if it is
/// asleep at two checks in a row (in a join, for example) and did not run in between.
pub const POLL_INTERVAL: Duration = Duration::from_millis(25);
/// A PPE thread that computes this long between two calls, or an SPE that is loaded this long
/// without a run, is given up.
pub const TIME_LIMIT: Duration = Duration::from_secs(2);

/// How often a sleeping thread has gone to sleep, according to Linux.
type Sleep = String;

/// The time-out of an actor.
#[derive(Debug)]
pub(super) struct Timeout {
    since: Instant,
    /// The thread's folder in /proc.
    thread: Option<PathBuf>,
    last: Option<(Instant, Sleep)>,
}

thread_local! {
    static THIS_THREAD: Option<PathBuf> =
        fs::read_link("/proc/thread-self").ok().map(|thread| PathBuf::from("/proc").join(thread));
}

impl Timeout {
    pub fn of_this_thread() -> Self {
        Self {
            since: Instant::now(),
            // A thread that is ending has no folder, and only the time limit applies to it.
            thread: THIS_THREAD.try_with(Clone::clone).ok().flatten(),
            last: None,
        }
    }

    /// The time-out of an actor that has no thread yet.
    pub fn without_thread() -> Self {
        Self {
            since: Instant::now(),
            thread: None,
            last: None,
        }
    }

    pub fn has_expired(&mut self) -> bool {
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
        let Some(sleep) = self.thread.as_deref().and_then(|thread| {
            let status = fs::read_to_string(thread.join("status")).ok()?;
            sleep_of(&status)
        }) else {
            self.last = None;
            return false;
        };
        let slept_through = self.last.as_ref().is_some_and(|(_, last)| *last == sleep);
        self.last = Some((now, sleep));
        slept_through
    }
}

/// The count in a thread's `status`. `None` if the thread is not asleep.
fn sleep_of(status: &str) -> Option<Sleep> {
    let field = |name| {
        let line = status.lines().find(|line| line.starts_with(name))?;
        line.split(':').nth(1).map(str::trim)
    };
    field("State")?
        .starts_with('S')
        .then(|| field("voluntary_ctxt_switches").map(str::to_owned))?
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::mpsc;
    use std::thread;

    #[test]
    fn only_a_sleeping_thread_has_a_sleep() {
        let status = |state| format!("Name:\tx\nState:\t{state}\nvoluntary_ctxt_switches:\t17\n");
        assert_eq!(sleep_of(&status("S (sleeping)")), Some("17".to_owned()));
        assert_eq!(sleep_of(&status("R (running)")), None);
        assert_eq!(sleep_of("State:\tS (sleeping)\n"), None);
    }

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
