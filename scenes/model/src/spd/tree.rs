//! "tree": a tree after Aono and Kunii on a field. Each branch, a cone with a sphere at its end,
//! carries two smaller ones.

use glam::{DAffine3, DVec3};

use super::Generator;
use super::builder::{Builder, opaque, rotation, view};

pub(super) const GENERATOR: Generator = Generator {
    name: "tree",
    default: 11,
    most: u32::MAX,
    objects: |size| 2u128.saturating_pow(size.saturating_add(2)).saturating_sub(1),
    build,
};

const LIGHTS: [DVec3; 7] = [
    DVec3::new(-5.0, 5.0, 50.0),
    DVec3::new(30.0, -30.0, 30.0),
    DVec3::new(-40.0, -30.0, 20.0),
    DVec3::new(10.0, 30.0, 40.0),
    DVec3::new(-30.0, 40.0, 10.0),
    DVec3::new(50.0, 25.0, 20.0),
    DVec3::new(-10.0, -60.0, 30.0),
];

/// The two branches at the end of one: the angle to it, the angle around it, both in degrees, and
/// the length relative to it.
const BRANCHES: [(f64, f64, f64); 2] = [(40.0, 90.0, 0.65), (25.0, 230.0, 0.70)];
/// The radius of a branch's end, and so of the branches there, relative to the beginning's.
const TAPER: f64 = 0.67;
/// The radius of the trunk, whose length is 1.
const TRUNK: f64 = 0.15;

fn build(size: u32) -> Builder {
    let from = DVec3::new(4.5, 0.4, 2.0);
    let mut builder = Builder::new(view(from, DVec3::new(0.0, 0.0, 1.5)), &LIGHTS);
    builder.material(opaque(DVec3::new(0.2, 0.7, 0.2), 1.0, 0.0, 0.0));
    builder.ground(50.0);
    builder.material(opaque(DVec3::new(0.55, 0.4, 0.2), 1.0, 0.0, 0.0));
    let branches = BRANCHES.map(|(bend, around, length)| {
        let bend = rotation(DVec3::X, bend.to_radians());
        let turn = rotation(DVec3::Z, around.to_radians());
        DAffine3::from_scale_rotation_translation(DVec3::splat(length), turn * bend, DVec3::Z)
    });
    grow(&mut builder, &branches, &DAffine3::IDENTITY, TRUNK, size);
    builder
}

/// Adds the branch from the origin to (0, 0, 1) of these coordinates and, down to `levels` below
/// it, those that it carries.
fn grow(
    builder: &mut Builder,
    branches: &[DAffine3; 2],
    place: &DAffine3,
    radius: f64,
    levels: u32,
) {
    let end = place.transform_point3(DVec3::Z);
    builder.cone((place.translation, radius), (end, TAPER * radius));
    builder.sphere(end, TAPER * radius);
    if levels > 0 {
        for branch in branches {
            let place = *place * *branch;
            grow(builder, branches, &place, TAPER * radius, levels - 1);
        }
    }
}
