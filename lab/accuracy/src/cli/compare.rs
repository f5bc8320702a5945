//! `cellray-bench compare`: a console's report against the model.

use std::fs;
use std::path::PathBuf;
use std::process::ExitCode;

use clap::Args;

use super::Outcome;

/// Compare a console's report with the model, row by row
///
/// Rows that leave their band are marked. Instructions with other results are printed as a patch
/// to lab/console/corners.txt.
#[derive(Args)]
pub struct Arguments {
    /// The file that ./report has written on the console
    report: PathBuf,
    /// The folder with the folder `scenes`, for the pictures
    #[arg(long, default_value = ".", value_name = "FOLDER")]
    folder: PathBuf,
    /// Compare frames a second, too: traces ten frames in simulated time, in some minutes
    #[arg(long)]
    frames: bool,
}

pub fn run(arguments: &Arguments) -> Outcome {
    let named = |error: String| format!("{}: {error}", arguments.report.display());
    let report = fs::read_to_string(&arguments.report).map_err(|error| named(error.to_string()))?;
    let found = console::compare::compare(&report, &arguments.folder, arguments.frames)
        .map_err(|error| named(error.to_string()))?;
    messages::write_data(&found.text)?;
    Ok(if found.differences == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}
