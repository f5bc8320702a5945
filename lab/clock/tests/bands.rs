//! Measures every row in simulated time. It sets the environment of the whole process, so it is a
//! program of its own. `MAKE_REF=1` writes docs/timing.md and model.json instead, as
//! `cellray-bench clock --write` does.

#![allow(
    clippy::print_stdout,
    clippy::print_stderr,
    reason = "a test has nothing to lose but its output"
)]

use std::process::ExitCode;

use clock::document::{error, renewed};
use clock::results::{Value, model};
use clock::rows::all;

fn main() -> ExitCode {
    // SAFETY: this is the first statement of a program that has only one thread.
    unsafe { std::env::set_var("LIBSPE2_TIMING", "1") };
    let rows = all();
    let mut failures = Vec::new();
    let mut values: Vec<Value> = Vec::new();
    for row in &rows {
        match row.measure() {
            Err(error) => failures.push(format!("{}: {error}", row.name)),
            Ok(value) => {
                if let Some(console) = &row.console {
                    let error = error(console, value.value);
                    println!("{}: {:.2}, {error:+.1} %", row.name, value.value);
                    if error.abs() > 100.0 * console.band {
                        failures.push(format!("{} is out of its band: {error:+.1} %", row.name));
                    }
                }
                values.push(value);
            }
        }
    }
    let document = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/timing.md");
    if std::env::var_os("MAKE_REF").is_some() {
        let figures = serde_json::to_string_pretty(&values).expect("figures are numbers") + "\n";
        let model = concat!(env!("CARGO_MANIFEST_DIR"), "/model.json");
        std::fs::write(model, figures).expect("the working copy can be written");
        let text = std::fs::read_to_string(document).expect("the working copy can be read");
        let text = renewed(&text, &rows, &values).expect("the document has lines for the table");
        std::fs::write(document, text).expect("the working copy can be written");
        return ExitCode::SUCCESS;
    }
    // Every run gives the same figures, to the bit.
    for value in &values {
        if !model().contains(value) {
            failures.push(format!("{value:?} differs from lab/clock/model.json"));
        }
    }
    match std::fs::read_to_string(document) {
        Ok(text) if renewed(&text, &rows, &values).as_ref() == Some(&text) => {}
        Ok(_) => failures.push(format!("{document} is stale: cellray-bench clock --write")),
        Err(error) => failures.push(format!("{document}: {error}")),
    }
    for failure in &failures {
        eprintln!("{failure}");
    }
    if failures.is_empty() { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}
