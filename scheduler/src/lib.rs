//! SPU code in files: read, held to the model of the pipelines, and scheduled.
//!
//! [`schedule()`] takes plain assembly and writes the same code for both pipes: blocks by list
//! scheduling, counted loops by software pipelining. [`check::check`] holds the notes in a source
//! to the model; [`code::Code`] is what both know of a file: words, functions, labels, source
//! lines. It all needs the instruction table and the pipelines ([`spu_isa`]), and no machine.

pub mod check;
pub mod code;
mod schedule;

pub use schedule::{
    Figures, LoopReport, Outcome, ScheduleError, Scheduled, Unschedulable, schedule,
};
