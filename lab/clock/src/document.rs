//! The tables that compare console and model: as Markdown, and for a terminal.
//!
//! Invariant: every figure of the model in it was measured by the run that writes it.

use std::fmt::Write as _;

use crate::results::{Value, model};
use crate::rows::{Console, Row};

/// The line before the table in `docs/timing.md`.
const BEGIN: &str = "<!-- clock: written by cellray-bench clock --write -->\n";
/// The line after it.
const END: &str = "<!-- end of what is written -->\n";

/// The document with the rows that a console has a figure for, or nothing if it has no lines for
/// the table.
#[must_use]
pub fn renewed(document: &str, rows: &[Row], values: &[Value]) -> Option<String> {
    let (before, rest) = document.split_once(BEGIN)?;
    let (_, after) = rest.split_once(END)?;
    Some(format!("{before}{BEGIN}\n{}\n{END}{after}", published(rows, values)))
}

/// The rows that a console has a figure for.
fn published(rows: &[Row], values: &[Value]) -> String {
    let mut text = String::from(
        "| row | pattern | unit | console | model | error | certainty |\n|---|---|---|---|---|---|---|\n",
    );
    for (row, value) in pairs(rows, values) {
        if let Some(console) = &row.console {
            // Without a sign of a zero.
            let error = (10.0 * error(console, value)).round() / 10.0 + 0.0;
            // Writing to a string can't fail.
            let _ = writeln!(
                text,
                "| {} | {} | {} | {} | {} | {error:+.1} % | {} |",
                row.name,
                row.what,
                row.unit,
                figure(console.value),
                figure(value),
                console.certainty.name(),
            );
        }
    }
    text
}

/// The table for a terminal: this machine, the model, and the console that others measured.
#[must_use]
pub fn table(rows: &[Row], values: &[Value]) -> String {
    let model = model();
    let mut text = format!(
        "{:<20} {:>12} {:>12} {:>12}  {:<16} {}\n",
        "row", "this machine", "model", "published", "unit", "pattern"
    );
    for (row, value) in pairs(rows, values) {
        let known = model.iter().find(|value| value.row == row.name);
        let known = known.map_or_else(String::new, |known| figure(known.value));
        let published = row.console.map(|console| figure(console.value));
        let _ = writeln!(
            text,
            "{:<20} {:>12} {known:>12} {:>12}  {:<16} {}",
            row.name,
            figure(value),
            published.unwrap_or_default(),
            row.unit,
            row.what
        );
    }
    text
}

/// The error of a figure against the console's, in per cent.
#[must_use]
pub fn error(console: &Console, value: f64) -> f64 {
    100.0 * (value / console.value - 1.0)
}

fn pairs<'a>(rows: &'a [Row], values: &'a [Value]) -> impl Iterator<Item = (&'a Row, f64)> {
    rows.iter().filter_map(|row| {
        let value = values.iter().find(|value| value.row == row.name);
        value.map(|value| (row, value.value))
    })
}

/// Four digits.
fn figure(value: f64) -> String {
    let decimals = match value.abs() {
        ..10.0 => 3,
        ..100.0 => 2,
        ..1000.0 => 1,
        _ => 0,
    };
    format!("{value:.decimals$}")
}
