//! The command line: its commands, and what runs them. Data goes to standard output, messages go to
//! standard error.

mod camera;
mod external;
mod fb;
mod info;
#[cfg_attr(target_arch = "powerpc64", path = "inspect_absent.rs")]
mod inspect;
mod new;
mod options;
mod progress;
mod render;
mod run;
mod sequence;
mod shader;
mod sphereflake;

use std::process::ExitCode;

use clap::{CommandFactory as _, Parser, Subcommand};

use crate::framebuffer;

/// What a command ends with.
pub type Outcome = Result<(), Box<dyn std::error::Error>>;

/// Interactive ray tracer for the Cell Broadband Engine under PS3 Linux.
///
/// SPUs trace the picture. The libspe2 that this program is linked with provides them.
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
  cellray render scenes/whitted16.nff --antialias 1 --colour linear --out nff.png
  cellray render scenes/still-life.nff --inspect frame.html
  cellray render scenes/whitted16.nff --frames 0..250 --out 'f-%05d.png'
  cellray play billiards
  cellray view scenes/whitted16.nff
  cellray bench accuracy
  cellray new mygame
  cellray render scene.nff --shader stripes.s --watch --out scene.png
  cellray sphereflake 4 > balls.nff
  cellray info";

/// The commands.
#[derive(Subcommand)]
pub enum Command {
    /// Render a scene to a picture, or to a sequence of pictures
    Render(render::Arguments),
    /// Render a scene to a framebuffer, or to a file in its format
    Fb(fb::Arguments),
    /// Play a game with the program cellray-play; without a name, list the games
    Play(external::Arguments),
    /// View a scene from all sides with the program cellray-play
    View(external::Arguments),
    /// Measure run time, error and numerical stability with the program cellray-bench
    Bench(external::Arguments),
    /// Show a PNG file in the terminal with the program cellray-play
    Show(external::Arguments),
    /// Create a folder with a game of your own, ready to run
    New(new::Arguments),
    /// Assemble, schedule and link shaders of your own
    Shader(shader::Arguments),
    /// Write man pages and shell completions
    #[command(hide = true)]
    Pages(messages::manual::Arguments),
    /// Write a sphereflake as an NFF scene to standard output
    Sphereflake(sphereflake::Arguments),
    /// Show the libspe2 in use, its SPEs, and the framebuffer
    Info(info::Arguments),
}

/// Runs the program's command line. Returns the exit code.
pub fn main() -> ExitCode {
    match dispatch(&Arguments::parse().command) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            messages::print!("cellray: error: {error}");
            ExitCode::FAILURE
        }
    }
}

/// Runs a command.
///
/// # Errors
/// The command fails.
pub fn dispatch(command: &Command) -> Outcome {
    framebuffer::refuse_large_files()?;
    match command {
        Command::Render(arguments) => render::run(arguments),
        Command::Fb(arguments) => fb::run(arguments),
        Command::Play(arguments) => external::PLAY.run(Some("play"), arguments),
        Command::View(arguments) => external::PLAY.run(Some("view"), arguments),
        Command::Bench(arguments) => external::BENCH.run(None, arguments),
        Command::Show(arguments) => external::PLAY.run(Some("show"), arguments),
        Command::New(arguments) => new::run(arguments),
        Command::Shader(arguments) => shader::run(arguments),
        Command::Pages(arguments) => Ok(messages::manual::write(Arguments::command(), arguments)?),
        Command::Sphereflake(arguments) => sphereflake::run(arguments),
        Command::Info(arguments) => info::run(arguments),
    }
}
