//! The document of the results: tables, plots and what is not beaten, as Markdown.
//!
//! Invariant: every number in it is one of the results that it is written from.

mod table;
#[cfg(test)]
mod tests;

use std::fmt::Write as _;
use std::fs;
use std::path::Path;

use crate::families::{FAMILIES, Form, triangles};
use crate::metrics::Summary;
use crate::output::{Document, OutputError};
use crate::pictures::SCENES;
use crate::plots::{self, Plot, worst_distance, wrong_far_off};
use crate::run::{KernelRow, Results};
use crate::spheres::{SphereRow, WELL_CONDITIONED};
use table::{Table, figure};

/// What stands in front of the plots' names beside the document.
pub const PREFIX: &str = "accuracy-";

/// Writes the document; its plots are expected beside it.
///
/// # Errors
///
/// A file that can't be written.
pub fn write(document: &Document, path: &Path) -> Result<(), OutputError> {
    fs::write(path, text(document)).map_err(OutputError::file(path))
}

/// The document.
#[must_use]
pub fn text(document: &Document) -> String {
    let results = &document.results;
    let plots = plots::plots(results);
    let mut text = head(document);
    text.push_str(READING);
    text.push_str(&formulations(results));
    for form in [Form::Eye, Form::General] {
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
        "Ways to intersect rays with spheres and triangles, each a kernel of its own: what they cost, and how\n\
         far off they are. The tracer is linked with one of each (`protocol/src/formulation.rs`).\n\n",
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
            results.spheres.first().map_or(0, |row| row.rays)
        );
    }
    text
}

const READING: &str = "
## How to read it

- *Truth* is exact for the very singles that a kernel is given: double precision that carries a bound of its
  own rounding, and numbers of any length where that leaves a verdict or 1/64 ulp open. A distance is counted
  along the direction at length 1.
- *ulps*: spacings of singles at the true distance; of a point, at its largest coordinate from the ray's
  origin; of a normal, at 1. The SPU truncates: half of an ulp is what rounding to nearest would give at best.
- *cycles*: of the timing model (`timing.md`), for one ray and one sphere in a long list. *host*: nanoseconds
  of this machine's interpreter for the same.
- *wrong hits, wrong misses*: the kernel says the other thing than exact arithmetic.
- *condition*: ulps that the true distance moves when each number given moves by half an ulp, all at their
  worst. A family is well-conditioned if that is small in the mean: an error there is the formulation's own.
- *not beaten*: no other is at least as good in run time and in error, and better in one.
";

fn formulations(results: &Results) -> String {
    let mut table = Table::new([
        "formulation",
        "for",
        "what it computes",
        "cycles",
        "host, ns",
    ]);
    for kernel in &results.kernels {
        table.row([
            kernel.formulation.clone(),
            kernel.form.clone(),
            kernel.doc.clone(),
            figure(kernel.cycles_a_ray),
            option(kernel.host_ns_a_ray),
        ]);
    }
    format!("\n## Formulations\n\n{table}")
}

/// A number, or nothing.
fn option(value: Option<f64>) -> String {
    value.map_or_else(String::new, figure)
}

fn part(summary: Option<Summary>, part: fn(&Summary) -> f64) -> String {
    option(summary.as_ref().map(part))
}

/// A plot with what is not beaten in it.
fn shown(plots: &[Plot], name: &str) -> String {
    let Some(plot) = plots.iter().find(|plot| plot.name == name) else {
        return String::new();
    };
    let mut text = format!("\n![{}]({PREFIX}{name}.svg)\n", plot.title);
    if !plot.front.is_empty() {
        _ = writeln!(text, "\nNot beaten: {}.", plot.front.join(", "));
    }
    text
}

fn spheres(results: &Results, plots: &[Plot], form: Form) -> String {
    let title = match form {
        Form::Eye => "Spheres, rays from the eye",
        Form::General => "Spheres, rays from anywhere",
    };
    let mut table = Table::new([
        "formulation",
        "cycles",
        "host, ns",
        "distance: largest, ulps",
        "99.9 %",
        "mean",
        "point: largest",
        "wrong at 4096, %",
    ]);
    let kernels: Vec<&KernelRow> = results
        .kernels
        .iter()
        .filter(|kernel| kernel.form == form.name())
        .collect();
    for kernel in &kernels {
        let rows: Vec<&SphereRow> = results
            .spheres
            .iter()
            .filter(|row| row.form == form && row.formulation == kernel.formulation)
            .collect();
        let sound = || rows.iter().filter(|row| row.well_conditioned);
        let most = |of: fn(&SphereRow) -> Option<f64>| {
            option(sound().filter_map(|row| of(row)).reduce(f64::max))
        };
        table.row([
            kernel.formulation.clone(),
            figure(kernel.cycles_a_ray),
            option(kernel.host_ns_a_ray),
            option(worst_distance(&rows)),
            most(|row| Some(row.distance_ulps?.p999)),
            most(|row| Some(row.distance_ulps?.mean)),
            most(|row| Some(row.point_ulps?.max)),
            option(wrong_far_off(&rows)),
        ]);
    }
    let mut text = format!(
        "\n## {title}\n\nOf each number the largest of all well-conditioned families.\n\n{table}"
    );
    for plot in ["distance", "verdicts", "ratio"] {
        text.push_str(&shown(plots, &format!("{plot}-{}", form.name())));
    }
    text.push_str("\nLargest error of the distance, in ulps, and behind it wrong hits and wrong misses, if any:\n\n");
    text.push_str(&by_family(results, form, &kernels).to_string());
    text
}

/// Families down, formulations across.
fn by_family(results: &Results, form: Form, kernels: &[&KernelRow]) -> Table {
    let names = kernels.iter().map(|kernel| kernel.formulation.as_str());
    let mut table = Table::new(std::iter::once("family").chain(names));
    for family in FAMILIES
        .iter()
        .filter(|family| family.forms.contains(&form))
    {
        let cell = |kernel: &&KernelRow| {
            let row = results.spheres.iter().find(|row| {
                row.form == form
                    && row.family == family.name
                    && row.formulation == kernel.formulation
            });
            row.map_or_else(String::new, |row| {
                let off = part(row.distance_ulps, |summary| summary.max);
                match (row.wrong_hits, row.wrong_misses) {
                    (0, 0) => off,
                    (hits, misses) => format!("{off} ({hits}, {misses})"),
                }
            })
        };
        let name = std::iter::once(family.name.to_owned());
        table.row(name.chain(kernels.iter().map(cell)));
    }
    table
}

fn families(results: &Results) -> String {
    let mut table = Table::new([
        "family",
        "for",
        "what is in it",
        "condition: mean",
        "largest",
        "well-conditioned",
    ]);
    for form in [Form::Eye, Form::General] {
        for family in FAMILIES {
            let row = results
                .spheres
                .iter()
                .find(|row| row.form == form && row.family == family.name);
            let Some(row) = row else { continue };
            let doc = match family.ratio {
                Some(_) => format!("distance/radius as named, {}", family.doc),
                None => family.doc.to_owned(),
            };
            table.row([
                family.name.to_owned(),
                form.name().to_owned(),
                doc,
                part(row.condition, |summary| summary.mean),
                part(row.condition, |summary| summary.max),
                if row.well_conditioned { "yes" } else { "no" }.to_owned(),
            ]);
        }
    }
    format!(
        "\n## Families of spheres\n\nWell-conditioned: the mean is at most {WELL_CONDITIONED}.\n\n{table}"
    )
}

fn flat(results: &Results) -> String {
    if results.triangles.is_empty() {
        return String::new();
    }
    let mut table = Table::new([
        "formulation",
        "family",
        "rays",
        "wrong hits",
        "wrong misses",
        "distance: largest, ulps",
        "99.9 %",
        "mean",
        "point: largest",
        "condition: mean",
    ]);
    for row in &results.triangles {
        table.row([
            row.formulation.clone(),
            row.family.clone(),
            row.rays.to_string(),
            row.wrong_hits.to_string(),
            row.wrong_misses.to_string(),
            part(row.distance_ulps, |summary| summary.max),
            part(row.distance_ulps, |summary| summary.p999),
            part(row.distance_ulps, |summary| summary.mean),
            part(row.point_ulps, |summary| summary.max),
            part(row.condition, |summary| summary.mean),
        ]);
    }
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
    let mut table = Table::new([
        "kernel",
        "computes",
        "cycles",
        "host, ns",
        "largest, ulps",
        "99.9 %",
        "mean",
        "worst operand",
    ]);
    for row in &results.roots {
        table.row([
            row.kernel.clone(),
            row.quantity.clone(),
            figure(row.cycles_an_operand),
            option(row.host_ns_an_operand),
            figure(row.ulps.max),
            figure(row.ulps.p999),
            figure(row.ulps.mean),
            format!("`{}`", row.worst),
        ]);
    }
    format!(
        "\n## Reciprocals and roots\n\nOver every fraction that an operand can have: an octave, or two for roots.\n\n{table}{}",
        shown(plots, "roots")
    )
}

fn pictures(results: &Results, plots: &[Plot]) -> String {
    if results.pictures.is_empty() {
        return String::new();
    }
    let mut text = "\n## Whole pictures\n\nOn six SPUs, in simulated time, against the reference in double \
                    precision (`oracle/`). A pixel is wrong if a channel\nis off by more than 1/255.\n"
        .to_owned();
    for scene in SCENES {
        let rows = results
            .pictures
            .iter()
            .filter(|row| row.scene == scene.name);
        let mut table = Table::new([
            "formulation",
            "frames/s",
            "RMSE, 1/255",
            "largest, 1/255",
            "off silhouettes",
            "wrong pixels",
            "off silhouettes",
        ]);
        let mut size = None;
        for row in rows {
            size = Some((row.width, row.height));
            table.row([
                row.formulation.clone(),
                figure(row.frames_per_second),
                figure(row.rmse),
                row.max_error.to_string(),
                row.max_error_off_silhouette.to_string(),
                row.wrong_pixels.to_string(),
                row.wrong_off_silhouette.to_string(),
            ]);
        }
        let Some((width, height)) = size else {
            continue;
        };
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
