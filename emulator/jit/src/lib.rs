//! Compiles traces of SPU code for the host.
//!
//! A [`Trace`] is a path that an SPU took through its code. [`Compiler::compile`] translates it to
//! a *unit*: a function of the host that changes registers, local store and FPSCR as the
//! instructions on that path do, as long as the SPU takes the same path again. [`Cpu::enter`] runs
//! units until the interpreter must continue.
//!
//! Units never give a wrong result. If an operation meets numbers for which the host computes
//! something else than an SPU, the unit restores the state of its last commit and reports
//! [`Exit::Failed`]. See docs/emulator.md.
//!
//! The compiler needs a host with x86-64, AVX2 and FMA. On an x86-64 host without AVX2 or FMA,
//! [`CodeCache::new`] returns `None`.
#![cfg_attr(not(target_arch = "x86_64"), doc = "This host is no x86-64, so the crate is empty.")]
#![cfg(target_arch = "x86_64")]

mod compiler;
mod cpu;
mod emit;
mod float_mode;
mod host;
mod tables;
mod trace;

pub use compiler::{CodeCache, Compiler, Tier, Unit, UnitOptions};
pub use cpu::{Cpu, Exit, Passage, Storage, WATCH_LOADS, WATCH_STORES};
pub use float_mode::{FloatMode, Steps};
pub use tables::Estimates;
pub use trace::{MAX_STEPS, Step, Trace, can_compile};
