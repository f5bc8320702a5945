//! Plots of results, each as SVG and PNG.
//!
//! This module defines which plots there are ([`plots`]), and `chart` how they look. Invariant: a
//! plot shows only numbers from the results.

mod chart;
mod labels;
mod scale;

use std::fs;
use std::path::Path;

use image::RgbImage;
use plotters::prelude::{BitMapBackend, IntoDrawingArea as _, SVGBackend};
use protocol::formulation::SPHERES;

use crate::families::{FAR, Form};
use crate::file::OutputError;

use crate::antialiasing::Row;
use crate::mesh_cache;
use crate::run::{KernelRow, Results};
use crate::spheres::SphereRow;
use crate::totals::Total;
use chart::{Axis, Chart, Group, Point, SIZE, not_beaten, use_font};
use scale::Kind;

/// The scale of PNGs.
const ZOOM: u32 = 2;

/// A plot.
pub struct Plot {
    /// The file's name without folder and extension.
    pub name: String,
    /// The title.
    pub title: String,
    /// For plots of cost against error: the names of the points that no other beats, the cheapest
    /// first.
    pub front: Vec<String>,
    chart: Chart,
}

/// All plots for which there are enough results.
pub fn plots(results: &Results) -> Vec<Plot> {
    let mut charts = Vec::new();
    charts.push(("pictures".to_owned(), pictures(results)));
    for form in Form::ALL {
        charts.push((format!("distance-{}", form.name()), distance(results, form)));
        charts.push((format!("ratio-{}", form.name()), ratio(results, form)));
    }
    let charts = charts.into_iter();
    charts
        .filter(|(_, chart)| chart.has_points())
        .map(|(name, chart)| Plot::of(name, chart))
        .collect()
}

/// The plots of antialiasing: one for each scene, by its name.
pub fn antialiasing(rows: &[Row]) -> Vec<Plot> {
    let mut scenes: Vec<&str> = rows.iter().map(|row| row.scene).collect();
    scenes.dedup();
    let plot = |scene: &str| {
        let rows = rows.iter().filter(|row| row.scene == scene);
        let point = |row: &Row| Point {
            name: row.way.clone(),
            x: row.frames_per_second,
            y: row.rmse,
            colour: if row.way.starts_with("4 ") {
                1
            } else if row.way.starts_with("16 ") {
                4
            } else {
                0
            },
        };
        let chart = Chart {
            title: format!("Frames a second against the error of antialiased pictures: {scene}"),
            note: "Samples a pixel and lowest contrast; ringed and joined: not beaten in both"
                .to_owned(),
            x: Axis { rising: true, ..axis("frames a second (simulated)", Kind::Log) },
            y: axis("root of the mean square error, 1/255", Kind::Log),
            groups: vec![Group::Rivals(rows.map(point).collect())],
        };
        Plot::of(scene.to_owned(), chart)
    };
    scenes.into_iter().map(plot).collect()
}

/// The plots of the cache of a mesh's blocks: one of speed and one of bytes, with a course for
/// each scene.
pub fn mesh_cache(rows: &[mesh_cache::Row]) -> Vec<Plot> {
    let plot = |name: &str, title: &str, label: &str, value: fn(&mesh_cache::Row) -> f64| {
        let courses = rows.chunk_by(|one, next| one.scene == next.scene);
        let course = |(number, rows): (usize, &[mesh_cache::Row])| {
            let point = |row: &mesh_cache::Row| Point {
                // The size of the picture stands in the table.
                name: row.scene.split([',', ' ']).next().unwrap_or("").to_owned(),
                x: row.blocks,
                y: value(row),
                colour: [0, 1, 4][number % 3],
            };
            Group::Course(rows.iter().map(point).collect())
        };
        let chart = Chart {
            title: format!("Blocks that an SPU caches against {title}"),
            note: "Blocks of 2048 bytes; six SPUs".to_owned(),
            x: axis("blocks, at most", Kind::Log),
            y: axis(label, Kind::Log),
            groups: courses.enumerate().map(course).collect(),
        };
        Plot::of(name.to_owned(), chart)
    };
    vec![
        plot("frames", "frames a second", "frames a second (simulated)", |row| {
            row.frames_per_second
        }),
        plot("bytes", "bytes a ray", "bytes of blocks a ray", |row| row.bytes_a_ray),
    ]
}

impl Plot {
    fn of(name: String, chart: Chart) -> Self {
        let rivals = chart.groups.iter().filter_map(Group::rivals);
        let fronts = rivals.flat_map(|points| {
            let front = not_beaten(&chart.x, points).into_iter();
            front.map(|at| points[at].name.clone())
        });
        Self { name, title: chart.title.clone(), front: fronts.collect(), chart }
    }
}

/// The file format of a plot.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// SVG: lines and text, for documents.
    Svg,
    /// PNG.
    Png,
}

/// Writes plots to a folder, with a prefix before their names.
///
/// # Errors
///
/// Fails if a file can't be written.
pub fn write(
    plots: &[Plot],
    folder: &Path,
    prefix: &str,
    formats: &[Format],
) -> Result<(), OutputError> {
    for plot in plots {
        for format in formats {
            let ending = match format {
                Format::Svg => "svg",
                Format::Png => "png",
            };
            let path = folder.join(format!("{prefix}{}.{ending}", plot.name));
            let failed = OutputError::of(path.display());
            use_font().map_err(&failed)?;
            match format {
                Format::Svg => {
                    let text = svg(&plot.chart).map_err(failed)?;
                    fs::write(&path, text).map_err(OutputError::of(path.display()))?;
                }
                Format::Png => {
                    let picture = bitmap(&plot.chart).map_err(failed)?;
                    picture.save(&path).map_err(OutputError::of(path.display()))?;
                }
            }
        }
    }
    Ok(())
}

fn svg(chart: &Chart) -> Result<String, String> {
    let mut text = String::new();
    let area = SVGBackend::with_string(&mut text, SIZE).into_drawing_area();
    chart.draw(&area, 1).map_err(|error| error.to_string())?;
    drop(area);
    Ok(text)
}

fn bitmap(chart: &Chart) -> Result<RgbImage, String> {
    let (width, height) = (ZOOM * SIZE.0, ZOOM * SIZE.1);
    let mut picture = RgbImage::new(width, height);
    let area = BitMapBackend::with_buffer(&mut picture, (width, height)).into_drawing_area();
    chart.draw(&area, ZOOM).map_err(|error| error.to_string())?;
    drop(area);
    Ok(picture)
}

/// The colour of a formulation, which is the same in all plots.
fn colour(formulation: &str) -> usize {
    let place = SPHERES.iter().position(|known| known.name == formulation);
    place.unwrap_or(SPHERES.len())
}

fn axis(label: impl Into<String>, kind: Kind) -> Axis {
    Axis { label: label.into(), kind, rising: false }
}

fn whose(form: Form) -> &'static str {
    match form {
        Form::Eye => "rays from the eye",
        Form::General => "rays from anywhere",
    }
}

/// The largest error of the distance over the well-conditioned families, in ulps.
pub(crate) fn worst_distance(rows: &[&SphereRow]) -> Option<f64> {
    let sound =
        rows.iter().filter_map(|row| row.figures.sound(|of| Some(of.distance_ulps?.max))?);
    sound.reduce(f64::max)
}

/// The plot of the cost of a form's kernels against their largest error.
fn distance(results: &Results, form: Form) -> Chart {
    let point = |kernel: &KernelRow| {
        Some(Point {
            name: kernel.formulation.clone(),
            x: kernel.cycles_a_ray,
            y: worst_distance(&results.spheres_of(form, &kernel.formulation))?,
            colour: colour(&kernel.formulation),
        })
    };
    let points = results.kernels_of(form.name()).filter_map(point);
    Chart {
        title: format!("Run time against error of the distance: {}", whose(form)),
        note: "Largest error over all well-conditioned families; ringed and joined: not beaten in both"
            .to_owned(),
        x: axis("cycles a ray and sphere (simulated)", Kind::Log),
        y: axis("largest error of the distance, ulps", Kind::Log),
        groups: vec![Group::Rivals(points.collect())],
    }
}

/// The share of rays at distance over radius 4096 for which a kernel's verdict is wrong, in per
/// cent.
pub(crate) fn wrong_far_off(rows: &[&SphereRow]) -> Option<f64> {
    let row = rows.iter().find(|row| row.family == FAR)?;
    Some(row.figures.wrong())
}

fn ratio(results: &Results, form: Form) -> Chart {
    let course = |kernel: &KernelRow| {
        let rows = results.spheres_of(form, &kernel.formulation).into_iter();
        let points = rows.filter_map(|row| {
            Some(Point {
                name: row.formulation.clone(),
                x: row.ratio?,
                y: row.figures.distance_ulps?.max,
                colour: colour(&row.formulation),
            })
        });
        Group::Course(points.collect())
    };
    Chart {
        title: format!("Error of the distance against distance/radius: {}", whose(form)),
        note: "Largest error of the rays within 0.9 radii that the kernel lets hit".to_owned(),
        x: axis("distance / radius", Kind::Log),
        y: axis("largest error of the distance, ulps", Kind::Log),
        groups: results.kernels_of(form.name()).map(course).collect(),
    }
}

/// The plot of all scenes' pictures: the programs, and the line that none can pass.
fn pictures(results: &Results) -> Chart {
    let place = |(name, total): &(&str, Total), pixels: u64, colour| Point {
        name: (*name).to_owned(),
        x: total.cycles / 1e6,
        y: total.percent(pixels),
        colour,
    };
    let totals = results.totals();
    let point = |(number, total): (usize, &(&str, Total))| {
        place(total, total.1.wrong_pixels, [0, 3, 1, 4][number % 4])
    };
    let points: Vec<Point> = totals.iter().enumerate().map(point).collect();
    let floor = totals
        .iter()
        .map(|total| Point { name: "floor".to_owned(), ..place(total, total.1.floor, 7) });
    let mut floor: Vec<Point> = floor.collect();
    floor.sort_by(|a, b| a.x.total_cmp(&b.x));
    // A straight line needs no more than its ends.
    if floor.len() > 2 {
        floor.drain(1..floor.len() - 1);
    }
    Chart {
        title: "Time against error of pictures".to_owned(),
        note: "All scenes together; lower left is better; the floor is what single precision must \
               get wrong"
            .to_owned(),
        x: axis("million cycles for one picture of each scene (simulated, six SPUs)", Kind::Linear),
        y: axis("wrong pixels, %", Kind::Log),
        groups: vec![Group::Rivals(points), Group::Course(floor)],
    }
}

impl Chart {
    fn has_points(&self) -> bool {
        self.groups.iter().any(|group| !group.points().is_empty())
    }
}
