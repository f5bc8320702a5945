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
//! The compiler needs a host with x86-64, AVX2 and FMA, or the feature `wasm` in a program that is
//! WebAssembly itself. On an x86-64 host without AVX2 or FMA, [`CodeCache::new`] returns `None`.
//! With the feature, the module `wasm` emits them on every host, for tests.
#![cfg_attr(
    not(any(target_arch = "x86_64", feature = "wasm")),
    doc = "This host is no x86-64, so the crate is empty."
)]
#![cfg(any(target_arch = "x86_64", feature = "wasm"))]

#[cfg(any(target_arch = "x86_64", target_arch = "wasm32"))]
#[cfg_attr(target_arch = "wasm32", path = "wasm/compiler.rs")]
mod compiler;
#[cfg(any(target_arch = "x86_64", target_arch = "wasm32"))]
mod cpu;
#[cfg(target_arch = "x86_64")]
mod emit;
mod exit;
mod float_mode;
#[cfg(any(target_arch = "x86_64", target_arch = "wasm32"))]
#[cfg_attr(target_arch = "wasm32", path = "wasm/host.rs")]
mod host;
#[cfg(target_arch = "x86_64")]
mod tables;
mod trace;
#[cfg(any(target_arch = "x86_64", target_arch = "wasm32"))]
mod unit;
#[cfg(feature = "wasm")]
pub mod wasm;

#[cfg(target_arch = "wasm32")]
pub use compiler::Interpret;
#[cfg(any(target_arch = "x86_64", target_arch = "wasm32"))]
pub use compiler::{CodeCache, Compiler};
#[cfg(any(target_arch = "x86_64", target_arch = "wasm32"))]
pub use cpu::{Cpu, Passage, Storage, WATCH_LOADS, WATCH_STORES};
pub use exit::Exit;
pub use float_mode::{FloatMode, Steps};
pub use trace::{MAX_STEPS, Step, Trace, can_compile};
#[cfg(any(target_arch = "x86_64", target_arch = "wasm32"))]
pub use unit::{Estimates, Tier, Unit, UnitOptions};
