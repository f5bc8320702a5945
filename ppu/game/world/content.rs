//! What a world is made of, each under its handle.

use nff::Shape;

use super::edits::Tracing;
use super::ids::MaterialId;
use super::material::Light;

pub(super) struct Object {
    /// In the file that it is from.
    pub line: Option<u32>,
    pub shape: Shape,
    pub material: MaterialId,
    pub visible: bool,
    pub fixed: bool,
    pub traced: Tracing,
}

pub(super) struct WorldMaterial {
    /// In the file that it is from.
    pub line: Option<u32>,
    pub material: nff::Material,
    /// Objects that are made of it.
    pub users: u32,
    pub traced: Tracing,
}

pub(super) struct WorldLight {
    /// In the file that it is from.
    pub line: Option<u32>,
    pub light: Light,
    pub traced: Tracing,
}
