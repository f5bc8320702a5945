//! Spheres, cones and planes in f64, the `OBJECT`s for them, and rays that hit them.

use std::f64::consts::TAU;

use crate::prelude::*;
use twins::surfaces::{Object, Ray};

/// How much the numbers of an object, and the coordinates of a point, add to the origin offset of
/// a ray, relative to their magnitude.
pub const LEAVE: f64 = 1.0 / (1 << 22) as f64;
/// The error of a hit's distance, in roundings of the larger of the distance and the object's
/// size.
const ROUNDINGS: f64 = 16.0;

/// A surface: gain |a| + slope h = offset, where h is along the axis and a is across it, both from
/// the centre.
#[derive(Clone, Copy, Debug)]
pub struct Shape {
    /// The centre, the base, or a point of the plane.
    pub centre: Vector,
    /// The same as in `OBJECT`.
    pub gain: f64,
    /// A unit vector or 0.
    pub axis: Vector,
    /// The same as in `OBJECT`.
    pub slope: f64,
    /// The same as in `OBJECT`.
    pub offset: f64,
}

impl Shape {
    /// A sphere. With a radius below 0, it is visible from inside.
    #[must_use]
    pub fn sphere(centre: Vector, radius: f64) -> Self {
        Self {
            centre,
            gain: radius.signum(),
            axis: [0.0; 3],
            slope: 0.0,
            offset: radius.abs() * radius.signum(),
        }
    }

    /// A cone, or a cylinder if the growth is 0.
    #[must_use]
    pub fn cone(base: Vector, axis: Vector, radius: f64, growth: f64) -> Self {
        let gain = 1.0 / libm::hypot(growth, 1.0);
        Self { centre: base, gain, axis, slope: -gain * growth, offset: gain * radius }
    }

    /// A plane.
    #[must_use]
    pub fn plane(point: Vector, normal: Vector) -> Self {
        Self { centre: point, gain: 0.0, axis: normal, slope: 1.0, offset: 0.0 }
    }

    /// A random shape of any size, within 100 of the eye.
    pub fn any(random: &mut ChaCha8Rng) -> Self {
        // Values that a record can represent exactly.
        let centre = in_cube(100.0, random).map(|x| to_f64(from_f64(x)));
        let radius = to_f64(from_f64(magnitude(0.01..30.0, random)));
        match random.random_range(0..4) {
            0 => Self::sphere(centre, radius),
            1 => Self::sphere(centre, -radius),
            2 => {
                let growth = random.random_range(-1.0..1.0);
                Self::cone(centre, any_direction(random), radius, growth)
            }
            _ => Self::plane(centre, any_direction(random)),
        }
    }

    /// The shape's record.
    #[must_use]
    pub fn object(&self) -> Object {
        let magnitude: f64 = self.centre.iter().map(|x| x.abs()).sum();
        Object {
            centre: self.centre.map(from_f64),
            gain: from_f64(self.gain),
            axis: self.axis.map(from_f64),
            slope: from_f64(self.slope),
            offset: from_f64(self.offset),
            leave: from_f64(LEAVE * (magnitude + self.offset.abs())),
            sides: 0,
        }
    }

    /// The height above the surface, and the normal there.
    #[must_use]
    pub fn at(&self, point: Vector) -> (f64, Vector) {
        let from = sub(point, self.centre);
        let along = dot(from, self.axis);
        let off: Vector = std::array::from_fn(|k| from[k] - along * self.axis[k]);
        let distance = dot(off, off).sqrt();
        let height = self.gain * distance + self.slope * along - self.offset;
        let scale = if self.gain == 0.0 { 0.0 } else { self.gain / distance };
        let normal = std::array::from_fn(|k| scale * off[k] + self.slope * self.axis[k]);
        (height, normal)
    }

    /// A random point of the surface.
    pub fn any_point(&self, random: &mut ChaCha8Rng) -> Vector {
        let size = if self.gain == 0.0 { 50.0 } else { self.offset / self.gain };
        let (height, radius) = if self.axis == [0.0; 3] {
            return self.beside_centre(any_direction(random), size);
        } else if self.gain == 0.0 {
            (0.0, magnitude(0.01..size, random))
        } else {
            // Where the radius shrinks, at least a tenth of it remains.
            let growth = -self.slope / self.gain;
            let height = size * random.random_range(0.0..0.9);
            (height, size + growth * height)
        };
        let across = unit(cross(self.axis, any_direction(random)));
        let other = cross(self.axis, across);
        let (sin, cos) = libm::sincos(random.random_range(0.0..TAU));
        let off = std::array::from_fn(|k| {
            height * self.axis[k] + radius * (cos * across[k] + sin * other[k])
        });
        self.beside_centre(off, 1.0)
    }

    /// A ray that hits the surface, with the distance that a kernel finds.
    pub fn any_ray(&self, random: &mut ChaCha8Rng) -> Ray {
        let point = self.any_point(random);
        let distance = magnitude(0.01..100.0, random);
        let back = any_direction(random);
        let origin: Vector = std::array::from_fn(|k| point[k] + distance * back[k]);
        let origin = origin.map(|x| to_f64(from_f64(x)));
        let way = sub(point, origin);
        let size = distance.max(self.offset.abs());
        let off = random.random_range(-ROUNDINGS..ROUNDINGS) * 2_f64.powi(-23) * size;
        Ray {
            origin: origin.map(from_f64),
            direction: unit(way).map(from_f64),
            t: from_f64((dot(way, way).sqrt() + off).max(0.0)),
        }
    }

    fn beside_centre(&self, direction: Vector, distance: f64) -> Vector {
        std::array::from_fn(|k| self.centre[k] + distance * direction[k])
    }
}
