//! The virtual terminal behind the screen: while frames are shown, the kernel must not draw text.
//!
//! Invariant: the mode found is put back when a [`Console`] is dropped, be it on return, on an error or
//! by a panic's unwinding; and by [`restore_in_handler`] when a signal ends the program outright.

use super::ioctl::{KD_GRAPHICS, KD_TEXT, KDGETMODE, KDSETMODE, VT_GETSTATE, VtStat};
use std::fmt;
use std::fs::{File, OpenOptions};
use std::io;
use std::os::fd::AsRawFd;
use std::os::unix::fs::OpenOptionsExt;
use std::path::Path;
use std::sync::atomic::{AtomicI32, Ordering};

/// The terminal that is in graphics mode by our doing, for [`restore_in_handler`]; -1 for none.
static TAKEN: AtomicI32 = AtomicI32::new(-1);

/// The calls that a virtual terminal answers: the seam for tests.
trait Terminal: Send {
    /// KDGETMODE.
    fn mode(&self) -> io::Result<i32>;
    /// KDSETMODE.
    fn set_mode(&self, mode: i32) -> io::Result<()>;
    /// VT_GETSTATE: the number of the terminal that is on the screen, be it this one or another.
    fn on_screen(&self) -> io::Result<u16>;
}

/// A virtual terminal in graphics mode.
pub(super) struct Console {
    name: &'static str,
    terminal: Box<dyn Terminal>,
    found: i32,
    /// The terminal that was on the screen at the start, where that can be asked.
    on_screen: Option<u16>,
}

impl Console {
    /// Puts the program's terminal into graphics mode; where that is no virtual terminal (a remote
    /// login), the one in the foreground. Without the right to, an error.
    pub(super) fn enter() -> io::Result<Console> {
        let enter = |name| Console::take(name, Box::new(VirtualTerminal::open(Path::new(name))?));
        enter("/dev/tty").or_else(|_| enter("/dev/tty0"))
    }

    fn take(name: &'static str, terminal: Box<dyn Terminal>) -> io::Result<Console> {
        let found = terminal.mode()?;
        terminal.set_mode(KD_GRAPHICS)?;
        let on_screen = terminal.on_screen().ok();
        Ok(Console {
            name,
            terminal,
            found,
            on_screen,
        })
    }

    /// Whether the screen still is this program's alone: the kernel draws on it for the terminal that
    /// the user switches to.
    pub(super) fn has_the_screen(&self) -> bool {
        self.on_screen.is_some() && self.terminal.on_screen().ok() == self.on_screen
    }
}

impl fmt::Display for Console {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name)
    }
}

impl Drop for Console {
    fn drop(&mut self) {
        // There is nobody left to tell.
        let _ = self.terminal.set_mode(self.found);
    }
}

/// Puts the terminal taken over, if any, back into text mode. May be called from a signal handler:
/// it makes one system call and takes no lock.
pub(super) fn restore_in_handler() {
    let terminal = TAKEN.swap(-1, Ordering::SeqCst);
    if terminal >= 0 {
        // SAFETY: the number is that of an open terminal: it is taken out before the file is closed.
        unsafe { libc::ioctl(terminal, KDSETMODE as libc::Ioctl, KD_TEXT) };
    }
}

struct VirtualTerminal {
    file: File,
}

impl VirtualTerminal {
    fn open(path: &Path) -> io::Result<VirtualTerminal> {
        let flags = libc::O_NONBLOCK | libc::O_NOCTTY;
        let file = OpenOptions::new()
            .read(true)
            .write(true)
            .custom_flags(flags)
            .open(path)?;
        Ok(VirtualTerminal { file })
    }
}

impl Terminal for VirtualTerminal {
    fn mode(&self) -> io::Result<i32> {
        let mut mode: libc::c_int = 0;
        // SAFETY: the descriptor is open; KDGETMODE writes one int, here `mode`.
        let result =
            unsafe { libc::ioctl(self.file.as_raw_fd(), KDGETMODE as libc::Ioctl, &mut mode) };
        if result < 0 {
            Err(io::Error::last_os_error())
        } else {
            Ok(mode)
        }
    }

    fn set_mode(&self, mode: i32) -> io::Result<()> {
        let terminal = self.file.as_raw_fd();
        // SAFETY: the descriptor is open; KDSETMODE takes its argument by value.
        if unsafe { libc::ioctl(terminal, KDSETMODE as libc::Ioctl, libc::c_long::from(mode)) } < 0
        {
            return Err(io::Error::last_os_error());
        }
        TAKEN.store(
            if mode == KD_GRAPHICS { terminal } else { -1 },
            Ordering::SeqCst,
        );
        Ok(())
    }

    fn on_screen(&self) -> io::Result<u16> {
        let mut state = VtStat::default();
        let terminal = self.file.as_raw_fd();
        // SAFETY: the descriptor is open; VT_GETSTATE writes one vt_stat, here `state`.
        if unsafe { libc::ioctl(terminal, VT_GETSTATE as libc::Ioctl, &mut state) } < 0 {
            return Err(io::Error::last_os_error());
        }
        Ok(state.active)
    }
}

impl Drop for VirtualTerminal {
    fn drop(&mut self) {
        // Only if it is this one: another console may have been taken over since.
        let _ = TAKEN.compare_exchange(
            self.file.as_raw_fd(),
            -1,
            Ordering::SeqCst,
            Ordering::SeqCst,
        );
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::panic::{AssertUnwindSafe, catch_unwind};
    use std::sync::{Arc, Mutex};

    /// A terminal that notes what it is told.
    struct Noted {
        found: io::Result<i32>,
        denied: bool,
        told: Arc<Mutex<Vec<i32>>>,
        on_screen: Arc<Mutex<Option<u16>>>,
    }

    impl Terminal for Noted {
        fn mode(&self) -> io::Result<i32> {
            self.found
                .as_ref()
                .copied()
                .map_err(|error| io::Error::from(error.kind()))
        }

        fn set_mode(&self, mode: i32) -> io::Result<()> {
            self.told.lock().unwrap().push(mode);
            if self.denied {
                Err(io::Error::from(io::ErrorKind::PermissionDenied))
            } else {
                Ok(())
            }
        }

        fn on_screen(&self) -> io::Result<u16> {
            let shown = *self.on_screen.lock().unwrap();
            shown.ok_or(io::Error::from_raw_os_error(libc::ENOTTY))
        }
    }

    fn noted(found: io::Result<i32>, denied: bool) -> (Box<Noted>, Arc<Mutex<Vec<i32>>>) {
        let told = Arc::new(Mutex::new(Vec::new()));
        (
            Box::new(Noted {
                found,
                denied,
                told: told.clone(),
                on_screen: Arc::default(),
            }),
            told,
        )
    }

    #[test]
    fn the_mode_found_comes_back() {
        for found in [KD_TEXT, KD_GRAPHICS] {
            let (terminal, told) = noted(Ok(found), false);
            drop(Console::take("tty", terminal).unwrap());
            assert_eq!(*told.lock().unwrap(), [KD_GRAPHICS, found]);
        }
    }

    #[test]
    fn the_mode_found_comes_back_after_a_panic() {
        let (terminal, told) = noted(Ok(KD_TEXT), false);
        let console = Console::take("tty", terminal).unwrap();
        let panicked = catch_unwind(AssertUnwindSafe(move || {
            let _console = console;
            std::panic::resume_unwind(Box::new(()));
        }));
        assert!(panicked.is_err());
        assert_eq!(*told.lock().unwrap(), [KD_GRAPHICS, KD_TEXT]);
    }

    #[test]
    fn what_is_no_terminal_is_left_alone() {
        let (terminal, told) = noted(Err(io::Error::from_raw_os_error(libc::ENOTTY)), false);
        assert!(Console::take("tty", terminal).is_err());
        assert!(told.lock().unwrap().is_empty());
        let (terminal, told) = noted(Ok(KD_TEXT), true);
        assert!(Console::take("tty", terminal).is_err());
        assert_eq!(*told.lock().unwrap(), [KD_GRAPHICS]);
    }

    #[test]
    fn the_screen_is_lost_while_another_terminal_is_on_it() {
        let (terminal, _) = noted(Ok(KD_TEXT), false);
        let on_screen = terminal.on_screen.clone();
        *on_screen.lock().unwrap() = Some(2);
        let console = Console::take("tty", terminal).unwrap();
        for (shown, ours) in [
            (Some(2), true),
            (Some(3), false),
            (None, false),
            (Some(2), true),
        ] {
            *on_screen.lock().unwrap() = shown;
            assert_eq!(console.has_the_screen(), ours, "{shown:?}");
        }
        // Where it could not be asked at the start, it is not believed later.
        let (terminal, _) = noted(Ok(KD_TEXT), false);
        let on_screen = terminal.on_screen.clone();
        let console = Console::take("tty", terminal).unwrap();
        assert!(!console.has_the_screen());
        *on_screen.lock().unwrap() = Some(2);
        assert!(!console.has_the_screen());
    }

    #[test]
    fn the_kernel_says_what_is_no_terminal() {
        let null = VirtualTerminal::open(Path::new("/dev/null")).unwrap();
        let answers = [
            null.mode().map(drop),
            null.set_mode(KD_GRAPHICS),
            null.on_screen().map(drop),
        ];
        for answer in answers {
            // The second is the user-mode emulator's for a request that it does not know.
            let unknown = [Some(libc::ENOTTY), Some(libc::ENOSYS)];
            assert!(unknown.contains(&answer.unwrap_err().raw_os_error()));
        }
        assert_eq!(TAKEN.load(Ordering::SeqCst), -1);
    }
}
