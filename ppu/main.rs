//! The command line of cellray.

mod cli;

use std::process::ExitCode;

fn main() -> ExitCode {
    cli::main()
}
