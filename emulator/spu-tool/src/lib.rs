//! The library of the tool `spu`: [`report`]s about code, and test [`vectors`] of instructions.
//!
//! The program itself is in `bin/spu`. Its subcommands are thin layers over this library, the
//! [scheduler](spu_scheduler) and the [emulator](spu_emulator).

pub mod report;
#[cfg(feature = "cli")]
pub mod vectors;

/// The examples of the readme.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
