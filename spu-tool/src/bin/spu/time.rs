//! `spu time`: the static analyser.

use std::fs;
use std::io::{self, Write};
use std::path::PathBuf;
use std::process::ExitCode;

use clap::Args;
use spu_isa::timing::Rules;
use spu_isa::timing::rules::MISS_CYCLES;
use spu_scheduler::check::{self, CheckError};
use spu_scheduler::code::{Code, CodeError};
use spu_tool::report::Report;
use thiserror::Error;

use crate::failure::Failure;

/// Shows when each instruction issues, and where the cycles go, without running the program
///
/// Code is taken straight on, branches not taken, all registers ready at its start. A row of the
/// listing: the cycle; the pipe, 0 even and 1 odd; D for a pair that issued together, d for one
/// that would have, had its second instruction been ready; the cycles in flight as their last
/// digits, dashes for waiting; the address; the instruction; what it waited for. Loops are shown
/// in their steady state, branch and hint included.
#[derive(Args, Debug)]
#[command(after_help = "Examples:
  spu time tracer.elf --function isect_spheres_r16
  spu time --json kernel.o
  spu time --check tracer.elf spu/isect/isect_spheres_r16.s")]
pub struct Arguments {
    /// SPU program or object
    file: PathBuf,
    /// Only the function of this name
    #[arg(long, value_name = "NAME", conflicts_with = "check")]
    function: Option<String>,
    /// Write JSON
    #[arg(long, conflicts_with = "check")]
    json: bool,
    /// Compare the schedule notes (`# 12e`) in the sources with the model; exit status 1 if one
    /// differs. FILE must have been assembled with -g
    #[arg(long)]
    check: bool,
    /// Sources whose notes are checked; without any, all that FILE's line table names
    #[arg(requires = "check", value_name = "SOURCE")]
    sources: Vec<PathBuf>,
    #[command(flatten)]
    model: Model,
}

/// Switches for what no source settles; see docs/timing.md.
#[derive(Args, Debug)]
#[command(next_help_heading = "Model")]
struct Model {
    /// Extra cycles of a mispredicted branch: 18 or 19
    #[arg(long, value_name = "CYCLES", default_value_t = MISS_CYCLES,
        value_parser = clap::value_parser!(u64).range(18..=19))]
    miss_cycles: u64,
    /// Least cycles between two channel instructions
    #[arg(long, value_name = "CYCLES", default_value_t = 1,
        value_parser = clap::value_parser!(u64).range(1..=100))]
    channel_interval: u64,
    /// Registers that are encoded as targets but never written delay their readers
    #[arg(long)]
    false_targets: bool,
    /// FP6 does not wait behind FP7
    #[arg(long)]
    no_float_conflict: bool,
    /// Straight-line code waits for its lines
    #[arg(long)]
    inline_prefetch: bool,
    /// Double precision as on the PowerXCell 8i
    #[arg(long)]
    double_extension: bool,
}

impl Model {
    fn rules(&self) -> Rules {
        Rules {
            miss_cycles: self.miss_cycles,
            hints: true,
            float_conflict: !self.no_float_conflict,
            false_targets: self.false_targets,
            channel_interval: self.channel_interval,
            inline_prefetch: self.inline_prefetch,
            double_extension: self.double_extension,
        }
    }
}

/// Why nothing was shown.
#[derive(Debug, Error)]
pub enum TimeError {
    #[error("{path}: {source}")]
    Read { path: PathBuf, source: io::Error },
    #[error("{path}: {source}")]
    Code { path: PathBuf, source: CodeError },
    #[error("{path}: {source}")]
    Check { path: PathBuf, source: CheckError },
    #[error("{path}: no function {name}; it has {functions}")]
    NoFunction {
        path: PathBuf,
        name: String,
        functions: String,
    },
    #[error("{0}: no schedule note in it")]
    NoNotes(String),
    #[error("standard output: {0}")]
    Output(io::Error),
}

impl From<TimeError> for Failure {
    fn from(error: TimeError) -> Self {
        Self::verb(error)
    }
}

/// Runs the verb. Status 1: a note differs.
pub fn run(arguments: &Arguments) -> Result<ExitCode, TimeError> {
    let path = &arguments.file;
    let data = fs::read(path).map_err(|source| TimeError::Read {
        path: path.clone(),
        source,
    })?;
    let code = Code::parse(&data).map_err(|source| TimeError::Code {
        path: path.clone(),
        source,
    })?;
    if arguments.check {
        return compare(arguments, &code);
    }
    let name = arguments.function.as_deref();
    let report = Report::new(&code, name, arguments.model.rules());
    let report = report.ok_or_else(|| {
        let names: Vec<_> = code.functions().iter().map(|f| f.name.as_str()).collect();
        TimeError::NoFunction {
            path: path.clone(),
            name: name.unwrap_or_default().to_owned(),
            functions: names.join(", "),
        }
    })?;
    print(&if arguments.json {
        report.json()
    } else {
        report.text()
    })?;
    Ok(ExitCode::SUCCESS)
}

fn compare(arguments: &Arguments, code: &Code) -> Result<ExitCode, TimeError> {
    let named = if arguments.sources.is_empty() {
        check::source_files(code)
    } else {
        arguments.sources.clone()
    };
    let read = |path: &PathBuf| match fs::read(path) {
        Ok(text) => Ok((path.clone(), String::from_utf8_lossy(&text).into_owned())),
        Err(source) => Err(TimeError::Read {
            path: path.clone(),
            source,
        }),
    };
    let sources = named.iter().map(read).collect::<Result<Vec<_>, _>>()?;
    let outcome = check::check(code, &sources, arguments.model.rules()).map_err(|source| {
        TimeError::Check {
            path: arguments.file.clone(),
            source,
        }
    })?;
    if outcome.notes == 0 {
        let names: Vec<_> = named
            .iter()
            .map(|path| path.display().to_string())
            .collect();
        return Err(TimeError::NoNotes(names.join(", ")));
    }
    let lines = outcome.differences.iter();
    print(
        &lines
            .map(|difference| format!("{difference}\n"))
            .collect::<String>(),
    )?;
    let wrong = outcome.differences.len();
    // Who closed standard error sees the status.
    let _ = writeln!(
        io::stderr(),
        "{} notes, {wrong} differ from the model",
        outcome.notes
    );
    Ok(ExitCode::from(u8::from(wrong > 0)))
}

/// A reader that has seen enough, `head` say, is no error.
fn print(text: &str) -> Result<(), TimeError> {
    match io::stdout().write_all(text.as_bytes()) {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => Err(TimeError::Output(error)),
        _ => Ok(()),
    }
}
