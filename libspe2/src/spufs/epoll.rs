//! Waiting for the readiness of files.

use std::io;
use std::os::fd::{AsRawFd, FromRawFd, OwnedFd, RawFd};
use std::ptr;
use std::time::Duration;

use libc::c_int;

use crate::error::Errno;

pub(crate) struct Epoll(OwnedFd);

impl Epoll {
    pub(crate) fn new() -> Result<Self, Errno> {
        // SAFETY: the call takes no pointers.
        let raw = unsafe { libc::epoll_create1(libc::EPOLL_CLOEXEC) };
        if raw < 0 {
            return Err(io::Error::last_os_error().into());
        }
        // SAFETY: the descriptor was just created, and nothing else owns it.
        Ok(Self(unsafe { OwnedFd::from_raw_fd(raw) }))
    }

    /// Waits for `file` from now on: until it can be written if `out`, and otherwise for data.
    /// Fails with EEXIST if it already does.
    pub(crate) fn add(&self, file: RawFd, out: bool, number: usize) -> Result<(), Errno> {
        let mut event = libc::epoll_event {
            events: if out { libc::EPOLLOUT } else { libc::EPOLLIN } as u32,
            u64: number as u64,
        };
        // SAFETY: the event is a valid structure.
        let result = unsafe {
            libc::epoll_ctl(self.0.as_raw_fd(), libc::EPOLL_CTL_ADD, file, &raw mut event)
        };
        if result != 0 {
            return Err(io::Error::last_os_error().into());
        }
        Ok(())
    }

    /// Ends the waiting for a file.
    pub(crate) fn remove(&self, file: RawFd) {
        // SAFETY: removing needs no event.
        unsafe { libc::epoll_ctl(self.0.as_raw_fd(), libc::EPOLL_CTL_DEL, file, ptr::null_mut()) };
    }

    /// Sleeps until a file is ready, and returns the numbers of at most `most` that are. There are
    /// none if the limit passes, or if a signal is caught meanwhile. Without a limit, a signal does
    /// not end the sleep.
    pub(crate) fn wait(&self, most: usize, limit: Option<Duration>) -> Result<Vec<usize>, Errno> {
        /// Events for one call, so that a huge array of the program's costs no memory.
        const AT_ONCE: usize = 256;
        let milliseconds = limit.map_or(-1, |limit| limit.as_millis() as c_int);
        let mut events = vec![libc::epoll_event { events: 0, u64: 0 }; most.min(AT_ONCE)];
        loop {
            // SAFETY: the array holds that many events.
            let ready = unsafe {
                libc::epoll_wait(
                    self.0.as_raw_fd(),
                    events.as_mut_ptr(),
                    events.len() as c_int,
                    milliseconds,
                )
            };
            let Ok(ready) = usize::try_from(ready) else {
                match (io::Error::last_os_error(), limit) {
                    (error, None) if error.kind() == io::ErrorKind::Interrupted => continue,
                    (error, Some(_)) if error.kind() == io::ErrorKind::Interrupted => {
                        return Ok(Vec::new());
                    }
                    (error, _) => return Err(error.into()),
                }
            };
            return Ok(events[..ready].iter().map(|event| event.u64 as usize).collect());
        }
    }
}
