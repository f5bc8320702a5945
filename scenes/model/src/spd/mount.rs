//! "mount": a fractal mountain and four spheres of glass in front.
//!
//! The mountain is a square whose edges and middle are moved up or down, and so the four squares in
//! it, down to single squares of two triangles. How far a point moves depends only on its place.

use std::f64::consts::{FRAC_1_SQRT_2, PI, SQRT_2};

use glam::DVec3;

use super::Generator;
use super::builder::{Builder, opaque, rotation, view};
use crate::{Material, View};

pub(super) const GENERATOR: Generator = Generator {
    name: "mount",
    default: 6,
    // SPD's hash shifts by 7 less the size.
    most: 7,
    objects: |size| 2 * 4u128.saturating_pow(size).min(u128::MAX / 4) + 4,
    build,
};

/// The fractal dimension, from 2 (smooth) to 3.
const DIMENSION: f64 = 2.2;
/// The number of this mountain.
const MOUNTAIN: u32 = 21;
/// The corner and the side of the mountain's square.
const CORNER: f64 = -1.0;
const SIDE: f64 = 2.0;

fn build(size: u32) -> Builder {
    let view = View { hither: 0.01, ..view(DVec3::new(-1.6, 1.6, 1.7), DVec3::ZERO) };
    let mut builder = Builder::new(view, &[DVec3::new(-100.0, -100.0, 100.0)]);
    builder.material(Material {
        transmittance: 0.9,
        refraction_index: 1.5,
        ..opaque(DVec3::ONE, 0.1, 0.1, 6.7)
    });
    spheres(&mut builder, DVec3::new(-0.8, 0.8, 1.0), 0.17);

    builder.material(opaque(DVec3::new(0.5, 0.45, 0.35), 1.0, 0.0, 0.0));
    let ratio = 2.0 / libm::exp(libm::log(2.0) / (DIMENSION - 1.0));
    let width = 1 << size;
    let mut mountain = Mountain {
        builder,
        size,
        spacing: SIDE / f64::from(width),
        roughness: (ratio * ratio - 1.0).sqrt(),
    };
    let square = Square { x: 0, y: 0, width, heights: [0.0; 4] };
    mountain.grow(&square);
    mountain.builder
}

/// Four touching spheres around a point: one above and three below.
fn spheres(builder: &mut Builder, middle: DVec3, radius: f64) {
    let top = DVec3::new(0.0, 0.0, radius * 1.5f64.sqrt());
    builder.sphere(middle + top, radius);
    let axis = DVec3::new(FRAC_1_SQRT_2, FRAC_1_SQRT_2, 0.0);
    // The angle between the vertices of a tetrahedron, as seen from its middle.
    let low = rotation(axis, libm::acos(-1.0 / 3.0)) * top;
    for third in 0..3 {
        let turn = rotation(DVec3::Z, f64::from(third) * 2.0 * PI / 3.0);
        builder.sphere(middle + turn * low, radius);
    }
}

struct Mountain {
    builder: Builder,
    size: u32,
    /// The side of a single square.
    spacing: f64,
    roughness: f64,
}

/// A square of the mountain: its corner and its width in single squares, and the heights of its
/// corners, counter-clockwise.
struct Square {
    x: u32,
    y: u32,
    width: u32,
    heights: [f64; 4],
}

impl Mountain {
    fn grow(&mut self, square: &Square) {
        let &Square { x, y, width, heights: [a, b, c, d] } = square;
        if width == 1 {
            let corner = |x, y, height| {
                let across = CORNER + f64::from(x) * self.spacing;
                let along = CORNER + f64::from(y) * self.spacing;
                DVec3::new(across, along, height)
            };
            let [a, b] = [corner(x, y, a), corner(x + 1, y, b)];
            let [c, d] = [corner(x + 1, y + 1, c), corner(x, y + 1, d)];
            self.builder.polygon(vec![a, b, c]);
            self.builder.polygon(vec![c, d, a]);
            return;
        }
        let half = width / 2;
        let rise = f64::from(half) * self.spacing * self.roughness;
        let moved = |x, y| rise * gaussian(MOUNTAIN + hash(x, y, self.size));
        let lower = (a + b) / 2.0 + moved(x + half, y);
        let right = (b + c) / 2.0 + moved(x + width, y + half);
        let upper = (c + d) / 2.0 + moved(x + half, y + width);
        let left = (d + a) / 2.0 + moved(x, y + half);
        let middle = (a + b + c + d) / 4.0 + SQRT_2 * moved(x + half, y + half);
        for (x, y, heights) in [
            (x, y, [a, lower, middle, left]),
            (x + half, y, [lower, b, right, middle]),
            (x + half, y + half, [middle, right, c, upper]),
            (x, y + half, [left, middle, upper, d]),
        ] {
            self.grow(&Square { x, y, width: half, heights });
        }
    }
}

/// SPD's own hash of a point. It repeats, and the mountain with it; the published counts are those
/// of this mountain.
fn hash(x: u32, y: u32, size: u32) -> u32 {
    let sum = (x << (23 - size)).wrapping_add(y << (15 - size)).wrapping_add(x << (7 - size));
    sum & 0xffff
}

/// A number of the normal distribution by Marsaglia's polar method, from a linear congruential
/// generator with this seed.
fn gaussian(seed: u32) -> f64 {
    const MODULUS: u32 = 134_456;
    let next = |number: u32| (28_411 + number * 8121) % MODULUS;
    let uniform = |number: u32| 2.0 * f64::from(number) / f64::from(MODULUS) - 1.0;
    let mut number = seed;
    loop {
        let first = next(number);
        number = next(first);
        let (x, y) = (uniform(first), uniform(number));
        let square = x * x + y * y;
        if square < 1.0 {
            return x * (-2.0 * libm::log(square) / square).sqrt();
        }
    }
}
