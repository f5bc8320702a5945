//! Tests of simulated time with small programs: it must be the same in every run, and as long as
//! the constants require.

mod accounts;
mod deterministic;
mod figures;
mod hops;
mod in_turn;
mod memoised;
mod ppe;
mod races;
mod support;
mod throughput;
