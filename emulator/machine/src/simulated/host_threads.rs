//! The process's threads, as Linux reports them: which threads are blocked.
//!
//! Known weakness: under QEMU, Linux shows the host's system calls, whose numbers may differ.
//! Then no thread is recognised as blocked, and only time-outs remain. Systems without `/proc`
//! don't report any thread.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::time::Duration;

use crate::lock::lock;

const TASKS: &str = "/proc/self/task";

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

static HELPERS: Mutex<Vec<ThreadId>> = Mutex::new(Vec::new());

/// While it exists, the thread that created it counts as a helper: it acts for no PPE thread and
/// wakes none. So simulated time does not wait for it. It compiles, or it serves a debugger.
#[derive(Debug)]
pub struct HelperThread(Option<ThreadId>);

impl HelperThread {
    /// Registers the current thread as a helper.
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

/// A thread's folder in `/proc`.
pub(super) fn folder(thread: ThreadId) -> PathBuf {
    Path::new(TASKS).join(thread.to_string())
}

/// The number of times that a sleeping thread has gone to sleep, which identifies the sleep.
pub(super) type Sleep = String;

/// The sleep of the thread with this folder. `None` if it is not asleep.
pub(super) fn sleep(folder: &Path) -> Option<Sleep> {
    sleep_of(&fs::read_to_string(folder.join("status")).ok()?)
}

/// The total time that the thread with this folder was ready to run while the processors were busy
/// with others. `None` if the system doesn't report it.
pub(super) fn time_preempted(folder: &Path) -> Option<Duration> {
    time_preempted_of(&fs::read_to_string(folder.join("schedstat")).ok()?)
}

/// The second number of a thread's `schedstat`, which is in nanoseconds.
fn time_preempted_of(schedstat: &str) -> Option<Duration> {
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
#[cfg(target_os = "linux")]
fn is_blocked_by_a_thread(syscall: &str) -> bool {
    let mut words = syscall.split_ascii_whitespace();
    let number = words.next().and_then(|number| number.parse().ok());
    const TIME_LIMIT: usize = 3;
    number == Some(libc::SYS_futex) && words.nth(TIME_LIMIT) == Some("0x0")
}

#[cfg(not(target_os = "linux"))]
fn is_blocked_by_a_thread(_: &str) -> bool {
    false
}

/// The sleeps of threads while the scheduler waits for one of them, the leader.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Sleeps {
    /// Of threads that may act before the leader.
    others: Vec<(PathBuf, Sleep)>,
    /// Of threads that act after the leader. `None` if one of them is running.
    later: Option<Vec<(PathBuf, Sleep)>>,
}

/// The sleeps of all threads except helpers and this one. `None` if a thread that is not in `later`
/// could continue without being woken.
fn sleeps(later: &[ThreadId]) -> Option<Sleeps> {
    let this = this_thread()?;
    let helpers = lock(&HELPERS).clone();
    let mut sleeps = Sleeps { others: Vec::new(), later: Some(Vec::new()) };
    for entry in fs::read_dir(TASKS).ok()? {
        let folder = entry.ok()?.path();
        let thread = folder.file_name()?.to_str()?.parse().ok()?;
        if thread == this || helpers.contains(&thread) {
            continue;
        }
        let sleep = sleep(&folder);
        if later.contains(&thread) {
            match (sleep, &mut sleeps.later) {
                (Some(sleep), Some(all)) => all.push((folder, sleep)),
                _ => sleeps.later = None,
            }
            continue;
        }
        let sleep = sleep?;
        if !is_blocked_by_a_thread(&fs::read_to_string(folder.join("syscall")).ok()?) {
            return None;
        }
        sleeps.others.push((folder, sleep));
    }
    Some(sleeps)
}

/// Which threads might wake the leader, for which the scheduler waits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Wakers {
    /// No thread: all others are blocked by another thread, or wait until the leader acts. This is
    /// certain, unless the process receives a signal.
    Blocked,
    /// A thread that acts after the leader, but is running and may hold a lock for a moment.
    LockHolder,
    /// Any thread might.
    Unknown,
}

/// The threads that might wake the leader. The threads `later` do not act before it does, and
/// helpers and this thread wake no other.
///
/// A thread may wake one that was examined before it. So all are examined twice, and count as
/// blocked only if they slept in between.
pub(super) fn wakers(later: &[ThreadId]) -> Wakers {
    match (sleeps(later), sleeps(later)) {
        (Some(first), Some(second)) if first == second && first.later.is_some() => Wakers::Blocked,
        (Some(first), Some(second)) if first.others == second.others => Wakers::LockHolder,
        _ => Wakers::Unknown,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn preempted_time_is_the_second_number() {
        let time_preempted = time_preempted_of("5000 3000000007 12\n");
        assert_eq!(time_preempted, Some(Duration::new(3, 7)));
        assert_eq!(time_preempted_of(""), None);
    }

    #[test]
    fn only_a_sleeping_thread_has_a_sleep() {
        let status = |state| format!("Name:\tx\nState:\t{state}\nvoluntary_ctxt_switches:\t17\n");
        assert_eq!(sleep_of(&status("S (sleeping)")), Some("17".to_owned()));
        assert_eq!(sleep_of(&status("R (running)")), None);
        assert_eq!(sleep_of("State:\tS (sleeping)\n"), None);
    }

    #[test]
    fn wait_with_a_time_limit_is_not_blocked_by_a_thread() {
        let futex = |limit: &str| format!("{} 0x7f00 0x189 0x0 {limit} 0x0", libc::SYS_futex);
        assert!(is_blocked_by_a_thread(&futex("0x0")));
        assert!(!is_blocked_by_a_thread(&futex("0x7ffe1230")));
        assert!(!is_blocked_by_a_thread("running"));
        assert!(!is_blocked_by_a_thread("-1 0x7ffe 0x7ffe"));
    }
}
