//! PPE-assisted library calls, made as the guest makes them: with blocks of cells in local store.
//!
//! Provenance: the results of `printf` and `scanf` are compared with the host's C library, because
//! the console's C library serves these calls. Layouts and results are libspe2's.

mod libea;
mod posix;
mod print;
mod scan;
mod streams;
mod support;
