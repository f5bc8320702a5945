//! The command line of cellray.

use std::process::ExitCode;

fn main() -> ExitCode {
    cellray::cli::main()
}
