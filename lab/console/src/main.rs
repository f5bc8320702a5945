//! The program of `./start` and `./report`.

use std::path::PathBuf;
use std::process::ExitCode;

use cellray::framebuffer::refuse_large_files;
use clap::{Parser, Subcommand};
use console::{Failure, compare, pictures, report, start};

/// Starts cellray on a console, and reports what the console does
#[derive(Parser)]
#[command(name = "cellray-console", version)]
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
}

fn main() -> ExitCode {
    match run(&Arguments::parse().command) {
        Ok(code) => code,
        Err(error) => {
            messages::print!("cellray-console: error: {error}");
            ExitCode::FAILURE
        }
    }
}

fn run(command: &Command) -> Result<ExitCode, Failure> {
    refuse_large_files()?;
    match command {
        Command::Start(arguments) => start::run(arguments),
        Command::Report(arguments) => report::run(arguments),
        Command::Facts => {
            messages::write_data(compare::facts()?)?;
            Ok(ExitCode::SUCCESS)
        }
        Command::Golden { folder } => {
            messages::write_data(pictures::golden(folder)?)?;
            Ok(ExitCode::SUCCESS)
        }
    }
}
