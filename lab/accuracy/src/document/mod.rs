//! The document with the results: tables, plots and the formulations that no other beats, as
//! Markdown.
//!
//! Invariant: every number in it comes from the results.

pub mod antialiasing;
mod table;
#[cfg(test)]
mod tests;

use std::fmt::Write as _;
use std::fs;
use std::path::Path;

use crate::families::{FAMILIES, Form, triangles};
use crate::figures::{Figures, WELL_CONDITIONED};
use crate::file::OutputError;
use crate::metrics::Summary;
use crate::output::Document;
use crate::pictures::{PictureRow, SCENES};
use crate::plots::{self, Plot, worst_distance, wrong_far_off};
use crate::run::{KernelRow, Results};
use crate::spheres::SphereRow;
use table::{Table, figure, option};

/// The prefix of the plots' file names, which are next to the document.
pub const PREFIX: &str = "accuracy-";

/// Writes the document, which refers to plots next to it.
///
/// # Errors
///
/// Fails if the file can't be written.
pub fn write(document: &Document, path: &Path) -> Result<(), OutputError> {
    fs::write(path, text(document)).map_err(OutputError::of(path.display()))
}

/// The document's text.
pub fn text(document: &Document) -> String {
    let results = &document.results;
    let plots = plots::plots(results);
    let mut text = head(document);
    text.push_str(READING);
    text.push_str(&formulations(results));
    for form in Form::ALL {
        text.push_str(&spheres(results, &plots, form));
    }
    text.push_str(&families(results));
    text.push_str(&flat(results));
    text.push_str(&roots(results, &plots));
    text.push_str(&pictures(results, &plots));
    text
}

fn head(document: &Document) -> String {
    let mut text = "# Run time against error\n\n".to_owned();
    text.push_str(
        "The cost and the error of every way to intersect rays with spheres and triangles, for readers who choose\n\
         between them or doubt them. Each way is a kernel of its own. The tracer is linked with one for each\n\
         purpose (`protocol/src/formulation.rs`).\n\n",
    );
    let results = &document.results;
    if let Some(origin) = &document.origin {
        let command = &origin.command;
        _ = writeln!(text, "Written by `{command}`.\n");
        _ = writeln!(
            text,
            "Machine: {}. Commit: {}. Seed: {}. Rays of each family: {}.",
            origin.machine,
            origin.commit,
            results.seed,
            results.spheres.first().map_or(0, |row| row.figures.rays)
        );
    }
    text
}

const READING: &str = "
## How to read it

- *Truth* is exact for the very singles that a kernel gets. It is computed in double precision with a bound of
  its own rounding. Where that bound leaves a verdict or 1/64 ulp open, it is computed with numbers of any
  length. A distance counts along the direction at length 1.
- *ulps*: spacings of singles. For a distance, at the true distance; for a point, at its largest coordinate from
  the ray's origin; for a normal, at 1. The SPU truncates. Half an ulp is the best that rounding to nearest
  could give.
- *cycles*: from the timing model ([timing.md](timing.md)), for one ray and one sphere in a long list. *host*:
  nanoseconds of this machine's interpreter for the same.
- *wrong hits, wrong misses*: the kernel decides otherwise than exact arithmetic.
- *condition*: the number of ulps by which the true distance moves if each given number moves by half an ulp, in
  the worst combination. A family is well-conditioned if the mean of that is small. An error there is the
  formulation's own.
- *not beaten*: no other kernel is at least as good in both run time and error, and better in one of them.
";

fn formulations(results: &Results) -> String {
    let table = Table::of(
        &results.kernels,
        &[
            ("formulation", |row| row.formulation.clone()),
            ("for", |row| row.form.clone()),
            ("what it computes", |row| row.doc.clone()),
            ("cycles", |row| figure(row.cycles_a_ray)),
            ("host, ns", |row| option(row.host_ns_a_ray)),
        ],
    );
    format!("\n## Formulations\n\n{table}")
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
            ("host, ns", |(kernel, _)| option(kernel.host_ns_a_ray)),
            ("distance: largest, ulps", |(_, rows)| option(worst_distance(rows))),
            ("99.9 %", |of| largest(of, |of| Some(of.distance_ulps?.p999))),
            ("mean", |of| largest(of, |of| Some(of.distance_ulps?.mean))),
            ("point: largest", |of| largest(of, |of| Some(of.point_ulps?.max))),
            ("wrong at 4096, %", |(_, rows)| option(wrong_far_off(rows))),
        ],
    );
    let mut text = format!(
        "\n## {title}\n\nEach number is the largest of all well-conditioned families.\n\n{table}"
    );
    for plot in ["distance", "verdicts", "ratio"] {
        text.push_str(&shown(plots, &format!("{plot}-{}", form.name())));
    }
    text.push_str("\nLargest error of the distance, in ulps; in brackets wrong hits and wrong misses, if any:\n\n");
    text.push_str(&by_family(form, &kernels).to_string());
    text
}

/// A table with families as rows and formulations as columns.
fn by_family(form: Form, kernels: &[Kernel<'_>]) -> Table {
    let names = kernels.iter().map(|(kernel, _)| kernel.formulation.as_str());
    let mut table = Table::new(std::iter::once("family").chain(names));
    for family in FAMILIES.iter().filter(|family| family.forms.contains(&form)) {
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
    let all =
        Form::ALL.into_iter().flat_map(|form| FAMILIES.iter().map(move |family| (form, family)));
    let rows = all.filter_map(|(form, family)| {
        let of = |row: &&SphereRow| row.form == form && row.family == family.name;
        Some((family, results.spheres.iter().find(of)?))
    });
    let table = Table::of(
        rows,
        &[
            ("family", |(family, _)| family.name.to_owned()),
            ("for", |(_, row)| row.form.name().to_owned()),
            ("what is in it", |(family, _)| match family.ratio {
                Some(_) => format!("distance/radius as named, {}", family.doc),
                None => family.doc.to_owned(),
            }),
            ("condition: mean", |(_, row)| mean(row.figures.condition)),
            ("largest", |(_, row)| most(row.figures.condition)),
            ("well-conditioned", |(_, row)| {
                if row.figures.well_conditioned { "yes" } else { "no" }.to_owned()
            }),
        ],
    );
    format!(
        "\n## Families of spheres\n\nWell-conditioned: the mean is at most {WELL_CONDITIONED}.\n\n{table}"
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
    let mut text = format!("\n## Triangles\n\n{table}\n");
    for family in triangles::FAMILIES {
        _ = writeln!(text, "- {}: {}.", family.name, family.doc);
    }
    text.push_str(
        "\nA wrong miss at a shared edge is a leak: the ray passes between two triangles that touch there.\n",
    );
    text
}

fn roots(results: &Results, plots: &[Plot]) -> String {
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
        "\n## Reciprocals and roots\n\nMeasured over every fraction that an operand can have: one octave, or two for roots.\n\n{table}{}",
        shown(plots, "roots")
    )
}

fn pictures(results: &Results, plots: &[Plot]) -> String {
    if results.pictures.is_empty() {
        return String::new();
    }
    let mut text = "\n## Whole pictures\n\nTraced by six SPUs in simulated time, and compared with the reference in \
                    double precision (`lab/oracle/`).\nA pixel is wrong if a channel is off by more than 1/255.\n"
        .to_owned();
    for scene in SCENES {
        let of = |row: &&PictureRow| row.scene == scene.name;
        let rows: Vec<&PictureRow> = results.pictures.iter().filter(of).collect();
        let Some(PictureRow { width, height, .. }) = rows.last() else {
            continue;
        };
        let table = Table::of(
            rows.iter().copied(),
            &[
                ("formulation", |row| row.formulation.clone()),
                ("frames/s", |row| figure(row.frames_per_second)),
                ("RMSE, 1/255", |row| figure(row.rmse)),
                ("largest, 1/255", |row| row.max_error.to_string()),
                ("off silhouettes", |row| row.max_error_off_silhouette.to_string()),
                ("wrong pixels", |row| row.wrong_pixels.to_string()),
                ("off silhouettes", |row| row.wrong_off_silhouette.to_string()),
            ],
        );
        _ = write!(
            text,
            "\n### {}\n\n{}, {width}x{height}.\n\n{table}{}",
            scene.name,
            capital(scene.doc),
            shown(plots, &format!("picture-{}", scene.name))
        );
    }
    text
}

fn capital(text: &str) -> String {
    let mut letters = text.chars();
    let first = letters.next().map(|first| first.to_ascii_uppercase());
    first.into_iter().chain(letters).collect()
}
