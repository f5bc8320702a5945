//! The part of the document about pictures of several samples a pixel.

use std::fmt::Write as _;
use std::path::Path;

use super::table::{Table, figure};
use super::{put, titled};
use crate::antialiasing::{Row, SIZE};
use crate::file::OutputError;
use crate::output::Origin;
use crate::plots::Plot;

/// The prefix of the plots' file names, which are next to the document.
pub const PREFIX: &str = "antialiasing-";

/// Puts the results into the document, which refers to plots next to it.
///
/// # Errors
///
/// Fails if the file can't be read or written.
pub fn write(
    rows: &[Row],
    plots: &[Plot],
    origin: &Origin,
    path: &Path,
) -> Result<(), OutputError> {
    put("antialiasing", &text(rows, plots, origin), path)
}

fn text(rows: &[Row], plots: &[Plot], origin: &Origin) -> String {
    let (width, height) = SIZE;
    let mut text = format!(
        "Written by `{}` at commit {}. Pictures of {width}x{height}, six SPUs.\n",
        origin.command, origin.commit
    );
    for plot in plots {
        let table = Table::of(
            rows.iter().filter(|row| row.scene == plot.name),
            &[
                ("samples", |row| row.way.clone()),
                ("rays a pixel", |row| format!("{:.2}", row.rays_a_pixel)),
                ("frames/s", |row| figure(row.frames_per_second)),
                ("RMSE, 1/255", |row| format!("{:.2}", row.rmse)),
                ("largest, 1/255", |row| format!("{:.0}", row.max_error)),
                ("pixels off by over 8/255, %", |row| format!("{:.3}", row.visible_percent)),
            ],
        );
        _ = write!(text, "\n### Samples of {}\n\n{table}{}", plot.name, titled(plot, PREFIX));
    }
    text
}
