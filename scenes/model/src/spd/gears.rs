//! "gears": a cube of meshing cogwheels, one in five of which is of glass, on a mirror.

use std::f64::consts::PI;

use glam::DVec3;

use super::Generator;
use super::builder::{Builder, opaque, view};
use crate::Material;

pub(super) const GENERATOR: Generator = Generator {
    name: "gears",
    default: 4,
    most: u32::MAX,
    objects: |size| {
        let wheels = u128::from(size).pow(3);
        wheels * (2 + 4 * TEETH as u128) + 1
    },
    build,
};

const LIGHTS: [DVec3; 5] = [
    DVec3::new(2.0, 4.0, 4.0),
    DVec3::new(-2.0, 4.0, 3.0),
    DVec3::new(2.0, -2.5, 2.5),
    DVec3::new(-1.0, -4.0, 2.0),
    DVec3::new(-1.111, -2.121, 2.626),
];

const TEETH: usize = 36;
/// The height of a tooth, relative to the radius.
const TOOTH: f64 = 0.1;
/// The radius of the teeth is a little less than the full radius, so that wheels don't touch.
const CLEARANCE: f64 = 0.995;
/// The corners of a tooth: their angles, relative to the angle between teeth, and whether they are
/// at the top of the tooth.
const CORNERS: [(f64, bool); 4] = [(-0.19, true), (0.19, true), (0.3, false), (0.7, false)];

fn build(size: u32) -> Builder {
    let from = DVec3::new(-1.1, -2.1, 2.6);
    let mut builder = Builder::new(view(from, DVec3::ZERO), &LIGHTS);
    builder.material(opaque(DVec3::new(1.0, 0.85, 0.7), 0.3, 0.6, 37.0));
    builder.ground(2.0);

    let count = f64::from(size);
    let radius = 1.0 / (count - (count - 1.0) * TOOTH / 2.0);
    let first = DVec3::new(radius - 1.0, radius - 1.0, 1.0);
    let step = DVec3::new(radius * (2.0 - TOOTH), radius * (2.0 - TOOTH), -1.0 / count);
    let thickness = TOOTH.min(0.5 / count);
    for z in 0..size {
        for y in 0..size {
            for x in 0..size {
                builder.material(material(x, y, z));
                let place = DVec3::new(f64::from(x), f64::from(y), f64::from(z));
                // Neighbours are turned by half a tooth.
                let turn = if (x + y + z) % 2 == 1 { 0.5 } else { 0.0 };
                wheel(&mut builder, first + place * step, turn, radius, thickness);
            }
        }
    }
    builder
}

/// The material of a wheel, with a colour that looks random and has its largest channel at 1.
fn material(x: u32, y: u32, z: u32) -> Material {
    let channel = |a: u32, b: u32, c: u32, factor: u32| {
        0.01 + (f64::from(3 * a + 2 * b + c + 1) * f64::from(factor) / 7.0).fract()
    };
    let colour = DVec3::new(channel(x, y, z, 5), channel(y, z, x, 3), channel(z, x, y, 2));
    let colour = colour / colour.max_element();
    if (4 * x + 2 * y + z).is_multiple_of(5) {
        Material { transmittance: 0.8, refraction_index: 1.1, ..opaque(colour, 0.2, 0.0, 0.0) }
    } else {
        opaque(colour, 1.0, 0.0, 0.0)
    }
}

/// Adds a wheel, whose top is around `centre`: top, sides and bottom. `turn` is in teeth.
fn wheel(builder: &mut Builder, centre: DVec3, turn: f64, radius: f64, thickness: f64) {
    let angle_each = 2.0 * PI / TEETH as f64;
    let rim = |direction: f64| -> Vec<DVec3> {
        let corners = (0..TEETH).flat_map(|tooth| CORNERS.map(|corner| (tooth as f64, corner)));
        corners
            .map(|(tooth, (offset, is_top))| {
                let reach = if is_top { CLEARANCE } else { 1.0 - TOOTH };
                let angle = (turn + direction * (tooth + offset)) * angle_each;
                let (across, along) = libm::sincos(angle);
                centre + reach * radius * DVec3::new(along, across, 0.0)
            })
            .collect()
    };
    let down = DVec3::new(0.0, 0.0, -thickness);
    let top = rim(1.0);
    builder.polygon(top.clone());
    for (at, &corner) in top.iter().enumerate() {
        let next = top[(at + 1) % top.len()];
        builder.polygon(vec![corner, corner + down, next + down, next]);
    }
    builder.polygon(rim(-1.0).into_iter().map(|corner| corner + down).collect());
}
