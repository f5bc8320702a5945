//! Reads SPU code from files, checks it against the model of the pipelines, and schedules it.
//!
//! [`schedule()`] takes plain assembly and writes the same code for both pipes: blocks by list
//! scheduling, counted loops by software pipelining. [`check::check`] compares the notes in a
//! source with the model. Both use [`code::Code`], which holds the words, functions, labels and
//! source lines of a file. They need only the instruction table and the pipelines ([`spu_isa`]),
//! not an emulated machine.

pub mod check;
pub mod code;
mod schedule;

pub use schedule::{
    Figures, Kind, LoopReport, Outcome, ScheduleError, Scheduled, Unschedulable, schedule,
};

/// A hash of the scheduler's sources. Schedules that were made by another scheduler may differ.
pub const SOURCES: &str = env!("SPU_SCHEDULER_SOURCES");

/// The examples of the readme.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
