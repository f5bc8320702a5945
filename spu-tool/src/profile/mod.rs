//! The profile of a run, program by program: functions, lines and instructions by their cost.
//!
//! What is charged to whom is [`spu_emulator::profile`]'s.

mod figures;
mod json;
mod listing;
mod view;

pub use figures::{FunctionFigures, LineFigures};
pub use view::{View, ViewError};
