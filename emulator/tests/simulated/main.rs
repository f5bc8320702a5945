//! Simulated time, by small programs: that it is the same in every run, and that it is as long as the
//! constants say.

mod accounts;
mod deterministic;
mod hops;
mod ppe;
mod profile;
#[path = "../spu_program/mod.rs"]
mod spu_program;
mod support;
mod throughput;
