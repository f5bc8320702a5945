//! Scenes as Eric Haines' Neutral File Format (NFF) gives them.
//!
//! Owns the scene data, the text format both ways, the camera that a view stands for, the triangles
//! of a polygon, the sphereflake of the Standard Procedural Databases and the depth-shading model. Knows nothing of
//! work units, SPUs or pictures.
//!
//! Invariant: a [`Scene`] that [`parse`] returned has a valid view, only finite numbers of at most
//! [`MAX_MAGNITUDE`], no zero radius and no material index out of range.

pub mod depth;
mod error;
mod lines;
mod parse;
mod scene;
pub mod sphereflake;
mod triangles;
mod view;
mod words;
mod write;

pub use error::{Error, Excerpt, Fault};
pub use lines::Limits;
pub use parse::{parse, read};
pub use scene::{Light, Material, Object, Scene, Shape};
pub use triangles::{area_vector, triangles};
pub use view::{Camera, MAX_SIDE, View, ViewError, unit};
pub use words::MAX_MAGNITUDE;

use std::path::Path;

/// What names a generated sphereflake where a file name is expected: `sphereflake:LEVEL`.
const SPHEREFLAKE: &str = "sphereflake:";

/// Brings the scene that a user named: `sphereflake:LEVEL` is generated, all else is a file to [`read`].
///
/// # Errors
/// What [`read`] or [`sphereflake::generate`] refuses; a level that is not a number.
pub fn load(name: &Path) -> Result<Scene, Error> {
    let level = name
        .to_str()
        .and_then(|name| name.strip_prefix(SPHEREFLAKE));
    let Some(level) = level else {
        return read(name);
    };
    let level = level
        .parse()
        .map_err(|_| sphereflake::Error::Level(Excerpt::of(level)))?;
    Ok(sphereflake::generate(level)?)
}
