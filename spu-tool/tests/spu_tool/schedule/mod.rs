//! `spu schedule`: what it writes does what the plain source does, and is timed as its notes say.

mod errors;
mod kept;
mod kernels;
mod programs;
mod support;
