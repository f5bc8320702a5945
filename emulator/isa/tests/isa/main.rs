//! Tests of the instruction table and the pipelines. They are one program, because linking takes
//! most of a test program's time.

mod account;
mod branches;
mod loops;
mod objdump;
mod rules;
mod sequences;
mod state;
mod table;
