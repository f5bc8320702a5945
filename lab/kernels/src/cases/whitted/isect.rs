//! The kernels that intersect candidates: the inputs that they share.

pub mod call;
pub mod cone;
pub mod error;
pub mod rectangle;
pub mod shape;
pub mod sphere;
pub mod triangle;
pub mod triangle_mt;

use twins::sphere::{
    Estimate, Factored, InDouble, Interpolated, Newton2, Paper, Perpendicular, Refined, Stable,
    Unnormalised,
};
use twins::sphere_ray::Ray;

use crate::cases::sphere_ray::case_rays;
use crate::prelude::*;
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
fn row<S: Shape + 'static>() -> Kernel {
    Kernel::of::<call::Pairs<S>>([
        case("all miss", CANDIDATES, |count| candidates([S::ahead(9.0, 5.0); 4], count)),
        case("all hit, each nearer", CANDIDATES, |count| {
            let nearer = [20.0, 15.0, 10.0, 5.0];
            candidates(nearer.map(|distance| S::ahead(0.0, distance)), count)
        }),
    ])
    .error(error::nearest::<S>)
}

/// The kernels in this file.
pub fn kernels() -> Vec<Kernel> {
    vec![
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
        Kernel::of([case("packets", PACKETS, |count| {
            let packets = vec![case_rays(); count as usize];
            Sheared { packets, anything: 0 }
        })])
        .error(error::shear_packets),
        row::<TriangleObject>(),
        row::<MoellerTrumbore>(),
        row::<ConeObject>(),
    ]
}

/// Each of the objects paired with sixteen packets.
fn candidates<S: Shape>(objects: [S; 4], count: u32) -> call::Pairs<S> {
    let rays = case_rays().map(|ray| Ray { t: FARTHEST, ..ray });
    let list = (0..count as usize).map(|number| [number / 16, number % 16]).collect();
    call::Pairs { packets: vec![rays; 16], objects: objects.into(), list, anything: 0 }
}
