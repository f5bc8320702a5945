//! Renders pictures by the model of Whitted (1980), as `docs/shading.md` describes it.
//!
//! Owns the grid of primary rays, and combines their colours to pixels. Invariant: the same scene
//! and options give the same picture and the same counts, with any number of threads.

mod colour;
mod finish;
mod light;
mod path;
mod probe;
mod stage;
mod texture;
mod weight;

use glam::DVec3;
use nff::{Scene, depth};

use crate::{Error, Picture, Reference, rows, silhouette};
pub use colour::Colour;
pub use path::Counts;
use path::Path;
pub use probe::Probe;
use stage::Stage;

/// The greatest ray depth. Each hit on glass sends two rays, so a depth of n may cost 2^n.
pub const MAX_DEPTH: u32 = 16;

/// The settings of the model.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Options {
    /// The longest chain of rays, including the primary ray, from 1 to [`MAX_DEPTH`].
    pub depth: u32,
    /// Whether transparent surfaces reflect by Schlick's approximation in addition to their Ks.
    pub fresnel: bool,
    /// Whether to trace all rays that the Standard Procedural Databases count, even those of
    /// weight 0. Then every surface that reflects or lets light through sends a reflected ray, and
    /// every lit surface sends a shadow ray to each light in front of it. This changes only the
    /// counts.
    pub spd_rays: bool,
    /// Whether primary rays go through the corners of the pixels instead of their centres, and
    /// each pixel averages its four, as the Standard Procedural Databases require.
    pub corners: bool,
    /// What the channels of the scene's colours and of pixels say about light.
    pub colour: Colour,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            depth: 5,
            fresnel: false,
            spd_rays: false,
            corners: false,
            colour: Colour::Linear,
        }
    }
}

/// The result of a primary ray.
#[derive(Debug, Clone, Copy, Default)]
struct Sample {
    colour: DVec3,
    /// [`Path::signature`].
    signature: u64,
}

/// Renders a scene with its silhouettes, and counts the rays.
///
/// # Errors
/// - The size or the ray depth is out of range, or the view has no camera for the size.
/// - A transparent material has no index of refraction.
/// - A patch has too many vertices.
/// - A material has a game's own shader.
pub fn trace(
    scene: &Scene,
    width: u32,
    height: u32,
    options: &Options,
) -> Result<(Reference, Counts), Error> {
    let mut picture = Picture::black(width, height)?;
    let mut camera = scene
        .view
        .camera(width, height)
        .map_err(|source| Error::View {
            scene: scene.name.clone(),
            source,
        })?;
    let more = u32::from(options.corners);
    let (columns, lines) = (width + more, height + more);
    if options.corners {
        camera.corner -= (camera.right + camera.down) / 2.0;
    }
    let stage = Stage::new(scene, &camera, options)?;

    let row = columns as usize;
    let mut samples = vec![Sample::default(); row * lines as usize];
    let mut counts = vec![Counts::default(); lines as usize];
    let items = (0..lines).zip(samples.chunks_mut(row)).zip(&mut counts);
    rows::each(items, |((y, samples), counts)| {
        for (x, sample) in (0..).zip(samples) {
            let mut path = Path::default();
            let colour = stage.eye(camera.eye, camera.direction(x, y), &mut path);
            *sample = Sample {
                colour: colour.clamp(DVec3::ZERO, DVec3::ONE),
                signature: path.signature(),
            };
            *counts += path.counts;
        }
    });
    let counts = counts.into_iter().fold(Counts::default(), |mut sum, row| {
        sum += row;
        sum
    });

    let pixel = |(x, y): (usize, usize)| {
        let first = y * row + x;
        if options.corners {
            [first, first + 1, first + row, first + row + 1].map(|at| samples[at])
        } else {
            [samples[first]; 4]
        }
    };
    let places = (0..height as usize).flat_map(|y| (0..width as usize).map(move |x| (x, y)));
    let mut signatures = Vec::with_capacity(picture.pixels().len());
    for (bytes, corners) in picture.pixels_mut().iter_mut().zip(places.map(pixel)) {
        let [a, b, c, d] = corners.map(|sample| sample.colour);
        *bytes = depth::bytes(options.colour.shown(((a + b) + (c + d)) / 4.0));
        signatures.push(corners.map(|sample| sample.signature));
    }
    let reference = Reference {
        picture,
        silhouette: silhouette::mask(&signatures, width as usize),
        covered: counts.eye_hit as f64 / counts.eye as f64,
    };
    Ok((reference, counts))
}
