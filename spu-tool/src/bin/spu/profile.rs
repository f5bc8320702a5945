//! `spu profile`: where a run's cycles went.

use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::Args;
use spu_reports::{ProfileError, ProfileFile};
use spu_scheduler::code::{Code, CodeError};
use spu_tool::profile::{View, ViewError};
use thiserror::Error;

use crate::failure::Failure;

/// Shows which functions, instructions and source lines a run in simulated time spent its cycles
/// on
///
/// The profile is written by a program on this project's libspe2 with LIBSPE2_TIMING=1 and
/// LIBSPE2_PROFILE=FILE. The cycles from the issue of the instruction before until an instruction
/// issues are its own; the second of a dual pair costs nothing; a branch has its miss, a channel
/// instruction its sleep. All SPEs are taken together.
#[derive(Args, Debug)]
#[command(after_help = "Examples:
  spu profile tracer.elf run.json
  spu profile tracer.elf run.json --function main
  spu profile tracer.elf run.json --lines | head -20")]
pub struct Arguments {
    /// The SPU program that ran
    program: PathBuf,
    /// Its profile
    profile: PathBuf,
    /// The listing of this function
    #[arg(long, value_name = "NAME")]
    function: Option<String>,
    /// Source lines, the most expensive first; the program must have been assembled with -g
    #[arg(long)]
    lines: bool,
    /// Write JSON: functions and lines, or the one function with its instructions
    #[arg(long, conflicts_with = "lines")]
    json: bool,
}

/// Why nothing was shown.
#[derive(Debug, Error)]
pub enum Error {
    #[error("{path}: {source}")]
    File { path: PathBuf, source: io::Error },
    #[error("{path}: {source}")]
    Code { path: PathBuf, source: CodeError },
    #[error("{path}: {source}")]
    Profile { path: PathBuf, source: ProfileError },
    #[error("{path}: {source}")]
    View { path: PathBuf, source: ViewError },
    #[error("{0}: no line table in it")]
    NoLines(PathBuf),
    #[error("standard output: {0}")]
    Output(io::Error),
}

impl From<Error> for Failure {
    fn from(error: Error) -> Self {
        Self::verb(error)
    }
}

/// Runs the verb.
pub fn run(arguments: &Arguments) -> Result<ExitCode, Error> {
    let image = read(&arguments.program)?;
    let code = Code::parse(&image).map_err(|source| Error::Code {
        path: arguments.program.clone(),
        source,
    })?;
    let profile = read(&arguments.profile)?;
    let profile = ProfileFile::parse(&profile).map_err(|source| Error::Profile {
        path: arguments.profile.clone(),
        source,
    })?;
    let strange = |source| Error::View {
        path: arguments.profile.clone(),
        source,
    };
    let view = View::new(&code, &image, &profile).map_err(strange)?;
    let name = arguments.function.as_deref();
    let function = name.map(|name| view.function(name));
    let function = function.transpose().map_err(strange)?;
    let mut source = |path: &Path| {
        let text = fs::read(path).ok()?;
        Some(String::from_utf8_lossy(&text).into_owned())
    };
    let text = if arguments.json {
        view.json(function.as_ref())
    } else if arguments.lines {
        if code.sources().is_empty() {
            return Err(Error::NoLines(arguments.program.clone()));
        }
        let within = function.as_ref().map(|figures| &figures.function);
        view.lines_text(within, &mut source)
    } else if let Some(function) = &function {
        view.function_text(function, &mut source)
    } else {
        view.functions_text()
    };
    match io::stdout().write_all(text.as_bytes()) {
        // A reader that has seen enough, `head` say, is no error.
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => Err(Error::Output(error)),
        _ => Ok(ExitCode::SUCCESS),
    }
}

fn read(path: &Path) -> Result<Vec<u8>, Error> {
    fs::read(path).map_err(|source| Error::File {
        path: path.to_path_buf(),
        source,
    })
}
