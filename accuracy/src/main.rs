//! The command line of the benchmarks of accuracy and stability.

mod cli;

use std::process::ExitCode;

fn main() -> ExitCode {
    cli::main()
}
