//! The errors of Whitted's model.

use crate::scene::mesh::MeshError;
use protocol::layout::{MAX_DEPTH, MAX_LIGHTS, MAX_OBJECTS, MESH_TEXTURES};

/// Why a scene can't be converted to the SPUs' format. The messages begin with the file.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum BlockError {
    /// The scene has more primitives of a kind than a tree holds.
    #[error("{place}: more than {MAX_OBJECTS} {what}: the scene has about {count}; {fits}")]
    TooManyObjects {
        /// The file, and the line of the first object that doesn't fit.
        place: String,
        /// The kind of primitive, in plural.
        what: &'static str,
        /// About how many the scene has.
        count: usize,
        /// A text that estimates how much fits.
        fits: String,
    },
    /// An object is added to a tree that is full.
    #[error("{place}: there are {MAX_OBJECTS} {what} already")]
    FullTree {
        /// The file, and the line of the first object that doesn't fit.
        place: String,
        /// The kind of primitive, in plural.
        what: &'static str,
    },
    /// A polygon needs more triangles than a tree holds.
    #[error("{place}: a polygon of {vertices} vertices takes more than {MAX_OBJECTS} triangles")]
    LargePolygon {
        /// The file, and the polygon's line.
        place: String,
        /// The number of its vertices.
        vertices: usize,
    },
    /// The scene has more lights than the SPUs' memory holds.
    #[error("{file}:{line}: more than {MAX_LIGHTS} lights")]
    TooManyLights {
        /// Name of the file.
        file: String,
        /// Line of the first light that doesn't fit.
        line: u32,
    },
    /// A number is outside of the range in which the SPU's single format can hold its square.
    #[error("{place}: {what} {value:e} is out of range: its magnitude must be at most 2^62{also}")]
    OutOfRange {
        /// The file, and the line if there is one.
        place: String,
        /// Name of the number.
        what: &'static str,
        /// Its value.
        value: f64,
        /// A further bound, as a part of the message.
        also: &'static str,
    },
    /// A transparent material has no index of refraction.
    #[error("{file}:{line}: an index of refraction of 0 refracts nothing (T is above 0)")]
    RefractionIndex {
        /// Name of the file.
        file: String,
        /// The material's line.
        line: u32,
    },
    /// The SPU program doesn't have a material's shader.
    #[error("{file}:{line}: the SPU program has no shader `{name}`")]
    UnknownShader {
        /// Name of the file.
        file: String,
        /// The material's line.
        line: u32,
        /// The shader's name.
        name: String,
    },
    /// The SPU program doesn't have the shader of skies.
    #[error(
        "{file}: the SPU program has no shader `sky`, which the gradient of the background needs"
    )]
    NoSky {
        /// Name of the file.
        file: String,
    },
    /// The local store is too small for the scene.
    #[error(
        "{file}: the scene takes {needed} bytes of local store, but {capacity} are free (with a queue for rays of depth {ray_depth}): {consumers}; {fits}"
    )]
    TooLarge {
        /// Name of the file.
        file: String,
        /// The bytes that the scene takes.
        needed: usize,
        /// The bytes that are available.
        capacity: usize,
        /// The longest chain of rays, which determines the space for queued rays.
        ray_depth: u32,
        /// A text that lists the largest consumers of memory.
        consumers: String,
        /// A text that estimates how much fits.
        fits: String,
    },
    /// The scene's mesh has more textures than the SPUs support.
    #[error("{file}: the mesh has {count} textures; there may be {MESH_TEXTURES}")]
    TooManyTextures {
        /// Name of the file.
        file: String,
        /// The number of its textures.
        count: usize,
    },
    /// The scene's mesh can't be converted to blocks.
    #[error("{file}: {source}")]
    Mesh {
        /// Name of the file.
        file: String,
        /// The reason.
        source: MeshError,
    },
    /// The ray depth is out of range.
    #[error("ray depth {0}: must be 1 to {MAX_DEPTH}")]
    RayDepth(u32),
}

impl BlockError {
    /// Whether the scene does not fit into local store, so that more of it must be in main memory.
    pub(crate) fn is_out_of_memory(&self) -> bool {
        matches!(self, Self::TooLarge { .. } | Self::TooManyObjects { .. })
    }
}
