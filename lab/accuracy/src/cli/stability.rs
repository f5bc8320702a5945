//! `cellray-bench stability`: the stress suite and the guarantees.

use std::path::PathBuf;
use std::process::ExitCode;

use accuracy::stability::regressions::{Regressions, keep};
use accuracy::stability::{self, Size};
use clap::Args;

use super::Outcome;

/// Run the stress suite and check the guarantees about scenes
#[derive(Args)]
pub struct Arguments {
    /// Seed of the random inputs
    #[arg(long, default_value_t = kernels::bench::SEED, value_name = "N", allow_negative_numbers = true)]
    seed: u64,
    /// Try this many times as many cases
    #[arg(long, default_value_t = 1, value_name = "N", allow_negative_numbers = true)]
    #[arg(value_parser = clap::value_parser!(u32).range(1..))]
    times: u32,
    /// Try a tenth of the cases, for slow hosts
    #[arg(long, conflicts_with = "times")]
    quick: bool,
    /// Try only this family
    #[arg(long, value_name = "FAMILY", value_parser = family)]
    only: Option<String>,
    /// Also write the report as JSON
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// Write each family's worst inputs to this folder, for later versions to try again
    #[arg(long, value_name = "FOLDER")]
    keep: Option<PathBuf>,
}

/// Parses a family's name.
fn family(name: &str) -> Result<String, String> {
    let names = stability::names().map_err(|error| error.to_string())?;
    if names.contains(&name) {
        Ok(name.to_owned())
    } else {
        Err(format!("the families are {}", names.join(", ")))
    }
}

pub fn run(arguments: &Arguments) -> Outcome {
    let size = if arguments.quick { Size::Quick } else { Size::Times(arguments.times) };
    let kept = Regressions::kept()?;
    messages::print!("cellray-bench: seed {}", arguments.seed);
    let only = arguments.only.as_deref();
    let report = stability::run(size, arguments.seed, only, &kept)?;
    if let Some(path) = &arguments.json {
        let text = serde_json::to_string_pretty(&report.json())?;
        std::fs::write(path, text + "\n").map_err(|e| format!("{}: {e}", path.display()))?;
    }
    if let Some(folder) = &arguments.keep {
        keep(&report, folder)?;
    }
    messages::write_data(report.to_string())?;
    Ok(if report.held() { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}
