//! Rows of the SPU's pipelines.

use super::{Row, alone, ran};
use crate::order::{Benchmark, Order};

pub fn rows() -> Vec<Row> {
    let a_pass = |benchmark, parts: f64| move || Ok(alone(Order::new(benchmark, 20_000))? / parts);
    vec![
        Row::new(
            "hint",
            "a loop of a hint and its branch, which could go after 11 cycles",
            "cycles a pass",
            ran(17.0, "SpuTest; its ratio allows up to 17.8", 0.05),
            a_pass(Benchmark::HintedLoop, 1.0),
        ),
        Row::new(
            "branch",
            "a taken branch without a hint, after its own cycle",
            "cycles",
            ran(18.0, "SpuTest", 0.02),
            move || Ok((alone(Order::new(Benchmark::TakenBranches, 2_000))? - 20.0) / 100.0 - 1.0),
        ),
        Row::new(
            "dfma",
            "a pair of dfma and lnop",
            "cycles",
            ran(8.0, "SpuTest", 0.03),
            a_pass(Benchmark::DoublePairs, 100.0),
        ),
    ]
}
