//! The virtual terminal behind the screen: while frames are shown, the kernel must not draw text,
//! and before the user sees another terminal, the program lets go of the screen.
//!
//! Invariant: the modes found are put back when a [`Console`] is dropped, be it on return, on an
//! error or by a panic's unwinding; and the terminal's text at any other end that a program can
//! see.

mod terminal;

use super::interrupted;
use super::ioctl::{KD_GRAPHICS, VT_ACKACQ, VT_PROCESS, VT_RELEASED, VtMode};
use super::switching::{self, Asked, Switching};
use std::fmt;
use std::io;
use std::path::Path;
use terminal::{Terminal, VirtualTerminal};

/// A virtual terminal in graphics mode.
pub(super) struct Console {
    name: &'static str,
    terminal: Box<dyn Terminal>,
    found: i32,
    /// The terminal that was on the screen at the start, where that can be asked.
    on_screen: Option<u16>,
    /// How the kernel changed terminals, where it asks us now.
    changes: Option<VtMode>,
    switching: Switching,
    /// Whether another terminal has the screen by our leave.
    away: bool,
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

    /// What is asked of a terminal that is on the screen.
    pub(super) fn asked(&self) -> Option<Asked> {
        if self.away {
            None
        } else {
            self.switching.asked()
        }
    }

    /// Does what was asked, once nothing of the program's is on the screen.
    pub(super) fn leave(&mut self, asked: Asked) {
        match asked {
            Asked::Leave => {
                self.switching.leave();
                // Refused where nobody waits for the screen: the user thought better of it, or the
                // signal was not the kernel's. Then it is not given back, either.
                self.away = self.terminal.answer(VT_RELEASED).is_ok();
            }
            Asked::Stop => {
                self.restore();
                switching::stop();
                // Without the right any more, the frames go over the text.
                let _ = self.seize();
            }
        }
    }

    /// Waits until the screen is the program's, and says whether it is: not when it is asked to
    /// end.
    pub(super) fn come_back(&mut self) -> bool {
        if self.away && self.switching.wait_until_back() {
            self.away = false;
            // The kernel does not wait for the answer.
            let _ = self.terminal.answer(VT_ACKACQ);
        }
        !self.away
    }

    /// Whether the screen still is this program's alone: the kernel draws on it for the terminal
    /// that the user switches to.
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
        // There is nobody left to tell.
        if let Some(changes) = self.changes.take() {
            let _ = self.terminal.set_changes(changes);
        }
        let _ = self.terminal.set_mode(self.found);
        // Keys that steered the program are no commands to the shell.
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
