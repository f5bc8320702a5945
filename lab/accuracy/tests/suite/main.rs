//! Tests the program from outside: its command line, the files that it writes, and whether all
//! bounds hold.

mod accuracy;
mod search;
mod stability;

use std::process::{Command, Output};

/// The output of a command of `cellray-bench` with these arguments.
fn bench(command: &str, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_cellray-bench"))
        .arg(command)
        .args(arguments)
        .output()
        .expect("the program starts")
}
