//! The program `spu` from outside: SPU programs assembled here and now, run, traced and taken
//! apart.
//!
//! No compiler for the SPU is at hand, so the programs make library calls in the sequences that
//! newlib uses (`programs/runtime.inc`): stored instructions, saved registers, `va_list`.

mod charges;
mod dump;
mod faults;
mod hour;
mod observe;
mod profile;
mod random;
mod report;
mod run;
mod schedule;
mod support;
mod time;
