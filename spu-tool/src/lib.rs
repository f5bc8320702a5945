//! What the tool `spu` shows: [`report`]s of code, and [`profile`]s of runs against it.
//!
//! The program itself is in `bin/spu`; its verbs are thin over this library, the
//! [scheduler](spu_scheduler) and the [emulator](spu_emulator).

pub mod profile;
pub mod report;
