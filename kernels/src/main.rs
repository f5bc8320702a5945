//! Times and checks the kernels of the SPU program, and keeps their table in the document.

use std::path::PathBuf;
use std::process::ExitCode;

use clap::Parser;
use kernels::catalogue::{self, Kernel};
use kernels::document::{self, DocumentError};
use kernels::measure::{MeasureError, measure_all};
use kernels::schedule::{ScheduleError, Workshop};
use kernels::source::SOURCES;
use kernels::table::markdown;
use thiserror::Error;

/// Times the kernels of the SPU program by the emulator's pipelines and measures their errors;
/// makes their scheduled versions.
#[derive(Debug, Parser)]
#[command(version)]
struct Arguments {
    /// Kernels to measure; all if none is named.
    #[arg(value_name = "NAME")]
    names: Vec<String>,
    /// Print JSON instead of the table.
    #[arg(long)]
    json: bool,
    /// Write the table into a document, between its markers.
    #[arg(long, value_name = "FILE", conflicts_with = "json")]
    write: Option<PathBuf>,
    /// Fail if the document's table is not what is measured now; with --schedule and without FILE,
    /// if scheduled versions are not what would be written.
    #[arg(long, value_name = "FILE", num_args = 0..=1, conflicts_with_all = ["json", "write"])]
    check: Option<Option<PathBuf>>,
    /// Write the scheduled versions of all kernels, made of the plain ones.
    #[arg(long, conflicts_with_all = ["names", "json", "write"])]
    schedule: bool,
}

#[derive(Debug, Error)]
enum Failure {
    #[error("there is no kernel {name}; there are {known}")]
    Unknown { name: String, known: String },
    #[error("--check takes FILE, or --schedule beside it")]
    CheckOfWhat,
    #[error(transparent)]
    Measure(#[from] MeasureError),
    #[error(transparent)]
    Schedule(#[from] ScheduleError),
    #[error(transparent)]
    Document(#[from] DocumentError),
    #[error("the table as JSON: {0}")]
    Json(#[from] serde_json::Error),
}

fn main() -> ExitCode {
    match run(&Arguments::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("kernels: {error}");
            ExitCode::FAILURE
        }
    }
}

fn run(arguments: &Arguments) -> Result<(), Failure> {
    match (arguments.schedule, &arguments.check) {
        (true, None) => return Ok(Workshop::here()?.write(SOURCES)?),
        (true, Some(None)) => return Ok(Workshop::here()?.check(SOURCES)?),
        (true, Some(Some(_))) | (false, Some(None)) => return Err(Failure::CheckOfWhat),
        (false, _) => {}
    }
    let measured = measure_all(chosen(&arguments.names)?)?;
    if let Some(file) = &arguments.write {
        document::write(file, &markdown(&measured))?;
    } else if let Some(Some(file)) = &arguments.check {
        document::check(file, &markdown(&measured))?;
    } else if arguments.json {
        println!("{}", serde_json::to_string_pretty(&measured)?);
    } else {
        print!("{}", markdown(&measured));
    }
    Ok(())
}

fn chosen(names: &[String]) -> Result<Vec<&'static Kernel>, Failure> {
    if names.is_empty() {
        return Ok(catalogue::kernels().collect());
    }
    let find = |name: &String| {
        catalogue::kernels()
            .find(|kernel| kernel.name == name)
            .ok_or_else(|| Failure::Unknown {
                name: name.clone(),
                known: catalogue::kernels()
                    .map(|kernel| kernel.name)
                    .collect::<Vec<_>>()
                    .join(", "),
            })
    };
    names.iter().map(find).collect()
}
