//! Cones and cylinders as objects of a scene.
//!
//! Whether the verdict for a ray is certain, and how precisely its t is known, is determined with
//! slightly larger and smaller cones. This detects outlines, ends, apexes and grazing rays.

pub use twins::cone::ConeObject;
use twins::cone::isect_cone;
use twins::pairs::Sides;
use twins::sphere_ray::Ray;

use super::shape::{Shape, Truth, any_sides, head_words};
use crate::cases::sphere_ray::ray;
use crate::prelude::*;

/// How much larger and smaller they are, relative to the radius and to the distance.
const LARGER: [f64; 2] = [1e-4, 2e-6];
/// The most that t may change with the surface's position: one over the cosine of the ray's
/// incidence.
const STEEPEST: f64 = 10.0;

/// A cone in f64.
#[derive(Clone, Copy, Debug)]
pub struct Exact {
    /// The centre of the base.
    pub base: Vector,
    /// The unit axis.
    pub axis: Vector,
    /// The radius at the base.
    pub radius: f64,
    /// The growth of the radius with the height.
    pub growth: f64,
    /// The lower and the upper end.
    pub heights: [f64; 2],
    /// The sides from which it is visible.
    pub sides: Sides,
}

impl Exact {
    /// The first hit of a ray.
    fn hit(&self, origin: Vector, direction: Vector) -> Option<f64> {
        let from_base = sub(origin, self.base);
        let split = |vector: Vector| {
            let along = dot(vector, self.axis);
            let across: Vector = std::array::from_fn(|axis| vector[axis] - along * self.axis[axis]);
            (along, across)
        };
        let ((h, c), (rise, e)) = (split(from_base), split(direction));
        let (k, m) = (self.radius + self.growth * h, self.growth * rise);
        let (a, b) = (dot(e, e) - m * m, dot(c, e) - k * m);
        let out = dot(c, c) - k * k;
        let v: Vector = std::array::from_fn(|axis| k * e[axis] - m * c[axis]);
        let turn = cross(c, e);
        let disc = dot(v, v) - dot(turn, turn);
        if disc <= 0.0 {
            return None;
        }
        let q = b + disc.sqrt().copysign(b);
        let Sides { both, exit } = self.sides;
        let crossings = [(-q / a, b >= 0.0), (-out / q, b < 0.0)];
        let seen = crossings.into_iter().filter(|&(t, enters)| {
            let height = h + t * rise;
            let within = (self.heights[0]..=self.heights[1]).contains(&height);
            t > 0.0 && within && (both || enters != exit)
        });
        seen.map(|(t, _)| t).reduce(f64::min)
    }
}

impl Shape for ConeObject {
    const KERNEL: &'static str = "isect_cone_pairs_r16";
    type Record = layout::Cone;

    fn record(&self, anything: u32) -> layout::Cone {
        layout::Cone {
            object: head_words(self.base, self.axis, anything, self.sides, anything),
            radius: single(self.radius),
            growth: single(self.growth),
            height: single(self.height),
            reserved: F32::from_bytes(anything.to_be_bytes()),
        }
    }

    fn twin(&self, ray: Ray, object: u32) -> Ray {
        isect_cone(ray, self, object)
    }

    fn truth(&self, ray: &Ray) -> Truth {
        let [origin, direction] = [ray.origin.map(to_f64), unit(ray.direction.map(to_f64))];
        let base = self.base.map(to_f64);
        let (radius, height) = (to_f64(self.radius), to_f64(self.height));
        let exact = Exact {
            base,
            axis: unit(self.axis.map(to_f64)),
            radius,
            growth: to_f64(self.growth),
            heights: [0.0, height],
            sides: self.sides,
        };
        let from_base = sub(origin, base);
        let distance = dot(from_base, from_base).sqrt();
        let widest = radius.max(radius + exact.growth * height);
        let by = LARGER[0] * widest + LARGER[1] * (distance + height);
        let slant = libm::hypot(exact.growth, 1.0);
        let t = exact.hit(origin, direction);
        let (mut counts, mut sure) = (true, true);
        for [wider, longer] in [[1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0]] {
            let other = Exact {
                radius: radius + wider * by * slant,
                heights: [-longer * by, height + longer * by],
                ..exact
            };
            match (t, other.hit(origin, direction)) {
                (Some(t), Some(other)) => counts &= (t - other).abs() <= STEEPEST * by,
                (None, None) => {}
                _ => (counts, sure) = (false, false),
            }
        }
        let size = distance + height + widest;
        Truth {
            t,
            unit: libm::exp2(libm::log2(size).floor() - 23.0),
            counts,
            // Here t belongs to another crossing of a slightly larger cone.
            sure: sure && counts,
        }
    }

    fn ahead(x: f64, distance: f64) -> Self {
        cone(&Exact {
            base: [x, -2.0, -distance],
            axis: [0.0, 1.0, 0.0],
            radius: 1.0,
            growth: -0.125,
            heights: [0.0, 4.0],
            sides: Sides { both: true, exit: false },
        })
    }

    fn around(random: &mut ChaCha8Rng, scale: f64) -> (Self, [Ray; 16]) {
        let height = scale * random.random_range(0.1..10.0);
        let widest = height
            * match random.random_range(0..4) {
                0 => magnitude(1e-3..0.1, random),
                1 => magnitude(1.0..30.0, random),
                _ => random.random_range(0.1..1.0),
            };
        let narrowest = widest
            * match random.random_range(0..3) {
                0 => 0.0,
                1 => 1.0,
                _ => random.random_range(0.0..1.0),
            };
        let [radius, top] = if random.random() { [widest, narrowest] } else { [narrowest, widest] };
        let exact = Exact {
            base: std::array::from_fn(|_| scale * random.random_range(-3.0..3.0)),
            axis: any_direction(random),
            radius,
            growth: (top - radius) / height,
            heights: [0.0, height],
            sides: any_sides(random),
        };
        let size = height.max(widest);
        let rays = std::array::from_fn(|lane| {
            let within = |reach: f64, random: &mut ChaCha8Rng| -> Vector {
                let h = height * random.random_range(0.0..1.0);
                let k = radius + exact.growth * h;
                let out = any_direction(random);
                let out = unit(cross(out, exact.axis));
                let out = out.map(|component| component * k * random.random_range(0.0..reach));
                std::array::from_fn(|axis| exact.base[axis] + h * exact.axis[axis] + out[axis])
            };
            let target = within(1.2, random);
            let origin = match lane % 4 {
                0 => within(1.0, random),
                _ => {
                    let away = size * magnitude(0.1..30.0, random);
                    let from = match lane {
                        // One ray along the axis and one along a side.
                        1 => exact.axis,
                        2 => {
                            let out = unit(cross(any_direction(random), exact.axis));
                            let slant = |axis: usize| exact.axis[axis] + exact.growth * out[axis];
                            unit(std::array::from_fn(slant))
                        }
                        _ => any_direction(random),
                    };
                    std::array::from_fn(|axis| target[axis] + away * from[axis])
                }
            };
            ray(origin, unit(sub(target, origin)), FARTHEST)
        });
        (cone(&exact), rays)
    }

    fn junk(random: &mut ChaCha8Rng) -> Self {
        Self {
            base: random.random(),
            axis: random.random(),
            radius: random.random(),
            growth: random.random(),
            height: random.random(),
            sides: any_sides(random),
        }
    }
}

/// The cone as an object, with heights from 0.
#[must_use]
pub fn cone(exact: &Exact) -> ConeObject {
    ConeObject {
        base: exact.base.map(from_f64),
        axis: exact.axis.map(from_f64),
        radius: from_f64(exact.radius),
        growth: from_f64(exact.growth),
        height: from_f64(exact.heights[1]),
        sides: exact.sides,
    }
}
