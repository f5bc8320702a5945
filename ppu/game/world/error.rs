//! The errors of a world.

use std::error::Error;
use std::panic::Location;

use scenes::ViewError;

use crate::scene::SceneError;

/// A change of a world that is refused, or a world that can't be traced: why, and in which line of
/// the game.
#[derive(Debug, thiserror::Error)]
#[error("{kind}")]
pub struct WorldError {
    #[source]
    kind: WorldErrorKind,
    place: &'static Location<'static>,
}

/// Why a change of a world is refused, or why it can't be traced.
#[derive(Debug, thiserror::Error)]
pub enum WorldErrorKind {
    /// The handle's object was removed, or belongs to another world.
    #[error("there is no such object: it was removed, or belongs to another world")]
    NoObject,
    /// The handle's mesh was removed, or belongs to another world.
    #[error("there is no such mesh: it was removed, or belongs to another world")]
    NoMesh,
    /// A world has one height field at most.
    #[error("the world has a height field already")]
    SecondTerrain,
    /// The world has no height field that could be changed.
    #[error("the world has no height field")]
    NoTerrain,
    /// A mesh whose parts don't belong together.
    #[error("the mesh is not valid: {0}")]
    BadMesh(String),
    /// The handle's material was removed, or belongs to another world.
    #[error("there is no such material: it was removed, or belongs to another world")]
    NoMaterial,
    /// The handle's light was removed, or belongs to another world.
    #[error("there is no such light: it was removed, or belongs to another world")]
    NoLight,
    /// A material can't be removed while objects or meshes are made of it.
    #[error("the material can't be removed: {users} object(s) or mesh(es) are made of it")]
    MaterialInUse {
        /// How many objects are made of it.
        users: u32,
    },
    /// A fixed object can't be moved.
    #[error("the object is fixed: it can't be moved until it is freed")]
    Fixed,
    /// A number is outside of the range in which the SPU's single format can hold its square.
    #[error("{what} {value:e} is out of range: its magnitude must be at most 2^62{also}")]
    OutOfRange {
        /// Name of the number.
        what: &'static str,
        /// Its value.
        value: f64,
        /// A further bound, as a part of the message.
        also: &'static str,
    },
    /// A shape without a surface.
    #[error("the shape has no surface: {0}")]
    NoSurface(&'static str),
    /// The object, light or material in a line of a file is refused.
    #[error("{file}:{line}: {source}")]
    At {
        /// Name of the file.
        file: String,
        /// Number of the line, from 1.
        line: u32,
        /// The reason.
        source: Box<WorldErrorKind>,
    },
    /// A directional light without a direction.
    #[error("a light that is infinitely far away needs a direction other than 0")]
    NoDirection,
    /// Fog with a negative density.
    #[error("the density of the fog is {0}: it must not be below 0")]
    NegativeFog(f64),
    /// A sky without a direction to its zenith.
    #[error("a sky needs a direction to its zenith other than 0")]
    NoZenith,
    /// An error of the game itself, such as a file that it can't read: see [`WorldError::game`].
    #[error(transparent)]
    Game(Box<dyn Error + Send + Sync>),
    /// A view that shows nothing.
    #[error(transparent)]
    View(#[from] ViewError),
    /// The world doesn't fit the SPUs' local store, or a shader is missing.
    #[error(transparent)]
    Scene(#[from] SceneError),
}

impl WorldError {
    /// An error of the game itself, which ends the session with its message.
    ///
    /// ```
    /// use cellray::game::WorldError;
    ///
    /// fn level(file: &str) -> Result<String, WorldError> {
    ///     std::fs::read_to_string(file).map_err(|error| WorldError::game(format!("{file}: {error}")))
    /// }
    /// assert!(level("no-such-level").unwrap_err().to_string().starts_with("no-such-level: "));
    /// ```
    #[track_caller]
    pub fn game(error: impl Into<Box<dyn Error + Send + Sync>>) -> Self {
        WorldErrorKind::Game(error.into()).into()
    }

    /// Why.
    #[must_use]
    pub fn kind(&self) -> &WorldErrorKind {
        &self.kind
    }

    /// The place in the source where the world's method was called.
    #[must_use]
    pub fn place(&self) -> &'static Location<'static> {
        self.place
    }

    /// The reason alone.
    pub(super) fn into_kind(self) -> WorldErrorKind {
        self.kind
    }
}

impl From<WorldErrorKind> for WorldError {
    #[track_caller]
    fn from(kind: WorldErrorKind) -> Self {
        let place = Location::caller();
        Self { kind, place }
    }
}

impl From<SceneError> for WorldError {
    #[track_caller]
    fn from(error: SceneError) -> Self {
        WorldErrorKind::from(error).into()
    }
}

impl From<ViewError> for WorldError {
    #[track_caller]
    fn from(error: ViewError) -> Self {
        WorldErrorKind::from(error).into()
    }
}
