//! `spu schedule`: plain assembly to scheduled assembly.

use std::fs;
use std::io::{self, Write};
use std::path::PathBuf;
use std::process::ExitCode;

use clap::Args;
use spu_build::Tools;
use spu_scheduler::{Figures, Outcome, ScheduleError};
use thiserror::Error;

use crate::failure::Failure;

/// Writes an assembly source again with its functions scheduled for both pipes
///
/// Blocks are list-scheduled, loops that `ai $n,$n,-1` and `brnz $n` count down are software
/// pipelined. Macros are expanded, each line has the note that `spu time --check` compares with
/// the model, and returns and loops get their hints. What else is in the source stays as it is.
/// The schedule is assembled and its instructions are held to the source's before it is written.
#[derive(Args, Debug)]
#[command(
    after_help = "Memory: loads and stores through different base values do not overlap, unless the store's line says
`may alias` in its comment; through the same one they do if their offsets do. A pointer that a loop
moves by a constant is followed from pass to pass; one that it loads anew points to the same record
as before or to one that does not overlap it. lqx and stqx with an unknown index may meet every
access through their first register.

Registers: $2 to $79 are used where they are not live. At a return $0, $1, $80 to $127 and those that
`Out` in the source's header names are live; without such a line, all are.

Assembler: the one that SPU_AS names, else spu-elf-as or spu-as.

Example:
  spu-elf-as -g -I include -o kernel.o kernel.s
  spu schedule -I include kernel.o kernel.s -o scheduled/kernel.s"
)]
pub struct Arguments {
    /// Object of the source, assembled with -g and without --strip-local-absolute
    object: PathBuf,
    /// The source
    source: PathBuf,
    /// Folder with files that the source includes, as for the assembler
    #[arg(short = 'I', long = "include", value_name = "DIR")]
    includes: Vec<PathBuf>,
    /// Where the schedule goes; standard output unless named
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    /// Tell the figures of each pipelined loop on standard error
    #[arg(short, long)]
    verbose: bool,
}

/// Why nothing was scheduled.
#[derive(Debug, Error)]
pub enum Error {
    #[error("{path}: {source}")]
    File { path: PathBuf, source: io::Error },
    #[error("{path}: {source}")]
    Object {
        path: PathBuf,
        source: ScheduleError,
    },
    #[error(transparent)]
    Line(ScheduleError),
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
    let read = |path: &PathBuf| {
        fs::read(path).map_err(|source| Error::File {
            path: path.clone(),
            source,
        })
    };
    let object = read(&arguments.object)?;
    let text = read(&arguments.source)?;
    let path = arguments.source.to_string_lossy();
    let scheduled =
        spu_scheduler::schedule(&object, &path, &String::from_utf8_lossy(&text), |text| {
            assemble(arguments, text)
        });
    let scheduled = scheduled.map_err(|source| match source {
        at @ (ScheduleError::At { .. } | ScheduleError::Assembler(_)) => Error::Line(at),
        source => Error::Object {
            path: arguments.object.clone(),
            source,
        },
    })?;
    for found in &scheduled.loops {
        let told = match &found.outcome {
            Outcome::Plain(why) => format!("not pipelined: {why}"),
            Outcome::Pipelined(figures) if arguments.verbose => describe(figures),
            Outcome::Pipelined(_) => continue,
        };
        // Who closed standard error gets the schedule.
        let _ = writeln!(
            io::stderr(),
            "{path}:{}: loop {}: {told}",
            found.line,
            found.name
        );
    }
    match &arguments.output {
        Some(output) => fs::write(output, scheduled.text).map_err(|source| Error::File {
            path: output.clone(),
            source,
        })?,
        None => match io::stdout().write_all(scheduled.text.as_bytes()) {
            Err(error) if error.kind() != io::ErrorKind::BrokenPipe => {
                return Err(Error::Output(error));
            }
            _ => {}
        },
    }
    Ok(ExitCode::SUCCESS)
}

/// The object of a schedule.
fn assemble(
    arguments: &Arguments,
    text: &str,
) -> Result<Vec<u8>, Box<dyn std::error::Error + Send + Sync>> {
    let folder = tempfile::tempdir()?;
    let source = folder.path().join("scheduled.s");
    let object = folder.path().join("scheduled.o");
    fs::write(&source, text)?;
    Tools::find()?.assemble(&arguments.includes, &[], &object, &source)?;
    Ok(fs::read(&object)?)
}

fn describe(figures: &Figures) -> String {
    format!(
        "even {}, odd {}, minimum {}, interval {}, stages {}, registers {}, copies {}",
        figures.even,
        figures.odd,
        figures.minimum,
        figures.interval,
        figures.stages,
        figures.registers,
        figures.copies
    )
}
