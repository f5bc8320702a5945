//! Checks and times the kernels of the SPU program, one by one.
//!
//! Owns how a kernel is called from outside ([`Bench`]), what is known of each ([`source`]: its
//! header; [`catalogue`]: ways to call it, and how its error is measured), how its schedule and
//! the images are made ([`workshop`], [`set`]) and the table of all that ([`table`]). Knows
//! nothing of frames. Invariant: no number in the table is copied from anywhere; what a header
//! states stands beside it.

pub mod bench;
pub mod cases;
pub mod catalogue;
pub mod check;
pub mod document;
pub mod eye_records;
pub mod flat_records;
pub mod images;
pub mod loops;
pub mod measure;
pub mod records;
pub mod set;
pub mod single;
pub mod source;
pub mod table;
pub mod time;
pub mod vector;
pub mod workshop;

pub use bench::{Bench, Place, Returned, Version, random};
