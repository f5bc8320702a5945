//! `cellray-bench stability`: the stress suite and the guarantees.

use std::process::ExitCode;

use clap::Args;

use super::Outcome;

/// Run the stress suite and check what is guaranteed of scenes.
#[derive(Args)]
pub struct Arguments {
    /// Seed of the random inputs
    #[arg(long, default_value_t = kernels::bench::SEED, value_name = "N")]
    seed: u64,
}

pub fn run(arguments: &Arguments) -> Outcome {
    eprintln!("cellray-bench: seed {}", arguments.seed);
    Ok(ExitCode::SUCCESS)
}
