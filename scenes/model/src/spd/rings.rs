//! "rings": a pyramid of interlocked rings before a wall. Six pentagonal rings, of cylinders with
//! spheres at the joints, connect the middles of a dodecahedron's edges.

use std::f64::consts::PI;

use glam::DVec3;

use super::Generator;
use super::builder::{Builder, opaque, rotation, view};

pub(super) const GENERATOR: Generator = Generator {
    name: "rings",
    default: 7,
    most: u32::MAX,
    objects: |size| {
        let size = u128::from(size);
        10 * size * (size + 1) * (2 * size + 1) + 1
    },
    build,
};

/// The radius of cylinders and spheres.
const RADIUS: f64 = 0.07412;

const COLOURS: [DVec3; 6] = [
    DVec3::new(1.0, 0.0, 0.0),
    DVec3::new(0.0, 1.0, 0.0),
    DVec3::new(0.0, 0.0, 1.0),
    DVec3::new(0.0, 1.0, 1.0),
    DVec3::new(1.0, 0.0, 1.0),
    DVec3::new(1.0, 1.0, 0.0),
];

fn build(size: u32) -> Builder {
    // The distance between the layers of the pyramid.
    let spread = 1.0 / libm::sin(PI / 8.0);
    let from = DVec3::new(-1.0, -spread, 0.5);
    let lights = [(3.0, 3.0), (-4.0, 1.0), (2.0, -4.0)].map(|(x, z)| DVec3::new(x, -spread, z));
    let mut builder = Builder::new(view(from, from + DVec3::Y), &lights);

    builder.material(opaque(DVec3::ONE, 1.0, 0.0, 0.0));
    let depth = spread * (f64::from(size) + 1.0);
    // Just more than is in view.
    let half_side = 1.01 * (depth - from.y) * libm::tan(PI / 8.0);
    let corners = [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)];
    let middle = DVec3::new(from.x, depth, from.z);
    let corner = |(x, z)| middle + half_side * DVec3::new(x, 0.0, z);
    builder.polygon(corners.map(corner).to_vec());

    let rings = rings();
    for layer in 0..size {
        let place = |index: u32| 2.0 * f64::from(index) - f64::from(layer);
        for row in 0..=layer {
            for column in 0..=layer {
                let depth = spread * (f64::from(layer) + 1.0);
                let middle = DVec3::new(place(column), depth, place(row));
                for (ring, colour) in rings.iter().zip(COLOURS) {
                    builder.material(opaque(colour, 0.5, 0.2, 37.0));
                    for (joint, &vertex) in ring.iter().enumerate() {
                        let before = ring[(joint + 4) % 5];
                        let base = middle + vertex;
                        builder.cone((base, RADIUS), (middle + before, RADIUS));
                        builder.sphere(base, RADIUS);
                    }
                }
            }
        }
    }
    builder
}

/// The joints of six rings, around the origin within a sphere of radius 1.
fn rings() -> [[DVec3; 5]; 6] {
    let flat: [DVec3; 5] = std::array::from_fn(|joint| {
        let (across, along) = libm::sincos(joint as f64 * 2.0 * PI / 5.0);
        DVec3::new(along, across, 0.0) / (1.0 + RADIUS)
    });
    // The angle between two faces.
    let tilt = 2.0 * libm::acos(libm::cos(PI / 3.0) / libm::sin(PI / 5.0));
    let tilt = rotation(DVec3::X, tilt);
    std::array::from_fn(|ring| match ring {
        0 => flat,
        _ => {
            let turn = rotation(DVec3::Z, PI * (2.0 * ring as f64 - 1.0) / 5.0);
            flat.map(|joint| turn * (tilt * joint))
        }
    })
}
