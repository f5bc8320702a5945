//! Compiled code against the interpreter, which is the definition.

mod operations;
mod programs;
mod units;
