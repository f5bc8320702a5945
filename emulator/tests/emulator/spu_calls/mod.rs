//! PPE-assisted library calls, made as the guest makes them: blocks of cells in local store.
//!
//! Provenance: texts and numbers that `printf` and `scanf` give are compared with the host's C
//! library, which serves the calls on the console; layouts and results are libspe2's.

mod libea;
mod posix;
mod print;
mod scan;
mod streams;
mod support;
