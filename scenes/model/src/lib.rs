//! Scenes in Eric Haines' Neutral File Format (NFF).
//!
//! Owns the scene data, meshes included, reading and writing the text format with its `#cellray`
//! extensions, the camera of a view, the triangles of a polygon, the scenes of the Standard
//! Procedural Databases, and the depth-shading model. Has no part in work units, SPUs or pictures.
//!
//! Invariant: a [`Scene`] that [`parse`] returned has a valid view, only finite numbers of at most
//! [`MAX_MAGNITUDE`], no radius or direction of 0 and no material index out of range.

pub mod daylight;
pub mod depth;
mod directives;
mod error;
mod even_odd;
mod heights;
mod lines;
mod mesh;
mod names;
mod parse;
mod scene;
pub mod spd;
pub mod sphereflake;
pub mod tetra;
mod texture;
mod triangles;
mod view;
mod words;
mod write;

pub use daylight::{Fog, Sky};
pub use error::{Error, Excerpt, Fault};
pub use even_odd::even_odd;
pub use heights::{HeightError, HeightField, HeightMap, HeightRegion, HeightSample, MAX_SAMPLES};
pub use lines::Limits;
pub use mesh::{Mesh, Visibility, cuboid};
pub use names::{Generated, generated};
pub use parse::{parse, read};
pub use scene::{Light, LightKind, Material, Object, Scene, Shader, Shape};
pub use texture::{Texture, Wrap};
pub use triangles::{area_vector, triangles};
pub use view::{Camera, MAX_SIDE, View, ViewError, check_size, unit};
pub use words::MAX_MAGNITUDE;

use std::path::Path;

/// Loads the scene that a user has named: `sphereflake:LEVEL`, `tetra:LEVEL` and the scenes of
/// [`spd::GENERATORS`] are generated, any other name is a file to [`read`]. A file that has the
/// name of one of these is the file.
///
/// # Errors
/// The level or size is not a number, or any error of [`read`], [`sphereflake::generate`],
/// [`tetra::generate`] or [`spd::Generator::generate`].
pub fn load(name: &Path) -> Result<Scene, Error> {
    let text = name.to_str().unwrap_or_default();
    if name.is_file() {
        read(name)
    } else if let Some(level) = text.strip_prefix(sphereflake::PREFIX) {
        let level = level.parse().map_err(|_| sphereflake::Error::Level(Excerpt::of(level)))?;
        Ok(sphereflake::generate(level)?)
    } else if let Some(level) = text.strip_prefix(tetra::PREFIX) {
        let level = level.parse().map_err(|_| tetra::Error::Level(Excerpt::of(level)))?;
        Ok(tetra::generate(level)?)
    } else if let Some(scene) = spd::named(text) {
        Ok(scene?)
    } else {
        read(name)
    }
}
