//! The virtual terminal that the screen shows. While frames are shown, the kernel must not draw
//! text there. Before the user sees another terminal, the program releases the screen.
//!
//! Invariant: the terminal's modes are restored when a [`Console`] is dropped, on return, on an
//! error or when a panic unwinds. If the program ends in any other way that it can catch, the text
//! mode is restored.

mod terminal;

use super::interrupted;
use super::ioctl::{KD_GRAPHICS, VT_ACKACQ, VT_PROCESS, VT_RELEASED, VtMode};
use super::switching::{self, ScreenRequest, Switching};
use std::fmt;
use std::io;
use std::path::Path;
use terminal::{Terminal, VirtualTerminal};

/// A virtual terminal in graphics mode.
pub(super) struct Console {
    name: &'static str,
    terminal: Box<dyn Terminal>,
    found: i32,
    /// The terminal that was on the screen at the start, if the kernel reports it.
    on_screen: Option<u16>,
    /// How the kernel switched terminals before; `None` if it doesn't ask this program now.
    changes: Option<VtMode>,
    switching: Switching,
    /// Whether this program has released the screen to another terminal.
    away: bool,
}

impl Console {
    /// Puts the program's terminal into graphics mode, or the one in the foreground if the
    /// program's isn't a virtual terminal (a remote login). Without the permission, returns an
    /// error.
    pub(super) fn enter() -> io::Result<Console> {
        let enter = |name| Console::take(name, Box::new(VirtualTerminal::open(Path::new(name))?));
        enter("/dev/tty").or_else(|_| enter("/dev/tty0"))
    }

    fn take(name: &'static str, terminal: Box<dyn Terminal>) -> io::Result<Console> {
        let found = terminal.mode()?;
        interrupted::watch()?;
        let switching = Switching::catch()?;
        let mut console = Console {
            name,
            terminal,
            found,
            on_screen: None,
            changes: None,
            switching,
            away: false,
        };
        console.seize()?;
        Ok(console)
    }

    /// The pending request to release the screen, if the screen is not released already.
    pub(super) fn request(&self) -> Option<ScreenRequest> {
        if self.away { None } else { self.switching.take_request() }
    }

    /// Fulfils a request. The program must have taken its picture off the screen before.
    pub(super) fn leave(&mut self, request: ScreenRequest) {
        match request {
            ScreenRequest::Leave => {
                self.switching.leave();
                // The kernel refuses this if nobody waits for the screen: the user switched back,
                // or the signal wasn't the kernel's. Then the screen will not be returned either.
                self.away = self.terminal.acknowledge(VT_RELEASED).is_ok();
            }
            ScreenRequest::Stop => {
                self.restore();
                switching::stop();
                // If the permission is gone, the frames are drawn over the text.
                let _ = self.seize();
            }
        }
    }

    /// Waits until the program has the screen; `false` if the program is asked to end meanwhile.
    pub(super) fn come_back(&mut self) -> bool {
        if self.away && self.switching.wait_until_back() {
            self.away = false;
            // The kernel doesn't wait for this acknowledgement.
            let _ = self.terminal.acknowledge(VT_ACKACQ);
        }
        !self.away
    }

    /// Whether this program still has the screen. If the user has switched to another terminal,
    /// the kernel draws that one's text.
    pub(super) fn has_the_screen(&self) -> bool {
        self.on_screen.is_some() && self.terminal.on_screen().ok() == self.on_screen
    }

    fn seize(&mut self) -> io::Result<()> {
        self.terminal.set_mode(KD_GRAPHICS)?;
        self.on_screen = self.terminal.on_screen().ok();
        self.changes = self.terminal.changes().ok().filter(|changes| {
            let ours = VtMode {
                mode: VT_PROCESS,
                relsig: switching::leave_signal() as i16,
                acqsig: switching::back_signal() as i16,
                ..*changes
            };
            self.terminal.set_changes(ours).is_ok()
        });
        Ok(())
    }

    fn restore(&mut self) {
        // An error can't be reported here.
        if let Some(changes) = self.changes.take() {
            let _ = self.terminal.set_changes(changes);
        }
        let _ = self.terminal.set_mode(self.found);
        // The shell must not take keys that were meant for the program as commands.
        self.terminal.discard_input();
    }
}

impl fmt::Display for Console {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name)
    }
}

impl Drop for Console {
    fn drop(&mut self) {
        self.restore();
    }
}

#[cfg(test)]
mod tests;
