//! Cylinders and cones, cut at right angles to the axis, without caps.
//!
//! Let w be the vector from the base's centre to the ray's origin. It and the direction d are
//! split into parts along the axis (a) and across it (c). The radius at the height of the ray's
//! point t is ρ + m t. The crossings are the roots of |w_c + t d_c|² = (ρ + m t)². A quarter of
//! the discriminant is |ρ d_c - m w_c|² - |w_c x d_c|², which cancels only at the silhouette. The
//! root -root/a enters the body, whatever the sign of a, so only the heights must be checked to
//! exclude the rest of the double cone.

use glam::DVec3;
use scenes::unit;

use super::{Place, Sides, nearest_seen, rounding};
use crate::bvh::Bounds;
use crate::ray::Ray;

#[derive(Debug, Clone, Copy)]
pub(crate) struct Cone {
    base: DVec3,
    apex: DVec3,
    /// The unit vector from base to apex.
    axis: DVec3,
    height: f64,
    /// The radii at base and apex.
    radii: [f64; 2],
    /// The growth of the radius with the height.
    slope: f64,
    /// Whether the normal points towards the axis.
    hollow: bool,
    sides: Sides,
}

impl Cone {
    /// A cone between two discs, each given by centre and radius. With negative radii the normal
    /// points inwards.
    pub(super) fn new(base: (DVec3, f64), apex: (DVec3, f64), sides: Sides) -> Option<Self> {
        let axis = unit(apex.0 - base.0)?;
        let height = (apex.0 - base.0).dot(axis);
        let radii = [base.1.abs(), apex.1.abs()];
        let slope = (radii[1] - radii[0]) / height;
        let sound = slope.is_finite() && radii != [0.0; 2];
        sound.then_some(Self {
            base: base.0,
            apex: apex.0,
            axis,
            height,
            radii,
            slope,
            hollow: base.1.min(apex.1) < 0.0,
            sides,
        })
    }

    /// The height above the base of a point, given relative to the base, and its part across the
    /// axis.
    fn split(&self, from_base: DVec3) -> (f64, DVec3) {
        let height = from_base.dot(self.axis);
        (height, from_base - height * self.axis)
    }

    /// The signed distance from the surface, positive outside, of a point at this height and
    /// distance from the axis.
    fn above(&self, height: f64, from_axis: f64) -> f64 {
        let radius = self.radii[0] + self.slope * height;
        (from_axis - radius) / libm::hypot(self.slope, 1.0)
    }

    pub(super) fn hit(&self, ray: &Ray, limit: f64) -> Option<f64> {
        let from_base = ray.origin - self.base;
        let (height, across) = self.split(from_base);
        let (rise, sweep) = self.split(ray.direction);
        let (radius, growth) = (self.radii[0] + self.slope * height, self.slope * rise);
        let a = (sweep.length() - growth) * (sweep.length() + growth);
        let b = across.dot(sweep) - radius * growth;
        let min = rounding(ray.origin, from_base);
        let (enter, leave) = if self.above(height, across.length()).abs() <= min {
            let other = -2.0 * b / a;
            if b > 0.0 { (other, f64::NEG_INFINITY) } else { (f64::NEG_INFINITY, other) }
        } else {
            let c = (across.length() - radius) * (across.length() + radius);
            let (spread, twist) =
                ((radius * sweep - growth * across).length(), across.cross(sweep).length());
            let squared = (spread - twist) * (spread + twist);
            if squared.is_nan() || squared < 0.0 {
                return None;
            }
            let sum = -(b + squared.sqrt().copysign(b));
            if b < 0.0 { (c / sum, sum / a) } else { (sum / a, c / sum) }
        };
        let within = |t: f64| {
            if (0.0..=self.height).contains(&(height + t * rise)) { t } else { f64::NEG_INFINITY }
        };
        let crossings = [(within(enter), !self.hollow), (within(leave), self.hollow)];
        nearest_seen(crossings, self.sides, min, limit)
    }

    pub(super) fn place(&self, point: DVec3, direction: DVec3) -> Place {
        let (height, across) = self.split(point - self.base);
        // At an apex every direction across the axis would do; take the one that the ray comes
        // from.
        let outward = unit(across)
            .or_else(|| unit(-self.split(direction).1))
            .unwrap_or_else(|| self.axis.any_orthonormal_vector());
        let outward = (outward - self.slope * self.axis).normalize();
        let normal = if self.hollow { -outward } else { outward };
        Place {
            point: point - self.above(height, across.length()) * outward,
            normal,
            smooth: normal,
        }
    }

    pub(super) fn bounds(&self) -> Bounds {
        // A disc's extent along a coordinate axis is the part of that axis across the disc's
        // normal.
        let reach = (DVec3::ONE - self.axis * self.axis).max(DVec3::ZERO).map(f64::sqrt);
        let disc = |centre: DVec3, radius: f64| Bounds {
            low: centre - radius * reach,
            high: centre + radius * reach,
        };
        disc(self.base, self.radii[0]).with(disc(self.apex, self.radii[1]))
    }
}
