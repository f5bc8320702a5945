//! `spu`: tools for SPU programs that need no PPE program.

mod asm;
mod debug;
mod dump;
mod failure;
mod image;
mod profile;
mod run;
mod schedule;
mod time;
mod vectors;

use std::env;
use std::path::Path;
use std::process::ExitCode;

use clap::error::ErrorKind;
use clap::{CommandFactory as _, Parser, Subcommand};

use failure::{USAGE, fail};

/// Assembles, runs, debugs, times and disassembles programs of the Cell Broadband Engine's SPU.
#[derive(Parser)]
#[command(name = "spu", version, max_term_width = 100)]
struct CommandLine {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    Run(Box<run::Options>),
    Asm(asm::Arguments),
    Debug(Box<debug::Arguments>),
    Dump(dump::Options),
    Time(Box<time::Arguments>),
    Profile(profile::Arguments),
    Schedule(Box<schedule::Arguments>),
    Vectors(vectors::Arguments),
    /// Write man pages and shell completions
    #[command(hide = true)]
    Pages(messages::manual::Arguments),
}

/// A program was named where a subcommand belongs.
fn suggest_run() {
    let Some(first) = env::args_os().nth(1) else {
        return;
    };
    if Path::new(&first).is_file() {
        messages::print!("  tip: to run a program: spu run {}", first.display());
    }
}

fn main() -> ExitCode {
    let line = match CommandLine::try_parse() {
        Ok(line) => line,
        Err(error) => {
            // If the error can't be printed either, the exit status still reports it.
            let _ = error.print();
            if error.kind() == ErrorKind::InvalidSubcommand {
                suggest_run();
            }
            return if error.use_stderr() { USAGE.into() } else { ExitCode::SUCCESS };
        }
    };
    let done = match line.command {
        Command::Run(options) => run::run(&options),
        Command::Asm(arguments) => asm::run(&arguments),
        Command::Debug(arguments) => debug::run(&arguments),
        Command::Dump(options) => dump::dump(&options),
        Command::Time(arguments) => time::run(&arguments),
        Command::Profile(arguments) => profile::run(&arguments),
        Command::Schedule(arguments) => schedule::run(&arguments),
        Command::Vectors(arguments) => vectors::run(&arguments),
        Command::Pages(arguments) => messages::manual::write(CommandLine::command(), &arguments)
            .map(|()| ExitCode::SUCCESS)
            .map_err(Into::into),
    };
    done.unwrap_or_else(|failure| fail(&failure))
}
