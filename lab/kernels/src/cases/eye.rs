//! The kernels for primary rays, in the order in which a group of packets passes through them.

pub mod call;
pub mod cull;
pub mod error;
pub mod formulation;
pub mod lists;
pub mod packets;
pub mod pairs;

use twins::isect_pairs::Hit;
use twins::ray_setup::Basis;
use twins::shade_depth::Depth;
use twins::sphere::Perpendicular;
use twins::sphere_ray::BareSphere;

use crate::cases::sphere_ray::{bare_sphere, unit};
use crate::eye_records;
use crate::prelude::*;
use cull::{CullSpheres, FilterSpheres, FrustumSpheres, HiddenPairs};
use lists::{ListPairs, ListPlaces, MaskPairs};
use packets::{Pack, RaySetup, ShadeDepth};
use protocol::layout::Sphere;

/// The sixteen packets of one group, and of three groups.
const PACKETS: Objects = Objects::List(16, 48);
/// A short list of spheres, and a long one.
const SPHERES: Objects = Objects::List(16, 64);
/// The packets that a mask can select.
const NAMED: Objects = Objects::Fixed(64);

/// The kernels in this file.
pub fn kernels() -> Vec<Kernel> {
    vec![
        Kernel::of::<FrustumSpheres>([
            case("all outside", SPHERES, |count| frustum_spheres(&beside(), count)),
            case("all within", SPHERES, |count| frustum_spheres(&ahead(), count)),
        ])
        .rays(1),
        Kernel::of::<CullSpheres>([case("none seen", SPHERES, cull_spheres)]),
        Kernel::of::<ListPlaces>([case("all named", NAMED, list_places)]).rays(1),
        Kernel::of::<RaySetup>([case("packets", PACKETS, ray_setup)]).error(error::ray_setup),
        Kernel::of::<FilterSpheres>([case("all miss", SPHERES, filter_spheres)]),
        Kernel::of::<ListPairs>([case("all named", NAMED, list_pairs)]).rays(1),
        Kernel::of::<HiddenPairs>([case("all hidden", PACKETS, hidden_pairs)]),
        formulation::row::<Perpendicular>(),
        Kernel::of::<MaskPairs>([case("pairs", PACKETS, mask_pairs)]).rays(1),
        Kernel::of::<ShadeDepth>([case("all hit", PACKETS, shade_depth)]).error(error::shade_depth),
        Kernel::of::<Pack>([case("packets", PACKETS, pack)]).error(error::pack),
    ]
}

/// The rays of the cases, which are close to -z.
fn rays() -> Vectors {
    std::array::from_fn(|lane| {
        let step = |at: usize| (at as f64 - 1.5) * 0.01;
        unit([step(lane % 4), step(lane / 4), -1.0]).map(from_f64)
    })
}

fn beside() -> BareSphere {
    bare_sphere([9.0, 0.0, -5.0], 1.0)
}

fn ahead() -> BareSphere {
    bare_sphere([0.0, 0.0, -5.0], 1.0)
}

/// The record of a sphere with the limits of its tests, without margins for rounding.
fn limited(bare: &BareSphere) -> Sphere {
    let mut sphere = eye_records::sphere(bare);
    let square: f64 = bare.centre.map(|component| to_f64(component).powi(2)).iter().sum();
    let radius_squared = to_f64(bare.radius_squared);
    let limit = single(from_f64((square - radius_squared).sqrt()));
    (sphere.ray_limit, sphere.packet_limit) = (limit, limit);
    sphere.reach = single(from_f64(radius_squared.sqrt()));
    sphere
}

fn frustum_spheres(bare: &BareSphere, count: u32) -> FrustumSpheres {
    // The sides of a pyramid around -z that is half as wide as it is long.
    let (along, across) = (libm::sin(libm::atan(0.5_f64)), libm::cos(libm::atan(0.5_f64)));
    let sides = [[across, 0.0], [-across, 0.0], [0.0, across], [0.0, -across]];
    let normals = sides.map(|[x, y]| [x, y, -along].map(from_f64));
    FrustumSpheres { normals, spheres: vec![limited(bare); count as usize] }
}

fn cull_spheres(count: u32) -> CullSpheres {
    let (count, middles) = (count as usize, [rays(); 4]);
    let spheres = vec![limited(&beside()); count];
    CullSpheres { middles, spheres, order: (0..count).collect() }
}

fn list_places(_: u32) -> ListPlaces {
    ListPlaces { named: [0xffff; 4], places: [[0; 4]; 64], origin: [0; 4] }
}

fn list_pairs(_: u32) -> ListPairs {
    ListPairs { named: [0xffff; 4], places: [[0; 4]; 64], object: 0 }
}

fn ray_setup(count: u32) -> RaySetup {
    let basis = Basis {
        corner: [-0.5, 0.5, -1.0].map(from_f64),
        right: [0.001, 0.0, 0.0].map(from_f64),
        down: [0.0, -0.001, 0.0].map(from_f64),
    };
    let pixels = (0..count).map(|number| [number % 16 * 4, number / 16 * 4]).collect();
    RaySetup { basis, pixels, background: 0 }
}

fn filter_spheres(count: u32) -> FilterSpheres {
    let spheres = vec![limited(&beside()); count as usize];
    FilterSpheres { packets: vec![rays()], spheres }
}

fn hidden_pairs(count: u32) -> HiddenPairs {
    let packets = vec![[Hit { t: from_f64(1.0), object: 0 }; 16]; count as usize];
    HiddenPairs { packets, near: vec![from_f64(4.0); count as usize] }
}

fn mask_pairs(count: u32) -> MaskPairs {
    let numbers = (0..count as usize).collect();
    MaskPairs { numbers, first: 0x1000, object: 0 }
}

fn shade_depth(count: u32) -> ShadeDepth {
    let hits = vec![[Hit { t: from_f64(4.0), object: 1 }; 16]; count as usize];
    let depth = Depth { far: from_f64(10.0), scale: from_f64(0.1) };
    ShadeDepth { hits, colours: vec![[0; 3]; 2], depth }
}

fn pack(count: u32) -> Pack {
    let colours = vec![[[from_f64(0.5); 3]; 16]; count as usize];
    Pack { colours, shifts: [16, 8, 0] }
}
