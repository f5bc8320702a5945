//! The profile of a run, program by program: the cost of functions, lines and instructions.
//!
//! [`spu_emulator::profile`] defines which instruction each cycle is charged to.

mod figures;
mod json;
mod listing;
mod view;

pub use figures::{FunctionFigures, LineFigures};
pub use view::{View, ViewError};
