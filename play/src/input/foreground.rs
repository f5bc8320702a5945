//! Detects whether the player was elsewhere: on another virtual terminal, or at the shell while
//! the program was stopped.
//!
//! Keyboards are read directly, not through terminals, so keys that are typed elsewhere would
//! arrive here too. Invariant: every absence is detected, however short, even if the program slept
//! through it, as it does while another terminal has its screen.

use std::fs::File;
use std::io::{self, Read as _, Seek as _};
use std::os::fd::AsRawFd as _;
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use signal_hook::consts::SIGCONT;
use signal_hook::flag;

/// The file in which the kernel names the terminal that is on the screen.
const ACTIVE: &str = "/sys/class/tty/tty0/active";

/// Detects whether the player was elsewhere.
pub trait Foreground {
    /// Whether the player is elsewhere, or was at any time since the last call.
    fn was_left(&mut self) -> bool;
}

/// Detects it on this system.
#[derive(Debug)]
pub struct SystemForeground {
    /// `None` if the kernel has no virtual terminals.
    active: Option<Active>,
    /// Whether the program was stopped and continued.
    is_continued: Arc<AtomicBool>,
}

impl SystemForeground {
    /// The player counts as present now.
    ///
    /// # Errors
    /// The signal can't be caught.
    pub fn new() -> io::Result<Self> {
        let is_continued = Arc::new(AtomicBool::new(false));
        flag::register(SIGCONT, Arc::clone(&is_continued))?;
        Ok(Self { active: Active::of(Path::new(ACTIVE)).ok(), is_continued })
    }
}

impl Foreground for SystemForeground {
    fn was_left(&mut self) -> bool {
        let is_continued = self.is_continued.swap(false, Ordering::SeqCst);
        let active = self.active.as_mut();
        active.is_some_and(Active::was_other) || is_continued
    }
}

/// The terminal that was on the screen.
#[derive(Debug)]
struct Active {
    file: File,
    first: String,
}

impl Active {
    fn of(path: &Path) -> io::Result<Self> {
        let mut active = Self { file: File::open(path)?, first: String::new() };
        active.first = active.name()?;
        Ok(active)
    }

    /// Reads the terminal's name, which also clears the kernel's notification.
    fn name(&mut self) -> io::Result<String> {
        let mut name = String::new();
        self.file.rewind()?;
        self.file.read_to_string(&mut name)?;
        Ok(name)
    }

    /// Whether the kernel has notified of a switch since the name was read.
    fn is_notified(&self) -> bool {
        let mut active =
            libc::pollfd { fd: self.file.as_raw_fd(), events: libc::POLLPRI, revents: 0 };
        // SAFETY: the call accesses one record, which outlives it, and doesn't wait.
        unsafe { libc::poll(&raw mut active, 1, 0) == 1 }
    }

    fn was_other(&mut self) -> bool {
        let is_notified = self.is_notified();
        // Always read, because the notification stays until then.
        let is_other = self.name().is_ok_and(|name| name != self.first);
        is_notified || is_other
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;

    #[test]
    fn switch_to_background_and_back_is_noticed() {
        let folder = tempfile::tempdir().expect("a folder");
        let file = folder.path().join("active");
        assert!(Active::of(&file).is_err());
        fs::write(&file, "tty1\n").expect("a file");
        let mut active = Active::of(&file).expect("a file");
        for (name, is_other) in [("tty1\n", false), ("tty2\n", true), ("tty1\n", false)] {
            fs::write(&file, name).expect("a file");
            assert_eq!(active.was_other(), is_other, "{name}");
        }
    }

    #[test]
    fn notification_is_cleared_when_read() {
        // If the kernel has virtual terminals, nobody switches them during tests.
        if let Ok(mut active) = Active::of(Path::new(ACTIVE)) {
            active.was_other();
            assert!(!active.is_notified() && !active.was_other());
        }
    }

    #[test]
    fn stop_signal_is_noticed() {
        let mut foreground = SystemForeground::new().expect("a signal");
        foreground.is_continued.store(false, Ordering::SeqCst);
        signal_hook::low_level::raise(SIGCONT).expect("a signal");
        assert!(foreground.was_left());
        assert!(!foreground.was_left());
    }
}
