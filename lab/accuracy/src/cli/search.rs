//! `cellray-bench search`: small scenes with the worst pictures.

use std::path::PathBuf;
use std::process::ExitCode;

use accuracy::run::RunError;
use accuracy::search::{self, KeptRow};
use clap::Args;

use super::Outcome;

/// Search for small scenes whose pictures have the most wrong pixels over those that single
/// precision must get wrong
#[derive(Args)]
pub struct Arguments {
    /// Seed of the random scenes
    #[arg(
        long,
        default_value_t = kernels::bench::SEED,
        value_name = "N",
        allow_negative_numbers = true
    )]
    seed: u64,
    /// The number of scenes to try
    #[arg(long, default_value_t = 400, value_name = "N", allow_negative_numbers = true)]
    count: u32,
    /// Write the worst scenes to this folder, for a test to try again
    #[arg(long, value_name = "FOLDER")]
    keep: Option<PathBuf>,
}

pub fn run(arguments: &Arguments) -> Outcome {
    let cases = search::search(arguments.seed, arguments.count, |case| {
        messages::print!("cellray-bench: {}: {:.1}", case.row.scene, case.row.excess());
    })
    .map_err(RunError::Picture)?;
    if let Some(folder) = &arguments.keep {
        search::keep(&cases, folder)?;
    }
    let line = |case: &search::Case| {
        let KeptRow { scene, wrong_pixels, floor } = &case.row;
        let excess = case.row.excess();
        format!("{scene:24}  {wrong_pixels:5} wrong  floor {floor:4}  excess {excess:5.1}\n")
    };
    messages::write_data(cases.iter().map(line).collect::<String>())?;
    Ok(ExitCode::SUCCESS)
}
