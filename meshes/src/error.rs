//! The errors of mesh files.

use std::io;

use thiserror::Error;

use crate::{MAX_FILE, MAX_MATERIALS, MAX_TEXELS, MAX_TRIANGLES};

/// Why a scene can't be loaded.
#[derive(Debug, Error)]
pub enum Error {
    /// A scene that is not a mesh file.
    #[error(transparent)]
    Nff(#[from] nff::Error),
    /// A mesh file.
    #[error("{file}: {fault}")]
    Mesh {
        /// The file.
        file: String,
        /// What is wrong with it.
        fault: Fault,
    },
}

/// What is wrong with a mesh file.
#[derive(Debug, Error)]
pub enum Fault {
    /// The file could not be opened or read.
    #[error(transparent)]
    Io(#[from] io::Error),
    /// The file is too large.
    #[error("the file has {size} bytes or more; the most is {MAX_FILE}")]
    TooLarge {
        /// Bytes, as far as they were counted.
        size: u64,
    },
    /// A terrain can't be generated.
    #[error("the level is not a whole number from 0 to {most}")]
    Level {
        /// The greatest level.
        most: u32,
    },
    /// The file has no triangles.
    #[error("the file has no triangles")]
    NoTriangles,
    /// The file has too many triangles.
    #[error("the file has more than {MAX_TRIANGLES} triangles")]
    TooManyTriangles,
    /// The file has too many materials.
    #[error("the file's triangles have more than {MAX_MATERIALS} materials")]
    TooManyMaterials,
    /// A number is NaN or infinite.
    #[error("{what} {index} is not finite: {value}")]
    NotFinite {
        /// What has the number.
        what: &'static str,
        /// Its index in the file, from 0.
        index: usize,
        /// The number.
        value: f32,
    },
    /// A triangle has a vertex that doesn't exist.
    #[error("face {face} has the vertex {index}, but there are only {vertices} vertices")]
    Vertex {
        /// The face's index in the file, or in its part of the file, from 0.
        face: usize,
        /// The vertex's index.
        index: i64,
        /// The number of vertices.
        vertices: usize,
    },
    /// A face with fewer than three vertices.
    #[error("face {face} has {corners} vertices; it needs at least 3")]
    Corners {
        /// The face's index in the file, from 0.
        face: usize,
        /// The number of its vertices.
        corners: usize,
    },
    /// A corner of a face in an OBJ file has a number that no vertex has.
    #[error("line {line}: a face has the corner {corner}, but there is no such vertex")]
    Corner {
        /// The line.
        line: u32,
        /// The corner's numbers.
        corner: String,
    },
    /// The text of an OBJ file.
    #[error("not a valid OBJ file: {0}")]
    Obj(#[from] tobj::LoadError),
    /// A material library can't be read.
    #[error("{file}: {fault}")]
    Library {
        /// The library.
        file: String,
        /// What is wrong with it.
        fault: Box<Fault>,
    },
    /// The text of a material library.
    #[error("{file}:{line}: {word} needs three numbers")]
    Mtl {
        /// The library.
        file: String,
        /// The line, from 1.
        line: usize,
        /// The word that the numbers belong to.
        word: String,
    },
    /// A texture is missing or broken.
    #[error("the texture {name}: {what}")]
    Texture {
        /// The picture's file, or which of the file's images it is.
        name: String,
        /// What is wrong with it.
        what: String,
    },
    /// The textures are too large.
    #[error("the textures have {0} texels; the most is {MAX_TEXELS}")]
    TooManyTexels(usize),
    /// A part with a texture has no texture coordinates.
    #[error("{part} has a texture, but not all of its vertices have texture coordinates")]
    NoCoordinates {
        /// The part of the file.
        part: String,
    },
    /// A PLY file's header or data.
    #[error("not a valid PLY file: {0}")]
    Ply(String),
    /// A binary glTF file.
    #[error("not a valid glTF file: {0}")]
    Glb(String),
}
