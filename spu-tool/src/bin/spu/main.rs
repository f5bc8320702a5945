//! `spu`: tools for SPU programs that need no PPE program.

mod dump;
mod failure;
mod image;
mod profile;
mod run;
mod schedule;
mod time;

use clap::{CommandFactory as _, Parser, Subcommand};
use std::process::ExitCode;

use failure::{Failure, USAGE, fail};

/// Runs, traces, times and disassembles programs of the Cell Broadband Engine's SPU.
#[derive(Parser)]
#[command(name = "spu", version, max_term_width = 100)]
struct CommandLine {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    Run(Box<run::Options>),
    Dump(dump::Options),
    Time(Box<time::Arguments>),
    Profile(profile::Arguments),
    Schedule(Box<schedule::Arguments>),
    /// Write man pages and shell completions
    #[command(hide = true)]
    Pages(pages::Arguments),
}

fn main() -> ExitCode {
    let line = match CommandLine::try_parse() {
        Ok(line) => line,
        Err(error) => {
            // If the error can't be printed either, the exit status still reports it.
            let _ = error.print();
            return if error.use_stderr() {
                USAGE.into()
            } else {
                ExitCode::SUCCESS
            };
        }
    };
    let done = match line.command {
        Command::Run(options) => run::run(&options),
        Command::Dump(options) => dump::dump(&options),
        Command::Time(arguments) => time::run(&arguments).map_err(Into::into),
        Command::Profile(arguments) => profile::run(&arguments).map_err(Into::into),
        Command::Schedule(arguments) => schedule::run(&arguments).map_err(Into::into),
        Command::Pages(arguments) => pages::write(CommandLine::command(), &arguments)
            .map(|()| ExitCode::SUCCESS)
            .map_err(Failure::command),
    };
    done.unwrap_or_else(|failure| fail(&failure))
}
