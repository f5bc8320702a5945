//! `cellray bench`: hands over to `cellray-bench`, which holds the tracer against the f64 reference.
//!
//! A program of its own, since it carries the reference and the emulator, which a console has no use for.

use std::ffi::OsString;
use std::io::ErrorKind;
use std::os::unix::process::CommandExt as _;
use std::path::Path;
use std::process::Command;

use clap::Args;

use super::Outcome;

const PROGRAM: &str = "cellray-bench";

/// Measure run time against error, and numerical stability.
#[derive(Args)]
#[command(disable_help_flag = true)]
pub struct Arguments {
    /// What cellray-bench is to do: `accuracy` or `stability`, and its options
    #[arg(
        trailing_var_arg = true,
        allow_hyphen_values = true,
        value_name = "ARGUMENTS"
    )]
    arguments: Vec<OsString>,
}

pub fn run(arguments: &Arguments) -> Outcome {
    let beside = std::env::current_exe()
        .ok()
        .map(|program| program.with_file_name(PROGRAM))
        .filter(|program| program.is_file());
    // Without one beside it, one on PATH.
    let program = beside.unwrap_or_else(|| Path::new(PROGRAM).to_path_buf());
    let error = Command::new(&program).args(&arguments.arguments).exec();
    let hint = match error.kind() {
        ErrorKind::NotFound => ": it is built by cargo build --release -p accuracy",
        _ => "",
    };
    Err(format!("{}: {error}{hint}", program.display()).into())
}
