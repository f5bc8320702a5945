//! All tests of the tracer from outside. They are one program, because linking several takes
//! longer.

#![allow(clippy::print_stdout, reason = "the harness shows it with a failed test")]

mod command_line;
mod frames;
mod game;
mod links;
mod manifests;
mod measured_numbers;
mod prelude;
mod recorder;
mod speed;
mod whitted;
