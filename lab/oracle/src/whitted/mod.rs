//! Renders pictures with the model of Whitted (1980), as `docs/shading.md` describes it.
//!
//! Owns what a primary ray sees. Invariant: the same scene and options give the same picture and
//! the same counts, with any number of threads.

mod finish;
mod light;
mod path;
mod probe;
mod rounding;
mod stage;
mod texture;
mod weight;

use scenes::{Camera, Scene};

use crate::pixels::{Model, Seen, paint};
use crate::{Error, Pixels, Reference};
pub use path::Counts;
use path::Path;
pub use probe::Probe;
pub use rounding::Rounding;
use stage::Stage;

/// The maximum ray depth. Each hit on glass sends two rays, so a depth of n may cost 2^n.
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
    /// Whether objects cast shadows.
    pub shadows: bool,
    /// How pixels are made of what rays see.
    pub pixels: Pixels,
    /// What happens to the numbers of each ray's record.
    pub rounding: Rounding,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            depth: 5,
            fresnel: false,
            spd_rays: false,
            shadows: true,
            pixels: Pixels::PLAIN,
            rounding: Rounding::Double,
        }
    }
}

/// A scene, and the camera that looks at it.
struct Sight<'a> {
    stage: Stage<'a>,
    camera: Camera,
}

impl Model for Sight<'_> {
    fn row(&self, y: f64) -> impl Fn(f64, &mut Counts) -> Seen {
        let Camera { eye, corner, right, down } = self.camera;
        let first = corner + y * down;
        move |x, counts| {
            let mut path = Path::default();
            let light = self.stage.eye(eye, first + x * right, &mut path);
            *counts += path.counts;
            Seen { light, way: path.signature(), on_edge: false }
        }
    }
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
    let camera = crate::camera(scene, width, height)?;
    let stage = Stage::new(scene, &camera, options)?;
    paint((width, height), &options.pixels, &Sight { stage, camera })
}
