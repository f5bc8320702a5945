//! The tables of `lab/kernels/measured.txt`, as Markdown with aligned columns.

use std::fmt::Write as _;
use std::ops::Range;

use crate::measure::{Cost, Measured, Timed};

/// The columns for each version in the table of times.
const VERSIONS: [&str; 2] = ["plain", "scheduled"];

/// The tables of all measurements.
#[must_use]
pub fn markdown(kernels: &[Measured]) -> String {
    let mut text = String::new();
    times(&mut text, kernels);
    text.push('\n');
    loops(&mut text, kernels);
    text.push('\n');
    errors(&mut text, kernels);
    text
}

fn times(text: &mut String, kernels: &[Measured]) {
    let mut rows = vec![
        [
            "kernel",
            "case",
            "objects",
            "version",
            "cycles",
            "a ray",
            "in stream",
            "even",
            "odd",
            "both",
        ]
        .map(String::from),
    ];
    for kernel in kernels {
        for timed in &kernel.cases {
            for (version, cost) in VERSIONS.iter().zip([&timed.plain, &timed.scheduled]) {
                rows.push(row(kernel, timed, version, cost));
            }
        }
    }
    write_table(text, &rows, 4..10);
}

fn row(kernel: &Measured, timed: &Timed, version: &str, cost: &Cost) -> [String; 10] {
    let main = cost.main();
    [
        kernel.kernel.into(),
        timed.case.into(),
        timed.objects.to_string(),
        version.into(),
        cost.call.cycles.to_string(),
        format!("{:.2}", timed.cycles_a_test(cost)),
        timed.cycles_in_stream(cost).map_or_else(String::new, |cycles| format!("{cycles:.2}")),
        percent(main.even_share()),
        percent(main.odd_share()),
        percent(main.dual_share()),
    ]
}

fn percent(share: f64) -> String {
    // The time may be 0: a kernel that leaves a list early has no cost for further objects.
    if share.is_finite() { format!("{:.1} %", 100.0 * share) } else { String::new() }
}

fn loops(text: &mut String, kernels: &[Measured]) {
    let mut rows = vec![
        ["kernel", "loop", "even", "odd", "bound", "interval", "stages", "reached"]
            .map(String::from),
    ];
    for kernel in kernels {
        for found in &kernel.loops {
            let [even, odd, bound, interval, stages, reached] = match found.form.cycles() {
                Some(cycles) => [
                    cycles.even.to_string(),
                    cycles.odd.to_string(),
                    cycles.bound.to_string(),
                    cycles.interval.to_string(),
                    cycles.stages.to_string(),
                    percent(cycles.reached()),
                ],
                None => [const { String::new() }; 6],
            };
            rows.push([
                kernel.kernel.into(),
                found.name.clone(),
                even,
                odd,
                bound,
                interval,
                stages,
                reached,
            ]);
        }
    }
    write_table(text, &rows, 2..8);
}

fn errors(text: &mut String, kernels: &[Measured]) {
    let mut rows = vec![["kernel", "measured", "stated"].map(String::from)];
    for kernel in kernels {
        let Some(error) = kernel.error else { continue };
        rows.push([kernel.kernel.into(), format!("{error:.2}"), kernel.stated_error.clone()]);
    }
    write_table(text, &rows, 1..2);
}

/// Writes rows with aligned columns. The first row is the heading. The columns in `numbers` are
/// aligned to the right.
fn write_table<const N: usize>(text: &mut String, rows: &[[String; N]], numbers: Range<usize>) {
    let widths: [usize; N] = std::array::from_fn(|column| {
        let cells = rows.iter().map(|row| row[column].chars().count());
        cells.max().unwrap_or(0).max(3)
    });
    for (number, row) in rows.iter().enumerate() {
        for (column, cell) in row.iter().enumerate() {
            let width = widths[column];
            let _ = if numbers.contains(&column) {
                write!(text, "| {cell:>width$} ")
            } else {
                write!(text, "| {cell:<width$} ")
            };
        }
        text.push_str("|\n");
        if number == 0 {
            for (column, width) in widths.iter().enumerate() {
                let end = if numbers.contains(&column) { ":" } else { "-" };
                let _ = write!(text, "|{}{end}", "-".repeat(width + 1));
            }
            text.push_str("|\n");
        }
    }
}
