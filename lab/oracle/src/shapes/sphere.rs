//! Spheres.
//!
//! The ray's smallest distance from the centre decides about a hit, not b² - a c, which loses the
//! radius of a small sphere far away. The root that would cancel is the roots' product divided by
//! the other.

use glam::DVec3;

use super::{Place, Sides, nearest_seen, rounding};
use crate::bvh::Bounds;
use crate::ray::Ray;

#[derive(Debug, Clone, Copy)]
pub(crate) struct Sphere {
    centre: DVec3,
    radius: f64,
    /// Whether the normal points towards the centre.
    hollow: bool,
    sides: Sides,
}

impl Sphere {
    /// A sphere. With a negative radius the normal points inwards.
    pub(super) fn new(centre: DVec3, radius: f64, sides: Sides) -> Self {
        Self { centre, radius: radius.abs(), hollow: radius < 0.0, sides }
    }

    pub(super) fn hit(&self, ray: &Ray, limit: f64) -> Option<f64> {
        let to_centre = self.centre - ray.origin;
        let along = to_centre.dot(ray.direction);
        let distance = to_centre.length();
        let min = rounding(ray.origin, to_centre);
        let (enter, leave) = if (distance - self.radius).abs() <= min {
            (f64::NEG_INFINITY, 2.0 * along)
        } else {
            let offset = (to_centre - along * ray.direction).length();
            let squared = (self.radius - offset) * (self.radius + offset);
            if squared.is_nan() || squared < 0.0 {
                return None;
            }
            let far = along + squared.sqrt().copysign(along);
            let near = (distance - self.radius) * (distance + self.radius) / far;
            (near.min(far), near.max(far))
        };
        let crossings = [(enter, !self.hollow), (leave, self.hollow)];
        nearest_seen(crossings, self.sides, min, limit)
    }

    pub(super) fn place(&self, point: DVec3) -> Place {
        let outward = (point - self.centre).normalize();
        let normal = if self.hollow { -outward } else { outward };
        Place { point: self.centre + self.radius * outward, normal, smooth: normal }
    }

    pub(super) fn bounds(&self) -> Bounds {
        Bounds { low: self.centre - self.radius, high: self.centre + self.radius }
    }
}
