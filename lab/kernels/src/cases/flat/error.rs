//! Errors of the kernels for flat shapes against f64, over random inputs from their domains.
//!
//! The table contains the first number of a header's `Error`. The tests also check the others.

use rand_chacha::ChaCha8Rng;
use spu_emulator::float::single::to_f64;
use twins::triangle::Triangle;
use zerocopy::IntoBytes as _;

use super::{
    aimed_at_triangle, around_rectangle, on_plane, on_triangle, put_rectangle, put_triangles,
};
use crate::bench::Bench;
use crate::flat_records::{self, NO_HIT, Ray, Rays, Shears};
use crate::vector::ulps;

/// The number of packets over which an error is measured.
const PACKETS: u32 = 1000;

/// The largest error of a slope in ulps of 1, or of 1 / direction z in its own ulps.
pub fn shear(bench: &mut Bench, random: &mut ChaCha8Rng) -> f64 {
    let mut worst = 0.0_f64;
    for _ in 0..PACKETS {
        let rays: [Ray; 16] = std::array::from_fn(|_| aimed_at_triangle(random).0);
        bench.reset();
        let packet = bench.place(Rays::pack(&rays).as_bytes());
        let shears = bench.junk::<Shears>();
        bench.call("shear_r16", &[packet.address, shears.address]);
        let shears: Shears = bench.read(shears);
        for (lane, ray) in rays.iter().enumerate() {
            worst = worst.max(error_of_shear(ray, &shears, lane));
        }
    }
    worst
}

/// The same error of one ray.
#[must_use]
pub fn error_of_shear(ray: &Ray, shears: &Shears, lane: usize) -> f64 {
    let shear = flat_records::shear(shears, lane);
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
        bench.reset();
        let packet = bench.place(Rays::pack(&aimed.map(|(ray, _)| ray)).as_bytes());
        let shears = bench.junk::<Shears>();
        bench.call("shear_r16", &[packet.address, shears.address]);
        let triangles = put_triangles(bench, aimed.map(|(_, triangle)| triangle), || 0);
        let arguments = [packet.address, shears.address, triangles.address, 16, 1];
        bench.call("isect_triangles_r16", &arguments);
        let hits = bench.read::<Rays>(packet).hits();
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

/// The largest error of t in ulps of t for rays that hit the rectangle.
pub fn isect_rectangle(bench: &mut Bench, random: &mut ChaCha8Rng) -> f64 {
    nearest_error(bench, random, "isect_rectangle_r16")
}

/// The largest error of t in ulps of t. Infinite for a missed hit.
pub fn isect_plane(bench: &mut Bench, random: &mut ChaCha8Rng) -> f64 {
    nearest_error(bench, random, "isect_plane_r16")
}

fn nearest_error(bench: &mut Bench, random: &mut ChaCha8Rng, kernel: &str) -> f64 {
    /// The smallest distance of a point from an edge, in u and v, on either side.
    const EDGE: f64 = 5e-4;
    let mut worst = 0.0_f64;
    for _ in 0..PACKETS {
        let (rectangle, rays, distance) = around_rectangle(random);
        bench.reset();
        let packet = bench.place(Rays::pack(&rays).as_bytes());
        let shape = put_rectangle(bench, &rectangle, || 0);
        bench.call(kernel, &[packet.address, shape.address, 1]);
        for (ray, hit) in rays.iter().zip(bench.read::<Rays>(packet).hits()) {
            let ([t, u, v], incidence) = on_plane(ray, &rectangle);
            if incidence < 0.1 || t < distance / 2.0 {
                continue;
            }
            let inside = [u, v].map(|on| (EDGE..=1.0 - EDGE).contains(&on)) == [true; 2];
            if hit.t != NO_HIT.t {
                worst = worst.max(ulps(to_f64(hit.t), t));
            } else if inside || kernel == "isect_plane_r16" {
                worst = f64::INFINITY;
            }
        }
    }
    worst
}
