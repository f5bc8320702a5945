//! The calls of a virtual terminal, one method each, without any logic.
//!
//! Tests implement the trait with a scripted terminal in place of the kernel's.

use crate::framebuffer::ioctl::{
    KD_GRAPHICS, KD_TEXT, KDGETMODE, KDSETMODE, VT_GETMODE, VT_GETSTATE, VT_RELDISP, VT_SETMODE,
    VtMode, VtStat,
};
use crate::framebuffer::last_resort::{Argument, Place, RestorePromise};
use std::fs::{File, OpenOptions};
use std::io;
use std::os::fd::{AsFd, AsRawFd};
use std::os::unix::fs::OpenOptionsExt;
use std::path::Path;

/// A virtual terminal.
pub(super) trait Terminal: Send {
    /// KDGETMODE.
    fn mode(&self) -> io::Result<i32>;
    /// KDSETMODE.
    fn set_mode(&mut self, mode: i32) -> io::Result<()>;
    /// VT_GETSTATE: the number of the terminal that is on the screen, this one or another.
    fn on_screen(&self) -> io::Result<u16>;
    /// VT_GETMODE.
    fn changes(&self) -> io::Result<VtMode>;
    /// VT_SETMODE.
    fn set_changes(&self, changes: VtMode) -> io::Result<()>;
    /// VT_RELDISP: the acknowledgement when the kernel requests the screen or returns it.
    fn acknowledge(&self, reply: i32) -> io::Result<()>;
    /// Discards input that was typed but not read.
    fn discard_input(&self);
}

/// A virtual terminal of the kernel's.
pub(super) struct VirtualTerminal {
    // Dropped first, because it needs the open file.
    _promise: Option<RestorePromise>,
    file: File,
}

impl VirtualTerminal {
    pub(super) fn open(path: &Path) -> io::Result<VirtualTerminal> {
        let flags = libc::O_NONBLOCK | libc::O_NOCTTY;
        let file = OpenOptions::new().read(true).write(true).custom_flags(flags).open(path)?;
        Ok(VirtualTerminal { _promise: None, file })
    }

    /// A request that reads or writes a `T`.
    fn request<T>(&self, request: u32, argument: &mut T) -> io::Result<()> {
        let (terminal, request) = (self.file.as_raw_fd(), request as libc::Ioctl);
        // SAFETY: the descriptor is open, and each caller passes the type that its request reads
        // or writes, which outlives the call.
        checked(unsafe { libc::ioctl(terminal, request, argument as *mut T) })
    }

    /// A request that takes a number.
    fn set(&self, request: u32, value: i32) -> io::Result<()> {
        let (terminal, request) = (self.file.as_raw_fd(), request as libc::Ioctl);
        // SAFETY: the descriptor is open; the requests used here take their argument by value.
        checked(unsafe { libc::ioctl(terminal, request, libc::c_long::from(value)) })
    }
}

fn checked(result: libc::c_int) -> io::Result<()> {
    if result < 0 { Err(io::Error::last_os_error()) } else { Ok(()) }
}

impl Terminal for VirtualTerminal {
    fn mode(&self) -> io::Result<i32> {
        let mut mode: libc::c_int = 0;
        self.request(KDGETMODE, &mut mode)?;
        Ok(mode)
    }

    fn set_mode(&mut self, mode: i32) -> io::Result<()> {
        let promise = (mode == KD_GRAPHICS).then(|| {
            let text = Argument::Value(KD_TEXT.into());
            RestorePromise::promise(Place::Console, self.file.as_fd(), KDSETMODE, text)
        });
        self.set(KDSETMODE, mode)?;
        self._promise = promise;
        Ok(())
    }

    fn on_screen(&self) -> io::Result<u16> {
        let mut state = VtStat::default();
        self.request(VT_GETSTATE, &mut state)?;
        Ok(state.active)
    }

    fn changes(&self) -> io::Result<VtMode> {
        let mut changes = VtMode::default();
        self.request(VT_GETMODE, &mut changes)?;
        Ok(changes)
    }

    fn set_changes(&self, mut changes: VtMode) -> io::Result<()> {
        self.request(VT_SETMODE, &mut changes)
    }

    fn acknowledge(&self, reply: i32) -> io::Result<()> {
        self.set(VT_RELDISP, reply)
    }

    fn discard_input(&self) {
        let terminal = self.file.as_raw_fd();
        // SAFETY: the descriptor is open.
        unsafe {
            // In the background, the input belongs to the shell, and the call would stop the
            // program.
            let foreground = libc::tcgetpgrp(terminal);
            if foreground < 0 || foreground == libc::getpgrp() {
                libc::tcflush(terminal, libc::TCIFLUSH);
            }
        }
    }
}
