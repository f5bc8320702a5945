//! Where rays meet the shapes of a scene, in `f64`, from anywhere.
//!
//! What starts within [`rounding`] of a surface starts on it: a plane is then not met at all, and
//! of a quadric only the crossing that is not the start. So a ray leaves a surface without an
//! offset, at any scale, and without being told which object it leaves; a hit's point is put onto
//! its surface first, to be that near.
//!
//! Invariant: a distance found is finite, above 0 and below the limit; a normal has length 1.

mod cone;
mod polygon;
mod sphere;
#[cfg(test)]
pub(crate) mod tests;

use glam::DVec3;
use nff::Shape;

use crate::bvh::Bounds;
use crate::ray::Ray;
use cone::Cone;
pub(crate) use polygon::MAX_PATCH_VERTICES;
use polygon::Polygon;
use sphere::Sphere;

/// A surface that rays can meet.
#[derive(Debug, Clone)]
pub(crate) enum Surface {
    Sphere(Sphere),
    Cone(Cone),
    Polygon(Polygon),
}

/// From which sides a surface is seen. Its front is the side that its normal is on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Sides {
    pub front: bool,
    pub back: bool,
}

impl Sides {
    const BOTH: Self = Self {
        front: true,
        back: true,
    };
    const FRONT: Self = Self {
        front: true,
        back: false,
    };

    /// Whether a ray that goes against the normal (`true`) or with it sees the surface.
    fn seen(self, against: bool) -> bool {
        if against { self.front } else { self.back }
    }
}

/// A place on a surface.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Place {
    /// On the surface but for [`rounding`].
    pub point: DVec3,
    /// The surface's normal, on its front.
    pub normal: DVec3,
    /// The normal that a patch interpolates; else `normal`.
    pub smooth: DVec3,
}

impl Surface {
    /// The surface of a shape; `transmits` makes it seen from both sides. Nothing where the shape
    /// is none: a polygon without area, a cone without height or radius.
    pub(crate) fn new(shape: &Shape, transmits: bool) -> Option<Self> {
        let sides = if transmits { Sides::BOTH } else { Sides::FRONT };
        match shape {
            &Shape::Sphere { centre, radius } => {
                (radius != 0.0).then(|| Self::Sphere(Sphere::new(centre, radius, sides)))
            }
            &Shape::Cone {
                base,
                base_radius,
                apex,
                apex_radius,
            } => {
                // A sheet, not a body: where its outside is seen, so is its inside.
                let sides = if base_radius.max(apex_radius) > 0.0 {
                    Sides::BOTH
                } else {
                    sides
                };
                Cone::new((base, base_radius), (apex, apex_radius), sides).map(Self::Cone)
            }
            Shape::Polygon { vertices } => Polygon::new(vertices, None, sides).map(Self::Polygon),
            Shape::Patch { vertices, normals } => {
                Polygon::new(vertices, Some(normals), sides).map(Self::Polygon)
            }
        }
    }

    /// Distance to the nearest crossing, short of `limit`, that is seen from its side.
    pub(crate) fn hit(&self, ray: &Ray, limit: f64) -> Option<f64> {
        match self {
            Self::Sphere(sphere) => sphere.hit(ray, limit),
            Self::Cone(cone) => cone.hit(ray, limit),
            Self::Polygon(polygon) => polygon.hit(ray, limit),
        }
    }

    /// The place of the hit at a distance that [`Self::hit`] gave.
    pub(crate) fn place(&self, ray: &Ray, distance: f64) -> Place {
        let point = ray.at(distance);
        match self {
            Self::Sphere(sphere) => sphere.place(point),
            Self::Cone(cone) => cone.place(point, ray.direction),
            Self::Polygon(polygon) => polygon.place(point),
        }
    }

    /// A box around the surface.
    pub(crate) fn bounds(&self) -> Bounds {
        match self {
            Self::Sphere(sphere) => sphere.bounds(),
            Self::Cone(cone) => cone.bounds(),
            Self::Polygon(polygon) => polygon.bounds(),
        }
    }
}

/// How far off its surface a point that was put onto it may lie: some tens of roundings of its
/// coordinates and of those from the surface's own origin, where a few happen.
fn rounding(point: DVec3, from_own_origin: DVec3) -> f64 {
    let largest = |vector: DVec3| vector.abs().max_element();
    64.0 * f64::EPSILON * (largest(point) + largest(from_own_origin))
}

/// The nearest of two crossings, each with whether it goes against the normal, that is seen, ahead
/// by more than `least` and short of `limit`.
fn nearest_seen(crossings: [(f64, bool); 2], sides: Sides, least: f64, limit: f64) -> Option<f64> {
    let seen = |&(t, against): &(f64, bool)| t > least && t < limit && sides.seen(against);
    let distances = crossings.iter().filter(|it| seen(it)).map(|&(t, _)| t);
    distances.reduce(f64::min)
}
