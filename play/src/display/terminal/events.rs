//! Reads the terminal's events in a separate thread.
//!
//! A read waits if the bytes so far are not a complete event, for example after Alt and a bracket.
//! Reads of a terminal that has hung up return nothing, forever. Invariant: the frame loop waits
//! for neither, and the thread holds nothing that the program needs to end.
//!
//! Known weakness: if a terminal hangs up in the middle of an event, and the program continues
//! without it, the thread stays busy.

use std::io;
use std::sync::mpsc::{self, Receiver, Sender, TryRecvError};
use std::thread;
use std::time::{Duration, Instant};

use crossterm::event::{self, Event};

/// The events that the thread has read, each with the time at which it was read. That time doesn't
/// depend on how long frames take.
pub struct Events(Receiver<(Event, Instant)>);

impl Events {
    pub fn read() -> io::Result<Self> {
        let (sender, events) = mpsc::channel();
        thread::Builder::new().name("terminal".to_owned()).spawn(move || {
            // An error ends the thread and closes the channel, which the frame loop notices.
            while is_there() && pass_on(&sender).is_ok() {}
        })?;
        Ok(Self(events))
    }

    /// The next event, if there is one.
    ///
    /// # Errors
    /// The terminal has hung up, so there will be no more events.
    pub fn next(&self) -> io::Result<Option<(Event, Instant)>> {
        match self.0.try_recv() {
            Ok(event) => Ok(Some(event)),
            Err(TryRecvError::Empty) => Ok(None),
            Err(TryRecvError::Disconnected) => Err(io::ErrorKind::BrokenPipe.into()),
        }
    }
}

fn pass_on(events: &Sender<(Event, Instant)>) -> io::Result<()> {
    while event::poll(Duration::ZERO)? {
        let event = event::read()?;
        let sent = events.send((event, Instant::now()));
        sent.map_err(|_| io::ErrorKind::BrokenPipe)?;
    }
    Ok(())
}

/// Waits for input or a signal; `false` if the terminal has hung up.
fn is_there() -> bool {
    let mut terminal = libc::pollfd { fd: libc::STDIN_FILENO, events: libc::POLLIN, revents: 0 };
    // SAFETY: one record, which outlives the call.
    unsafe { libc::poll(&raw mut terminal, 1, -1) };
    terminal.revents & (libc::POLLHUP | libc::POLLERR | libc::POLLNVAL) == 0
}
