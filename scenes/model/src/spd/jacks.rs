//! "jacks": a jack, three crossing cylinders with spheres at their ends, and smaller ones in its
//! eight corners, which have smaller ones in theirs.

use glam::{DAffine3, DVec3};

use super::Generator;
use super::builder::{Builder, opaque, rotation, view};
use crate::View;

pub(super) const GENERATOR: Generator = Generator {
    name: "jacks",
    default: 1,
    most: u32::MAX,
    objects: |size| {
        let corners = 8u128.saturating_pow(size);
        // Of each jack, nine; the sum of 8^n for n below the size.
        ((corners - 1) / 7).saturating_mul(9)
    },
    build,
};

/// The reach of a jack in its cube from -1 to 1.
const REACH: f64 = 0.75;
/// Radii, relative to the reach.
const CYLINDER: f64 = 0.1;
const SPHERE: f64 = 0.2;

fn build(size: u32) -> Builder {
    let view = View {
        up: DVec3::Y,
        angle: 25.0,
        hither: 0.001,
        resolution: (256, 256),
        ..view(DVec3::new(0.0, 0.0, -8.0), DVec3::ZERO)
    };
    let background = DVec3::new(0.2, 0.05, 0.2);
    let mut builder = Builder::new(view, &[DVec3::new(-10.0, 3.0, -20.0)]).background(background);
    builder.material(opaque(DVec3::new(0.737, 0.561, 0.561), 0.7, 0.7, 20.0));
    let turn =
        rotation(DVec3::X, (-30f64).to_radians()) * rotation(DVec3::Y, (-20f64).to_radians());
    grow(&mut builder, &DAffine3::from_quat(turn), 1.0, size);
    builder
}

/// Adds a jack of this scale, and those in its corners if `levels` has more than this one.
fn grow(builder: &mut Builder, place: &DAffine3, scale: f64, levels: u32) {
    let end = |direction| place.transform_point3(REACH * direction);
    let reach = REACH * scale;
    for way in DVec3::AXES {
        builder.cone((end(-way), CYLINDER * reach), (end(way), CYLINDER * reach));
    }
    for way in DVec3::AXES.into_iter().chain(DVec3::AXES.map(|way| -way)) {
        builder.sphere(end(way), SPHERE * reach);
    }
    if levels > 1 {
        for corner in 0..8 {
            let side = |bit: u32| if corner >> bit & 1 == 1 { 0.5 } else { -0.5 };
            let middle = DVec3::new(side(2), side(1), side(0));
            let half = DAffine3::from_scale(DVec3::splat(0.5));
            let place = *place * DAffine3::from_translation(middle) * half;
            grow(builder, &place, scale / 2.0, levels - 1);
        }
    }
}
