//! `spu profile`: shows where a run's cycles went.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::Args;
use spu_reports::ProfileFile;
use spu_reports::views::View;
use spu_scheduler::code::Code;

use crate::failure::Failure;
use crate::image::read_file;

/// Shows which functions, instructions and source lines a run in simulated time spent its cycles
/// on
///
/// A program on this project's libspe2 writes the profile if LIBSPE2_TIMING=1 and
/// LIBSPE2_PROFILE=FILE are set. An instruction is charged the cycles from the issue of the
/// instruction before it to its own issue. The second of a dual pair costs nothing. A branch is
/// also charged its miss, and a channel instruction its wait. The figures of all SPEs are added
/// up.
#[derive(Args, Debug)]
#[command(after_help = "Examples:
  spu profile tracer.elf run.json
  spu profile tracer.elf run.json --function main
  spu profile tracer.elf run.json --lines | head -20")]
pub struct Arguments {
    /// The SPU program that ran
    program: PathBuf,
    /// The profile of its run
    profile: PathBuf,
    /// Show the listing of this function
    #[arg(long, value_name = "NAME")]
    function: Option<String>,
    /// Show source lines, the most expensive first; the program must have been assembled with -g
    #[arg(long)]
    lines: bool,
    /// Write JSON: functions and lines, or one function with its instructions
    #[arg(long, conflicts_with = "lines")]
    json: bool,
}

/// Runs the subcommand.
pub fn run(arguments: &Arguments) -> Result<ExitCode, Failure> {
    let image = read_file(&arguments.program)?;
    let code = Code::parse(&image).map_err(Failure::file(&arguments.program))?;
    let profile = read_file(&arguments.profile)?;
    let profile = ProfileFile::parse(&profile).map_err(Failure::file(&arguments.profile))?;
    let view = View::new(&code, &image, &profile).map_err(Failure::file(&arguments.profile))?;
    let name = arguments.function.as_deref();
    let function = name.map(|name| view.function(name));
    let function = function.transpose().map_err(Failure::file(&arguments.profile))?;
    let mut source = |path: &Path| {
        let text = fs::read(path).ok()?;
        Some(String::from_utf8_lossy(&text).into_owned())
    };
    let text = if arguments.json {
        view.json(function.as_ref())
    } else if arguments.lines {
        if code.sources().is_empty() {
            return Err(Failure::file(&arguments.program)("the file has no line table"));
        }
        let within = function.as_ref().map(|figures| &figures.function);
        view.lines_text(within, &mut source)
    } else if let Some(function) = &function {
        view.function_text(function, &mut source)
    } else {
        view.functions_text()
    };
    messages::write_data(text)?;
    Ok(ExitCode::SUCCESS)
}
