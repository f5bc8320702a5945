//! Commands: data goes to standard output, talk to standard error.

mod bench;
mod fb;
mod info;
mod progress;
mod render;
mod run;
mod sphereflake;

use std::process::ExitCode;

use clap::{Parser, Subcommand};

type Outcome = Result<(), Box<dyn std::error::Error>>;

/// Interactive ray tracer for the Cell Broadband Engine under PS3 Linux.
///
/// The SPUs trace the picture, through the libspe2 that this program is linked to.
#[derive(Parser)]
#[command(name = "cellray", version, after_help = EXAMPLES, after_long_help = EXAMPLES)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

const EXAMPLES: &str = "\
Examples:
  cellray render scenes/paper16.nff --size 1280x720 --out paper16.png
  cellray render sphereflake:2 --spus 6 --frames 10 --stats - --out balls.png
  cellray fb scenes/paper16.nff --device /tmp/fb --size 1280x720
  cellray render scenes/far.nff --sphere paper --out far.png
  cellray bench accuracy
  cellray sphereflake 4 > balls.nff
  cellray info";

#[derive(Subcommand)]
enum Command {
    /// Trace a scene into a PNG file
    Render(render::Arguments),
    /// Trace a scene into a framebuffer, or a file in the place of one
    Fb(fb::Arguments),
    /// Measure run time against error, and numerical stability, by the program cellray-bench
    Bench(bench::Arguments),
    /// Write a sphereflake as an NFF scene to standard output
    Sphereflake(sphereflake::Arguments),
    /// Show the libspe2 that answers, its SPEs, and the framebuffer
    Info(info::Arguments),
}

pub fn main() -> ExitCode {
    let outcome = match Arguments::parse().command {
        Command::Render(arguments) => render::run(&arguments),
        Command::Fb(arguments) => fb::run(&arguments),
        Command::Bench(arguments) => bench::run(&arguments),
        Command::Sphereflake(arguments) => sphereflake::run(&arguments),
        Command::Info(arguments) => info::run(&arguments),
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("cellray: error: {error}");
            ExitCode::FAILURE
        }
    }
}
