//! `cellray-bench clock`: the rows of the clock, on the machine that it runs on.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::Args;
use clock::document::{renewed, table};
use clock::results::{Machine, Results};
use clock::rows;

use super::Outcome;

/// Measure pipelines, memory and interconnect by small SPU programs
///
/// On a console this measures the console. Elsewhere it measures the emulator's model, in simulated
/// time.
#[derive(Args)]
pub struct Arguments {
    /// Measure only this row; may be repeated
    #[arg(long, value_name = "ROW")]
    only: Vec<String>,
    /// Write the results and a description of the machine as JSON
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
    /// Write docs/timing.md and lab/clock/model.json of a working copy; only for the emulator
    #[arg(long, conflicts_with = "only")]
    write: bool,
}

pub fn run(arguments: &Arguments) -> Outcome {
    let rows = rows::named(&arguments.only)?;
    let mut values = Vec::new();
    for row in &rows {
        messages::print!("cellray-bench: {}", row.name);
        values.push(row.measure()?);
    }
    messages::write_data(table(&rows, &values))?;
    if arguments.write {
        let model = serde_json::to_string_pretty(&values)? + "\n";
        save(Path::new("lab/clock/model.json"), &model)?;
        let path = Path::new("docs/timing.md");
        let document =
            fs::read_to_string(path).map_err(|error| format!("{}: {error}", path.display()))?;
        let document = renewed(&document, &rows, &values)
            .ok_or_else(|| format!("{}: it has no lines around the table", path.display()))?;
        save(path, &document)?;
    }
    if let Some(path) = &arguments.out {
        let results = Results {
            version: env!("CARGO_PKG_VERSION").to_owned(),
            machine: Machine::here(),
            rows: values,
        };
        save(path, &(serde_json::to_string_pretty(&results)? + "\n"))?;
    }
    Ok(ExitCode::SUCCESS)
}

fn save(path: &Path, text: &str) -> Result<(), String> {
    fs::write(path, text).map_err(|error| format!("{}: {error}", path.display()))
}
