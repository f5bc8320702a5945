//! Calls kernels that intersect rays with spheres, by name. Those of all formulations of a form
//! take the same arguments, and each gets one sphere.

use twins::sphere::Perpendicular;
use twins::sphere_ray::{BareSphere, Ray};

use super::eye;
use super::whitted::isect::call::{self, packet};
use super::whitted::isect::sphere::{By, SphereObject};
use crate::bench::Version;
use crate::catalogue;
use crate::eye_records;
use crate::measure::cost;
use crate::prelude::*;
use protocol::layout::Sphere;

/// The content of a sphere's record for primary rays.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EyeSphere {
    /// The centre relative to the eye, and the squared radius, for kernels that take
    /// `EyeRecord::Centre`.
    Centre {
        /// The centre minus the eye.
        centre: [Single; 3],
        /// The squared radius.
        radius_squared: Single,
    },
    /// The same by direction and distance, for kernels that take `EyeRecord::Axis`.
    Axis {
        /// The unit direction to the centre.
        axis: [Single; 3],
        /// The square of radius over distance.
        k: Single,
        /// The distance of the centre.
        distance: Single,
    },
}

impl EyeSphere {
    /// The record in local store.
    #[must_use]
    pub fn record(&self) -> Sphere {
        match *self {
            Self::Centre { centre, radius_squared } => {
                eye_records::sphere(&BareSphere { centre, radius_squared })
            }
            Self::Axis { axis, k, distance } => Sphere {
                distance: single(distance),
                ..eye_records::sphere(&BareSphere { centre: axis, radius_squared: k })
            },
        }
    }
}

/// For each of sixteen rays, the distance of its hit if the kernel finds one.
pub type Distances = [Option<Single>; 16];

/// Calls a kernel for rays from anywhere (`isect_sphere_pairs…_r16`) on packets of rays and a
/// sphere. The rays have no distance limit; their `t` and `object` are ignored.
///
/// # Panics
///
/// Panics if there is no such kernel, or if the packets do not fit into local store, which has
/// capacity for 64.
#[must_use]
pub fn general(
    bench: &mut Bench,
    kernel: &str,
    packets: &[[Ray; 16]],
    sphere: &SphereObject,
) -> Vec<Distances> {
    bench.reset();
    let unhit = |ray: Ray| Ray { t: FARTHEST, object: 0, ..ray };
    let packets: Vec<RayPacket> = packets.iter().map(|rays| packet(&rays.map(unhit), 0)).collect();
    let list: Vec<[usize; 2]> = (0..packets.len()).map(|number| [0, number]).collect();
    // All formulations use the same record.
    let placed = call::place(bench, &packets, &[By::<Perpendicular>::from(*sphere)], &list, 0);
    bench.call(kernel, &[placed.candidates, list.len() as u32]);
    let after: Vec<RayPacket> = bench.read_all(placed.packets);
    after
        .iter()
        .map(|packet| call::rays(packet).map(|ray| (ray.object != 0).then_some(ray.t)))
        .collect()
}

/// Calls a kernel for primary rays (`isect_pairs…_r16`) on packets of directions and a sphere.
///
/// # Panics
///
/// Panics if there is no such kernel, or if the packets do not fit into local store, which has
/// capacity for 64.
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
    bench.reset();
    let (placed, arguments) = eye::pairs::place(bench, &packets, &[sphere.record()], &pairs);
    bench.call(kernel, &arguments);
    let packets = placed.packets.iter();
    packets
        .map(|packet| {
            eye_records::hits(&bench.read(*packet)).map(|hit| (hit.object != 0).then_some(hit.t))
        })
        .collect()
}

/// The simulated cycles in which a kernel's scheduled version tests one ray with one further
/// object of a list, measured on its last case in the catalogue. `None` if the catalogue does not
/// contain the kernel or the kernel takes no list.
#[must_use]
pub fn cycles_a_ray(bench: &mut Bench, kernel: &str) -> Option<f64> {
    let kernel = catalogue::kernels().find(|row| row.name == kernel)?;
    let case = kernel.cases.last()?;
    let stream = cost(bench, kernel.name, case, Version::Scheduled).stream?;
    Some(stream.time.cycles as f64 / f64::from(stream.objects * kernel.rays))
}
