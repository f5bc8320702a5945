//! Where a session's events come from, when a loop asks for them.

use std::ops::ControlFlow;

use crate::framebuffer::Interrupted;
use crate::game::InputEvent;

/// Where input comes from.
pub trait InputSource {
    /// Appends what has happened since the last call; with [`ControlFlow::Break`] the session ends
    /// before the frame at hand.
    fn poll(&mut self, events: &mut Vec<InputEvent>) -> std::io::Result<ControlFlow<()>>;

    /// Told from time to time, while a frame is traced, which part of it is done, 0 to 1. A window
    /// answers its system then.
    fn tracing(&mut self, _part: f64) {}
}

/// No input at all.
#[derive(Clone, Copy, Debug, Default)]
pub struct NoInput;

impl InputSource for NoInput {
    fn poll(&mut self, _events: &mut Vec<InputEvent>) -> std::io::Result<ControlFlow<()>> {
        Ok(ControlFlow::Continue(()))
    }
}

/// No input, up to a signal.
impl InputSource for Interrupted {
    fn poll(&mut self, _events: &mut Vec<InputEvent>) -> std::io::Result<ControlFlow<()>> {
        Ok(match self.signal() {
            Some(_) => ControlFlow::Break(()),
            None => ControlFlow::Continue(()),
        })
    }
}
