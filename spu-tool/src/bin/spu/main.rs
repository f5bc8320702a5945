//! `spu`: SPU programs without a PPE program.

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

/// Runs, traces and takes apart programs of the Cell Broadband Engine's SPU.
#[derive(Parser)]
#[command(name = "spu", version, max_term_width = 100)]
struct CommandLine {
    #[command(subcommand)]
    verb: Verb,
}

#[derive(Subcommand)]
enum Verb {
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
            // If not even that can be printed, the status says it.
            let _ = error.print();
            return if error.use_stderr() {
                USAGE.into()
            } else {
                ExitCode::SUCCESS
            };
        }
    };
    let done = match line.verb {
        Verb::Run(options) => run::run(&options),
        Verb::Dump(options) => dump::dump(&options),
        Verb::Time(arguments) => time::run(&arguments).map_err(Into::into),
        Verb::Profile(arguments) => profile::run(&arguments).map_err(Into::into),
        Verb::Schedule(arguments) => schedule::run(&arguments).map_err(Into::into),
        Verb::Pages(arguments) => pages::write(CommandLine::command(), &arguments)
            .map(|()| ExitCode::SUCCESS)
            .map_err(Failure::verb),
    };
    done.unwrap_or_else(|failure| fail(&failure))
}
