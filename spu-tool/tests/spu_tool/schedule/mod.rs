//! Tests `spu schedule`: its output does what the plain source does, and takes the cycles in its
//! notes.

mod errors;
mod kept;
mod kernels;
mod programs;
mod support;
