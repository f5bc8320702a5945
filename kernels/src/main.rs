//! Times and checks the kernels of the SPU program, and keeps their table in the document.

use std::path::PathBuf;
use std::process::ExitCode;

use clap::Parser;
use kernels::bench::Bench;
use kernels::catalogue::{self, Kernel};
use kernels::document::{self, DocumentError};
use kernels::measure::{Measured, measure};
use kernels::table::markdown;
use thiserror::Error;

/// Times the kernels of the SPU program by the emulator's pipelines and measures their errors.
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
    #[arg(long, value_name = "FILE", conflicts_with_all = ["names", "json"])]
    write: Option<PathBuf>,
    /// Fail if the document's table is not what is measured now.
    #[arg(long, value_name = "FILE", conflicts_with_all = ["names", "json", "write"])]
    check: Option<PathBuf>,
}

#[derive(Debug, Error)]
enum Failure {
    #[error("there is no kernel {name}; there are {known}")]
    Unknown { name: String, known: String },
    #[error("{0}: no source, or its header has not the house's form")]
    Header(&'static str),
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
    let measured = measure_all(&chosen(&arguments.names)?)?;
    if let Some(file) = &arguments.write {
        document::write(file, &markdown(&measured))?;
    } else if let Some(file) = &arguments.check {
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

fn measure_all(kernels: &[&Kernel]) -> Result<Vec<Measured>, Failure> {
    let mut bench = Bench::new();
    let measured = kernels
        .iter()
        .map(|kernel| measure(&mut bench, kernel).ok_or(Failure::Header(kernel.name)));
    measured.collect()
}
