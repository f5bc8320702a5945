//! The reference: the depth-shading model of [`nff::depth`] traced in `f64`, and the comparison of
//! pictures with it.
//!
//! Owns what is true about a picture. Knows nothing of work units or of how the picture under test
//! came about. Invariant: the reference shares no formula with a kernel or its twin; `nff` gives only
//! the data, the camera and the model's shading.

mod compare;
mod picture;
mod sphere;
mod tracer;
pub mod twin;

pub use compare::{Comparison, DIFFERENCE_SCALE, compare, difference};
pub use picture::{MAX_PIXELS, Picture};
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
    /// More pixels than [`MAX_PIXELS`], or none.
    #[error("a picture of {width}x{height} has not from 1 to {MAX_PIXELS} pixels")]
    Size {
        /// Pixels in a row.
        width: u32,
        /// Rows.
        height: u32,
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
