//! The page that compares console and model, as Markdown, and the table for a terminal.
//!
//! Invariant: every figure of the model in it was measured by the run that writes it.

use std::fmt::Write as _;

use crate::results::{Value, model};
use crate::rows::{Console, Row};

const HEAD: &str = "# The clock against a console

How the emulator's clock compares with a PlayStation 3, row by row: for everyone who judges the figures of this project.

Each row is a small program in SPU assembly (`lab/clock/spu`), which times itself by the SPU's decrementer. It runs on
the emulator and on a console alike:

    cellray-bench clock                         prints this table for the machine that it runs on
    cellray-bench clock --out clock.json        also writes a file, which the owner of a console can send
    cellray-bench clock --write                 writes this page and `lab/clock/model.json`

[ps3.md](ps3.md#the-clock) has the command for a console. The figures of the console below were not made by these
programs but by benchmarks of others, SpuTest and cellmark among them, whose patterns these programs follow. *ran*: the
source's own program was also run in the emulator and its printed figure compared. *read*: the figure, and the code that
made it, were read; several of these programs were run as well, but our notes don't name them. Under the console's own
system six busy SPUs take 1.062 times as long, because it takes a share; the figures of six SPUs at main memory are
without that share.

A test measures all rows. It fails if a row leaves its band, or if it gives another figure than this page has
(`lab/clock/tests/bands.rs`).

";

const CHOICES: &str = "
## Fitted and unknown figures

- *Constants.* The model's constants, each with its source, are in `emulator/machine/src/simulated/figures.rs`. The constants of
  lines, puts, rings and atomic commands were chosen so that the rows above come out. They are therefore no independent
  confirmation; the rows of the pipelines are.
- *Rings.* The four rings are one resource, at 3.6 cycles a line, which is what six flows between three pairs got. One
  flow and five flows into one local store are limited by ports. Between those loads, and for other places of SPEs on the
  rings, the model is a guess. Lines to and from main memory do not take the rings.
- *Tenths.* A line takes 17.0, 17.3 or 17.4 cycles. Reservations are kept in tenths of a cycle, which is what the
  measurements resolve. Sums of integers are the same on every host. A line that is written takes a slot of main memory
  like one that is read, and an additional slot whenever the 0.4 cycles of difference add up to one.
- *Puts to one line.* Only a transfer's first and last line can wait for a put of another SPE. A put never waits for
  earlier puts of the same SPE.
- *Atomic commands.* The latency is the same whether the own atomic unit, another one, or main memory has the line,
  because the measurements are of lines that several SPEs want. One SPE alone is therefore probably served too slowly.
- *Unloaded latency.* Nobody has published the latency of a `get` from main memory without load. 280 cycles after the
  line's own time stand in the model. About 10 GB/s for one SPE alone are remembered from the literature; that would
  need twice that latency or half the lines in flight.
- *Signals.* A signal of another SPE is timed like a transfer to its local store. The numbers of SPUs are those of
  contexts: which places on the rings they have is the kernel's choice, which the program can't determine.
- *The PPE.* Its calls are estimates of Linux, and the only figure found is of another system.

## The PPE's share

The PPE's own computations take no simulated time, so the clock does not show how busy it is.
[ps3.md](ps3.md#the-ppes-share) has a bound by a count of instructions. Where the documents give the SPUs less time for a
frame than the PPE needs to prepare one, a console would be slower than predicted, unless the frame shows what the last
one showed.

## Another machine

`LIBSPE2_MACHINE=FILE`, `spu run --timing --machine FILE` and `spu time --machine FILE` take another machine's figures
from a TOML file. Names and units are those of `Rules`, `MemoryFigures` and `PpeFigures`; what the file does not name is
the console's:

    [pipelines]
    hint_cycles = 15
    [memory]
    get_line = 16.0
    get_latency = 400
    [ppe]
    call_cycles = 1600
";

/// The whole page, with the rows and the model's figures of them.
#[must_use]
pub fn page(rows: &[Row], values: &[Value]) -> String {
    let mut text = HEAD.to_owned();
    text.push_str("## Rows with a figure of a console\n\n");
    text.push_str(
        "| row | pattern | unit | console | model | error | band | certainty | source |\n",
    );
    text.push_str("|---|---|---|---|---|---|---|---|---|\n");
    for (row, value) in pairs(rows, values) {
        if let Some(console) = &row.console {
            // Without a sign of a zero.
            let error = (10.0 * error(console, value)).round() / 10.0 + 0.0;
            // Writing to a string can't fail.
            let _ = writeln!(
                text,
                "| {} | {} | {} | {} | {} | {error:+.1} % | {:.0} % | {} | {} |",
                row.name,
                row.what,
                row.unit,
                figure(console.value),
                figure(value),
                100.0 * console.band,
                console.certainty.name(),
                console.source
            );
        }
    }
    text.push_str("\n## Rows that nobody has published\n\n");
    text.push_str("The model's figures, to be confirmed or refuted by the first console that runs the program.\n\n");
    text.push_str("| row | pattern | unit | model |\n|---|---|---|---|\n");
    for (row, value) in pairs(rows, values) {
        if row.console.is_none() {
            let value = figure(value);
            let _ = writeln!(text, "| {} | {} | {} | {value} |", row.name, row.what, row.unit);
        }
    }
    text.push_str(CHOICES);
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
