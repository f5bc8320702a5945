//! `cellray-bench accuracy`: run time against error.

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use accuracy::antialiasing;
use accuracy::document;
use accuracy::output::{self, Document, Origin};
use accuracy::plots::{self, Format};
use accuracy::run::{self, Extent, Order, RunError};
use clap::Args;

use super::Outcome;

/// Measure run time against error of pictures, and of every formulation
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub struct Arguments {
    /// Folder for results.json, the tables as CSV and the plots
    #[arg(long, default_value = "target/accuracy", value_name = "DIR")]
    out: PathBuf,
    /// Write only the results as JSON, to a file or to standard output with -
    #[arg(long, value_name = "F.json", conflicts_with_all = ["out", "write"])]
    json: Option<PathBuf>,
    /// Leave out the host's name, its time and the command, so that the output is the same on
    /// every host
    #[arg(long)]
    no_host_time: bool,
    /// Also put the tables into a document, with their plots next to it
    #[arg(long, value_name = "F.md")]
    write: Option<PathBuf>,
    /// Seed of the random rays
    #[arg(long, default_value_t = kernels::bench::SEED, value_name = "N", allow_negative_numbers = true)]
    seed: u64,
    /// Use some thousand rays and no pictures or roots, which takes some seconds
    #[arg(long, conflicts_with = "full")]
    quick: bool,
    /// Use sixteen times as many rays, and pictures of 512x384
    #[arg(long)]
    full: bool,
    /// Trace no pictures
    #[arg(long)]
    no_pictures: bool,
    /// Trace only pictures, and measure no kernels
    #[arg(long, conflicts_with_all = ["quick", "no_pictures", "only"])]
    pictures: bool,
    /// Trace only pictures of these scenes: those of the repository and generated ones, by name
    #[arg(long, value_name = "SCENE", value_delimiter = ',', requires = "pictures")]
    scenes: Vec<String>,
    /// Trace only pictures by these programs: paper, fast, default, exact
    #[arg(long, value_name = "PROGRAM", value_delimiter = ',', requires = "pictures")]
    programs: Vec<String>,
    /// Measure only pictures with several samples a pixel: adaptive antialiasing and regular
    /// supersampling
    #[arg(
        long,
        conflicts_with_all = ["quick", "full", "no_pictures", "pictures", "only", "json", "seed"]
    )]
    antialiasing: bool,
    /// Measure only these formulations, and no pictures
    #[arg(long, value_name = "NAME", value_delimiter = ',')]
    only: Vec<String>,
}

const EXAMPLES: &str = "\
Examples:
  cellray-bench accuracy
  cellray-bench accuracy --only paper,perpendicular
  cellray-bench accuracy --pictures --write docs/accuracy.md
  cellray-bench accuracy --write docs/accuracy.md
  cellray-bench accuracy --antialiasing --write docs/accuracy.md
  cellray-bench accuracy --quick --no-host-time --json -";

pub fn run(arguments: &Arguments) -> Outcome {
    if arguments.antialiasing {
        return antialiasing(arguments);
    }
    let extent = match (arguments.quick, arguments.full) {
        (true, _) => Extent::Quick,
        (false, true) => Extent::Full,
        (false, false) => Extent::Standard,
    };
    let order = Order {
        extent,
        seed: arguments.seed,
        only: arguments.only.clone(),
        kernels: !arguments.pictures,
        scenes: arguments.scenes.clone(),
        programs: arguments.programs.clone(),
        pictures: !(arguments.quick || arguments.no_pictures),
        host_time: !arguments.no_host_time,
    };
    // Checked before the minutes of measuring, not after them.
    if arguments.json.is_none() {
        output::folder(&arguments.out)?;
    }
    let results = run::run(&order, |next| messages::print!("cellray-bench: {next}"))?;
    let document = Document { origin: order.host_time.then(Origin::here), results };
    if let Some(file) = &arguments.json {
        output::json(&document, file)?;
        return Ok(ExitCode::SUCCESS);
    }
    output::write(&document, &arguments.out)?;
    let plots = plots::plots(&document.results);
    plots::write(&plots, &arguments.out, "", &[Format::Svg, Format::Png])?;
    messages::print!("cellray-bench: {}", arguments.out.display());
    if let Some(file) = &arguments.write {
        let beside = file.parent().unwrap_or(Path::new("."));
        plots::write(&plots, beside, document::PREFIX, &[Format::Svg])?;
        document::write(&document, file)?;
        messages::print!("cellray-bench: {}", file.display());
    }
    Ok(ExitCode::SUCCESS)
}

/// Measures antialiasing, and writes its plots and, if asked to, its part of the document.
fn antialiasing(arguments: &Arguments) -> Outcome {
    output::folder(&arguments.out)?;
    let rows = antialiasing::measure(|next| messages::print!("cellray-bench: {next}"))
        .map_err(RunError::Picture)?;
    let plots = plots::antialiasing(&rows);
    let prefix = document::antialiasing::PREFIX;
    plots::write(&plots, &arguments.out, prefix, &[Format::Svg, Format::Png])?;
    messages::print!("cellray-bench: {}", arguments.out.display());
    if let Some(file) = &arguments.write {
        let beside = file.parent().unwrap_or(Path::new("."));
        plots::write(&plots, beside, prefix, &[Format::Svg])?;
        document::antialiasing::write(&rows, &plots, &Origin::here(), file)?;
        messages::print!("cellray-bench: {}", file.display());
    }
    Ok(ExitCode::SUCCESS)
}
