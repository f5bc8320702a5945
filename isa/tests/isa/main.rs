//! The instruction table and the pipelines: one program, since most of the time that a test
//! program takes is its linking.

mod account;
mod branches;
mod loops;
mod objdump;
mod rules;
mod sequences;
mod state;
mod table;
