//! The protocol between the PPU program and the SPU program.
//!
//! [`layout`] defines the records in main memory and in local store, and all constants, as Rust
//! types. [`assembler`] prints them for the SPU's sources. [`formulation`] names the ways to
//! intersect a ray with a shape, and the kernels of each. `docs/frame.md` describes when each
//! record is read and written.

pub mod assembler;
pub mod formulation;
pub mod layout;
