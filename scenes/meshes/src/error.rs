//! The errors of mesh files.

use std::io;

use thiserror::Error;

use crate::builder::MAX_CORNERS;
use crate::{MAX_FILE, MAX_MATERIALS, MAX_TRIANGLES};

/// Why a scene can't be loaded.
#[derive(Debug, Error)]
pub enum Error {
    /// A scene that is not a mesh file.
    #[error(transparent)]
    Nff(#[from] scenes::Error),
    /// There is neither a file nor a generated scene of this name.
    #[error("{name}: {what}")]
    Unknown {
        /// The name.
        name: String,
        /// What is wrong with it, and what may have been meant.
        what: String,
    },
    /// A mesh file.
    #[error("{file}: {fault}")]
    Mesh {
        /// The file.
        file: String,
        /// What is wrong with it.
        fault: Fault,
    },
    /// A line of a mesh file.
    #[error("{file}:{line}: {what}")]
    Line {
        /// The file.
        file: String,
        /// The line, from 1.
        line: usize,
        /// What is wrong with it.
        what: String,
    },
}

impl Error {
    /// A fault of a file, or of a line of it.
    pub(crate) fn of(file: &str, fault: Fault) -> Self {
        let file = file.to_owned();
        match fault {
            Fault::Line { line, what } => Self::Line { file, line, what },
            fault => Self::Mesh { file, fault },
        }
    }
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
    /// The file is of a format that is not read.
    #[error(
        "this is {0}; the formats that are read are NFF, OBJ, PLY, STL, glTF (.gltf, .glb) \
             and height maps (.png, .hgt, .npy)"
    )]
    Foreign(&'static str),
    /// The text has an encoding in which words are not those of ASCII.
    #[error("the file is {0} text; save it as UTF-8")]
    Encoding(&'static str),
    /// A terrain can't be generated.
    #[error("the level is not a whole number from 0 to {most}")]
    Level {
        /// The largest level.
        most: u32,
    },
    /// Mountains can't be generated.
    #[error("the level is not a whole number from {minimum} to {maximum}")]
    Mountains {
        /// The smallest level.
        minimum: u32,
        /// The largest level.
        maximum: u32,
    },
    /// The file has no triangles.
    #[error("the file has no triangles")]
    NoTriangles,
    /// All triangles are lines or points.
    #[error("no triangle has an area, of {0} in the file")]
    NoArea(usize),
    /// The file has too many triangles.
    #[error("the file has more than {MAX_TRIANGLES} triangles")]
    TooManyTriangles,
    /// The file has too many vertices.
    #[error("the file has more than three vertices for each of {MAX_TRIANGLES} triangles")]
    TooManyVertices,
    /// A face has too many corners.
    #[error("a face has {0} corners; the most is {MAX_CORNERS}")]
    TooManyCorners(usize),
    /// The file has too many materials.
    #[error("the file's triangles have more than {MAX_MATERIALS} materials")]
    TooManyMaterials,
    /// A number is NaN or infinite.
    #[error("{what} {index} is not finite: {value}")]
    NotFinite {
        /// What has the number.
        what: &'static str,
        /// Its index among the vertices of faces, from 0.
        index: usize,
        /// The number.
        value: f64,
    },
    /// A coordinate is too large.
    #[error("vertex {index} is at {position:?}; coordinates must be at most 2^62")]
    OutOfRange {
        /// The vertex's index.
        index: usize,
        /// Its position.
        position: [f64; 3],
    },
    /// A triangle has a vertex that doesn't exist.
    #[error("face {face} has the vertex {index}, but there are only {vertices} vertices")]
    Vertex {
        /// The face's index in the file, or in its part of the file, from 0.
        face: usize,
        /// The vertex's index.
        index: f64,
        /// The number of vertices.
        vertices: usize,
    },
    /// A line of a text file.
    #[error("line {line}: {what}")]
    Line {
        /// The line, from 1.
        line: usize,
        /// The fault.
        what: String,
    },
    /// A material library can't be read.
    #[error("{file}: {fault}")]
    Library {
        /// The library.
        file: String,
        /// The fault.
        fault: Box<Fault>,
    },
    /// A PLY file's header or data.
    #[error("not a valid PLY file: {0}")]
    Ply(String),
    /// An STL file.
    #[error("not a valid STL file: {0}")]
    Stl(String),
    /// A glTF file.
    #[error("not a valid glTF file: {0}")]
    Gltf(String),
    /// A file has no such animation.
    #[error(
        "the file has no animation `{name}`; it has {}",
        if known.is_empty() { "none".to_owned() } else { known.join(", ") }
    )]
    NoAnimation {
        /// The name or number that was asked for.
        name: String,
        /// The names that it has, or the numbers of those without a name.
        known: Vec<String>,
    },
    /// A height map.
    #[error("not a valid height map: {0}")]
    HeightMap(String),
    /// A height map whose sizes or lengths can't be those of a height field.
    #[error(transparent)]
    Heights(#[from] scenes::HeightError),
    /// An extension of glTF that is not read.
    #[error("the file needs the extension {name}: {what}")]
    Extension {
        /// The extension.
        name: &'static str,
        /// Its meaning, and how the file can be converted.
        what: &'static str,
    },
}
