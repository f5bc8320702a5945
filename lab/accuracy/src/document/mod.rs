//! The results as a part of a document: tables, plots and the formulations that no other beats, as
//! Markdown. People write the rest of the document, which stays as it is.
//!
//! Invariant: every number in the part comes from the results.

pub mod antialiasing;
mod pictures;
mod table;
#[cfg(test)]
mod tests;

use std::fmt::Write as _;
use std::fs;
use std::io::ErrorKind;
use std::path::Path;

use crate::families::{FAMILIES, Family, Form, triangles};
use crate::figures::{Figures, WELL_CONDITIONED};
use crate::file::OutputError;
use crate::metrics::Summary;
use crate::output::Document;
use crate::plots::{self, Plot, worst_distance, wrong_far_off};
use crate::run::{KernelRow, Results};
use crate::spheres::SphereRow;
use table::{Table, figure, option};

/// The prefix of the plots' file names, which are next to the document.
pub const PREFIX: &str = "accuracy-";

/// The longest line of a document.
const COLUMNS: usize = 120;

/// The line after a part that a command writes, as in `ci/common.sh`.
const END: &str = "<!-- end of what is written -->";

/// Puts the results into the document, which refers to plots next to it.
///
/// # Errors
///
/// Fails if the file can't be read or written.
pub fn write(document: &Document, path: &Path) -> Result<(), OutputError> {
    let plots = plots::plots(&document.results);
    if !document.results.pictures.is_empty() {
        put("pictures", &pictures::text(document, &plots), path)?;
    }
    if !document.results.kernels.is_empty() {
        put("accuracy", &text(document, &plots), path)?;
    }
    Ok(())
}

/// Replaces the part of this name in a document, or adds it to one that has none.
fn put(name: &str, part: &str, path: &Path) -> Result<(), OutputError> {
    let document = match fs::read_to_string(path) {
        Err(error) if error.kind() == ErrorKind::NotFound => String::new(),
        read => read.map_err(OutputError::of(path.display()))?,
    };
    fs::write(path, with_part(&document, name, part)).map_err(OutputError::of(path.display()))
}

/// The document with a part between the two lines of its name.
fn with_part(document: &str, name: &str, part: &str) -> String {
    let begin = format!("<!-- {name}: written by cellray-bench -->");
    let lines = document
        .split_once(&begin)
        .and_then(|(before, rest)| Some((before, rest.split_once(END)?.1)));
    let (before, after) = lines.unwrap_or((document, "\n"));
    format!("{before}{begin}\n\n{}\n\n{END}{after}", filled(part.trim()))
}

/// The text with its long lines broken between words, except those of tables and images.
fn filled(text: &str) -> String {
    let mut filled = String::new();
    for line in text.lines() {
        let mut column = 0;
        for (at, word) in line.split(' ').enumerate() {
            let is_long = column + 1 + word.chars().count() > COLUMNS;
            if column > 0 && is_long && !line.starts_with(['|', '!']) {
                filled.push('\n');
                column = 0;
            } else if at > 0 {
                filled.push(' ');
                column += 1;
            }
            filled.push_str(word);
            column += word.chars().count();
        }
        filled.push('\n');
    }
    filled.trim_end().to_owned()
}

/// The text of the kernels' results.
fn text(document: &Document, plots: &[Plot]) -> String {
    let results = &document.results;
    let mut text = origin(document);
    text.push_str(READING);
    text.push_str(&formulations(results));
    for form in Form::ALL {
        text.push_str(&spheres(results, plots, form));
    }
    text.push_str(&families(results));
    text.push_str(&flat(results));
    text.push_str(&roots(results));
    text
}

/// Where and how the results were measured.
fn origin(document: &Document) -> String {
    let Some(origin) = &document.origin else {
        return String::new();
    };
    format!(
        "Written by `{}`.\nMachine: {}. Commit: {}. Seed: {}.\n",
        origin.command, origin.machine, origin.commit, document.results.seed
    )
}

const READING: &str = "
## Measured formulations

- *Truth* is exact for the very singles that a kernel gets. A distance counts along the direction at length 1.
- *ulps*: spacings of singles. For a distance, at the true distance; for a point, at its largest coordinate from
  the ray's origin. Half an ulp is the best that rounding to nearest could give.
- *cycles*: of the timing model ([timing.md](timing.md)), for one ray and one sphere in a long list. *host*:
  nanoseconds of this machine's interpreter for the same.
- *wrong hits, wrong misses*: the kernel decides otherwise than exact arithmetic.
- *condition*: the number of ulps by which the true distance moves if each given number moves by half an ulp, in
  the worst combination. In a well-conditioned family, whose mean is small, an error is the formulation's own.
- *not beaten*: no other kernel is at least as good in both run time and error, and better in one of them.
";

fn formulations(results: &Results) -> String {
    // A formulation has one row for all of its forms.
    let mut rows: Vec<Vec<&KernelRow>> = Vec::new();
    for kernel in &results.kernels {
        match rows.iter_mut().find(|row| row[0].formulation == kernel.formulation) {
            Some(row) => row.push(kernel),
            None => rows.push(vec![kernel]),
        }
    }
    let table = Table::of(
        &rows,
        &[
            ("formulation", |row| row[0].formulation.clone()),
            ("for", |row| {
                let forms: Vec<&str> = row.iter().map(|kernel| kernel.form.as_str()).collect();
                forms.join(", ")
            }),
            ("what it computes", |row| row[0].doc.clone()),
        ],
    );
    let mut text = format!("\n### Formulations\n\n{table}");
    for kernel in results.kernels_of("triangle") {
        let cycles = figure(kernel.cycles_a_ray);
        _ = writeln!(text, "\nA triangle by {}: {cycles} cycles.", kernel.formulation);
    }
    text
}

fn most(summary: Option<Summary>) -> String {
    option(summary.map(|summary| summary.max))
}

fn p999(summary: Option<Summary>) -> String {
    option(summary.map(|summary| summary.p999))
}

fn mean(summary: Option<Summary>) -> String {
    option(summary.map(|summary| summary.mean))
}

/// A plot and the names of the points that no other beats.
fn shown(plots: &[Plot], name: &str) -> String {
    let Some(plot) = plots.iter().find(|plot| plot.name == name) else {
        return String::new();
    };
    titled(plot, PREFIX)
}

/// A plot, in a file with this prefix, and the names of the points that no other beats.
fn titled(plot: &Plot, prefix: &str) -> String {
    let mut text = format!("\n![{}]({prefix}{}.svg)\n", plot.title, plot.name);
    if !plot.front.is_empty() {
        _ = writeln!(text, "\nNot beaten: {}.", plot.front.join(", "));
    }
    text
}

/// A kernel and all of its rows.
type Kernel<'a> = (&'a KernelRow, Vec<&'a SphereRow>);

/// The largest value of a figure over the well-conditioned families.
fn largest((_, rows): &Kernel<'_>, of: fn(&Figures) -> Option<f64>) -> String {
    let sound = rows.iter().filter_map(|row| row.figures.sound(of)?);
    option(sound.reduce(f64::max))
}

fn spheres(results: &Results, plots: &[Plot], form: Form) -> String {
    let title = match form {
        Form::Eye => "Spheres, rays from the eye",
        Form::General => "Spheres, rays from anywhere",
    };
    let kernels: Vec<Kernel<'_>> = results
        .kernels_of(form.name())
        .map(|kernel| (kernel, results.spheres_of(form, &kernel.formulation)))
        .collect();
    let table = Table::of(
        &kernels,
        &[
            ("formulation", |(kernel, _)| kernel.formulation.clone()),
            ("cycles", |(kernel, _)| figure(kernel.cycles_a_ray)),
            ("distance: largest, ulps", |(_, rows)| option(worst_distance(rows))),
            ("99.9 %", |of| largest(of, |of| Some(of.distance_ulps?.p999))),
            ("mean", |of| largest(of, |of| Some(of.distance_ulps?.mean))),
            ("point: largest", |of| largest(of, |of| Some(of.point_ulps?.max))),
            ("wrong at 4096, %", |(_, rows)| option(wrong_far_off(rows))),
        ],
    );
    let mut text = format!(
        "\n### {title}\n\nEach number is the largest of all well-conditioned families.\n\n{table}"
    );
    for plot in ["distance", "ratio"] {
        text.push_str(&shown(plots, &format!("{plot}-{}", form.name())));
    }
    text.push_str("\nLargest error of other families, in ulps; in brackets wrong hits and wrong misses, if any:\n\n");
    text.push_str(&by_family(form, &kernels).to_string());
    text
}

/// A table with families as rows and formulations as columns. The plot shows the families of a
/// ratio.
fn by_family(form: Form, kernels: &[Kernel<'_>]) -> Table {
    let names = kernels.iter().map(|(kernel, _)| kernel.formulation.as_str());
    let mut table = Table::new(std::iter::once("family").chain(names));
    let listed = |family: &&Family| family.ratio.is_none() && family.forms.contains(&form);
    for family in FAMILIES.iter().filter(listed) {
        let cell = |(_, rows): &Kernel<'_>| {
            let Some(row) = rows.iter().find(|row| row.family == family.name) else {
                return String::new();
            };
            let of = &row.figures;
            let off = most(of.distance_ulps);
            match (of.wrong_hits, of.wrong_misses) {
                (0, 0) => off,
                (hits, misses) => format!("{off} ({hits}, {misses})"),
            }
        };
        let name = std::iter::once(family.name.to_owned());
        table.row(name.chain(kernels.iter().map(cell)));
    }
    table
}

fn families(results: &Results) -> String {
    let rows = FAMILIES.iter().filter(|family| family.ratio.is_none()).map(|family| {
        let condition = Form::ALL.map(|form| {
            let of = |row: &&SphereRow| row.form == form && row.family == family.name;
            results.spheres.iter().find(of).and_then(|row| row.figures.condition)
        });
        (family, condition)
    });
    let table = Table::of(
        rows.filter(|(_, condition)| condition.iter().any(Option::is_some)),
        &[
            ("family", |(family, _)| family.name.to_owned()),
            ("content", |(family, _)| family.doc.to_owned()),
            ("eye: mean", |(_, [eye, _])| mean(*eye)),
            ("largest", |(_, [eye, _])| most(*eye)),
            ("anywhere: mean", |(_, [_, general])| mean(*general)),
            ("largest", |(_, [_, general])| most(*general)),
        ],
    );
    format!(
        "\n### Families of spheres\n\nTheir condition; the plots show the families of a ratio. Well-conditioned: the mean is at most \
         {WELL_CONDITIONED}.\n\n{table}"
    )
}

fn flat(results: &Results) -> String {
    if results.triangles.is_empty() {
        return String::new();
    }
    let table = Table::of(
        &results.triangles,
        &[
            ("formulation", |row| row.formulation.clone()),
            ("family", |row| row.family.clone()),
            ("rays", |row| row.figures.rays.to_string()),
            ("wrong hits", |row| row.figures.wrong_hits.to_string()),
            ("wrong misses", |row| row.figures.wrong_misses.to_string()),
            ("distance: largest, ulps", |row| most(row.figures.distance_ulps)),
            ("99.9 %", |row| p999(row.figures.distance_ulps)),
            ("mean", |row| mean(row.figures.distance_ulps)),
            ("point: largest", |row| most(row.figures.point_ulps)),
            ("condition: mean", |row| mean(row.figures.condition)),
        ],
    );
    let mut text = format!("\n### Triangles\n\n{table}\n");
    for family in triangles::FAMILIES {
        _ = writeln!(text, "- {}: {}.", family.name, family.doc);
    }
    text.push_str(
        "\nA wrong miss at a shared edge is a leak: the ray passes between two triangles that touch there.\n",
    );
    text
}

fn roots(results: &Results) -> String {
    if results.roots.is_empty() {
        return String::new();
    }
    let table = Table::of(
        &results.roots,
        &[
            ("kernel", |row| row.kernel.clone()),
            ("computes", |row| row.quantity.clone()),
            ("cycles", |row| figure(row.cycles_an_operand)),
            ("host, ns", |row| option(row.host_ns_an_operand)),
            ("largest, ulps", |row| figure(row.ulps.max)),
            ("99.9 %", |row| figure(row.ulps.p999)),
            ("mean", |row| figure(row.ulps.mean)),
            ("worst operand", |row| format!("`{}`", row.worst)),
        ],
    );
    format!(
        "\n### Reciprocals and roots\n\nMeasured over every fraction that an operand can have: one octave, or two for roots.\n\n{table}"
    )
}
