//! Whole pictures with several samples a pixel: frames a second in simulated time against the
//! error of the picture. Regular supersampling is compared with antialiasing of those pixels that
//! differ from a neighbour.

use std::collections::BTreeMap;

use cellray::scene::{CONTRAST, RenderOptions, Samples};
use cellray::spe::Program;
use glam::DVec3;
use oracle::DepthProbe;
use oracle::whitted::{self, Probe};
use serde::Serialize;

use crate::parallel;
use crate::pictures::{PictureError, Subject};
use crate::traced::{Traced, trace};

/// The reference has this many samples across and down a pixel.
const REFERENCE: u32 = 8;
/// The size of the pictures.
pub const SIZE: (u32, u32) = (640, 360);
/// The scenes: one of each model.
const NAMES: [&str; 2] = ["whitted16", "paper16"];
/// The contrasts of adaptive antialiasing.
const CONTRASTS: [u8; 6] = [4, 8, 16, 32, 48, 96];

/// How the samples are spread over the picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Way {
    /// A regular grid with this number of samples across and down every pixel. It is the mean of a
    /// picture that is larger by this factor.
    Grid(u32),
    /// This number of samples, by the SPU program, in pixels of at least this contrast.
    Spread(Samples, u8),
}

/// The picture of a way.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Row {
    /// The scene.
    pub scene: &'static str,
    /// The way.
    pub way: String,
    /// Primary rays for each pixel.
    pub rays_a_pixel: f64,
    /// Frames a second in simulated time.
    pub frames_per_second: f64,
    /// The root of the mean square error of all channels, in 1/255.
    pub rmse: f64,
    /// The largest error of a channel, in 1/255.
    pub max_error: f64,
    /// The share of the pixels with an error of more than 8/255 in some channel, in per cent.
    pub visible_percent: f64,
}

impl Way {
    /// All ways that are compared.
    pub fn all() -> Vec<Self> {
        let spread = [Samples::Four, Samples::Sixteen].into_iter();
        let adaptive = spread.flat_map(|samples| {
            let everywhere = std::iter::once(0);
            everywhere.chain(CONTRASTS).map(move |contrast| Self::Spread(samples, contrast))
        });
        [1, 2, 4].map(Self::Grid).into_iter().chain(adaptive).collect()
    }

    /// Its name.
    #[must_use]
    pub fn name(self) -> String {
        match self {
            Self::Grid(1) => "1".to_owned(),
            Self::Grid(side) => format!("{side}x{side}"),
            Self::Spread(samples, 0) => format!("{} everywhere", samples as u32),
            Self::Spread(samples, contrast) => format!("{} at {contrast}", samples as u32),
        }
    }

    /// How many pixels of the traced picture are one of [`SIZE`], across and down.
    fn side(self) -> u32 {
        match self {
            Self::Grid(side) => side,
            Self::Spread(..) => 1,
        }
    }

    /// The pixels, and what tracing them took.
    fn pixels(self, subject: &Subject) -> Result<(Vec<DVec3>, Traced), PictureError> {
        let side = self.side();
        let (samples, contrast) = match self {
            Self::Grid(_) => (Samples::One, CONTRAST),
            Self::Spread(samples, contrast) => (samples, contrast),
        };
        let options = RenderOptions { samples, contrast, ..RenderOptions::default() };
        let size = (side * SIZE.0, side * SIZE.1);
        let traced = trace(&subject.name, &subject.scene, options, size, Program::tracer())?;
        let pixels = traced.picture.pixels().iter();
        let light: Vec<_> = pixels.map(|pixel| DVec3::from(pixel.map(f64::from))).collect();
        Ok((means(&light, side), traced))
    }
}

/// The means of squares of `side` samples across and down, which fill a picture of [`SIZE`].
fn means(samples: &[DVec3], side: u32) -> Vec<DVec3> {
    let (width, side) = (SIZE.0 as usize, side as usize);
    let rows = samples.chunks_exact(width * side * side);
    let pixel = |row: &[DVec3], x: usize| {
        let lines = row.chunks_exact(width * side);
        let sum: DVec3 = lines.flat_map(|line| &line[side * x..side * (x + 1)]).sum();
        sum / (side * side) as f64
    };
    rows.flat_map(|row| (0..width).map(move |x| pixel(row, x))).collect()
}

/// What a ray through a point of a picture of [`SIZE`] sees, channels from 0 to 1.
enum Light<'a> {
    Depth(DepthProbe),
    Whitted(Box<Probe<'a>>),
}

impl<'a> Light<'a> {
    fn of(subject: &'a Subject) -> Result<Self, PictureError> {
        let ((width, height), scene) = (SIZE, &subject.scene);
        Ok(if subject.is_by_depth() {
            Self::Depth(DepthProbe::new(scene, width, height)?)
        } else {
            let options = whitted::Options::default();
            Self::Whitted(Box::new(Probe::new(scene, width, height, &options)?))
        })
    }

    fn at(&self, x: f64, y: f64) -> DVec3 {
        match self {
            Self::Depth(probe) => probe.colour(x, y),
            Self::Whitted(probe) => probe.light(x, y),
        }
    }

    /// The picture with [`REFERENCE`] samples across and down each pixel, in 1/255, of which a
    /// picture `side` times as large has `side` pixels across and down. Light is limited after the
    /// mean is taken.
    ///
    /// NFF's camera has its corners in the centres of the corner pixels. So the pixels of a larger
    /// picture are not exactly parts of those of the smaller one.
    fn picture(&self, side: u32) -> Vec<DVec3> {
        let place = |pixel: u32, cell: u32, pixels: u32| {
            let side = f64::from(side);
            let within = (f64::from(cell) + 0.5) / f64::from(REFERENCE);
            let in_larger = side * (f64::from(pixel) + within) - 0.5;
            in_larger * f64::from(pixels - 1) / (side * f64::from(pixels) - 1.0)
        };
        let pixel = |x: u32, y: u32| {
            let cells =
                (0..REFERENCE).flat_map(|row| (0..REFERENCE).map(move |column| (column, row)));
            let light =
                cells.map(|(column, row)| self.at(place(x, column, SIZE.0), place(y, row, SIZE.1)));
            let mean = light.sum::<DVec3>() / f64::from(REFERENCE * REFERENCE);
            255.0 * mean.clamp(DVec3::ZERO, DVec3::ONE)
        };
        let rows: Vec<u32> = (0..SIZE.1).collect();
        let row = |(): &mut (), y: &u32| (0..SIZE.0).map(|x| pixel(x, *y)).collect::<Vec<_>>();
        parallel::map(&rows, || (), row).concat()
    }
}

/// Traces the scenes in every way.
///
/// # Errors
///
/// Fails if a scene can't be traced, or if an SPU fails.
pub fn measure(mut progress: impl FnMut(&str)) -> Result<Vec<Row>, PictureError> {
    let mut rows = Vec::new();
    for name in NAMES {
        let subject = Subject::load(name)?;
        let light = Light::of(&subject)?;
        let mut references = BTreeMap::new();
        for way in Way::all() {
            progress(&format!("{name}: {}", way.name()));
            let (pixels, traced) = way.pixels(&subject)?;
            let side = way.side();
            let expected = references.entry(side).or_insert_with(|| light.picture(side));
            let errors = pixels.iter().zip(&*expected);
            let errors: Vec<_> = errors.map(|(found, exact)| (found - exact).abs()).collect();
            let squares: f64 = errors.iter().map(|error| error.length_squared()).sum();
            let count = errors.len() as f64;
            let visible = errors.iter().filter(|error| error.max_element() > 8.0);
            rows.push(Row {
                scene: name,
                way: way.name(),
                rays_a_pixel: traced.primary_rays as f64 / count,
                frames_per_second: traced.frames_per_second,
                rmse: (squares / (3.0 * count)).sqrt(),
                max_error: errors.iter().map(|error| error.max_element()).fold(0.0, f64::max),
                visible_percent: 100.0 * visible.count() as f64 / count,
            });
        }
    }
    Ok(rows)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn grid_mean_is_of_a_pixels_square() {
        let (width, height) = SIZE;
        let value = |x: u32, y: u32| DVec3::new(f64::from(x), f64::from(y), 1.0);
        let samples: Vec<_> =
            (0..2 * height).flat_map(|y| (0..2 * width).map(move |x| value(x, y))).collect();
        let means = means(&samples, 2);
        assert_eq!(means.len(), (width * height) as usize);
        assert_eq!(means[(3 * width + 5) as usize], DVec3::new(10.5, 6.5, 1.0));
    }

    #[test]
    fn names_differ() {
        let mut names: Vec<_> = Way::all().into_iter().map(Way::name).collect();
        let count = names.len();
        names.sort();
        names.dedup();
        assert_eq!(names.len(), count);
    }
}
