//! Whether the player was elsewhere: on another virtual terminal, or at the shell while the
//! program was stopped.
//!
//! Keyboards are read past the terminals, so what is typed elsewhere would be heard here, too.
//! Invariant: a way there and back is seen, however short, and also where the program slept
//! through it, as it does while another terminal has its screen.

use std::fs::File;
use std::io::{self, Read as _, Seek as _};
use std::os::fd::AsRawFd as _;
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use signal_hook::consts::SIGCONT;
use signal_hook::flag;

/// Where the kernel names the terminal that is on the screen.
const ACTIVE: &str = "/sys/class/tty/tty0/active";

/// Tells whether the player was elsewhere.
pub trait Foreground {
    /// Whether the player was at any moment since the last call, or is.
    fn was_left(&mut self) -> bool;
}

/// That of this system.
#[derive(Debug)]
pub struct SystemForeground {
    /// None where the kernel has no virtual terminals.
    active: Option<Active>,
    /// The program was stopped, and goes on.
    is_continued: Arc<AtomicBool>,
}

impl SystemForeground {
    /// The player is here now.
    pub fn new() -> io::Result<Self> {
        let is_continued = Arc::new(AtomicBool::new(false));
        flag::register(SIGCONT, Arc::clone(&is_continued))?;
        Ok(Self {
            active: Active::of(Path::new(ACTIVE)).ok(),
            is_continued,
        })
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
        let mut active = Self {
            file: File::open(path)?,
            first: String::new(),
        };
        active.first = active.name()?;
        Ok(active)
    }

    /// Reading is what a notice of the kernel's is taken by.
    fn name(&mut self) -> io::Result<String> {
        let mut name = String::new();
        self.file.rewind()?;
        self.file.read_to_string(&mut name)?;
        Ok(name)
    }

    /// Whether the kernel has told of another terminal since the name was read.
    fn is_notified(&self) -> bool {
        let mut active = libc::pollfd {
            fd: self.file.as_raw_fd(),
            events: libc::POLLPRI,
            revents: 0,
        };
        // SAFETY: one record, which outlives the call, and no waiting.
        unsafe { libc::poll(&raw mut active, 1, 0) == 1 }
    }

    fn was_other(&mut self) -> bool {
        let is_notified = self.is_notified();
        // Read in any case: the notice stays until then.
        let is_other = self.name().is_ok_and(|name| name != self.first);
        is_notified || is_other
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;

    #[test]
    fn a_switch_is_seen_and_so_is_the_way_back() {
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
    fn a_notice_is_taken_by_the_look_that_finds_it() {
        // The kernel's own, where it has virtual terminals: nobody changes them during tests.
        if let Ok(mut active) = Active::of(Path::new(ACTIVE)) {
            active.was_other();
            assert!(!active.is_notified() && !active.was_other());
        }
    }

    #[test]
    fn a_stop_is_seen() {
        let mut foreground = SystemForeground::new().expect("a signal");
        foreground.is_continued.store(false, Ordering::SeqCst);
        signal_hook::low_level::raise(SIGCONT).expect("a signal");
        assert!(foreground.was_left());
        assert!(!foreground.was_left());
    }
}
