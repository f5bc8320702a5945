//! The entries of a world, each stored under its handle.

use scenes::Shape;

use super::edits::SceneEntry;
use super::ids::MaterialId;
use super::material::Light;

pub(super) struct Object {
    /// Its line in the file that it comes from.
    pub line: Option<u32>,
    pub shape: Shape,
    pub material: MaterialId,
    pub visible: bool,
    pub fixed: bool,
    pub traced: SceneEntry,
}

pub(super) struct WorldMaterial {
    /// Its line in the file that it comes from.
    pub line: Option<u32>,
    pub material: scenes::Material,
    /// How many objects and meshes are made of it.
    pub users: u32,
    pub traced: SceneEntry,
}

pub(super) struct WorldLight {
    /// Its line in the file that it comes from.
    pub line: Option<u32>,
    pub light: Light,
    pub traced: SceneEntry,
}
