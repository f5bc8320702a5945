//! The reference: the depth-shading model of [`scenes::depth`] and Whitted's model of
//! `docs/shading.md` traced in `f64`, and the comparison of pictures with them.
//!
//! Owns the definition of a right picture. Does not depend on work units, or on how the picture
//! under test was made. Invariant: the reference shares no formula with a kernel. From `nff` it
//! only uses the data, the camera and the model's shading.

mod bvh;
mod colour;
mod compare;
mod explain;
mod floor;
mod picture;
mod pixels;
#[cfg(test)]
mod random;
mod ray;
mod rows;
mod settings;
mod shapes;
mod silhouette;
mod sphere;
mod tracer;
pub mod whitted;

pub use colour::Colour;
pub use compare::{Comparison, DIFFERENCE_SCALE, compare, difference};
pub use explain::{Explanation, ULPS, WELL_CONDITIONED, WrongPixel, explain};
pub use floor::rounded_to_singles;
pub use picture::Picture;
pub use pixels::{Pixels, Samples};
pub use settings::{Model, Settings};
pub use tracer::{DepthProbe, Reference, render, trace, trace_with};

use std::path::PathBuf;

use scenes::{Camera, Scene};
use thiserror::Error;

/// The camera of a scene's view for a picture of this size, which must be one.
fn camera(scene: &Scene, width: u32, height: u32) -> Result<Camera, Error> {
    scenes::check_size(width, height)?;
    let camera = scene.view.camera(width, height);
    camera.map_err(|source| Error::View { scene: scene.name.clone(), source })
}

/// Why a picture can't be rendered or compared.
#[derive(Debug, Error)]
pub enum Error {
    /// The scene's view has no camera for this size.
    #[error("{scene}: {source}")]
    View {
        /// The scene's name.
        scene: String,
        /// The reason.
        source: scenes::ViewError,
    },
    /// The size is out of range.
    #[error(transparent)]
    Size(#[from] scenes::ViewError),
    /// The ray depth is 0 or above [`whitted::MAX_DEPTH`].
    #[error("a ray depth of {0} is not from 1 to {max}", max = whitted::MAX_DEPTH)]
    Depth(u32),
    /// A transparent material has no index of refraction.
    #[error("{scene}:{line}: an index of refraction of 0 refracts nothing (T is above 0)")]
    RefractionIndex {
        /// The scene's name.
        scene: String,
        /// Line of the material.
        line: u32,
    },
    /// A material has a game's own shader, which only SPUs can run.
    #[error("{scene}:{line}: the reference has no shader `{name}`, which is a game's own")]
    Shader {
        /// The scene's name.
        scene: String,
        /// Line of the material.
        line: u32,
        /// The shader's name.
        name: String,
    },
    /// A patch has too many vertices to be split into triangles.
    #[error("{scene}:{line}: a patch of {vertices} vertices, more than {max}", max = shapes::MAX_PATCH_VERTICES)]
    PatchVertices {
        /// The scene's name.
        scene: String,
        /// Line of the patch.
        line: u32,
        /// The number of its vertices.
        vertices: usize,
    },
    /// A PNG can't be read or written.
    #[error("{}: {source}", path.display())]
    Png {
        /// The file.
        path: PathBuf,
        /// The reason.
        source: image::ImageError,
    },
    /// The name of a picture has the extension of another format.
    #[error("{}: a reference is written as .png, which loses nothing", path.display())]
    Format {
        /// The file.
        path: PathBuf,
    },
    /// A PNG has channels other than 8-bit red, green and blue.
    #[error("{}: the PNG has pixels of the kind {kind}, not red, green and blue of 8 bits", path.display())]
    Kind {
        /// The file.
        path: PathBuf,
        /// The kind of its pixels.
        kind: String,
    },
    /// A picture has a setting that means nothing.
    #[error("{}: its setting {name} is {value:?}, which is not {expected}", path.display())]
    Setting {
        /// The file.
        path: PathBuf,
        /// The setting's name.
        name: &'static str,
        /// Its value.
        value: String,
        /// The expected kind of value.
        expected: &'static str,
    },
    /// Pixels of several samples can't be explained.
    #[error("only pictures with one sample a pixel can be explained (--antialias 1)")]
    Samples,
    /// The pictures have different sizes.
    #[error("the picture has {}x{} pixels, the reference {}x{}", picture.0, picture.1, reference.0, reference.1)]
    Sizes {
        /// Width and height of the picture.
        picture: (u32, u32),
        /// Width and height of the reference.
        reference: (u32, u32),
    },
}
