//! Simulated time, by small programs: that it is the same in every run, and that it is as long as
//! the constants say.

mod accounts;
mod deterministic;
mod figures;
mod hops;
mod memoised;
mod ppe;
mod support;
mod throughput;
