//! Kernels that intersect rays with spheres, called by name: those of all formulations of a form
//! take the same, and each is given one sphere.

use twins::sphere::Perpendicular;
use twins::sphere_ray::{BareSphere, Ray};
use twins::{FARTHEST, Single};

use super::eye;
use super::whitted::isect::call::{self, packet};
use super::whitted::isect::sphere::{By, SphereObject};
use crate::bench::{Bench, Version};
use crate::catalogue;
use crate::eye_records::{self, Vectors};
use crate::measure::cost;
use crate::single::single;
use protocol::layout::{RayPacket, Sphere};

/// What a sphere's record holds for the primary rays.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EyeSphere {
    /// The centre as the eye sees it and the radius squared, for kernels that take
    /// `EyeRecord::Centre`.
    Centre {
        /// Centre less eye.
        centre: [Single; 3],
        /// Radius squared.
        radius_squared: Single,
    },
    /// The same by direction and distance, for kernels that take `EyeRecord::Axis`.
    Axis {
        /// The centre's direction, at length 1.
        axis: [Single; 3],
        /// The square of radius over distance.
        k: Single,
        /// The centre's distance.
        distance: Single,
    },
}

impl EyeSphere {
    /// The record in local store.
    #[must_use]
    pub fn record(&self) -> Sphere {
        match *self {
            Self::Centre {
                centre,
                radius_squared,
            } => eye_records::sphere(&BareSphere {
                centre,
                radius_squared,
            }),
            Self::Axis { axis, k, distance } => Sphere {
                distance: single(distance),
                ..eye_records::sphere(&BareSphere {
                    centre: axis,
                    radius_squared: k,
                })
            },
        }
    }
}

/// A hit's distance for each of sixteen rays, if the kernel says that there is one.
pub type Distances = [Option<Single>; 16];

/// Calls a kernel for rays from anywhere (`isect_sphere_pairs…_r16`) on packets of rays and a
/// sphere. No ray has a farthest distance; what `t` and `object` hold does not count.
///
/// # Panics
///
/// If there is no such kernel, or more packets than local store has room for (64 there is).
#[must_use]
pub fn general(
    bench: &mut Bench,
    kernel: &str,
    packets: &[[Ray; 16]],
    sphere: &SphereObject,
) -> Vec<Distances> {
    bench.reset();
    let unhit = |ray: Ray| Ray {
        t: FARTHEST,
        object: 0,
        ..ray
    };
    let packets: Vec<RayPacket> = packets
        .iter()
        .map(|rays| packet(&rays.map(unhit), 0))
        .collect();
    let list: Vec<[usize; 2]> = (0..packets.len()).map(|number| [0, number]).collect();
    // The record is that of all formulations.
    let placed = call::place(
        bench,
        &packets,
        &[By::<Perpendicular>::from(*sphere)],
        &list,
        0,
    );
    bench.call(kernel, &[placed.candidates, list.len() as u32]);
    let after: Vec<RayPacket> = bench.read_all(placed.packets);
    after
        .iter()
        .map(|packet| call::rays(packet).map(|ray| (ray.object != 0).then_some(ray.t)))
        .collect()
}

/// Calls a kernel for the primary rays (`isect_pairs…_r16`) on packets of directions and a sphere.
///
/// # Panics
///
/// If there is no such kernel, or more packets than local store has room for (64 there is).
#[must_use]
pub fn eye(
    bench: &mut Bench,
    kernel: &str,
    packets: &[Vectors],
    sphere: &EyeSphere,
) -> Vec<Distances> {
    let packets: Vec<_> = packets
        .iter()
        .map(|directions| eye_records::packet(directions, &eye::error::NO_HITS))
        .collect();
    let pairs: Vec<[usize; 2]> = (0..packets.len()).map(|number| [0, number]).collect();
    let (after, _) = eye::call::isect_pairs(bench, kernel, &packets, &[sphere.record()], &pairs);
    after
        .iter()
        .map(|packet| eye_records::hits(packet).map(|hit| (hit.object != 0).then_some(hit.t)))
        .collect()
}

/// Simulated cycles in which a kernel's scheduled version tests one ray with one further object of
/// a list, as its last case in the catalogue measures it; none if the catalogue has no such
/// kernel, or it takes no list.
#[must_use]
pub fn cycles_a_ray(bench: &mut Bench, kernel: &str) -> Option<f64> {
    let kernel = catalogue::kernels().find(|row| row.name == kernel)?;
    let case = kernel.cases.last()?;
    let stream = cost(bench, kernel.name, case, Version::Scheduled).stream?;
    Some(stream.time.cycles as f64 / f64::from(stream.objects * kernel.rays))
}
