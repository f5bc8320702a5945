//! `cellray shader`: assembles, schedules and links shaders.

use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};

use clap::{Args, Subcommand};
use spu_isa::timing::{Loop, Rules, find_loops, straight_line};
use spu_scheduler::code::{Code, Function};
use spu_scheduler::{LoopReport, Outcome as Form, ScheduleError};

use super::Outcome;
use crate::spe::Program;

/// Assemble, schedule and link shaders of your own.
#[derive(Args)]
pub struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Assemble shaders and link them into an SPU program, for --program
    Build {
        /// Sources in SPU assembly; the rules are in docs/shaders.md
        #[arg(value_name = "F.s", required = true)]
        sources: Vec<PathBuf>,
        /// SPU program to write [default: the first source's name with .elf, in the current folder]
        #[arg(long, value_name = "F.elf")]
        out: Option<PathBuf>,
    },
    /// Assemble a shader into an object file, for spu time and spu schedule
    Assemble {
        /// Source in SPU assembly
        #[arg(value_name = "F.s")]
        source: PathBuf,
        /// Object file to write [default: the source's name with .o, in the current folder]
        #[arg(long, value_name = "F.o")]
        out: Option<PathBuf>,
    },
    /// Schedule a shader for both pipes of the SPU, and print its cycles before and after
    Schedule {
        /// Source in SPU assembly; the rules are in docs/spu-programming.md
        ///
        /// Its functions are between function and endfunction, or have .type and .size.
        #[arg(value_name = "F.s")]
        source: PathBuf,
        /// Scheduled source to write [default: the source's name with .scheduled.s, in the current
        /// folder]
        #[arg(short, long, value_name = "F.s")]
        out: Option<PathBuf>,
    },
}

pub fn run(arguments: &Arguments) -> Outcome {
    match &arguments.command {
        Command::Build { sources, out } => build(sources, out.as_deref()),
        Command::Assemble { source, out } => {
            let out = named(source, out.as_deref(), "o");
            Ok(spu_build::assemble_shader(source, &out)?)
        }
        Command::Schedule { source, out } => schedule(source, out.as_deref()),
    }
}

fn build(sources: &[PathBuf], out: Option<&Path>) -> Outcome {
    let image = spu_build::tracer_with(sources)?;
    let shaders = Program::from_image(&image)?.shaders()?;
    let out = named(&sources[0], out, "elf");
    fs::write(&out, &image).map_err(|error| format!("{}: {error}", out.display()))?;
    messages::print!("cellray: {}: shaders {}", out.display(), shaders.join(", "));
    Ok(())
}

/// The file to write: the requested one, or the source's name in the current folder.
fn named(source: &Path, out: Option<&Path>, extension: &str) -> PathBuf {
    let stem = Path::new(source.file_stem().unwrap_or_default());
    out.map_or_else(|| stem.with_extension(extension), Path::to_path_buf)
}

fn schedule(source: &Path, out: Option<&Path>) -> Outcome {
    let out = named(source, out, "scheduled.s");
    let same =
        |one: &Path, other: &Path| Some(one.canonicalize().ok()? == other.canonicalize().ok()?);
    if same(source, &out) == Some(true) {
        let out = out.display();
        return Err(format!(
            "{out}: the schedule would replace its plain source; choose another file with --out"
        )
        .into());
    }
    let text =
        fs::read_to_string(source).map_err(|error| format!("{}: {error}", source.display()))?;
    let work = tempfile::tempdir()?;
    let assemble = |source: &Path| -> Result<Vec<u8>, Box<dyn Error + Send + Sync>> {
        let object = work.path().join("shader.o");
        spu_build::assemble_shader(source, &object)?;
        Ok(fs::read(object)?)
    };
    let plain = assemble(source).map_err(|error| error.to_string())?;
    let mut object = Vec::new();
    let kind = spu_scheduler::Kind::Kernel;
    let scheduled =
        spu_scheduler::schedule(&plain, kind, &source.to_string_lossy(), &text, |text| {
            let copy = work.path().join("scheduled.s");
            fs::write(&copy, text)?;
            object = assemble(&copy)?;
            Ok::<_, Box<dyn Error + Send + Sync>>(object.clone())
        });
    let scheduled = scheduled.map_err(|error| match error {
        ScheduleError::At { .. } | ScheduleError::Assembler(_) => error.to_string(),
        ScheduleError::NoFunction => format!(
            "{}: {error}; write the function out after `shader_entry NAME`, as docs/shaders.md \
             shows, where the macro `shader` has begun it",
            source.display()
        ),
        _ => format!("{}: {error}", source.display()),
    })?;
    fs::write(&out, &scheduled.text).map_err(|error| format!("{}: {error}", out.display()))?;
    let (plain, made) = (Code::parse(&plain)?, Code::parse(&object)?);
    messages::print!("cellray: {}: {} scheduled", out.display(), source.display());
    for line in cycles(&plain, &made, &scheduled.loops) {
        messages::print!("cellray: {line}");
    }
    Ok(())
}

/// For each function without loops, its cycles in both forms, and for each loop those of a pass.
fn cycles(plain: &Code, scheduled: &Code, reports: &[LoopReport]) -> Vec<String> {
    let rules = Rules::default();
    let words = |code: &Code, function: &Function| code.words(function.start, function.end);
    let straight = |code: &Code, function: &Function| {
        let account = straight_line(&words(code, function), rules).account?;
        Some(account.cycles())
    };
    let mut lines = Vec::new();
    for function in plain.functions() {
        let loops = find_loops(&words(plain, function), rules);
        let name = &function.name;
        let mut made = scheduled.functions().iter();
        let made = made.find(|made| made.name == *name);
        let both =
            made.and_then(|made| Some((straight(plain, function)?, straight(scheduled, made)?)));
        if let (true, Some((before, after))) = (loops.is_empty(), both) {
            lines.push(format!("{name}: {before} cycles straight on, {after} scheduled"));
        }
        lines.extend(loops.iter().filter_map(|found| {
            let line = line_of(plain, found)?;
            let report = reports.iter().find(|report| report.line == line)?;
            Some(pass(found, report))
        }));
    }
    lines
}

/// The source line of a loop's branch.
fn line_of(code: &Code, found: &Loop) -> Option<u64> {
    let sources = code.sources();
    let at = sources.iter().find(|(address, _)| *address == found.branch);
    at.map(|(_, source)| source.line)
}

fn pass(found: &Loop, report: &LoopReport) -> String {
    let before = found.steady.as_ref().map(|steady| steady.cycles_a_pass().ceil());
    let before = before.map_or_else(|| "unknown".to_owned(), |cycles| cycles.to_string());
    let name = &report.name;
    match &report.outcome {
        Form::Pipelined(figures) => {
            format!("loop {name}: {before} cycles a pass, {} scheduled", figures.interval)
        }
        Form::Plain(why) => format!("loop {name}: {before} cycles a pass; not pipelined: {why}"),
    }
}
