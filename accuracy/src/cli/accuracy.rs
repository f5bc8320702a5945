//! `cellray-bench accuracy`: run time against error.

use std::process::ExitCode;

use clap::Args;

use super::Outcome;

/// Measure run time against error of every formulation.
#[derive(Args)]
pub struct Arguments {
    /// Seed of the random rays
    #[arg(long, default_value_t = kernels::bench::SEED, value_name = "N")]
    seed: u64,
}

pub fn run(arguments: &Arguments) -> Outcome {
    eprintln!("cellray-bench: seed {}", arguments.seed);
    Ok(ExitCode::SUCCESS)
}
