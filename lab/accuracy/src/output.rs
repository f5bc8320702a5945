//! Results as files: everything as JSON, and each table as CSV.

use std::fs;
use std::path::Path;

use oracle::ULPS;
use serde::{Deserialize, Serialize};

use crate::figures::Figures;
use crate::file::OutputError;
use crate::metrics::Summary;
use crate::run::Results;

/// The file with all results.
const JSON: &str = "results.json";

/// Where and how results were measured. Only this part differs between hosts.
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
    /// The results.
    #[serde(flatten)]
    pub results: Results,
}

/// Ensures that the folder exists and that files can be written there.
///
/// # Errors
///
/// Fails if it does not exist and can't be created, or if it can't be written to.
pub fn folder(path: &Path) -> Result<(), OutputError> {
    fs::create_dir_all(path).map_err(OutputError::of(path.display()))?;
    let probe = path.join(JSON);
    let mut open = fs::OpenOptions::new();
    open.append(true).create(true).open(&probe).map_err(OutputError::of(probe.display()))?;
    Ok(())
}

/// Writes results as JSON. `-` means standard output.
///
/// # Errors
///
/// Fails if the file can't be written.
pub fn json(document: &Document, path: &Path) -> Result<(), OutputError> {
    let text = serde_json::to_string_pretty(document);
    let mut text = text.map_err(OutputError::of("results as JSON"))?;
    text.push('\n');
    if path == Path::new("-") {
        return messages::write_data(text).map_err(OutputError::of("results"));
    }
    fs::write(path, text).map_err(OutputError::of(path.display()))
}

/// Writes results to a folder, as JSON and as tables.
///
/// # Errors
///
/// Fails if a file can't be written.
pub fn write(document: &Document, folder: &Path) -> Result<(), OutputError> {
    json(document, &folder.join(JSON))?;
    tables(&document.results, folder)
}

/// Writes the tables as `kernels.csv`, `spheres.csv` and so on.
fn tables(results: &Results, folder: &Path) -> Result<(), OutputError> {
    for (name, rows) in csv_tables(results) {
        let path = folder.join(name);
        let mut file = csv::Writer::from_path(&path).map_err(OutputError::of(path.display()))?;
        for row in rows {
            file.write_record(row).map_err(OutputError::of(path.display()))?;
        }
        file.flush().map_err(OutputError::of(path.display()))?;
    }
    Ok(())
}

/// Every table with its header line.
fn csv_tables(results: &Results) -> [(&'static str, Vec<Vec<String>>); 5] {
    let kernels = results.kernels.iter().map(|row| {
        Cells::default()
            .text("formulation", &row.formulation)
            .text("form", &row.form)
            .text("kernel", &row.kernel)
            .number("cycles_a_ray", Some(row.cycles_a_ray))
            .number("host_ns_a_ray", row.host_ns_a_ray)
    });
    let costs = |cells: Cells, formulation: &str, form: &str| {
        let mut kernels = results.kernels_of(form);
        let kernel = kernels.find(|kernel| kernel.formulation == formulation);
        cells
            .number("cycles_a_ray", kernel.map(|kernel| kernel.cycles_a_ray))
            .number("host_ns_a_ray", kernel.and_then(|kernel| kernel.host_ns_a_ray))
    };
    let spheres = results.spheres.iter().map(|row| {
        let cells = Cells::default()
            .text("formulation", &row.formulation)
            .text("form", row.form.name())
            .text("family", &row.family);
        costs(cells, &row.formulation, row.form.name())
            .number("ratio", row.ratio)
            .figures(&row.figures)
            .summary("normal_ulps", row.normal_ulps)
    });
    let triangles = results.triangles.iter().map(|row| {
        let cells =
            Cells::default().text("formulation", &row.formulation).text("family", &row.family);
        costs(cells, &row.formulation, "triangle").figures(&row.figures)
    });
    let roots = results.roots.iter().map(|row| {
        Cells::default()
            .text("kernel", &row.kernel)
            .text("quantity", &row.quantity)
            .number("cycles_an_operand", Some(row.cycles_an_operand))
            .number("host_ns_an_operand", row.host_ns_an_operand)
            .text("operands", row.operands)
            .summary("ulps", Some(row.ulps))
            .text("worst", &row.worst)
    });
    let pictures = results.pictures.iter().map(|row| {
        let cells = Cells::default()
            .text("scene", &row.scene)
            .text("program", &row.program)
            .text("width", row.width)
            .text("height", row.height)
            .number("cycles", Some(row.cycles))
            .text("wrong_pixels", row.wrong_pixels)
            .text("floor", row.floor)
            .number("rmse", Some(row.rmse))
            .text("max_error", row.max_error);
        let by_ulps = ULPS.iter().zip(row.by_ulps);
        by_ulps
            .fold(cells, |cells, (ulps, pixels)| cells.text(&format!("ulps_{ulps}"), pixels))
            .text("ulps_beyond", row.by_ulps[ULPS.len()])
            .text("well_conditioned", row.well_conditioned)
    });
    [
        ("kernels.csv", table(kernels)),
        ("spheres.csv", table(spheres)),
        ("triangles.csv", table(triangles)),
        ("roots.csv", table(roots)),
        ("pictures.csv", table(pictures)),
    ]
}

/// Rows under their common header line. No rows give no lines.
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

/// The cells of a row.
#[derive(Default)]
struct Cells {
    names: Vec<String>,
    values: Vec<String>,
}

impl Cells {
    fn text(mut self, name: &str, value: impl ToString) -> Self {
        self.names.push(name.to_owned());
        self.values.push(value.to_string());
        self
    }

    /// A number with all its digits, or an empty cell.
    fn number(self, name: &str, value: Option<f64>) -> Self {
        self.text(name, value.map_or_else(String::new, |value| value.to_string()))
    }

    fn summary(self, name: &str, summary: Option<Summary>) -> Self {
        self.number(&format!("{name}_max"), summary.map(|summary| summary.max))
            .number(&format!("{name}_mean"), summary.map(|summary| summary.mean))
            .number(&format!("{name}_p999"), summary.map(|summary| summary.p999))
    }

    fn figures(self, of: &Figures) -> Self {
        self.summary("condition", of.condition)
            .text("well_conditioned", of.well_conditioned)
            .text("rays", of.rays)
            .text("hits", of.hits)
            .text("wrong_hits", of.wrong_hits)
            .text("wrong_misses", of.wrong_misses)
            .summary("distance_ulps", of.distance_ulps)
            .summary("distance_relative", of.distance_relative)
            .summary("point_ulps", of.point_ulps)
            .summary("point_relative", of.point_relative)
    }
}

#[cfg(test)]
mod tests;
