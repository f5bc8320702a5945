//! The reference: the depth-shading model of [`nff::depth`] and Whitted's model of
//! `docs/shading.md` traced in `f64`, and the comparison of pictures with them.
//!
//! Owns what is true about a picture. Knows nothing of work units or of how the picture under test
//! came about. Invariant: the reference shares no formula with a kernel; `nff` gives only
//! the data, the camera and the model's shading.

mod bvh;
mod compare;
mod picture;
#[cfg(test)]
mod random;
mod ray;
mod rows;
mod shapes;
mod silhouette;
mod sphere;
mod tracer;
pub mod whitted;

pub use compare::{Comparison, DIFFERENCE_SCALE, compare, difference};
pub use picture::Picture;
pub use tracer::{Reference, render, trace};

use std::path::PathBuf;

use thiserror::Error;

/// Why there is no picture or no comparison.
#[derive(Debug, Error)]
pub enum Error {
    /// The scene's view gives no picture of this size.
    #[error("{scene}: {source}")]
    View {
        /// The scene's name.
        scene: String,
        /// What is wrong with its view.
        source: nff::ViewError,
    },
    /// A size that no picture can have.
    #[error(transparent)]
    Size(#[from] nff::ViewError),
    /// A ray depth of 0 or above [`whitted::MAX_DEPTH`].
    #[error("a ray depth of {0} is not from 1 to {max}", max = whitted::MAX_DEPTH)]
    Depth(u32),
    /// A transmitting material into which no ray can be refracted.
    #[error("{scene}:{line}: an index of refraction of 0 refracts nothing (T is above 0)")]
    RefractionIndex {
        /// The scene's name.
        scene: String,
        /// Line of the material.
        line: u32,
    },
    /// A shader that only SPUs have.
    #[error("{scene}:{line}: the reference has no shader `{name}`, which is a game's own")]
    Shader {
        /// The scene's name.
        scene: String,
        /// Line of the material.
        line: u32,
        /// The shader's name.
        name: String,
    },
    /// A patch too large to be cut into triangles.
    #[error("{scene}:{line}: a patch of {vertices} vertices, more than {max}", max = shapes::MAX_PATCH_VERTICES)]
    PatchVertices {
        /// The scene's name.
        scene: String,
        /// Line of the patch.
        line: u32,
        /// How many it has.
        vertices: usize,
    },
    /// A PNG that can't be read or written.
    #[error("{}: {source}", path.display())]
    Png {
        /// The file.
        path: PathBuf,
        /// What is wrong.
        source: image::ImageError,
    },
    /// A PNG whose channels are not bytes.
    #[error("{}: the PNG has pixels of the kind {kind}, not red, green and blue of 8 bits", path.display())]
    Kind {
        /// The file.
        path: PathBuf,
        /// What it has.
        kind: String,
    },
    /// Pictures of different sizes.
    #[error("the picture has {}x{} pixels, the reference {}x{}", picture.0, picture.1, reference.0, reference.1)]
    Sizes {
        /// Width and height of the one.
        picture: (u32, u32),
        /// Width and height of the other.
        reference: (u32, u32),
    },
}
