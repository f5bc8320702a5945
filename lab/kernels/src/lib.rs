//! Checks and times the kernels of the SPU program, one by one.
//!
//! This crate calls kernels from outside ([`Bench`]), has the data about each of them ([`source`]:
//! its header; [`catalogue`]: its cases and how its error is measured), makes schedules and images
//! ([`workshop`], [`set`]), and writes the table of the results ([`table`]). It does not depend
//! on frames. Invariant: every number in the table is measured. The numbers that headers state
//! are next to it.

pub mod bench;
pub mod cases;
pub mod catalogue;
pub mod check;
pub mod description;
pub mod document;
pub mod eye_records;
pub mod flat_records;
pub mod images;
pub mod loops;
pub mod measure;
pub mod prelude;
pub mod records;
pub mod set;
pub mod single;
pub mod source;
pub mod table;
pub mod time;
pub mod vector;
pub mod workshop;

pub use bench::{Bench, Place, Returned, Version, random};
