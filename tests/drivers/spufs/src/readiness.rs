//! Descriptors that are ready when a file of a context would be.

use std::fs::File;
use std::io::{self, Read, Write};
use std::os::fd::{AsRawFd, FromRawFd, OwnedFd, RawFd};
use std::sync::{Mutex, OnceLock, PoisonError, Weak};

use spu_emulator::spe::{Spe, Watcher};

/// An eventfd cannot be written while its counter has this value.
const FULL: u64 = u64::MAX - 1;

/// An eventfd that shows whether something can be done.
pub(crate) struct Level {
    file: File,
    /// The counter while it cannot be done, and while it can.
    counters: [u64; 2],
    ready: Mutex<bool>,
}

impl Level {
    fn new(counters: [u64; 2]) -> io::Result<Self> {
        let level =
            Self { file: File::from(event_descriptor()?), counters, ready: Mutex::new(true) };
        level.count(1)?;
        level.set(false);
        Ok(level)
    }

    /// Readable if ready.
    pub fn readable() -> io::Result<Self> {
        Self::new([0, 1])
    }

    /// Writable if ready.
    pub fn writable() -> io::Result<Self> {
        Self::new([FULL, 0])
    }

    fn count(&self, index: usize) -> io::Result<()> {
        let value = self.counters[index];
        if value == 0 {
            return Ok(());
        }
        (&self.file).write_all(&value.to_ne_bytes())
    }

    pub fn set(&self, ready: bool) {
        let mut was = self.ready.lock().unwrap_or_else(PoisonError::into_inner);
        if *was != ready {
            *was = ready;
            if self.counters[usize::from(!ready)] != 0 {
                (&self.file).read_exact(&mut [0; 8]).expect("the counter is not 0");
            }
            self.count(usize::from(ready)).expect("the counter is 0");
        }
    }

    /// A descriptor of its own that shows the same.
    pub fn descriptor(&self) -> io::Result<OwnedFd> {
        self.file.try_clone().map(OwnedFd::from)
    }
}

/// An eventfd that is always writable and never readable.
pub(crate) fn event_descriptor() -> io::Result<OwnedFd> {
    // SAFETY: the call takes no pointers.
    let raw = unsafe { libc::eventfd(0, libc::EFD_CLOEXEC | libc::EFD_NONBLOCK) };
    if raw < 0 {
        return Err(io::Error::last_os_error());
    }
    // SAFETY: the descriptor was just created, and nothing else owns it.
    Ok(unsafe { OwnedFd::from_raw_fd(raw) })
}

/// Sleeps until a descriptor is ready for `events` of poll(2). A caught signal ends the sleep with
/// an error.
pub(crate) fn wait_for(descriptor: RawFd, events: i16) -> io::Result<()> {
    let mut wait = libc::pollfd { fd: descriptor, events, revents: 0 };
    // SAFETY: the structure is valid, and there is one.
    if unsafe { libc::poll(&raw mut wait, 1, -1) } < 0 {
        return Err(io::Error::last_os_error());
    }
    Ok(())
}

/// The levels of a context's files.
pub(crate) struct Levels {
    /// Words in the outbound interrupt mailbox.
    pub interrupt: Level,
    /// A free entry in the inbound mailbox.
    pub inbound: Level,
    /// A complete tag that was not reported.
    pub tags: Level,
    pub spe: OnceLock<Weak<Spe>>,
    /// One look at a time, so that the last one sees the last change.
    look: Mutex<()>,
}

impl Levels {
    pub fn new() -> io::Result<Self> {
        Ok(Self {
            interrupt: Level::readable()?,
            inbound: Level::writable()?,
            tags: Level::readable()?,
            spe: OnceLock::new(),
            look: Mutex::new(()),
        })
    }
}

impl Watcher for Levels {
    fn changed(&self) {
        let _one_at_a_time = self.look.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(spe) = self.spe.get().and_then(Weak::upgrade) {
            self.interrupt.set(spe.outbound_interrupt_waiting() > 0);
            self.inbound.set(spe.inbound_free() > 0);
        }
    }
}

/// The raw number of a descriptor that was handed to the program.
pub(crate) fn into_raw(descriptor: OwnedFd) -> RawFd {
    let raw = descriptor.as_raw_fd();
    std::mem::forget(descriptor);
    raw
}
