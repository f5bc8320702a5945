//! Tests of the interpreter, instruction by instruction.

mod control;
pub mod machine;
mod shifts;
mod shuffle;
mod vectors;
