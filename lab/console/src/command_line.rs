//! The command line: all commands of `cellray` and `cellray-play`, `./start` and `./report`.

use std::path::PathBuf;
use std::process::ExitCode;

use cellray::cli;
use cellray::framebuffer::refuse_large_files;
use clap::{Parser, Subcommand};

use crate::{Failure, compare, pictures, report, start};

/// Interactive ray tracer for the Cell Broadband Engine under PS3 Linux.
#[derive(Parser)]
#[command(name = "cellray", version)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Find out what is missing, and show a moving picture until a key is pressed
    Start(start::Arguments),
    /// Measure this machine, and write a report without personal data
    Report(report::Arguments),
    /// Print the results of uncertain instructions on this machine
    Facts,
    /// Print the hashes of the golden pictures
    Golden {
        /// The folder with the folder `scenes`
        #[arg(long, default_value = ".", value_name = "FOLDER")]
        folder: PathBuf,
    },
    #[command(flatten)]
    Tracer(Box<cli::Command>),
}

/// Runs the program's command line. Returns the exit code.
#[must_use]
pub fn main() -> ExitCode {
    match Arguments::parse().command {
        // It reads the same command line again, and prints its own errors.
        Command::Tracer(command) if is_of_play(&command) => cellray_play::main(games::GAMES),
        command => run(&command).unwrap_or_else(|error| {
            messages::print!("cellray: error: {error}");
            ExitCode::FAILURE
        }),
    }
}

fn is_of_play(command: &cli::Command) -> bool {
    matches!(command, cli::Command::Play(_) | cli::Command::View(_) | cli::Command::Show(_))
}

fn run(command: &Command) -> Result<ExitCode, Failure> {
    refuse_large_files()?;
    match command {
        Command::Start(arguments) => return start::run(arguments),
        Command::Report(arguments) => return report::run(arguments),
        Command::Facts => messages::write_data(compare::facts()?)?,
        Command::Golden { folder } => messages::write_data(pictures::golden(folder)?)?,
        Command::Tracer(command) => cli::dispatch(command)?,
    }
    Ok(ExitCode::SUCCESS)
}
