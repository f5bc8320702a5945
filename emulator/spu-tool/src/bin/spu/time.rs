//! `spu time`: the static analyser.

use std::fs;
use std::path::PathBuf;
use std::process::ExitCode;

use clap::Args;
use spu_emulator::simulated::Timing;
use spu_isa::timing::Rules;
use spu_isa::timing::rules::MISS_CYCLES;
use spu_scheduler::check;
use spu_scheduler::code::Code;
use spu_tool::report::Report;

use crate::asm;
use crate::failure::Failure;

/// Shows when each instruction issues, and where the cycles go, without running the program
///
/// The code is analysed as a straight line: no branch is taken, and all registers are ready at the
/// start. Each row of the listing shows the cycle; the pipe (0 even, 1 odd); D for a pair that
/// issued together, or d for a pair that would have if its second instruction had been ready; the
/// cycles in flight as their last digits, with dashes for waiting; the address; the instruction;
/// and what it waited for. Loops are shown in their steady state, including branch and hint.
#[derive(Args, Debug)]
#[command(after_help = "Examples:
  spu time tracer.elf --function isect_spheres_r16
  spu time --json kernel.o
  spu time --html pipelines.html kernel.o
  spu time --check tracer.elf spu/isect/isect_spheres_r16.s")]
pub struct Arguments {
    /// SPU program, object, or assembly source without macros
    file: PathBuf,
    /// Show only this function
    #[arg(long, value_name = "NAME", conflicts_with = "check")]
    function: Option<String>,
    /// Write JSON
    #[arg(long, conflicts_with = "check")]
    json: bool,
    /// Write a page of diagrams to this file: a row for each instruction, a column for each cycle
    #[arg(long, value_name = "PAGE", conflicts_with_all = ["check", "json"])]
    html: Option<PathBuf>,
    /// Compare the schedule notes (`# 12e`) in the sources with the model; the exit status is 1 if
    /// any differ. FILE must have been assembled with -g
    #[arg(long)]
    check: bool,
    /// Sources whose notes are checked; the default is all sources that FILE's line table names
    #[arg(requires = "check", value_name = "SOURCE")]
    sources: Vec<PathBuf>,
    #[command(flatten)]
    model: Model,
}

/// Switches for rules that no source settles; see docs/timing.md.
#[derive(Args, Debug)]
#[command(next_help_heading = "Model")]
struct Model {
    /// Extra cycles of a mispredicted branch: 18 or 19
    #[arg(long, value_name = "CYCLES", default_value_t = MISS_CYCLES,
        value_parser = clap::value_parser!(u64).range(18..=19))]
    miss_cycles: u64,
    /// Minimum number of cycles between two channel instructions
    #[arg(long, value_name = "CYCLES", default_value_t = 1,
        value_parser = clap::value_parser!(u64).range(1..=100))]
    channel_interval: u64,
    /// Make registers that are encoded as targets but never written delay their readers
    #[arg(long)]
    false_targets: bool,
    /// Let FP6 issue right after FP7 without waiting
    #[arg(long)]
    no_float_conflict: bool,
    /// Make straight-line code wait for its lines to be fetched
    #[arg(long)]
    inline_prefetch: bool,
    /// Time double precision as on the PowerXCell 8i
    #[arg(long)]
    double_extension: bool,
    /// Take the rules from the table `pipelines` of a file
    #[arg(long, value_name = "FILE", conflicts_with_all = ["miss_cycles", "channel_interval",
        "false_targets", "no_float_conflict", "inline_prefetch", "double_extension"])]
    machine: Option<PathBuf>,
}

impl Model {
    fn rules(&self) -> Result<Rules, Failure> {
        if let Some(path) = &self.machine {
            return Ok(Timing::read(path)?.rules);
        }
        Ok(Rules {
            miss_cycles: self.miss_cycles,
            float_conflict: !self.no_float_conflict,
            false_targets: self.false_targets,
            channel_interval: self.channel_interval,
            inline_prefetch: self.inline_prefetch,
            double_extension: self.double_extension,
            ..Rules::default()
        })
    }
}

/// Runs the subcommand. The exit status is 1 if a note differs.
pub fn run(arguments: &Arguments) -> Result<ExitCode, Failure> {
    let path = &arguments.file;
    let mut data = fs::read(path).map_err(Failure::file(path))?;
    if asm::is_source(path) {
        data = asm::assemble(path, &data)?.elf();
    }
    let code = Code::parse(&data).map_err(Failure::file(path))?;
    if arguments.check {
        return compare(arguments, &code);
    }
    let name = arguments.function.as_deref();
    let report = Report::new(&code, name, arguments.model.rules()?);
    let report = report.ok_or_else(|| {
        let names: Vec<_> = code.functions().iter().map(|f| f.name.as_str()).collect();
        let (name, names) = (name.unwrap_or_default(), names.join(", "));
        Failure::file(path)(format_args!("no function {name}; it has {names}"))
    })?;
    if let Some(page) = &arguments.html {
        let text = report.html(&path.display().to_string());
        fs::write(page, &text).map_err(Failure::file(page))?;
        messages::print!("{}: {} bytes", page.display(), text.len());
        return Ok(ExitCode::SUCCESS);
    }
    let text = match arguments.json {
        true => report.json(),
        false => report.text(),
    };
    messages::write_data(text)?;
    Ok(ExitCode::SUCCESS)
}

fn compare(arguments: &Arguments, code: &Code) -> Result<ExitCode, Failure> {
    let named = if arguments.sources.is_empty() {
        check::source_files(code)
    } else {
        arguments.sources.clone()
    };
    let read = |path: &PathBuf| match fs::read(path) {
        Ok(text) => Ok((path.clone(), String::from_utf8_lossy(&text).into_owned())),
        Err(error) => Err(Failure::file(path)(error)),
    };
    let sources = named.iter().map(read).collect::<Result<Vec<_>, _>>()?;
    let outcome = check::check(code, &sources, arguments.model.rules()?)
        .map_err(Failure::file(&arguments.file))?;
    if outcome.notes == 0 {
        let names: Vec<_> = named.iter().map(|path| path.display().to_string()).collect();
        return Err(Failure::of(names.join(", "))("the file has no schedule note"));
    }
    let lines = outcome.differences.iter();
    let text: String = lines.map(|difference| format!("{difference}\n")).collect();
    messages::write_data(text)?;
    let wrong = outcome.differences.len();
    messages::print!("{} notes, {wrong} differ from the model", outcome.notes);
    Ok(ExitCode::from(u8::from(wrong > 0)))
}
