//! The process's threads, as Linux shows them: who sleeps until another thread wakes him.
//!
//! Known weakness: under QEMU, Linux shows the host's system calls, whose numbers may be others.
//! Then nobody is found to wait for a thread, and only time-outs are left.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::time::Duration;

use crate::lock::lock;

const TASKS: &str = "/proc/self/task";

/// A thread's number.
pub(super) type ThreadId = u32;

thread_local! {
    static THIS_THREAD: Option<ThreadId> = this_thread_of_linux();
}

fn this_thread_of_linux() -> Option<ThreadId> {
    let link = fs::read_link("/proc/thread-self").ok()?;
    link.file_name()?.to_str()?.parse().ok()
}

/// This thread's number. A thread that is ending has none.
pub(super) fn this_thread() -> Option<ThreadId> {
    THIS_THREAD.try_with(Clone::clone).ok().flatten()
}

/// The threads of all [`HelperThread`]s.
static HELPERS: Mutex<Vec<ThreadId>> = Mutex::new(Vec::new());

/// While it lives, the thread that created it is known to act for no PPE thread and to wake none.
/// So simulated time does not wait for what it does: it compiles, or it serves a debugger.
#[derive(Debug)]
pub struct HelperThread(Option<ThreadId>);

impl HelperThread {
    /// The current thread is such a thread from now on.
    #[must_use]
    pub fn current() -> Self {
        let thread = this_thread();
        lock(&HELPERS).extend(thread);
        Self(thread)
    }
}

impl Drop for HelperThread {
    fn drop(&mut self) {
        lock(&HELPERS).retain(|&thread| Some(thread) != self.0);
    }
}

/// A thread's folder.
pub(super) fn folder(thread: ThreadId) -> PathBuf {
    Path::new(TASKS).join(thread.to_string())
}

/// How often a sleeping thread has gone to sleep.
pub(super) type Sleep = String;

/// The sleep of the thread with this folder. `None` if it is not asleep.
pub(super) fn sleep(folder: &Path) -> Option<Sleep> {
    sleep_of(&fs::read_to_string(folder.join("status")).ok()?)
}

/// How long the thread with this folder was ready to run so far, while the processors were busy
/// with others. `None` if the system doesn't say.
pub(super) fn held_up(folder: &Path) -> Option<Duration> {
    held_up_of(&fs::read_to_string(folder.join("schedstat")).ok()?)
}

/// The second number of a thread's `schedstat`, which is in nanoseconds.
fn held_up_of(schedstat: &str) -> Option<Duration> {
    let nanos = schedstat.split_ascii_whitespace().nth(1)?;
    nanos.parse().ok().map(Duration::from_nanos)
}

/// The count in a thread's `status`. `None` if the thread is not asleep.
fn sleep_of(status: &str) -> Option<Sleep> {
    let field = |name| {
        let line = status.lines().find(|line| line.starts_with(name))?;
        line.split(':').nth(1).map(str::trim)
    };
    field("State")?.starts_with('S').then(|| field("voluntary_ctxt_switches").map(str::to_owned))?
}

/// Whether a thread's `syscall` is a wait for another thread that has no time limit: in a lock, a
/// condition, a barrier or a join.
fn waits_for_a_thread(syscall: &str) -> bool {
    let mut words = syscall.split_ascii_whitespace();
    let number = words.next().and_then(|number| number.parse().ok());
    const TIME_LIMIT: usize = 3;
    number == Some(libc::SYS_futex) && words.nth(TIME_LIMIT) == Some("0x0")
}

/// What threads do while one of them is waited for.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Sleeps {
    /// Of those that are not behind it.
    others: Vec<(PathBuf, Sleep)>,
    /// Of those behind it. `None` if one of them is running.
    behind: Option<Vec<(PathBuf, Sleep)>>,
}

/// The sleeps of all threads but helpers and this one. `None` if one of them could go on without
/// being woken, unless it is in `behind`.
fn sleeps(behind: &[ThreadId]) -> Option<Sleeps> {
    let this = this_thread()?;
    let helpers = lock(&HELPERS).clone();
    let mut sleeps = Sleeps { others: Vec::new(), behind: Some(Vec::new()) };
    for entry in fs::read_dir(TASKS).ok()? {
        let folder = entry.ok()?.path();
        let thread = folder.file_name()?.to_str()?.parse().ok()?;
        if thread == this || helpers.contains(&thread) {
            continue;
        }
        let sleep = sleep(&folder);
        if behind.contains(&thread) {
            match (sleep, &mut sleeps.behind) {
                (Some(sleep), Some(all)) => all.push((folder, sleep)),
                _ => sleeps.behind = None,
            }
            continue;
        }
        let sleep = sleep?;
        if !waits_for_a_thread(&fs::read_to_string(folder.join("syscall")).ok()?) {
            return None;
        }
        sleeps.others.push((folder, sleep));
    }
    Some(sleeps)
}

/// Who might wake a thread that is waited for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Wakers {
    /// Nobody: all other threads sleep until another thread wakes them, or until it acts. This is
    /// certain, unless the process gets a signal.
    Nobody,
    /// A thread behind it, which is running and may hold a lock for a moment.
    Behind,
    /// Any thread.
    Anybody,
}

/// Who might wake a thread that is waited for. The threads `behind` it do not act before it does,
/// and helpers and this one wake nobody.
///
/// A thread may wake one that was looked at before. So all are looked at twice, and count only if
/// they slept in between.
pub(super) fn wakers(behind: &[ThreadId]) -> Wakers {
    match (sleeps(behind), sleeps(behind)) {
        (Some(first), Some(second)) if first == second && first.behind.is_some() => Wakers::Nobody,
        (Some(first), Some(second)) if first.others == second.others => Wakers::Behind,
        _ => Wakers::Anybody,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_a_thread_was_held_up_is_the_second_number() {
        let held_up = held_up_of("5000 3000000007 12\n");
        assert_eq!(held_up, Some(Duration::new(3, 7)));
        assert_eq!(held_up_of(""), None);
    }

    #[test]
    fn only_a_sleeping_thread_has_a_sleep() {
        let status = |state| format!("Name:\tx\nState:\t{state}\nvoluntary_ctxt_switches:\t17\n");
        assert_eq!(sleep_of(&status("S (sleeping)")), Some("17".to_owned()));
        assert_eq!(sleep_of(&status("R (running)")), None);
        assert_eq!(sleep_of("State:\tS (sleeping)\n"), None);
    }

    #[test]
    fn a_wait_with_a_time_limit_is_no_wait_for_a_thread() {
        let futex = |limit: &str| format!("{} 0x7f00 0x189 0x0 {limit} 0x0", libc::SYS_futex);
        assert!(waits_for_a_thread(&futex("0x0")));
        assert!(!waits_for_a_thread(&futex("0x7ffe1230")));
        assert!(!waits_for_a_thread("running"));
        assert!(!waits_for_a_thread("-1 0x7ffe 0x7ffe"));
    }
}
