//! The kernels that intersect candidates: the inputs that they share.

pub mod call;
pub mod cone;
pub mod error;
pub mod rectangle;
pub mod shape;
pub mod sphere;
pub mod triangle;
pub mod triangle_mt;

use twins::FARTHEST;
use twins::sphere::{
    Estimate, Factored, InDouble, Interpolated, Newton2, Paper, Perpendicular, Refined, Stable,
    Unnormalised,
};
use twins::sphere_ray::Ray;

use crate::bench::Bench;
use crate::cases::sphere_ray::case_rays;
use crate::catalogue::{Case, Kernel, Objects};
use crate::description::Description as _;
use call::Sheared;
use cone::ConeObject;
use rectangle::RectangleObject;
use shape::Shape;
use sphere::By;
use triangle::TriangleObject;
use triangle_mt::MoellerTrumbore;

/// A short list of candidates, and a long one.
const CANDIDATES: Objects = Objects::List(16, 64);
/// Packets to be sheared, up to as many as fit.
const PACKETS: Objects = Objects::List(8, 24);

/// The row of a shape's kernel, with objects that are missed and objects that are hit.
const fn row<S: Shape>() -> Kernel {
    Kernel {
        cases: const {
            &[
                Case {
                    name: "all miss",
                    objects: CANDIDATES,
                    place: |bench, count| candidates(bench, &[S::ahead(9.0, 5.0); 4], count),
                },
                Case {
                    name: "all hit, each nearer",
                    objects: CANDIDATES,
                    place: |bench, count| {
                        let nearer = [20.0, 15.0, 10.0, 5.0];
                        candidates(bench, &nearer.map(|distance| S::ahead(0.0, distance)), count)
                    },
                },
            ]
        },
        error: Some(error::nearest::<S>),
        ..Kernel::of::<call::Pairs<S>>()
    }
}

/// The kernels in this file.
pub const KERNELS: &[Kernel] = &[
    row::<By<Perpendicular>>(),
    row::<By<Paper>>(),
    row::<By<Estimate>>(),
    row::<By<Interpolated>>(),
    row::<By<Newton2>>(),
    row::<By<Stable>>(),
    row::<By<Factored>>(),
    row::<By<Refined>>(),
    row::<By<Unnormalised>>(),
    row::<By<InDouble>>(),
    row::<RectangleObject>(),
    Kernel {
        cases: &[Case {
            name: "packets",
            objects: PACKETS,
            place: |bench, count| {
                let packets = vec![case_rays(); count as usize];
                Sheared { packets, anything: 0 }.place(bench).1
            },
        }],
        error: Some(error::shear_packets),
        ..Kernel::of::<Sheared>()
    },
    row::<TriangleObject>(),
    row::<MoellerTrumbore>(),
    row::<ConeObject>(),
];

/// Each of the objects paired with sixteen packets.
fn candidates<S: Shape>(bench: &mut Bench, objects: &[S; 4], count: u32) -> Vec<u32> {
    let rays = case_rays().map(|ray| Ray { t: FARTHEST, ..ray });
    let packets = [call::packet(&rays, 0); 16];
    let list: Vec<[usize; 2]> =
        (0..count as usize).map(|number| [number / 16, number % 16]).collect();
    let placed = call::place(bench, &packets, objects, &list, 0);
    vec![placed.candidates, count]
}
