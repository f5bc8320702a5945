//! The document with the pictures of several samples a pixel.

use std::fmt::Write as _;
use std::fs;
use std::path::Path;

use super::table::{Table, figure};
use super::titled;
use crate::antialiasing::{Row, SIZE};
use crate::file::OutputError;
use crate::output::Origin;
use crate::plots::Plot;

/// The prefix of the plots' file names, which are next to the document.
pub const PREFIX: &str = "antialiasing-";

/// Writes the document, which refers to plots next to it.
///
/// # Errors
///
/// Fails if the file can't be written.
pub fn write(
    rows: &[Row],
    plots: &[Plot],
    origin: &Origin,
    path: &Path,
) -> Result<(), OutputError> {
    fs::write(path, text(rows, plots, origin)).map_err(OutputError::of(path.display()))
}

fn text(rows: &[Row], plots: &[Plot], origin: &Origin) -> String {
    let mut text = HEAD.to_owned();
    let (width, height) = SIZE;
    _ = write!(
        text,
        "\nWritten by `{}` at commit {}. Pictures of {width}x{height}, six SPUs.\n",
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
        _ = write!(text, "\n## {}\n\n{table}{}", plot.name, titled(plot, PREFIX));
    }
    text
}

const HEAD: &str = "# Run time against error of several samples a pixel

The run time and the error of antialiasing, for readers who choose `--antialias` and `--contrast`.
[whitted.md](whitted.md#several-samples-a-pixel) describes how the SPUs do it.

- *1, 2x2, 4x4*: a regular grid of samples in every pixel, the mean of a larger picture.
- *4 everywhere, 16 everywhere*: `--antialias N --contrast 0`. Samples are spread so that no two
  have the same column or row.
- *4 at 32*: `--antialias 4 --contrast 32`: four samples, only in pixels that differ by 32/255 or more
  from a neighbour.
- The error is against the reference in double precision with 8x8 samples a pixel, in the same parts
  of the scene: NFF's camera sees a little more in a larger picture's pixels. Light is limited
  to white after the mean is taken, except for 2x2 and 4x4, which are means of pictures.

## The default

`render`, `fb`, `view` and `play` take *4 at 32*, which nothing below beats. It halves the error of one sample on
`whitted16`, for less than twice the time. Contrasts below that gain little error for much time, and those above leave
steps that are easily seen: pixels off by over 8/255 are counted in the last column. *16 at 32* costs twice as much
again, for edges that are looked at from near: a picture at rest. The contrast is that of the pixels' values, so in sRGB
dark edges count for more, bright ones for less. These tables have linear light.
";
