//! What a world refuses.

use nff::ViewError;

use crate::scene::SceneError;

/// Why a world did not change, or can't be traced.
#[derive(Debug, thiserror::Error)]
pub enum WorldError {
    /// A handle of an object that was removed, or of none at all.
    #[error("there is no such object: it was removed, or never was in this world")]
    NoObject,
    /// A handle of a material that was removed, or of none at all.
    #[error("there is no such material: it was removed, or never was in this world")]
    NoMaterial,
    /// A handle of a light that was removed, or of none at all.
    #[error("there is no such light: it was removed, or never was in this world")]
    NoLight,
    /// A material that objects are made of stays.
    #[error("the material can't be removed: {users} object(s) are made of it")]
    MaterialInUse {
        /// How many.
        users: u32,
    },
    /// A fixed object stays where it is.
    #[error("the object is fixed: it can't be moved before it is freed")]
    Fixed,
    /// A number that is not in the SPU's single format with room to be squared.
    #[error("{what} {value:e} is out of range: its magnitude must be at most 2^62{also}")]
    OutOfRange {
        /// Which number.
        what: &'static str,
        /// What it was.
        value: f64,
        /// A further bound.
        also: &'static str,
    },
    /// A shape that is none.
    #[error("the shape has no surface: {0}")]
    NoSurface(&'static str),
    /// What is in a line of a file is refused.
    #[error("{file}:{line}: {source}")]
    At {
        /// The file.
        file: String,
        /// The line, from 1.
        line: u32,
        /// Why.
        source: Box<WorldError>,
    },
    /// A light from nowhere.
    #[error("a light that is infinitely far needs a direction, which 0 is not")]
    NoDirection,
    /// A view that shows nothing.
    #[error(transparent)]
    View(#[from] ViewError),
    /// Its objects, lights or materials do not fit the SPUs, or a shader is missing.
    #[error(transparent)]
    Scene(#[from] SceneError),
}
