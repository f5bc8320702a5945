//! Times and checks the kernels of the SPU program, shows their schedules, and maintains their
//! table in the document.

use std::io;
use std::path::PathBuf;
use std::process::ExitCode;

use clap::builder::PossibleValuesParser;
use clap::{Args, Parser, Subcommand};
use kernels::catalogue::{self, Kernel};
use kernels::check::{CheckError, check};
use kernels::document::{self, DocumentError};
use kernels::images;
use kernels::measure::{MeasureError, measure_all};
use kernels::set::{self, Kernels};
use kernels::table::markdown;
use kernels::workshop::{Workshop, WorkshopError};
use protocol::formulation::{self, Formulations, SPHERES, TRIANGLES};
use thiserror::Error;

/// Measures, checks and shows the kernels of the SPU program
#[derive(Debug, Parser)]
#[command(version)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Time kernels with the emulator's pipelines and measure their errors
    Measure(Measure),
    /// Print a kernel's schedule, with the cycle and pipe of each instruction
    Show {
        /// The kernel
        name: String,
    },
    /// Check everything about a kernel: schedule, ABI, error, time, and its tests against its twin
    Check {
        /// The kernels
        #[arg(value_name = "NAME", required = true)]
        names: Vec<String>,
    },
    /// Build the tracer's SPU program with other formulations, for cellray's --program
    Image {
        /// Formulation for spheres
        #[arg(long, value_name = "FORMULATION", value_parser = PossibleValuesParser::new(SPHERES.iter().map(|sphere| sphere.name)))]
        sphere: String,
        /// Formulation for triangles
        #[arg(long, value_name = "FORMULATION", default_value = Formulations::standard().triangle.name, value_parser = PossibleValuesParser::new(TRIANGLES.iter().map(|triangle| triangle.name)))]
        triangle: String,
        /// The file to write
        #[arg(long, value_name = "F.elf")]
        out: PathBuf,
    },
    /// Write the images that cellray ships to spu/images, for builds without an SPU assembler
    Images {
        /// Write nothing, and fail if an image is stale
        #[arg(long)]
        check: bool,
    },
    /// Fill a folder with all images, for a machine that has neither sources nor an SPU assembler;
    /// there, the variable CELLRAY_KERNELS must name the folder
    Pack {
        /// The folder
        folder: PathBuf,
    },
}

#[derive(Debug, Args)]
struct Measure {
    /// Kernels to measure; the default is all
    #[arg(value_name = "NAME")]
    names: Vec<String>,
    /// Print JSON instead of the table
    #[arg(long)]
    json: bool,
    /// Write the table into this document, between its markers
    #[arg(long, value_name = "FILE", conflicts_with = "json")]
    write: Option<PathBuf>,
    /// Fail if the table in this document differs from the measurement
    #[arg(long, value_name = "FILE", conflicts_with_all = ["json", "write"])]
    check: Option<PathBuf>,
}

#[derive(Debug, Error)]
enum Failure {
    #[error("there is no kernel {name}; the kernels are {known}")]
    Unknown { name: String, known: String },
    #[error(transparent)]
    Measure(#[from] MeasureError),
    #[error(transparent)]
    Workshop(#[from] WorkshopError),
    #[error(transparent)]
    Check(#[from] CheckError),
    #[error(transparent)]
    Document(#[from] DocumentError),
    #[error("can't write the table as JSON: {0}")]
    Json(#[from] serde_json::Error),
    #[error(transparent)]
    Output(#[from] io::Error),
    #[error("{}: {source}", path.display())]
    File { path: PathBuf, source: io::Error },
}

fn main() -> ExitCode {
    match run(Arguments::parse().command) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            messages::print!("kernels: {error}");
            ExitCode::FAILURE
        }
    }
}

fn run(command: Command) -> Result<(), Failure> {
    match command {
        Command::Measure(arguments) => measure(&arguments),
        Command::Show { name } => {
            let workshop = Workshop::here()?;
            let sources = workshop.sources()?;
            let found = sources.iter().find(|source| source.name == name);
            let known = || sources.iter().map(|source| source.name).collect();
            let source = found.ok_or_else(|| unknown(&name, known()))?;
            Ok(messages::write_data(workshop.schedule(source)?.text)?)
        }
        Command::Check { names } => {
            let kernels = chosen(&names)?;
            Ok(check(&kernels, &mut messages::Output)?)
        }
        Command::Image { sphere, triangle, out } => {
            let sphere = formulation::sphere(&sphere).expect("clap has checked the name");
            let triangle = formulation::triangle(&triangle).expect("clap has checked the name");
            let image = set::tracer(Formulations::of(sphere, triangle))?;
            std::fs::write(&out, image).map_err(|source| Failure::File { path: out, source })
        }
        Command::Images { check: true } => Ok(images::check()?),
        Command::Images { check: false } => Ok(images::write()?),
        Command::Pack { folder } => Ok(set::pack_into(&folder)?),
    }
}

fn measure(arguments: &Measure) -> Result<(), Failure> {
    let measured = measure_all(chosen(&arguments.names)?)?;
    if let Some(file) = &arguments.write {
        document::write(file, &markdown(&measured))?;
    } else if let Some(file) = &arguments.check {
        document::check(file, &markdown(&measured))?;
    } else if arguments.json {
        messages::write_data(serde_json::to_string_pretty(&measured)? + "\n")?;
    } else {
        messages::write_data(markdown(&measured))?;
    }
    Ok(())
}

/// The kernels with these names, or all.
fn chosen(names: &[String]) -> Result<Vec<&'static Kernel>, Failure> {
    Kernels::here()?;
    if names.is_empty() {
        return Ok(catalogue::kernels().collect());
    }
    let find = |name: &String| {
        let known = || catalogue::kernels().map(|kernel| kernel.name).collect();
        catalogue::kernels()
            .find(|kernel| kernel.name == name)
            .ok_or_else(|| unknown(name, known()))
    };
    names.iter().map(find).collect()
}

fn unknown(name: &str, known: Vec<&str>) -> Failure {
    Failure::Unknown { name: name.to_owned(), known: known.join(", ") }
}
