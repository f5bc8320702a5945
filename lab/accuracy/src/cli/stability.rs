//! `cellray-bench stability`: the stress suite and the guarantees.

use std::io::Write as _;
use std::path::PathBuf;
use std::process::ExitCode;

use accuracy::stability::regressions::{Regressions, keep};
use accuracy::stability::{self, Size};
use clap::Args;

use super::Outcome;

/// Run the stress suite and check what is guaranteed of scenes.
#[derive(Args)]
pub struct Arguments {
    /// Seed of the random inputs
    #[arg(long, default_value_t = kernels::bench::SEED, value_name = "N", allow_negative_numbers = true)]
    seed: u64,
    /// Ten times as many cases
    #[arg(long)]
    full: bool,
    /// A tenth of the cases, for slow hosts
    #[arg(long, conflicts_with = "full")]
    quick: bool,
    /// Try this family alone
    #[arg(long, value_name = "FAMILY", value_parser = family)]
    only: Option<String>,
    /// Write the report as JSON too
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// Write each family's worst inputs to this folder, to be tried again by later versions
    #[arg(long, value_name = "FOLDER")]
    keep: Option<PathBuf>,
}

/// A family's name.
fn family(name: &str) -> Result<String, String> {
    let names = stability::names().map_err(|error| error.to_string())?;
    if names.contains(&name) {
        Ok(name.to_owned())
    } else {
        Err(format!("there are {}", names.join(", ")))
    }
}

pub fn run(arguments: &Arguments) -> Outcome {
    let size = match (arguments.quick, arguments.full) {
        (true, _) => Size::Quick,
        (_, true) => Size::Full,
        _ => Size::Default,
    };
    let kept = Regressions::kept()?;
    eprintln!("cellray-bench: seed {}", arguments.seed);
    let only = arguments.only.as_deref();
    let report = stability::run(size, arguments.seed, only, &kept)?;
    if let Some(path) = &arguments.json {
        let text = serde_json::to_string_pretty(&report.json())?;
        std::fs::write(path, text + "\n").map_err(|e| format!("{}: {e}", path.display()))?;
    }
    if let Some(folder) = &arguments.keep {
        keep(&report, folder)?;
    }
    write!(std::io::stdout().lock(), "{report}")?;
    Ok(if report.held() {
        ExitCode::SUCCESS
    } else {
        ExitCode::FAILURE
    })
}
