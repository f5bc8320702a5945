//! A cone in main memory.

use glam::{DVec3, Vec3};
use protocol::layout::{self, MeshVertex};
use zerocopy::FromZeros as _;
use zerocopy::big_endian::F32;

use super::tree::Bounds;
use crate::scene::single::{down, single, up};

/// A cone or cylinder of a scene that does not fit into local store.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeshCone {
    /// The middle of its base, relative to the mesh's origin.
    pub base: Vec3,
    /// The unit vector to its apex.
    pub axis: Vec3,
    /// Height.
    pub height: f32,
    /// Radius at the base, not negative.
    pub radius: f32,
    /// Growth of the radius with the height.
    pub growth: f32,
    /// Whether its normal points inwards.
    pub hollow: bool,
    /// `SIDES_` bits.
    pub sides: u32,
    /// Index of the material in the scene.
    pub material: u32,
}

impl MeshCone {
    /// The quadword of its records for sorting that has the point at three quarters of its height.
    pub(super) const POINT: u32 = 4;

    /// The radius at the apex. It may not be below 0 because the growth is rounded.
    fn apex_radius(&self) -> f64 {
        let [radius, growth, height] = [self.radius, self.growth, self.height].map(f64::from);
        (radius + growth * height).max(0.0)
    }

    /// The box around it: that of its two rims. It is rounded outwards.
    pub(crate) fn corners(&self) -> [Vec3; 2] {
        let base = self.base.as_dvec3();
        let axis = self.axis.as_dvec3();
        let apex = base + axis * f64::from(self.height);
        // How far a disc of radius 1 across the axis reaches.
        let DVec3 { x, y, z } = axis / axis.length();
        let across = DVec3::new(libm::hypot(y, z), libm::hypot(z, x), libm::hypot(x, y));
        let rims = [across * f64::from(self.radius), across * self.apex_radius()];
        let low = (base - rims[0]).min(apex - rims[1]);
        let high = (base + rims[0]).max(apex + rims[1]);
        let low = low.to_array().map(|number| down(number).get());
        let high = high.to_array().map(|number| up(number).get());
        [low.into(), high.into()]
    }

    pub(super) fn bounds(&self) -> Bounds {
        let [low, high] = self.corners();
        Bounds { low, high }
    }

    /// Its records for sorting, where `material` is the number of the material in blocks.
    pub(super) fn quadwords(&self, material: u32) -> [MeshVertex; 5] {
        let [a, b, c, d]: [MeshVertex; 4] = zerocopy::transmute!(self.record(material));
        let position = self.base + 0.75 * self.height * self.axis;
        let position = position.to_array().map(F32::new);
        [a, b, c, d, MeshVertex { position, ..MeshVertex::new_zeroed() }]
    }

    /// Its record in a block, where `material` is the number of the material in blocks.
    pub(super) fn record(&self, material: u32) -> layout::Cone {
        let [radius, growth, height] = [self.radius, self.growth, self.height].map(f64::from);
        let Slant { gain, slope } = Slant::of(growth, self.hollow);
        let object = layout::Object {
            centre: self.base.to_array().map(F32::new),
            gain: single(gain),
            axis: self.axis.to_array().map(F32::new),
            slope: single(slope),
            offset: single(gain * radius),
            leave: single(height + radius.max(self.apex_radius())),
            material: material.into(),
            sides: self.sides.into(),
        };
        layout::Cone {
            object: zerocopy::transmute!(object),
            radius: self.radius.into(),
            growth: self.growth.into(),
            height: self.height.into(),
            ..layout::Cone::new_zeroed()
        }
    }
}

/// Of a cone's normal, the shares of the vector from its base and of its axis.
pub(crate) struct Slant {
    pub gain: f64,
    pub slope: f64,
}

impl Slant {
    /// That of a cone whose radius grows so much with the height.
    pub fn of(growth: f64, hollow: bool) -> Self {
        let gain = libm::hypot(growth, 1.0).recip() * if hollow { -1.0 } else { 1.0 };
        Self { gain, slope: -gain * growth }
    }
}
