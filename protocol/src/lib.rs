//! What the PPU program and the SPU program have agreed on.
//!
//! [`layout`] has the records in main memory and in local store, and all numbers in them; it is
//! written as Rust types, and [`assembler`] prints it for the SPU's sources. [`formulation`] names
//! the ways to intersect a ray with a shape, and the kernels of each. `docs/work-unit.md` says in
//! words when each record is read and written.

pub mod assembler;
pub mod formulation;
pub mod layout;
