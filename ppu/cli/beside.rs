//! Commands that are programs of their own, to which this one hands over.
//!
//! They carry what a console has no use for, or what those who only render have none for.

use std::ffi::{OsStr, OsString};
use std::io::ErrorKind;
use std::os::unix::process::CommandExt as _;
use std::path::Path;
use std::process::Command;

use clap::Args;

use super::Outcome;

/// A program that is built beside this one.
pub struct Program {
    name: &'static str,
    package: &'static str,
}

/// Holds the tracer against the f64 reference.
pub const BENCH: Program = Program {
    name: "cellray-bench",
    package: "accuracy",
};

/// Windows, terminals, input devices, games.
pub const PLAY: Program = Program {
    name: "cellray-play",
    package: "cellray-play",
};

/// What the other program is to do.
#[derive(Args)]
#[command(disable_help_flag = true)]
pub struct Arguments {
    /// Arguments of the program that it hands over to; --help has them
    #[arg(
        trailing_var_arg = true,
        allow_hyphen_values = true,
        value_name = "ARGUMENTS"
    )]
    arguments: Vec<OsString>,
}

impl Program {
    /// Hands over; there is only a failure to come back with.
    pub fn run(&self, command: Option<&str>, arguments: &Arguments) -> Outcome {
        let beside = std::env::current_exe()
            .ok()
            .map(|program| program.with_file_name(self.name))
            .filter(|program| program.is_file());
        // Without one beside it, one on PATH.
        let program = beside.unwrap_or_else(|| Path::new(self.name).to_path_buf());
        let error = Command::new(&program)
            .args(command.map(OsStr::new))
            .args(&arguments.arguments)
            .exec();
        let hint = match error.kind() {
            ErrorKind::NotFound => {
                format!(": it is built by cargo build --release -p {}", self.package)
            }
            _ => String::new(),
        };
        Err(format!("{}: {error}{hint}", program.display()).into())
    }
}
