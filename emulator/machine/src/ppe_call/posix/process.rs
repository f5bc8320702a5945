//! Time, and the process itself.

use std::time::{SystemTime, UNIX_EPOCH};

use super::super::Errno;
use super::super::errno::check;
use super::super::guest::Block;
use super::time_at;

pub(super) fn page_size() -> i32 {
    // SAFETY: `sysconf` accepts any number.
    unsafe { libc::sysconf(libc::_SC_PAGESIZE) as i32 }
}

/// Seconds and microseconds since the epoch.
fn now() -> (u32, u32) {
    let since = SystemTime::now().duration_since(UNIX_EPOCH);
    let since = since.unwrap_or_default();
    (since.as_secs() as u32, since.subsec_micros())
}

/// The time zone is 0, because C libraries no longer keep it there.
pub(super) fn gettimeofday(block: Block<'_>) -> Result<(), Errno> {
    let (seconds, microseconds) = now();
    if block.word(0) != 0 {
        let words = [seconds, microseconds];
        block.guest.set_words(block.word(0), &words);
    }
    if block.word(1) != 0 {
        block.guest.set_word(block.word(1), 0);
    }
    Ok(())
}

pub(super) fn time(block: Block<'_>) -> i32 {
    let (seconds, _) = now();
    if block.word(0) != 0 {
        block.guest.set_word(block.word(0), seconds);
    }
    seconds as i32
}

pub(super) fn nanosleep(block: Block<'_>) -> Result<i32, Errno> {
    let (seconds, nanoseconds) = time_at(block, block.word(0));
    let asked = libc::timespec { tv_sec: seconds.into(), tv_nsec: nanoseconds.into() };
    let mut left = libc::timespec { tv_sec: 0, tv_nsec: 0 };
    // SAFETY: both times are valid.
    let slept = check(unsafe { libc::nanosleep(&raw const asked, &raw mut left) });
    if block.word(1) != 0 {
        let words = [left.tv_sec as u32, left.tv_nsec as u32];
        block.guest.set_words(block.word(1), &words);
    }
    slept
}

/// Signals can be sent to this process only. Signal 0 only asks whether another process exists.
pub(super) fn kill(block: Block<'_>) -> Result<i32, Errno> {
    let (process, signal) = (block.int(0), block.int(1));
    let own = i32::try_from(std::process::id()) == Ok(process);
    if !own && signal != 0 {
        return Err(Errno(libc::EPERM));
    }
    // SAFETY: `kill` accepts any numbers.
    check(unsafe { libc::kill(process, signal) })
}

pub(super) fn wait(
    block: Block<'_>,
    process: i32,
    status_at: u32,
    options: i32,
) -> Result<i32, Errno> {
    let mut status = 0;
    // SAFETY: the status is writable.
    let ended = check(unsafe { libc::waitpid(process, &raw mut status, options) })?;
    if status_at != 0 {
        block.guest.set_word(status_at, status as u32);
    }
    Ok(ended)
}

pub(super) fn umask(block: Block<'_>) -> i32 {
    // SAFETY: `umask` accepts any number.
    unsafe { libc::umask(block.word(0)) as i32 }
}
