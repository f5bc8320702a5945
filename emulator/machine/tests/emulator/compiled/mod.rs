//! Tests that compare compiled code with the interpreter, which is the reference.

mod double_precision;
mod operations;
mod programs;
mod units;
mod vectors;
mod wasm;
