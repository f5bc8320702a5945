//! Results as files: everything as JSON, and a CSV a table.

use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

use crate::metrics::Summary;
use crate::plots::{self, Format};
use crate::run::Results;

/// The file that has all results.
const JSON: &str = "results.json";

/// Where and how results were measured: all that is not the same on every host.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Origin {
    /// The host's processor.
    pub machine: String,
    /// The commit of the sources, `-dirty` if they were changed.
    pub commit: String,
    /// The command line.
    pub command: String,
}

/// A file of results.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Document {
    /// Left out where hosts are compared.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub origin: Option<Origin>,
    /// What was measured.
    #[serde(flatten)]
    pub results: Results,
}

/// Why a file is not written.
#[derive(Debug, thiserror::Error)]
pub enum OutputError {
    /// A folder or file.
    #[error("{}: {source}", path.display())]
    File {
        /// Which.
        path: PathBuf,
        /// The system's error.
        source: io::Error,
    },
    /// A number that JSON has no form for.
    #[error("results as JSON: {0}")]
    Json(#[from] serde_json::Error),
    /// A table.
    #[error("{}: {source}", path.display())]
    Csv {
        /// Which.
        path: PathBuf,
        /// What failed.
        source: csv::Error,
    },
    /// A plot.
    #[error("{}: {reason}", path.display())]
    Plot {
        /// Which.
        path: PathBuf,
        /// What failed.
        reason: String,
    },
}

impl OutputError {
    /// What the system says of a file.
    pub(crate) fn file(path: &Path) -> impl FnOnce(io::Error) -> Self {
        let path = path.to_owned();
        |source| Self::File { path, source }
    }
}

/// Makes sure that there is such a folder, and that files can be written there.
///
/// # Errors
///
/// If there is none and it can't be made, or it can't be written to.
pub fn folder(path: &Path) -> Result<(), OutputError> {
    fs::create_dir_all(path).map_err(OutputError::file(path))?;
    let probe = path.join(JSON);
    let mut open = fs::OpenOptions::new();
    open.append(true)
        .create(true)
        .open(&probe)
        .map_err(OutputError::file(&probe))?;
    Ok(())
}

/// Writes results as JSON: to standard output for `-`.
///
/// # Errors
///
/// A file that can't be written.
pub fn json(document: &Document, path: &Path) -> Result<(), OutputError> {
    let mut text = serde_json::to_string_pretty(document)?;
    text.push('\n');
    let written = if path == Path::new("-") {
        io::stdout().write_all(text.as_bytes())
    } else {
        fs::write(path, text)
    };
    written.map_err(OutputError::file(path))
}

/// Writes everything there is of results into a folder: JSON, tables and plots.
///
/// # Errors
///
/// A file that can't be written.
pub fn write(document: &Document, folder: &Path) -> Result<(), OutputError> {
    json(document, &folder.join(JSON))?;
    tables(document, folder)?;
    plots::write(&document.results, folder, "", &[Format::Svg, Format::Png])
}

/// Writes the tables as `kernels.csv`, `spheres.csv` and so on.
///
/// # Errors
///
/// A file that can't be written.
pub fn tables(document: &Document, folder: &Path) -> Result<(), OutputError> {
    for (name, rows) in csv_tables(&document.results) {
        let path = folder.join(name);
        let failed = |source| OutputError::Csv {
            path: path.clone(),
            source,
        };
        let mut file = csv::Writer::from_path(&path).map_err(failed)?;
        for row in rows {
            file.write_record(row).map_err(failed)?;
        }
        file.flush().map_err(OutputError::file(&path))?;
    }
    Ok(())
}

/// Every table with its head.
fn csv_tables(results: &Results) -> [(&'static str, Vec<Vec<String>>); 5] {
    let kernels = results.kernels.iter().map(|row| {
        let mut cells = Cells::default();
        cells.text("formulation", &row.formulation);
        cells.text("form", &row.form);
        cells.text("kernel", &row.kernel);
        cells.number("cycles_a_ray", Some(row.cycles_a_ray));
        cells.number("host_ns_a_ray", row.host_ns_a_ray);
        cells
    });
    let kernel = |formulation: &str, form: &str| {
        let of = |row: &&crate::run::KernelRow| row.formulation == formulation && row.form == form;
        results.kernels.iter().find(of)
    };
    let costs = |cells: &mut Cells, formulation: &str, form: &str| {
        let kernel = kernel(formulation, form);
        cells.number("cycles_a_ray", kernel.map(|kernel| kernel.cycles_a_ray));
        cells.number(
            "host_ns_a_ray",
            kernel.and_then(|kernel| kernel.host_ns_a_ray),
        );
    };
    let spheres = results.spheres.iter().map(|row| {
        let mut cells = Cells::default();
        cells.text("formulation", &row.formulation);
        cells.text("form", row.form.name());
        cells.text("family", &row.family);
        costs(&mut cells, &row.formulation, row.form.name());
        cells.number("ratio", row.ratio);
        cells.summary("condition", row.condition);
        cells.text("well_conditioned", &row.well_conditioned.to_string());
        cells.counts([
            ("rays", row.rays),
            ("hits", row.hits),
            ("wrong_hits", row.wrong_hits),
            ("wrong_misses", row.wrong_misses),
        ]);
        cells.summary("distance_ulps", row.distance_ulps);
        cells.summary("distance_relative", row.distance_relative);
        cells.summary("point_ulps", row.point_ulps);
        cells.summary("point_relative", row.point_relative);
        cells.summary("normal_ulps", row.normal_ulps);
        cells
    });
    let triangles = results.triangles.iter().map(|row| {
        let mut cells = Cells::default();
        cells.text("formulation", &row.formulation);
        cells.text("family", &row.family);
        costs(&mut cells, &row.formulation, "triangle");
        cells.summary("condition", row.condition);
        cells.text("well_conditioned", &row.well_conditioned.to_string());
        cells.counts([
            ("rays", row.rays),
            ("hits", row.hits),
            ("wrong_hits", row.wrong_hits),
            ("wrong_misses", row.wrong_misses),
        ]);
        cells.summary("distance_ulps", row.distance_ulps);
        cells.summary("distance_relative", row.distance_relative);
        cells.summary("point_ulps", row.point_ulps);
        cells.summary("point_relative", row.point_relative);
        cells
    });
    let roots = results.roots.iter().map(|row| {
        let mut cells = Cells::default();
        cells.text("kernel", &row.kernel);
        cells.text("quantity", &row.quantity);
        cells.number("cycles_an_operand", Some(row.cycles_an_operand));
        cells.number("host_ns_an_operand", row.host_ns_an_operand);
        cells.counts([("operands", row.operands)]);
        cells.summary("ulps", Some(row.ulps));
        cells.text("worst", &row.worst);
        cells
    });
    let pictures = results.pictures.iter().map(|row| {
        let mut cells = Cells::default();
        cells.text("formulation", &row.formulation);
        cells.text("scene", &row.scene);
        cells.counts([
            ("width", row.width as usize),
            ("height", row.height as usize),
        ]);
        cells.number("frames_per_second", Some(row.frames_per_second));
        cells.number("rmse", Some(row.rmse));
        cells.counts([
            ("max_error", row.max_error.into()),
            (
                "max_error_off_silhouette",
                row.max_error_off_silhouette.into(),
            ),
            ("wrong_pixels", row.wrong_pixels as usize),
            ("wrong_off_silhouette", row.wrong_off_silhouette as usize),
        ]);
        cells
    });
    [
        ("kernels.csv", table(kernels)),
        ("spheres.csv", table(spheres)),
        ("triangles.csv", table(triangles)),
        ("roots.csv", table(roots)),
        ("pictures.csv", table(pictures)),
    ]
}

/// Rows under their common head; nothing of no rows.
fn table(rows: impl Iterator<Item = Cells>) -> Vec<Vec<String>> {
    let mut table = Vec::new();
    for Cells { names, values } in rows {
        if table.is_empty() {
            table.push(names);
        }
        table.push(values);
    }
    table
}

/// A row of a table.
#[derive(Default)]
struct Cells {
    names: Vec<String>,
    values: Vec<String>,
}

impl Cells {
    fn text(&mut self, name: &str, value: &str) {
        self.names.push(name.to_owned());
        self.values.push(value.to_owned());
    }

    /// A number, with all its digits; nothing where there is none.
    fn number(&mut self, name: &str, value: Option<f64>) {
        let value = value.map_or_else(String::new, |value| value.to_string());
        self.text(name, &value);
    }

    fn counts<const N: usize>(&mut self, counts: [(&str, usize); N]) {
        for (name, count) in counts {
            self.text(name, &count.to_string());
        }
    }

    fn summary(&mut self, name: &str, summary: Option<Summary>) {
        let of = |part: fn(&Summary) -> f64| summary.as_ref().map(part);
        self.number(&format!("{name}_max"), of(|summary| summary.max));
        self.number(&format!("{name}_mean"), of(|summary| summary.mean));
        self.number(&format!("{name}_p999"), of(|summary| summary.p999));
    }
}

#[cfg(test)]
mod tests;
