//! The kernels for primary rays, in the order in which a group of packets passes through them.

pub mod call;
pub mod cull;
pub mod error;
pub mod formulation;
pub mod lists;
pub mod packets;
pub mod pairs;

use spu_emulator::float::single::{from_f64, to_f64};
use twins::isect_pairs::Hit;
use twins::ray_setup::Basis;
use twins::shade_depth::Depth;
use twins::sphere::Perpendicular;
use twins::sphere_ray::BareSphere;

use crate::bench::Bench;
use crate::cases::sphere_ray::{bare_sphere, unit};
use crate::catalogue::{Case, Kernel, Objects};
use crate::description::Description as _;
use crate::eye_records::{self, Vectors};
use crate::single::single;
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
pub const KERNELS: &[Kernel] = &[
    Kernel {
        rays: 1,
        cases: &[
            Case {
                name: "all outside",
                objects: SPHERES,
                place: |bench, count| frustum_spheres(bench, &beside(), count),
            },
            Case {
                name: "all within",
                objects: SPHERES,
                place: |bench, count| frustum_spheres(bench, &ahead(), count),
            },
        ],
        ..Kernel::of::<FrustumSpheres>()
    },
    Kernel {
        cases: &[Case { name: "none seen", objects: SPHERES, place: cull_spheres }],
        ..Kernel::of::<CullSpheres>()
    },
    Kernel {
        rays: 1,
        cases: &[Case { name: "all named", objects: NAMED, place: list_places }],
        ..Kernel::of::<ListPlaces>()
    },
    Kernel {
        cases: &[Case { name: "packets", objects: PACKETS, place: ray_setup }],
        error: Some(error::ray_setup),
        ..Kernel::of::<RaySetup>()
    },
    Kernel {
        cases: &[Case { name: "all miss", objects: SPHERES, place: filter_spheres }],
        ..Kernel::of::<FilterSpheres>()
    },
    Kernel {
        rays: 1,
        cases: &[Case { name: "all named", objects: NAMED, place: list_pairs }],
        ..Kernel::of::<ListPairs>()
    },
    Kernel {
        cases: &[Case { name: "all hidden", objects: PACKETS, place: hidden_pairs }],
        ..Kernel::of::<HiddenPairs>()
    },
    formulation::row::<Perpendicular>(),
    Kernel {
        rays: 1,
        cases: &[Case { name: "pairs", objects: PACKETS, place: mask_pairs }],
        ..Kernel::of::<MaskPairs>()
    },
    Kernel {
        cases: &[Case { name: "all hit", objects: PACKETS, place: shade_depth }],
        error: Some(error::shade_depth),
        ..Kernel::of::<ShadeDepth>()
    },
    Kernel {
        cases: &[Case { name: "packets", objects: PACKETS, place: pack }],
        error: Some(error::pack),
        ..Kernel::of::<Pack>()
    },
];

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

fn frustum_spheres(bench: &mut Bench, bare: &BareSphere, count: u32) -> Vec<u32> {
    // The sides of a pyramid around -z that is half as wide as it is long.
    let (along, across) = (libm::sin(libm::atan(0.5_f64)), libm::cos(libm::atan(0.5_f64)));
    let sides = [[across, 0.0], [-across, 0.0], [0.0, across], [0.0, -across]];
    let normals = sides.map(|[x, y]| [x, y, -along].map(from_f64));
    FrustumSpheres { normals, spheres: vec![limited(bare); count as usize] }.place(bench).1
}

fn cull_spheres(bench: &mut Bench, count: u32) -> Vec<u32> {
    let (count, middles) = (count as usize, [rays(); 4]);
    let spheres = vec![limited(&beside()); count];
    CullSpheres { middles, spheres, order: (0..count).collect() }.place(bench).1
}

fn list_places(bench: &mut Bench, _: u32) -> Vec<u32> {
    ListPlaces { named: [0xffff; 4], places: [[0; 4]; 64], origin: [0; 4] }.place(bench).1
}

fn list_pairs(bench: &mut Bench, _: u32) -> Vec<u32> {
    ListPairs { named: [0xffff; 4], places: [[0; 4]; 64], object: 0 }.place(bench).1
}

fn ray_setup(bench: &mut Bench, count: u32) -> Vec<u32> {
    let basis = Basis {
        corner: [-0.5, 0.5, -1.0].map(from_f64),
        right: [0.001, 0.0, 0.0].map(from_f64),
        down: [0.0, -0.001, 0.0].map(from_f64),
    };
    let pixels = (0..count).map(|number| [number % 16 * 4, number / 16 * 4]).collect();
    RaySetup { basis, pixels, background: 0 }.place(bench).1
}

fn filter_spheres(bench: &mut Bench, count: u32) -> Vec<u32> {
    let spheres = vec![limited(&beside()); count as usize];
    FilterSpheres { packets: vec![rays()], spheres }.place(bench).1
}

fn hidden_pairs(bench: &mut Bench, count: u32) -> Vec<u32> {
    let packets = vec![[Hit { t: from_f64(1.0), object: 0 }; 16]; count as usize];
    HiddenPairs { packets, near: vec![from_f64(4.0); count as usize] }.place(bench).1
}

fn mask_pairs(bench: &mut Bench, count: u32) -> Vec<u32> {
    let numbers = (0..count as usize).collect();
    MaskPairs { numbers, first: 0x1000, object: 0 }.place(bench).1
}

fn shade_depth(bench: &mut Bench, count: u32) -> Vec<u32> {
    let hits = vec![[Hit { t: from_f64(4.0), object: 1 }; 16]; count as usize];
    let depth = Depth { far: from_f64(10.0), scale: from_f64(0.1) };
    ShadeDepth { hits, colours: vec![[0; 3]; 2], depth }.place(bench).1
}

fn pack(bench: &mut Bench, count: u32) -> Vec<u32> {
    let colours = vec![[[from_f64(0.5); 3]; 16]; count as usize];
    Pack { colours, shifts: [16, 8, 0] }.place(bench).1
}
