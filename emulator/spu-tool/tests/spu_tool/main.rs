//! Tests the program `spu` from outside: it assembles SPU programs, runs them, traces them and
//! disassembles them.
//!
//! There is no compiler for the SPU, so the programs make library calls with the sequences that
//! newlib uses (`programs/runtime.inc`): stored instructions, saved registers, `va_list`.

#![allow(clippy::print_stdout, reason = "the harness shows it with a failed test")]

mod asm;
mod charges;
mod debug;
mod dump;
mod faults;
mod gdb;
mod hour;
mod observe;
mod page;
mod profile;
mod races;
mod report;
mod run;
mod schedule;
mod support;
mod time;
mod typed;
mod vectors;
