//! Compiles traces of SPU code for the host.
//!
//! A [`Trace`] is a path that an SPU took. [`Compiler::compile`] makes a *unit* of it: a function of
//! the host that does to registers, local store and FPSCR what the instructions on that path do,
//! for as long as the SPU takes the same path again. [`Cpu::enter`] runs units until something has
//! to be left to an interpreter.
//!
//! What is exact here is exact for every input or tells that it is not: a unit whose arithmetic
//! meets what the host can't do as an SPU does leaves everything as it was at its last commit, and
//! reports [`Exit::Failed`]. docs/emulator.md says how.
//!
//! Only hosts with x86-64, AVX2 and FMA have a compiler: [`Compiler::new`] gives `None` on others.
#![cfg_attr(
    not(target_arch = "x86_64"),
    doc = "This host has none, so the crate is empty."
)]
#![cfg(target_arch = "x86_64")]

mod compiler;
mod cpu;
mod emit;
mod host;
mod tables;
mod trace;
mod way;

pub use compiler::{Compiler, Unit};
pub use cpu::{Cpu, Exit, Passage, Storage};
pub use tables::Estimates;
pub use trace::{MOST_STEPS, Step, Trace, can_compile};
pub use way::{Steps, Way};
