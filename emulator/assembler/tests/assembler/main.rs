//! Tests of the assembler: its bytes against the SPU binutils, its messages, its programs.

mod binutils;
mod messages;
mod programs;
mod random;
