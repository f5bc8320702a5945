//! The one program for consoles.

use std::process::ExitCode;

fn main() -> ExitCode {
    console::main()
}
