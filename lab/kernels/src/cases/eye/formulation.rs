//! Spheres for primary rays with the kernels of all formulations: records, cases, the exact result
//! in f64, and errors.

use std::fmt::Debug;

use twins::sphere::{
    Axis, Constants, Estimate, Factored, InDouble, Interpolated, Newton2, Paper, Refined, Stable,
    Unnormalised,
};
use twins::sphere_ray::BareSphere;

use super::error::NO_HITS;
use super::pairs::Pairs;
use super::{PACKETS, rays};

use crate::cases::formulation::ForTheEye;
use crate::cases::sphere_ray::{bare_sphere, ulp};
use crate::cases::spheres::EyeSphere;
use crate::prelude::*;
use protocol::layout::Sphere;

/// The smallest distance between a ray and the sphere's outline, as disc / r^2, for which the
/// verdict counts. Closer to it, the rounding of the direction decides.
const TANGENT: f64 = 1e-3;

/// The data that a formulation uses of a sphere for primary rays.
pub trait Seen: Copy + Debug + FromBytes {
    /// A sphere with this centre.
    fn at(centre: Vector, radius: f64) -> Self;
    /// The centre and the squared radius of the exact sphere that the data describe.
    fn exact(&self) -> (Vector, f64);
    /// The words in the record.
    fn words(&self) -> EyeSphere;

    /// The record.
    fn record(&self) -> Sphere {
        self.words().record()
    }
}

impl Seen for BareSphere {
    fn at(centre: Vector, radius: f64) -> Self {
        bare_sphere(centre, radius)
    }

    fn exact(&self) -> (Vector, f64) {
        (self.centre.map(to_f64), to_f64(self.radius_squared))
    }

    fn words(&self) -> EyeSphere {
        EyeSphere::Centre { centre: self.centre, radius_squared: self.radius_squared }
    }
}

impl Seen for Axis {
    fn at(centre: Vector, radius: f64) -> Self {
        // A centre at the eye has no direction. With a tiny distance, the eye is inside the
        // sphere, as it should be.
        let distance = dot(centre, centre).sqrt().max(radius * 2_f64.powi(-60));
        Self {
            axis: centre.map(|component| from_f64(component / distance)),
            k: from_f64((radius / distance).powi(2)),
            distance: from_f64(distance),
        }
    }

    fn exact(&self) -> (Vector, f64) {
        let distance = to_f64(self.distance);
        let centre = unit(self.axis.map(to_f64)).map(|component| component * distance);
        (centre, to_f64(self.k) * distance * distance)
    }

    fn words(&self) -> EyeSphere {
        EyeSphere::Axis { axis: self.axis, k: self.k, distance: self.distance }
    }
}

/// The kernels of the formulations other than the standard one for primary rays.
pub fn kernels() -> Vec<Kernel> {
    vec![
        row::<Paper>(),
        row::<Estimate>(),
        row::<Interpolated>(),
        row::<Newton2>(),
        row::<Stable>(),
        row::<Factored>(),
        row::<Constants>(),
        row::<Refined>(),
        row::<Unnormalised>(),
        row::<InDouble>(),
    ]
}

/// The row of a formulation's kernel.
pub(super) fn row<F: ForTheEye<Sphere: Seen>>() -> Kernel {
    Kernel::of::<Pairs<F>>([
        case("all miss", PACKETS, |count| {
            with_packets::<F>([F::Sphere::at([9.0, 0.0, -5.0], 1.0); 4], count)
        }),
        case("all hit, each nearer", PACKETS, |count| {
            let nearer = [20.0, 15.0, 10.0, 5.0];
            let sphere = |distance: f64| F::Sphere::at([0.0, 0.0, -distance], 1.0);
            with_packets::<F>(nearer.map(sphere), count)
        }),
    ])
    .error(error::<F>)
}

/// Each of the spheres paired with sixteen packets.
fn with_packets<F: ForTheEye<Sphere: Seen>>(spheres: [F::Sphere; 4], count: u32) -> Pairs<F> {
    let pairs = (0..count as usize).map(|number| [number / 16, number % 16]).collect();
    let packets = vec![(rays(), NO_HITS); 64];
    Pairs::<F> { packets, spheres: spheres.into(), pairs }
}

/// A sphere within a formulation's domain, and rays inside its outline and around it.
#[must_use]
pub fn around_a_sphere<F: ForTheEye<Sphere: Seen>>(
    random: &mut ChaCha8Rng,
) -> (Vectors, F::Sphere) {
    let radius = random.random_range(0.1..10.0);
    let distance = radius * magnitude(F::DOMAIN.eye, random);
    let centre = any_direction(random).map(|component| component * distance);
    let sphere = F::Sphere::at(centre, radius);
    let rays = std::array::from_fn(|_| {
        let towards = centre.map(|component| component + radius * random.random_range(-0.9..0.9));
        let length =
            if F::DOMAIN.lengths.is_empty() { 1.0 } else { magnitude(F::DOMAIN.lengths, random) };
        unit(towards).map(|component| from_f64(component * length))
    });
    (rays, sphere)
}

/// The largest error of t in ulps of t. Infinite for a missed or a false hit.
fn error<F: ForTheEye<Sphere: Seen>>(bench: &mut Bench, random: &mut ChaCha8Rng) -> f64 {
    let mut worst = 0.0_f64;
    for _ in 0..4000 {
        let (rays, sphere) = around_a_sphere::<F>(random);
        let (centre, radius_squared) = sphere.exact();
        let packets = vec![(rays, NO_HITS)];
        let pairs = Pairs::<F> { packets, spheres: vec![sphere], pairs: vec![[0, 0]] };
        for (direction, hit) in rays.iter().zip(pairs.call(bench)[0].1) {
            let direction = direction.map(to_f64);
            let length = dot(direction, direction).sqrt();
            let direction = unit(direction);
            let b = dot(centre, direction);
            let l: Vector = std::array::from_fn(|axis| centre[axis] - b * direction[axis]);
            let disc = radius_squared - dot(l, l);
            let depth = disc / radius_squared;
            let found = (hit.object != 0).then(|| to_f64(hit.t));
            // With directions of any length, t is a multiple of the length.
            let part = if F::DOMAIN.lengths.is_empty() { 1.0 } else { length };
            let truth = (disc >= 0.0).then(|| (b - disc.sqrt()) / part);
            match (found, truth) {
                (Some(found), Some(t)) if depth > F::DOMAIN.outline => {
                    worst = worst.max((found - t).abs() / ulp(t, t));
                }
                (None, Some(_)) | (Some(_), None) if depth.abs() > TANGENT => {
                    worst = f64::INFINITY;
                }
                _ => {}
            }
        }
    }
    worst
}
