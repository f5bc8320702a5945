//! `spu schedule`: turns plain assembly into scheduled assembly.

use std::fs;
use std::path::PathBuf;
use std::process::ExitCode;

use clap::Args;
use spu_build::Tools;
use spu_scheduler::{Figures, Kind, Outcome, ScheduleError};

use crate::failure::Failure;
use crate::image::read_file;

/// Writes an assembly source again with its functions scheduled for both pipes
///
/// Blocks are list-scheduled. Loops that `ai $n,$n,-1` and `brnz $n` count down are
/// software-pipelined. Macros are expanded, and returns and loops get hints. Each line has the
/// note that `spu time --check` compares with the model. The rest of the source is kept. Before
/// the schedule is written, it is assembled, and its instructions are compared with those of the
/// source.
#[derive(Args, Debug)]
#[command(
    after_help = "Memory: loads and stores through different base values do not overlap, unless the comment on the store's
line contains `may alias`. Through the same base value they overlap if their offsets do. A pointer that
a loop moves by a constant is tracked from pass to pass. A pointer that a loop loads in each pass
points to the same record as before or to one that does not overlap it. lqx and stqx with an unknown
index may overlap every access through their first register.

Registers: $2 to $79 are used where they are not live. At a return, $0, $1, $80 to $127 and the
registers that `Out` in the source's header lists are live. Without such a line, all are.

Short loops may get a kernel of several passes, unless the comment on the loop's branch contains `one pass`.

Assembler: the one that SPU_AS names, or else spu-elf-as or spu-as.

Example:
  spu-elf-as -g -I include -o kernel.o kernel.s
  spu schedule -I include kernel.o kernel.s -o scheduled/kernel.s"
)]
pub struct Arguments {
    /// The assembled source, made with -g and without --strip-local-absolute
    object: PathBuf,
    /// The assembly source
    source: PathBuf,
    /// Folder to search for included files, as for the assembler
    #[arg(short = 'I', long = "include", value_name = "DIR")]
    includes: Vec<PathBuf>,
    /// File for the schedule; the default is standard output
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    /// Only reorder the instructions of each block
    ///
    /// For functions that call others and have their own hints. The code keeps its size and its
    /// registers. Pointers may overlap, but for objects of different names and the stack.
    #[arg(long)]
    driver: bool,
    /// Print the figures of each pipelined loop to standard error
    #[arg(short, long)]
    verbose: bool,
}

/// Runs the subcommand.
pub fn run(arguments: &Arguments) -> Result<ExitCode, Failure> {
    let object = read_file(&arguments.object)?;
    let text = read_file(&arguments.source)?;
    let path = arguments.source.to_string_lossy();
    let kind = if arguments.driver { Kind::Driver } else { Kind::Kernel };
    let scheduled =
        spu_scheduler::schedule(&object, kind, &path, &String::from_utf8_lossy(&text), |text| {
            assemble(arguments, text)
        });
    let scheduled = scheduled.map_err(|source| match source {
        at @ (ScheduleError::At { .. } | ScheduleError::Assembler(_)) => at.into(),
        error => Failure::file(&arguments.object)(error),
    })?;
    for found in &scheduled.loops {
        let result = match &found.outcome {
            Outcome::Plain(why) => format!("not pipelined: {why}"),
            Outcome::Pipelined(figures) if arguments.verbose => describe(figures),
            Outcome::Pipelined(_) => continue,
        };
        messages::print!("{path}:{}: loop {}: {result}", found.line, found.name);
    }
    match &arguments.output {
        Some(output) => fs::write(output, scheduled.text).map_err(Failure::file(output))?,
        None => messages::write_data(scheduled.text)?,
    }
    Ok(ExitCode::SUCCESS)
}

/// Assembles a schedule and returns the object.
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
        "even {}, odd {}, minimum {}, interval {}, stages {}, registers {}, copies {}, passes {}",
        figures.even,
        figures.odd,
        figures.minimum,
        figures.interval,
        figures.stages,
        figures.registers,
        figures.copies,
        figures.passes
    )
}
