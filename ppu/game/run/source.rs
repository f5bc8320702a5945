//! Sources of input events, which the frame loop polls.

use std::ops::ControlFlow;

use crate::framebuffer::Interrupted;
use crate::game::InputEvent;

/// A source of input events.
pub trait InputSource {
    /// Appends the events since the last call. [`ControlFlow::Break`] ends the session before the
    /// current frame.
    ///
    /// # Errors
    /// A device fails; this ends the session.
    fn poll(&mut self, events: &mut Vec<InputEvent>) -> std::io::Result<ControlFlow<()>>;

    /// Called from time to time while a frame is traced, with the part of it that is done, 0 to 1.
    /// A window uses it to respond to its window system.
    fn tracing(&mut self, _part: f64) {}
}

/// A source without any input.
#[derive(Clone, Copy, Debug, Default)]
pub struct NoInput;

impl InputSource for NoInput {
    fn poll(&mut self, _events: &mut Vec<InputEvent>) -> std::io::Result<ControlFlow<()>> {
        Ok(ControlFlow::Continue(()))
    }
}

/// A source without events, which ends the session at a signal.
impl InputSource for Interrupted {
    fn poll(&mut self, _events: &mut Vec<InputEvent>) -> std::io::Result<ControlFlow<()>> {
        Ok(match self.signal() {
            Some(_) => ControlFlow::Break(()),
            None => ControlFlow::Continue(()),
        })
    }
}
