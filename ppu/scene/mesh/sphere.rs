//! A sphere in main memory.

use glam::{DVec3, Vec3};
use protocol::layout::{self, MeshVertex};
use zerocopy::FromZeros as _;
use zerocopy::big_endian::F32;

use super::tree::Bounds;

/// A sphere of a scene that does not fit into local store.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeshSphere {
    /// Centre, relative to the mesh's origin.
    pub centre: Vec3,
    /// Radius; below 0 if only its inside is seen.
    pub radius: f32,
    /// `SIDES_` bits.
    pub sides: u32,
    /// Index of the material in the scene.
    pub material: u32,
}

impl MeshSphere {
    /// The box around it. SPUs widen boxes by more than the rounding of these sums.
    pub(super) fn bounds(&self) -> Bounds {
        let radius = Vec3::splat(self.radius.abs());
        Bounds { low: self.centre - radius, high: self.centre + radius }
    }

    /// The corners of the box around it.
    #[inline]
    pub(super) fn corners(&self) -> [DVec3; 2] {
        let (centre, radius) = (self.centre.as_dvec3(), f64::from(self.radius.abs()));
        [centre - radius, centre + radius]
    }

    /// Its record for sorting, where `material` is the number of the material in blocks.
    #[inline]
    pub(super) fn quadwords(&self, material: u32) -> [MeshVertex; 3] {
        zerocopy::transmute!(self.record(material))
    }

    /// Its record in a block, where `material` is the number of the material in blocks.
    #[inline]
    pub(super) fn record(&self, material: u32) -> layout::Object {
        layout::Object {
            centre: self.centre.to_array().map(F32::new),
            gain: self.radius.signum().into(),
            offset: self.radius.into(),
            material: material.into(),
            sides: self.sides.into(),
            ..layout::Object::new_zeroed()
        }
    }
}
