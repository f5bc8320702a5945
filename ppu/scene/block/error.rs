//! Why Whitted's model can't trace a scene.

use protocol::layout::{MAX_DEPTH, MAX_LIGHTS, MAX_OBJECTS};

/// Why a scene is not brought into the SPUs' form. Messages begin with the file.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum BlockError {
    /// More objects of a shape than a tree holds.
    #[error("{place}: more than {MAX_OBJECTS} {what}: the scene has about {count}; {fits}")]
    TooManyObjects {
        /// The scene and the line of the object that finds no place.
        place: String,
        /// The shape, plural.
        what: &'static str,
        /// About how many there are.
        count: usize,
        /// About how much fits, in words.
        fits: String,
    },
    /// A tree is full.
    #[error("{place}: there are {MAX_OBJECTS} {what} already")]
    FullTree {
        /// The scene and the line of the object that finds no place.
        place: String,
        /// The shape, plural.
        what: &'static str,
    },
    /// A polygon that no tree holds.
    #[error("{place}: a polygon of {vertices} vertices takes more than {MAX_OBJECTS} triangles")]
    LargePolygon {
        /// The scene and the line of the polygon.
        place: String,
        /// How many vertices it has.
        vertices: usize,
    },
    /// More lights than the SPUs have room for.
    #[error("{file}:{line}: more than {MAX_LIGHTS} lights")]
    TooManyLights {
        /// The scene.
        file: String,
        /// Line of the first light that finds no place.
        line: u32,
    },
    /// A number that is not in the SPU's single format with room to be squared.
    #[error("{place}: {what} {value:e} is out of range: its magnitude must be at most 2^62{also}")]
    OutOfRange {
        /// The scene, and the line where there is one.
        place: String,
        /// Which number.
        what: &'static str,
        /// What it was.
        value: f64,
        /// A further bound.
        also: &'static str,
    },
    /// Glass that refracts nothing.
    #[error("{file}:{line}: an index of refraction of 0 refracts nothing (T is above 0)")]
    RefractionIndex {
        /// The scene.
        file: String,
        /// The material's line.
        line: u32,
    },
    /// A shader that the SPU program does not have.
    #[error("{file}:{line}: the SPU program has no shader `{name}`")]
    UnknownShader {
        /// The scene.
        file: String,
        /// The material's line.
        line: u32,
        /// The shader's name.
        name: String,
    },
    /// The local store is too small.
    #[error(
        "{file}: the scene takes {needed} bytes of local store and there are {room} (with rays of depth {ray_depth} that wait); of them take {consumers}; {fits}"
    )]
    TooLarge {
        /// The scene.
        file: String,
        /// Bytes that it takes.
        needed: usize,
        /// Bytes that there are for it.
        room: usize,
        /// Most rays in a chain, which is what the waiting rays' room depends on.
        ray_depth: u32,
        /// What takes how many of them, in words.
        consumers: String,
        /// About how much fits, in words.
        fits: String,
    },
    /// No such depth.
    #[error("ray depth {0}: must be 1 to {MAX_DEPTH}")]
    RayDepth(u32),
}
