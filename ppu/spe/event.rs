//! Waits for events of SPEs.

use std::ffi::{c_int, c_void};
use std::ptr::{self, NonNull};
use std::time::Duration;

use super::sys;
use super::{Context, Event, SpeError};

/// An event handler of libspe2, which is destroyed when dropped.
#[derive(Debug)]
pub struct Events(NonNull<c_void>);

// SAFETY: a handler is an epoll set, or is no more tied to a thread than one.
unsafe impl Send for Events {}

impl Events {
    /// Creates a handler that waits for nothing yet.
    ///
    /// # Errors
    /// libspe2 fails.
    pub fn create() -> Result<Self, SpeError> {
        // SAFETY: takes no arguments.
        let handler = unsafe { sys::spe_event_handler_create() };
        NonNull::new(handler).map(Self).ok_or_else(|| SpeError::last("spe_event_handler_create"))
    }

    /// Makes [`Events::wait`] report the events of this context under this number. The context
    /// must live as long as the handler.
    ///
    /// # Errors
    /// libspe2 fails.
    pub fn watch(&self, context: &Context, number: u32) -> Result<(), SpeError> {
        let mut unit = sys::spe_event_unit_t {
            events: sys::SPE_EVENT_OUT_INTR_MBOX | sys::SPE_EVENT_SPE_STOPPED,
            spe: context.as_ptr(),
            data: u64::from(number),
        };
        // SAFETY: handler and context live, and unit is valid for reading.
        let result = unsafe { sys::spe_event_handler_register(self.0.as_ptr(), &raw mut unit) };
        if result == 0 { Ok(()) } else { Err(SpeError::last("spe_event_handler_register")) }
    }

    /// Sleeps until an event, and returns the context's number and the event; `None` after the
    /// timeout.
    ///
    /// # Errors
    /// libspe2 fails.
    pub fn wait(&self, timeout: Duration) -> Result<Option<(u32, Event)>, SpeError> {
        let mut unit = sys::spe_event_unit_t { events: 0, spe: ptr::null_mut(), data: 0 };
        // At least a millisecond, because 0 would not sleep at all.
        let timeout = timeout.as_millis().clamp(1, c_int::MAX as u128) as c_int;
        // SAFETY: the handler lives, and one unit is valid for writing.
        let count = unsafe { sys::spe_event_wait(self.0.as_ptr(), &raw mut unit, 1, timeout) };
        match count {
            0 => Ok(None),
            1 if unit.events == sys::SPE_EVENT_OUT_INTR_MBOX => {
                Ok(Some((unit.data as u32, Event::Reply)))
            }
            1 => Ok(Some((unit.data as u32, Event::Stopped))),
            _ => Err(SpeError::last("spe_event_wait")),
        }
    }
}

impl Drop for Events {
    fn drop(&mut self) {
        // SAFETY: the handler lives, and has no other users.
        unsafe { sys::spe_event_handler_destroy(self.0.as_ptr()) };
    }
}
