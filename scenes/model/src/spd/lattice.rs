//! "lattice": the unit cube filled with spheres that reflect, and dull cylinders between
//! neighbours.

use glam::DVec3;

use super::Generator;
use super::builder::{Builder, opaque, view};
use crate::View;

pub(super) const GENERATOR: Generator = Generator {
    name: "lattice",
    default: 12,
    most: u32::MAX,
    objects: |size| {
        let size = u128::from(size);
        (size + 1).pow(2) * (size + 1 + 3 * size)
    },
    build,
};

const LIGHTS: [DVec3; 6] = [
    DVec3::new(2.0, 0.5, 0.5),
    DVec3::new(-1.0, 0.5, 0.5),
    DVec3::new(0.5, 2.0, 0.5),
    DVec3::new(0.5, -1.0, 0.5),
    DVec3::new(0.5, 0.5, 2.0),
    DVec3::new(0.5, 0.5, -1.0),
];

/// Radii, relative to the distance of neighbours.
const SPHERE: f64 = 1.0 / 4.0;
const CYLINDER: f64 = 1.0 / 16.0;

/// The directions of cylinders and their colours.
const WAYS: [(DVec3, DVec3); 3] = [
    (DVec3::X, DVec3::new(0.9, 0.1, 0.1)),
    (DVec3::Y, DVec3::new(0.1, 0.9, 0.1)),
    (DVec3::Z, DVec3::new(0.1, 0.1, 0.9)),
];

fn build(size: u32) -> Builder {
    let spacing = 1.0 / f64::from(size);
    let x = (f64::from(size / 2) + 0.5) * spacing;
    let view = View {
        up: DVec3::new(0.2, 1.0, 0.0),
        angle: 60.0,
        hither: 0.0,
        ..view(DVec3::new(x, 1.0, 1.0 - spacing / 2.0), DVec3::new(x, -1.0, -1.0 - spacing / 2.0))
    };
    let mut builder = Builder::new(view, &LIGHTS);
    // Cylinders begin a little inside of the spheres.
    let inside = 0.99 * SPHERE * spacing * (1.0 - (CYLINDER / SPHERE).sqrt());
    let radius = CYLINDER * spacing;
    for x in 0..=size {
        for y in 0..=size {
            for z in 0..=size {
                let indices = [x, y, z];
                let centre = DVec3::from_array(indices.map(|at| f64::from(at) / f64::from(size)));
                builder.material(opaque(DVec3::splat(0.9), 0.5, 0.5, 37.0));
                builder.sphere(centre, SPHERE * spacing);
                for (at, (way, colour)) in indices.into_iter().zip(WAYS) {
                    if at < size {
                        builder.material(opaque(colour, 0.99, 0.0, 0.0));
                        let base = centre + inside * way;
                        let apex = centre + (spacing - inside) * way;
                        builder.cone((base, radius), (apex, radius));
                    }
                }
            }
        }
    }
    builder
}
