//! Commands that replace this process by a separate program.
//!
//! Those programs need dependencies that a console, or a user who only renders, has no use for.

use std::ffi::{OsStr, OsString};
use std::io::ErrorKind;
use std::os::unix::process::CommandExt as _;
use std::path::Path;
use std::process::Command;

use clap::Args;

use super::Outcome;

/// A program that is built next to this one.
pub struct Program {
    name: &'static str,
    package: &'static str,
}

/// Compares the tracer with the f64 reference.
pub const BENCH: Program = Program { name: "cellray-bench", package: "accuracy" };

/// Windows, terminals, input devices, games.
pub const PLAY: Program = Program { name: "cellray-play", package: "cellray-play" };

/// Arguments that are passed on.
#[derive(Args)]
#[command(disable_help_flag = true)]
pub struct Arguments {
    /// Arguments of that program; --help prints them
    #[arg(trailing_var_arg = true, allow_hyphen_values = true, value_name = "ARGUMENTS")]
    arguments: Vec<OsString>,
}

impl Program {
    /// Replaces this process by the program; returns only if that fails.
    pub fn run(&self, command: Option<&str>, arguments: &Arguments) -> Outcome {
        let adjacent = std::env::current_exe()
            .ok()
            .map(|program| program.with_file_name(self.name))
            .filter(|program| program.is_file());
        // If there is none next to this program, PATH is searched.
        let program = adjacent.unwrap_or_else(|| Path::new(self.name).to_path_buf());
        let error =
            Command::new(&program).args(command.map(OsStr::new)).args(&arguments.arguments).exec();
        let hint = match error.kind() {
            ErrorKind::NotFound => {
                format!(": it is built by cargo build --release -p {}", self.package)
            }
            _ => String::new(),
        };
        Err(format!("{}: {error}{hint}", program.display()).into())
    }
}
