//! Errors of the kernels for primary rays against f64, each over random inputs from its domain.

use twins::isect_pairs::Hit;
use twins::ray_setup::Basis;
use twins::shade_depth::Depth;

use super::packets::{Pack, RaySetup, ShadeDepth};
use crate::cases::sphere_ray::unit;
use crate::eye_records::Hits;
use crate::prelude::*;

/// The distance between singles from 1/2 to 1.
const ULP_OF_1: f64 = 1.0 / (1 << 23) as f64;
type Vector = [f64; 3];

/// The largest error of a direction's component, in ulps of 1.
pub fn ray_setup(bench: &mut Bench, random: &mut ChaCha8Rng) -> f64 {
    let mut worst = 0.0_f64;
    for _ in 0..1000 {
        let basis = camera(random);
        let pixels = [[0; 2]; 2].map(|place| place.map(|_: u32| random.random_range(0..2048) * 4));
        worst = worst.max(error_of_rays(bench, &basis, &pixels));
    }
    worst
}

/// A camera with the picture plane at distance 1 and a random field of view, narrow to wide.
#[must_use]
pub fn camera(random: &mut ChaCha8Rng) -> Basis {
    let field = random.random_range(0.01..2.0);
    let step = field / 1280.0;
    let [left, top] = [(); 2].map(|()| random.random_range(-0.5..0.5) * field);
    let (sin, cos) = libm::sincos(random.random_range(0.0..std::f64::consts::TAU));
    let turned = |[x, y, z]: Vector| [x * cos - z * sin, y, x * sin + z * cos].map(from_f64);
    Basis {
        corner: turned([left, top, -1.0]),
        right: turned([step, 0.0, 0.0]),
        down: turned([0.0, -step, 0.0]),
    }
}

/// The largest error of a component of the directions through 4x4 pixels, starting at each of
/// `pixels`.
pub fn error_of_rays(bench: &mut Bench, basis: &Basis, pixels: &[[u32; 2]]) -> f64 {
    let setup = RaySetup { basis: *basis, pixels: pixels.to_vec(), background: 0 };
    let packets = setup.call(bench);
    let errors = pixels.iter().zip(packets);
    errors
        .map(|(&pixel, (directions, _))| error_of_directions(basis, pixel, &directions))
        .fold(0.0, f64::max)
}

/// The largest error of a component of these directions through 4x4 pixels, starting at (x, y).
#[must_use]
pub fn error_of_directions(basis: &Basis, [x, y]: [u32; 2], directions: &Vectors) -> f64 {
    let points = std::array::from_fn(|lane| {
        let (column, row) = (lane as u32 % 4, lane as u32 / 4);
        [x + column, y + row].map(f64::from)
    });
    error_of_directions_through(basis, &points, directions)
}

/// The same of directions through any points of the picture; of pixel (0, 0) the centre is (0, 0).
#[must_use]
pub fn error_of_directions_through(
    basis: &Basis,
    points: &[[f64; 2]; 16],
    directions: &Vectors,
) -> f64 {
    let [corner, right, down] =
        [basis.corner, basis.right, basis.down].map(|vector| vector.map(to_f64));
    let mut worst = 0.0_f64;
    for ([x, y], found) in points.iter().zip(directions) {
        let exact: Vector =
            std::array::from_fn(|axis| corner[axis] + x * right[axis] + y * down[axis]);
        for (found, exact) in found.iter().zip(unit(exact)) {
            worst = worst.max((to_f64(*found) - exact).abs() / ULP_OF_1);
        }
    }
    worst
}

/// The hits of rays that have hit nothing.
pub const NO_HITS: Hits = [Hit { t: FARTHEST, object: 0 }; 16];

/// Depth shading, colours of which the first is the background's, and hits of numbered objects at
/// distances from before the start of the fading to after its end.
#[must_use]
pub fn shaded_hits(random: &mut ChaCha8Rng) -> (Depth, Vec<[Single; 3]>, Hits) {
    let near: f64 = random.random_range(0.0..50.0);
    let range: f64 = random.random_range(1.0..50.0);
    let far = near + range;
    let depth = Depth { far: from_f64(far), scale: from_f64(1.0 / range) };
    let colours: Vec<[Single; 3]> =
        (0..20).map(|_| std::array::from_fn(|_| from_f64(random.random_range(0.0..1.0)))).collect();
    let hits = std::array::from_fn(|_| {
        let object = random.random_range(0..colours.len() as u32);
        let t = from_f64(random.random_range(near * 0.9..far * 1.1));
        Hit { t: if object == 0 { FARTHEST } else { t }, object }
    });
    (depth, colours, hits)
}

/// The largest error of a colour's channel, in ulps of 1.
pub fn shade_depth(bench: &mut Bench, random: &mut ChaCha8Rng) -> f64 {
    let mut worst = 0.0_f64;
    for _ in 0..2000 {
        let (depth, colours, hits) = shaded_hits(random);
        let shade = ShadeDepth { hits: vec![hits], colours, depth };
        let (found, _) = shade.call(bench);
        for (hit, found) in hits.iter().zip(found[0]) {
            let bright = match hit.object {
                0 => 1.0,
                _ => ((to_f64(depth.far) - to_f64(hit.t)) * to_f64(depth.scale)).clamp(0.0, 1.0),
            };
            for (found, channel) in found.iter().zip(shade.colours[hit.object as usize]) {
                worst = worst.max((to_f64(*found) - to_f64(channel) * bright).abs() / ULP_OF_1);
            }
        }
    }
    worst
}

/// The largest error of a pixel's channel, of 255.
pub fn pack(bench: &mut Bench, random: &mut ChaCha8Rng) -> f64 {
    let mut worst = 0.0_f64;
    for shifts in [[16, 8, 0], [8, 16, 24]] {
        for _ in 0..1000 {
            let colours: Vectors = std::array::from_fn(|_| {
                std::array::from_fn(|_| from_f64(random.random_range(-0.25..1.25)))
            });
            let words = Pack { colours: vec![colours], shifts }.call(bench);
            for (colour, word) in colours.iter().zip(words[0]) {
                for (channel, shift) in colour.iter().zip(shifts) {
                    let exact = to_f64(*channel).clamp(0.0, 1.0) * 255.0;
                    worst = worst.max((f64::from(word >> shift & 255) - exact).abs());
                }
            }
        }
    }
    worst
}
