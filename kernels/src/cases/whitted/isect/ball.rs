//! Spheres as objects of a scene.

use oracle::twin::FARTHEST;
use oracle::twin::ball::Ray;
pub use oracle::twin::ball_pairs::SphereObject;
use oracle::twin::ball_pairs::isect_ball;
use oracle::twin::pairs::Sides;
use rand::Rng as _;
use rand_chacha::ChaCha8Rng;
use spu_emulator::float::single::{from_f64, to_f64};

use super::shape::{Shape, Truth, any_sides, head};
use crate::cases::ball::{any_direction, ray, ulp};
use crate::layout::Object;
use crate::vector::{Vector, dot, unit};

/// How near to its outline a sphere may be passed, as disc / r^2, for a root that counts.
const OUTLINE: f64 = 0.01;
/// The same for a hit or a miss that counts.
const TANGENT: f64 = 1e-4;
/// How near to the surface, in radii, an origin may be for a side that counts.
const SURFACE: f64 = 1e-5;

impl Shape for SphereObject {
    const KERNEL: &'static str = "isect_ball_pairs_r16";
    type Record = Object;

    fn record(&self, anything: u32) -> Object {
        let axis = [anything; 3];
        head(self.centre, axis, self.offset, self.sides, anything)
    }

    fn twin(&self, ray: Ray, object: u32) -> Ray {
        isect_ball(ray, self, object)
    }

    fn truth(&self, ray: &Ray) -> Truth {
        let direction = unit(ray.direction.map(to_f64));
        let centre: Vector =
            std::array::from_fn(|axis| to_f64(self.centre[axis]) - to_f64(ray.origin[axis]));
        let radius = to_f64(self.offset).abs();
        let b = dot(centre, direction);
        let l: Vector = std::array::from_fn(|axis| centre[axis] - b * direction[axis]);
        let disc = radius * radius - dot(l, l);
        let root = disc.max(0.0).sqrt();
        let distance = dot(centre, centre).sqrt();
        let Sides { both, exit } = self.sides;
        let leaves = if both { distance < radius } else { exit };
        let t = if leaves { b + root } else { b - root };
        let t = (disc >= 0.0 && t > 0.0).then_some(t);
        let clear = (distance / radius - 1.0).abs() > SURFACE;
        Truth {
            t,
            unit: ulp(t.unwrap_or(0.0), radius),
            counts: disc > OUTLINE * radius * radius && clear,
            sure: disc.abs() > TANGENT * radius * radius && clear,
        }
    }

    fn ahead(x: f64, distance: f64) -> Self {
        sphere([x, 0.0, -distance], 1.0, FRONT)
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
                    _ => random.random_range(1.5..30.0),
                };
            let (from, to) = (any_direction(random), any_direction(random));
            let reach = radius * random.random_range(0.0..2.0);
            let origin: Vector = std::array::from_fn(|axis| around[axis] + distance * from[axis]);
            let towards =
                std::array::from_fn(|axis| around[axis] + reach * to[axis] - origin[axis]);
            ray(origin, unit(towards), FARTHEST)
        });
        (sphere, rays)
    }

    fn junk(random: &mut ChaCha8Rng) -> Self {
        Self {
            centre: random.random(),
            offset: random.random(),
            sides: any_sides(random),
        }
    }
}

/// Seen from the front alone: of a sphere where a ray enters it.
pub const FRONT: Sides = Sides {
    both: false,
    exit: false,
};

/// A sphere.
#[must_use]
pub fn sphere(centre: Vector, radius: f64, sides: Sides) -> SphereObject {
    SphereObject {
        centre: centre.map(from_f64),
        offset: from_f64(radius),
        sides,
    }
}
