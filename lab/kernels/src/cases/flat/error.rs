//! Errors of the kernels for flat shapes against f64, over random inputs from their domains.
//!
//! The table contains the first number of a header's `Error`. The tests also check the others.

use twins::triangle::{Shear, Triangle};

use super::rectangles::{PLANE, WithRectangle};
use super::triangles::{Sheared, Triangles};
use super::{aimed_at_triangle, around_rectangle, on_plane, on_triangle};
use crate::flat_records::NO_HIT;
use crate::flat_records::Ray;
use crate::prelude::*;
use crate::vector::ulps;

/// The number of packets over which an error is measured.
const PACKETS: u32 = 1000;

/// The largest error of a slope in ulps of 1, or of 1 / direction z in its own ulps.
pub fn shear(bench: &mut Bench, random: &mut ChaCha8Rng) -> f64 {
    let mut worst = 0.0_f64;
    for _ in 0..PACKETS {
        let rays: [Ray; 16] = std::array::from_fn(|_| aimed_at_triangle(random).0);
        for (ray, shear) in rays.iter().zip(Sheared { rays }.call(bench)) {
            worst = worst.max(error_of_shear(ray, &shear));
        }
    }
    worst
}

/// The same error of one ray.
#[must_use]
pub fn error_of_shear(ray: &Ray, shear: &Shear) -> f64 {
    let [x, y, z] = shear.axes.map(|axis| to_f64(ray.direction[axis]));
    let slopes = shear.slopes.into_iter().zip([x / z, y / z]);
    let errors = slopes.map(|(slope, exact)| (to_f64(slope) - exact).abs() * 2_f64.powi(23));
    errors.fold(ulps(to_f64(shear.minus_per_z), -1.0 / z), f64::max)
}

/// The largest error of t in ulps of t. Infinite for a missed hit.
pub fn isect_triangles(bench: &mut Bench, random: &mut ChaCha8Rng) -> f64 {
    let mut worst = 0.0_f64;
    for _ in 0..PACKETS {
        let aimed: [(Ray, Triangle); 16] = std::array::from_fn(|_| aimed_at_triangle(random));
        let rays = aimed.map(|(ray, _)| ray);
        let triangles = aimed.map(|(_, triangle)| triangle).to_vec();
        let (_, hits) = Triangles::<false> { rays, triangles, first: 1 }.call(bench);
        for ((number, (ray, triangle)), hit) in (1..).zip(&aimed).zip(hits) {
            // Another triangle may be in front of it, whose domain is not known.
            if hit.object == number {
                let [t, ..] = on_triangle(ray, triangle);
                worst = worst.max(ulps(to_f64(hit.t), t));
            } else if hit.object == 0 {
                worst = f64::INFINITY;
            }
        }
    }
    worst
}

/// The largest error of t in ulps of t for rays that hit the rectangle or its plane. Infinite for a
/// missed hit.
pub fn with_rectangle<const TEST: usize>(bench: &mut Bench, random: &mut ChaCha8Rng) -> f64 {
    /// The smallest distance of a point from an edge, in u and v, on either side.
    const EDGE: f64 = 5e-4;
    let mut worst = 0.0_f64;
    for _ in 0..PACKETS {
        let (rectangle, rays, distance) = around_rectangle(random);
        let (_, hits) = WithRectangle::<TEST> { rays, rectangle, object: 1 }.call(bench);
        for (ray, hit) in rays.iter().zip(hits) {
            let ([t, u, v], incidence) = on_plane(ray, &rectangle);
            if incidence < 0.1 || t < distance / 2.0 {
                continue;
            }
            let inside = [u, v].map(|on| (EDGE..=1.0 - EDGE).contains(&on)) == [true; 2];
            if hit.t != NO_HIT.t {
                worst = worst.max(ulps(to_f64(hit.t), t));
            } else if inside || TEST == PLANE {
                worst = f64::INFINITY;
            }
        }
    }
    worst
}
