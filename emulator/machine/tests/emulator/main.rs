//! The emulator's tests. They are one program, because linking takes most of a test program's
//! time.

#![allow(clippy::print_stdout, reason = "the harness shows it with a failed test")]

#[cfg(all(feature = "compiler", target_arch = "x86_64"))]
mod compiled;
mod filetests;
mod float;
mod instructions;
mod machine;
mod prelude;
mod simulated;
mod spu_calls;
mod support;
mod timer;
