//! Tests `spu schedule`: its output does what the plain source does, and takes the cycles in its
//! notes.

mod addresses;
mod errors;
mod kept;
mod kernels;
mod programs;
mod support;
