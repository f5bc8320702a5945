//! The commands, one in each file. Data goes to standard output, and messages to standard error.

mod accuracy;
mod stability;

use std::process::ExitCode;

use clap::{Parser, Subcommand};

/// Whether everything held that the command checks.
type Outcome = Result<ExitCode, Box<dyn std::error::Error>>;

/// Measures run time against error, and the numerical stability, of the ways to intersect rays
#[derive(Parser)]
#[command(name = "cellray-bench", version)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Measure run time against error of every formulation
    Accuracy(accuracy::Arguments),
    /// Run the stress suite and check the guarantees about scenes
    Stability(stability::Arguments),
}

pub fn main() -> ExitCode {
    let outcome = match Arguments::parse().command {
        Command::Accuracy(arguments) => accuracy::run(&arguments),
        Command::Stability(arguments) => stability::run(&arguments),
    };
    outcome.unwrap_or_else(|error| {
        eprintln!("cellray-bench: error: {error}");
        ExitCode::FAILURE
    })
}
