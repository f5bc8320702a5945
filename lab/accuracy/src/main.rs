//! The command line of the benchmarks of accuracy and stability.

mod cli;

use std::process::ExitCode;

fn main() -> ExitCode {
    // SAFETY: this is the first statement of a program that has only one thread.
    unsafe { accuracy::pictures::simulate_time() };
    cli::main()
}
