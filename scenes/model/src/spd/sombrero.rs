//! "sombrero": a height field of triangles, a damped wave around its middle.

use std::f64::consts::PI;

use glam::DVec3;

use super::Generator;
use super::builder::{Builder, opaque, view};
use crate::{Material, View};

pub(super) const GENERATOR: Generator = Generator {
    name: "sombrero",
    default: 1,
    most: u32::MAX,
    objects: |size| {
        let gaps = width(size).saturating_sub(1);
        gaps.saturating_mul(gaps).saturating_mul(2)
    },
    build,
};

/// Half the side of the field.
const HALF: f64 = 4.0;
/// The height of the undisturbed field.
const LEVEL: f64 = -3.0;

/// The number of heights on a side.
fn width(size: u32) -> u128 {
    2u128.saturating_pow(size.saturating_add(4))
}

fn build(size: u32) -> Builder {
    let view = View { angle: 40.0, hither: 0.01, ..view(DVec3::new(0.0, 5.0, -8.0), DVec3::ZERO) };
    let mut builder = Builder::new(view, &[DVec3::new(10.0, 10.0, -10.0)]);
    builder.material(Material {
        refraction_index: 1.0,
        ..opaque(DVec3::new(1.0, 0.1, 0.1), 0.8, 0.0, 40.0)
    });
    let width = width(size) as u32;
    // The wave is sampled with one gap more than the field has.
    let sample = |index: u32| 2.0 * HALF * f64::from(index) / f64::from(width) - HALF;
    let place = |index: u32| 2.0 * HALF * f64::from(index) / f64::from(width - 1) - HALF;
    let point = |x: u32, z: u32| {
        let (across, along) = (sample(x), sample(z));
        let radius = (across * across + along * along).sqrt();
        let height = libm::cos(2.0 * PI * radius) * libm::exp(-radius);
        // SPD holds heights in single precision.
        DVec3::new(place(x), LEVEL + f64::from(height as f32), place(z))
    };
    for z in 0..width - 1 {
        for x in 0..width - 1 {
            let [near, far] = [point(x, z), point(x + 1, z + 1)];
            builder.polygon(vec![near, far, point(x + 1, z)]);
            builder.polygon(vec![near, point(x, z + 1), far]);
        }
    }
    builder
}
