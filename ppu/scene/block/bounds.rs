//! Boxes along the axes.

use glam::DVec3;

use super::bounding_sphere::BoundingSphere;

/// A box along the axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Bounds {
    pub low: DVec3,
    pub high: DVec3,
}

impl Bounds {
    /// The box around nothing.
    pub const NOTHING: Self = Self { low: DVec3::INFINITY, high: DVec3::NEG_INFINITY };

    /// The box around a sphere.
    pub fn of_sphere(sphere: &BoundingSphere) -> Self {
        Self { low: sphere.centre - sphere.radius, high: sphere.centre + sphere.radius }
    }

    /// The box around this one and another.
    pub fn with(self, other: Self) -> Self {
        Self { low: self.low.min(other.low), high: self.high.max(other.high) }
    }

    pub fn size(&self) -> DVec3 {
        self.high - self.low
    }

    /// Half of the surface's area.
    pub fn half_area(&self) -> f64 {
        let size = self.size();
        size.dot(DVec3::new(size.y, size.z, size.x))
    }
}
