//! The first programs for the owner of a console: [`start`] finds out what is missing and shows a
//! moving picture, and [`report`] writes a file with the differences of the console from the model.
//! [`compare`] reads that file on a PC.
//!
//! Invariant: a step of the report that fails, crashes or hangs ends neither the report nor another
//! step, because each is a process of its own ([`step`]).

mod command_line;
pub mod compare;
pub mod corners;
pub mod pictures;
pub mod report;
pub mod start;
pub mod step;

pub use command_line::main;

/// The reason that a command or a step ends early.
pub type Failure = Box<dyn std::error::Error>;
