//! The commands, one in each file. Data goes to standard output, and messages to standard error.

mod accuracy;
mod clock;
mod compare;
mod mesh_cache;
mod search;
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
    /// Measure run time against error of pictures, and of every formulation
    Accuracy(accuracy::Arguments),
    /// Run the stress suite and check the guarantees about scenes
    Stability(stability::Arguments),
    /// Search for small scenes whose pictures have the most wrong pixels over those that single
    /// precision must get wrong
    Search(search::Arguments),
    /// Measure pipelines, memory and interconnect by small SPU programs
    Clock(clock::Arguments),
    /// Compare a console's report with the model, row by row
    Compare(compare::Arguments),
    /// Draw how many blocks of a mesh an SPU caches against frames a second and bytes a ray
    MeshCache(mesh_cache::Arguments),
}

pub fn main() -> ExitCode {
    let command = Arguments::parse().command;
    // The search's and the clock's programs are built in, and plots need none. The others need the
    // kernels' sources.
    if !matches!(
        command,
        Command::Search(_) | Command::Clock(_) | Command::Compare(_) | Command::MeshCache(_)
    ) && let Err(error) = kernels::set::Kernels::here()
    {
        messages::print!("cellray-bench: error: {error}");
        return ExitCode::FAILURE;
    }
    let outcome = match command {
        Command::Accuracy(arguments) => accuracy::run(&arguments),
        Command::Stability(arguments) => stability::run(&arguments),
        Command::Search(arguments) => search::run(&arguments),
        Command::Clock(arguments) => clock::run(&arguments),
        Command::Compare(arguments) => compare::run(&arguments),
        Command::MeshCache(arguments) => mesh_cache::run(&arguments),
    };
    outcome.unwrap_or_else(|error| {
        messages::print!("cellray-bench: error: {error}");
        ExitCode::FAILURE
    })
}
