//! The terminal's events, read by a thread of their own.
//!
//! A read waits where bytes have come that are no whole event, such as Alt and a bracket, and one
//! of a terminal that has hung up comes back empty for ever. Invariant: the frame loop waits for
//! neither, and the thread holds nothing that the program needs to end.
//!
//! Known weakness: a terminal that hangs up in the midst of an event, under a program that goes on
//! without it, keeps the thread busy.

use std::io;
use std::sync::mpsc::{self, Receiver, Sender, TryRecvError};
use std::thread;
use std::time::Duration;

use crossterm::event::{self, Event};

/// What is read.
pub struct Events(Receiver<Event>);

impl Events {
    /// Begins to read.
    pub fn read() -> io::Result<Self> {
        let (sender, events) = mpsc::channel();
        thread::Builder::new()
            .name("terminal".to_owned())
            .spawn(move || {
                // An error ends the thread, and so the channel, of which the frame loop hears.
                while is_there() && pass_on(&sender).is_ok() {}
            })?;
        Ok(Self(events))
    }

    /// The next, if one has come. An error where the terminal has hung up, so that there will be
    /// none.
    pub fn next(&self) -> io::Result<Option<Event>> {
        match self.0.try_recv() {
            Ok(event) => Ok(Some(event)),
            Err(TryRecvError::Empty) => Ok(None),
            Err(TryRecvError::Disconnected) => Err(io::ErrorKind::BrokenPipe.into()),
        }
    }
}

/// Passes on what has come.
fn pass_on(events: &Sender<Event>) -> io::Result<()> {
    while event::poll(Duration::ZERO)? {
        let sent = events.send(event::read()?);
        sent.map_err(|_| io::ErrorKind::BrokenPipe)?;
    }
    Ok(())
}

/// Waits until something has come, or a signal, and says whether the terminal has not hung up.
fn is_there() -> bool {
    let mut terminal = libc::pollfd {
        fd: libc::STDIN_FILENO,
        events: libc::POLLIN,
        revents: 0,
    };
    // SAFETY: one record, which outlives the call.
    unsafe { libc::poll(&raw mut terminal, 1, -1) };
    terminal.revents & (libc::POLLHUP | libc::POLLERR | libc::POLLNVAL) == 0
}
