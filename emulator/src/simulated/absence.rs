//! Actors that may never act again: PPE threads between two calls, and SPEs that are loaded but
//! not yet run.
//!
//! Nobody tells whether a thread that is computing, or has gone to sleep in a call of its own,
//! will come back, so whoever waits for it waits only so long in the host's time. This is the one
//! place where the host's time has a say. A thread that is given up joins again at its own clock
//! when it next calls; what it then does takes effect on SPEs that are ahead of it at their
//! clocks.

use std::fs;
use std::path::PathBuf;
use std::time::{Duration, Instant};

/// How often a waiter looks after a PPE thread that holds it up. A thread that sleeps outside (in
/// a join, say) at two looks in a row, and did not run in between, is given up.
pub const LOOK_EVERY: Duration = Duration::from_millis(25);
/// How long a PPE thread may compute between two calls, or an SPE that is loaded stay without a
/// run, before it is given up.
pub const LONGEST: Duration = Duration::from_secs(2);

/// What Linux tells of a sleeping thread: how often it has gone to sleep.
type Sleep = String;

/// How long to wait for an actor.
#[derive(Debug)]
pub(super) struct Patience {
    since: Instant,
    /// The folder of the thread in /proc.
    thread: Option<PathBuf>,
    last: Option<(Instant, Sleep)>,
}

thread_local! {
    static THIS_THREAD: Option<PathBuf> =
        fs::read_link("/proc/thread-self").ok().map(|thread| PathBuf::from("/proc").join(thread));
}

impl Patience {
    pub fn with_this_thread() -> Self {
        Self {
            since: Instant::now(),
            // A thread that is ending is only waited for.
            thread: THIS_THREAD.try_with(Clone::clone).ok().flatten(),
            last: None,
        }
    }

    /// For an actor that no thread stands for yet.
    pub fn with_nobody() -> Self {
        Self {
            since: Instant::now(),
            thread: None,
            last: None,
        }
    }

    pub fn is_over(&mut self) -> bool {
        let now = Instant::now();
        if now.duration_since(self.since) >= LONGEST {
            return true;
        }
        let looked = self.last.as_ref().map_or(self.since, |(looked, _)| *looked);
        if now.duration_since(looked) < LOOK_EVERY {
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

/// From a thread's `status`; `None` if it does not sleep.
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
            tell.send(Patience::with_this_thread()).unwrap();
            ended.recv().unwrap_err();
        });
        let mut patience = told.recv().unwrap();
        assert!(!patience.is_over());
        let start = Instant::now();
        while !patience.is_over() {
            thread::sleep(LOOK_EVERY);
            assert!(start.elapsed() < LONGEST);
        }
        let mut own = Patience::with_this_thread();
        let start = Instant::now();
        while start.elapsed() < 8 * LOOK_EVERY {
            assert!(!own.is_over());
        }
        drop(end);
        sleeper.join().unwrap();
    }
}
