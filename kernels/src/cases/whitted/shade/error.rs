//! Errors of the surface kernels against f64, over random inputs of their domains.

use oracle::twin::surfaces::{Material, Object};
use rand::Rng as _;
use rand_chacha::ChaCha8Rng;
use spu_emulator::float::single::{from_f64, to_f64};

use super::call::{self, Hit};
use super::shapes::Shape;
use crate::bench::Bench;
use crate::single::bits;

/// Packets that an error is measured over.
const PACKETS: u32 = 1000;

/// A material of anything that a scene may ask for.
pub fn any_material(random: &mut ChaCha8Rng) -> Material {
    let mut share = || from_f64(random.random_range(0.0..1.0));
    let colour = [(); 3].map(|()| share());
    let [diffuse, highlight, mirror, transmittance, schlick, grazing] = [(); 6].map(|()| share());
    let emission = [(); 3].map(|()| share());
    let index = random.random_range(0.5..2.0);
    Material {
        colour,
        diffuse,
        highlight,
        exponent: from_f64(random.random_range(0.0..1000.0)),
        mirror,
        transmittance,
        inverse_index: from_f64(1.0 / index),
        index: from_f64(index),
        schlick,
        grazing,
        emission,
        flags: 1 << random.random_range(0..5),
    }
}

/// Sixteen shapes and their objects behind the background's, and a packet of rays that hit them.
pub fn any_hits(random: &mut ChaCha8Rng) -> ([Shape; 16], Vec<(Object, usize)>, [Hit; 16]) {
    let shapes: [Shape; 16] = std::array::from_fn(|_| Shape::any(random));
    let background = Shape::plane([0.0; 3], [0.0, 0.0, 1.0]);
    let objects = std::iter::once(&background).chain(&shapes);
    let objects = objects.map(|shape| (shape.object(), 0)).collect();
    let hits = std::array::from_fn(|lane| Hit {
        ray: shapes[lane].any_ray(random),
        object: lane + 1,
    });
    (shapes, objects, hits)
}

/// Largest distance of a point from its surface, against what it says a ray has to leave it by.
pub fn surfaces(bench: &mut Bench, random: &mut ChaCha8Rng) -> f64 {
    let mut worst = 0.0_f64;
    for _ in 0..PACKETS {
        let (shapes, objects, hits) = any_hits(random);
        let materials = [any_material(random)];
        let (found, ..) = call::surfaces(bench, "surfaces_r16", &[hits], &objects, &materials);
        let found = &found[0];
        for (lane, shape) in shapes.iter().enumerate() {
            let point = [found.point_x, found.point_y, found.point_z];
            let (height, _) = shape.at(point.map(|row| to_f64(bits(row[lane]))));
            worst = worst.max(height.abs() / to_f64(bits(found.leave[lane])));
        }
    }
    worst
}
