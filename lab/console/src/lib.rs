//! What the owner of a console runs first: [`start`] finds out what is missing and shows a moving
//! picture, and [`report`] writes a file that says how the console differs from the model.
//! [`compare`] reads that file on a PC.
//!
//! Invariant: a step of the report that fails, crashes or hangs ends neither the report nor another
//! step, because each is a process of its own ([`step`]).

pub mod compare;
pub mod corners;
pub mod pictures;
pub mod report;
pub mod start;
pub mod step;

/// What stops a command or a step.
pub type Failure = Box<dyn std::error::Error>;
