//! Tests that compare compiled code with the interpreter, which is the reference.

mod operations;
mod programs;
mod units;
