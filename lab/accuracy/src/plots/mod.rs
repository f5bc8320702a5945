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
use crate::pictures::{PictureRow, SCENES};
use crate::roots::RootRow;
use crate::run::{KernelRow, Results};
use crate::spheres::SphereRow;
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
    for form in Form::ALL {
        charts.push((format!("distance-{}", form.name()), distance(results, form)));
        charts.push((format!("verdicts-{}", form.name()), verdicts(results, form)));
        charts.push((format!("ratio-{}", form.name()), ratio(results, form)));
    }
    charts.push(("roots".to_owned(), roots(results)));
    for scene in SCENES {
        let name = format!("picture-{}", scene.name);
        charts.push((name, picture(results, scene.name)));
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
            note: "Samples a pixel and minimum contrast; ringed and joined: not beaten in both"
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

/// The plot of the cost of a form's kernels against a figure of their rows.
fn against(
    results: &Results,
    form: Form,
    [what, note, axis_label]: [&str; 3],
    value: fn(&[&SphereRow]) -> Option<f64>,
) -> Chart {
    let point = |kernel: &KernelRow| {
        Some(Point {
            name: kernel.formulation.clone(),
            x: kernel.cycles_a_ray,
            y: value(&results.spheres_of(form, &kernel.formulation))?,
            colour: colour(&kernel.formulation),
        })
    };
    let points = results.kernels_of(form.name()).filter_map(point);
    Chart {
        title: format!("Run time against {what}: {}", whose(form)),
        note: format!("{note}; ringed and joined: not beaten in both"),
        x: axis("cycles a ray and sphere (simulated)", Kind::Log),
        y: axis(axis_label, Kind::Log),
        groups: vec![Group::Rivals(points.collect())],
    }
}

fn distance(results: &Results, form: Form) -> Chart {
    let words = [
        "error of the distance",
        "Largest error over all well-conditioned families",
        "largest error of the distance, ulps",
    ];
    against(results, form, words, worst_distance)
}

/// The share of rays at distance over radius 4096 for which a kernel's verdict is wrong, in per
/// cent.
pub(crate) fn wrong_far_off(rows: &[&SphereRow]) -> Option<f64> {
    let row = rows.iter().find(|row| row.family == FAR)?;
    Some(row.figures.wrong())
}

fn verdicts(results: &Results, form: Form) -> Chart {
    let words = [
        "wrong hits and misses",
        "At distance/radius 4096, rays over the disc within 2 radii",
        "wrong hits and misses, % of the rays",
    ];
    against(results, form, words, wrong_far_off)
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

fn roots(results: &Results) -> Chart {
    let quantities = ["1/x", "1/sqrt(x)", "sqrt(x)"];
    let group = |(colour, quantity): (usize, &str)| {
        let rows = results.roots.iter().filter(|row| row.quantity == quantity);
        let point = |row: &RootRow| Point {
            name: row.kernel.clone(),
            x: row.cycles_an_operand,
            y: row.ulps.max,
            colour: [0, 1, 4][colour],
        };
        Group::Rivals(rows.map(point).collect())
    };
    Chart {
        title: "Run time against error of reciprocals and roots".to_owned(),
        note:
            "Largest error over every fraction of an operand; ringed and joined: not beaten in both"
                .to_owned(),
        x: axis("cycles an operand (simulated)", Kind::Log),
        y: axis("largest error, ulps", Kind::Log),
        groups: quantities.into_iter().enumerate().map(group).collect(),
    }
}

fn picture(results: &Results, scene: &str) -> Chart {
    let rows = results.pictures.iter().filter(|row| row.scene == scene);
    let rows: Vec<&PictureRow> = rows.collect();
    let point = |row: &&PictureRow| Point {
        name: row.formulation.clone(),
        x: row.frames_per_second,
        y: row.rmse,
        colour: colour(&row.formulation),
    };
    let size =
        rows.first().map_or_else(String::new, |row| format!("{}x{}, ", row.width, row.height));
    Chart {
        title: format!("Frames a second against the picture's error: {scene}"),
        note: format!("{size}six SPUs; ringed and joined: not beaten in both"),
        x: Axis { rising: true, ..axis("frames a second (simulated)", Kind::Linear) },
        y: axis("root of the mean square error, 1/255", Kind::Log),
        groups: vec![Group::Rivals(rows.iter().map(point).collect())],
    }
}

impl Chart {
    fn has_points(&self) -> bool {
        self.groups.iter().any(|group| !group.points().is_empty())
    }
}
