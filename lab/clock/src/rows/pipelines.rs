//! Rows of the SPU's pipelines.

use super::{Row, alone, ran};
use crate::order::{Benchmark, Order};
use crate::spes::ClockError;

/// Cycles of a loop's own two instructions, of which the branch has no hint.
const LOOP: f64 = 21.0;

pub fn rows() -> Vec<Row> {
    vec![
        Row::new(
            "hint",
            "a loop of a hint and its branch, which could go after 11 cycles",
            "cycles a pass",
            ran(17.0, "a benchmark; its ratio allows up to 17.8", 0.05),
            || alone(Order::new(Benchmark::HintedLoop, 20_000)),
        ),
        Row::new(
            "branch",
            "a taken branch without a hint, after its own cycle",
            "cycles",
            ran(18.0, "a benchmark", 0.01),
            || Ok(a_hundredth(Benchmark::TakenBranches)? - 1.0),
        ),
        Row::new(
            "dfma",
            "a pair of dfma and lnop",
            "cycles",
            ran(8.0, "a benchmark", 0.01),
            || a_hundredth(Benchmark::DoublePairs),
        ),
    ]
}

/// Cycles of one of the hundred parts of a pass.
fn a_hundredth(benchmark: Benchmark) -> Result<f64, ClockError> {
    Ok((alone(Order::new(benchmark, 2_000))? - LOOP) / 100.0)
}
