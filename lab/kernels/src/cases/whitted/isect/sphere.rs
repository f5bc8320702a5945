//! Spheres as objects of a scene, with the kernels of all formulations.

use std::marker::PhantomData;

use twins::pairs::Sides;
pub use twins::sphere_pairs::SphereObject;
use twins::sphere_pairs::isect_sphere_pair;
use twins::sphere_ray::Ray;

use super::shape::{Shape, Truth, any_sides, head};
use crate::cases::formulation::ForAnyRay;
use crate::cases::sphere_ray::{ray, ulp};
use crate::prelude::*;
use protocol::layout::Object;

/// The smallest distance between a ray and the sphere's outline, as disc / r^2, for which the
/// verdict counts.
const TANGENT: f64 = 1e-4;

/// A sphere that a formulation intersects.
#[derive(Clone, Copy, Debug)]
pub struct By<F> {
    /// The sphere.
    pub sphere: SphereObject,
    formulation: PhantomData<F>,
}

impl<F> From<SphereObject> for By<F> {
    fn from(sphere: SphereObject) -> Self {
        Self { sphere, formulation: PhantomData }
    }
}

impl<F: ForAnyRay> Shape for By<F> {
    const KERNEL: &'static str = F::GENERAL;
    type Record = Object;

    fn record(&self, anything: u32) -> Object {
        record(&self.sphere, anything)
    }

    fn twin(&self, ray: Ray, object: u32) -> Ray {
        isect_sphere_pair::<F>(ray, &self.sphere, object)
    }

    fn truth(&self, ray: &Ray) -> Truth {
        let SphereObject { centre, offset, sides: Sides { both, exit } } = self.sphere;
        let direction = ray.direction.map(to_f64);
        let length = dot(direction, direction).sqrt();
        let direction = unit(direction);
        let centre: Vector =
            std::array::from_fn(|axis| to_f64(centre[axis]) - to_f64(ray.origin[axis]));
        let radius = to_f64(offset).abs();
        let b = dot(centre, direction);
        let l: Vector = std::array::from_fn(|axis| centre[axis] - b * direction[axis]);
        let disc = radius * radius - dot(l, l);
        let root = disc.max(0.0).sqrt();
        let distance = dot(centre, centre).sqrt();
        let leaves = if both { distance < radius } else { exit };
        let t = if leaves { b + root } else { b - root };
        let t = (disc >= 0.0 && t > 0.0).then_some(t);
        let clear = (distance / radius - 1.0).abs() > F::DOMAIN.surface;
        // With directions of any length, t is a multiple of the length.
        let part = if F::DOMAIN.lengths.is_empty() { 1.0 } else { length };
        let t = t.map(|t| t / part);
        Truth {
            t,
            unit: ulp(t.unwrap_or(0.0), radius / part),
            counts: disc > F::DOMAIN.outline * radius * radius && clear,
            sure: disc.abs() > TANGENT * radius * radius && clear,
        }
    }

    fn ahead(x: f64, distance: f64) -> Self {
        sphere([x, 0.0, -distance], 1.0, FRONT).into()
    }

    fn around(random: &mut ChaCha8Rng, scale: f64) -> (Self, [Ray; 16]) {
        let radius = scale * random.random_range(0.1..10.0);
        let around: Vector = std::array::from_fn(|_| scale * random.random_range(-3.0..3.0));
        let sphere = sphere(around, radius, any_sides(random));
        let rays = std::array::from_fn(|lane| {
            let distance = radius
                * match lane % 4 {
                    0 => random.random_range(0.0..0.999),
                    1 => random.random_range(1.001..1.5),
                    _ => random.random_range(1.5..F::DOMAIN.farthest),
                };
            let (from, to) = (any_direction(random), any_direction(random));
            let reach = radius * random.random_range(0.0..2.0);
            let origin: Vector = std::array::from_fn(|axis| around[axis] + distance * from[axis]);
            let towards =
                std::array::from_fn(|axis| around[axis] + reach * to[axis] - origin[axis]);
            let length = if F::DOMAIN.lengths.is_empty() {
                1.0
            } else {
                magnitude(F::DOMAIN.lengths, random)
            };
            ray(origin, unit(towards).map(|component| component * length), FARTHEST)
        });
        (sphere.into(), rays)
    }

    fn junk(random: &mut ChaCha8Rng) -> Self {
        SphereObject { centre: random.random(), offset: random.random(), sides: any_sides(random) }
            .into()
    }
}

/// Visible only from the front, which is where a ray enters a sphere.
pub const FRONT: Sides = Sides { both: false, exit: false };

/// A sphere.
#[must_use]
pub fn sphere(centre: Vector, radius: f64, sides: Sides) -> SphereObject {
    SphereObject { centre: centre.map(from_f64), offset: from_f64(radius), sides }
}

/// The record of a sphere. `anything` fills the fields that no intersector reads.
#[must_use]
pub fn record(sphere: &SphereObject, anything: u32) -> Object {
    let axis = [anything; 3];
    head(sphere.centre, axis, sphere.offset, sphere.sides, anything)
}
