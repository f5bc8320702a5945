//! Tests of simulated time with small programs: it must be the same in every run, and as long as
//! the constants require.

pub mod accounts;
mod deterministic;
mod disturbance;
mod figures;
mod in_turn;
mod memoised;
mod ppe;
mod throughput;
