//! Whether the console still shows the virtual terminal that it showed at first.
//!
//! Keyboards are read past the terminals, so what is typed on another one would be heard here, too.

use std::fs;
use std::path::PathBuf;

/// Where the kernel names the terminal that is on the screen.
const ACTIVE: &str = "/sys/class/tty/tty0/active";

/// The terminal that was on the screen.
#[derive(Debug)]
pub struct Foreground {
    file: PathBuf,
    first: Option<String>,
}

impl Foreground {
    /// Of the system.
    #[must_use]
    pub fn of_system() -> Self {
        Self::of(ACTIVE.into())
    }

    fn of(file: PathBuf) -> Self {
        Self {
            first: fs::read_to_string(&file).ok(),
            file,
        }
    }

    /// Whether another one is. Where the kernel has none there is no other.
    #[must_use]
    pub fn is_other(&self) -> bool {
        self.first.is_some() && fs::read_to_string(&self.file).ok() != self.first
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_switch_is_seen_and_so_is_the_way_back() {
        let folder = tempfile::tempdir().expect("a folder");
        let file = folder.path().join("active");
        assert!(!Foreground::of(file.clone()).is_other());
        fs::write(&file, "tty1\n").expect("a file");
        let foreground = Foreground::of(file.clone());
        for (active, is_other) in [("tty1\n", false), ("tty2\n", true), ("tty1\n", false)] {
            fs::write(&file, active).expect("a file");
            assert_eq!(foreground.is_other(), is_other, "{active}");
        }
    }
}
