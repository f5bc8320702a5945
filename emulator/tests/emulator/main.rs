//! The emulator's tests: one program, since most of the time that a test program takes is its
//! linking.

#[cfg(all(feature = "compiler", target_arch = "x86_64"))]
mod compiled;
mod float;
mod instructions;
mod machine;
mod program;
mod random;
mod simulated;
mod spu_calls;
mod timer;
