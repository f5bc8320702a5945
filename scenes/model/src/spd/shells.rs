//! "shells": a sea shell after Pickover, of spheres along a spiral that grow as it widens.

use std::f64::consts::PI;

use glam::DVec3;

use super::Generator;
use super::builder::{Builder, opaque, view};
use crate::{Material, View};

pub(super) const GENERATOR: Generator = Generator {
    name: "shells",
    default: 5,
    most: u32::MAX,
    objects: |size| steps(size).saturating_add(1),
    build,
};

/// The turns of the spiral, two thirds of them within radius 1.
const TURNS: f64 = 9.0;
/// How fast the spiral widens with its angle.
const GROWTH: f64 = 0.15;
/// The height for a radius.
const SLOPE: f64 = -2.0;

/// The number of steps between spheres.
fn steps(size: u32) -> u128 {
    2u128.saturating_pow(size).saturating_mul(180)
}

fn build(size: u32) -> Builder {
    let view =
        View { hither: 0.5, ..view(DVec3::new(-6.0, -60.0, 35.0), DVec3::new(0.0, 8.0, -15.0)) };
    let mut builder = Builder::new(view, &[DVec3::new(-100.0, -100.0, 100.0)]);
    builder.material(Material {
        refraction_index: 1.0,
        ..opaque(DVec3::new(1.0, 0.8, 0.4), 0.8, 0.2, 10.0)
    });
    // The steps are a multiple of three.
    let third = (steps(size) / 3) as i64;
    for step in -2 * third..=third {
        let angle = 2.0 * PI * TURNS * step as f64 / (3 * third) as f64;
        let radius = libm::exp(GROWTH * angle);
        let (across, along) = libm::sincos(angle);
        builder.sphere(radius * DVec3::new(across, along, SLOPE), radius);
    }
    builder
}
