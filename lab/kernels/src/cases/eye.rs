//! The kernels for primary rays, in the order in which a group of packets passes through them.

pub mod call;
pub mod error;
pub mod formulation;

use spu_emulator::float::single::{from_f64, to_f64};
use twins::isect_pairs::Hit;
use twins::sphere::Perpendicular;
use twins::sphere_ray::BareSphere;
use zerocopy::FromZeros as _;
use zerocopy::big_endian::U32;

use crate::bench::{self, Bench};
use crate::cases::sphere_ray::{bare_sphere, unit};
use crate::catalogue::{Case, Kernel, Objects};
use crate::eye_records::{self, Hits, Vectors};
use crate::single::single;
use call::{address, list_room, put, put_packets, put_places};
use protocol::layout::{Colours, Frustum, Packet, Pair, Place, Sphere};

/// The sixteen packets of one group, and of three groups.
const PACKETS: Objects = Objects::List(16, 48);
/// A short list of spheres, and a long one.
const SPHERES: Objects = Objects::List(16, 64);
/// The packets that a mask can select.
const NAMED: Objects = Objects::Fixed(64);

/// The kernels in this file.
pub const KERNELS: &[Kernel] = &[
    Kernel {
        name: "frustum_spheres",
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
        error: None,
        equal: None,
    },
    Kernel {
        name: "cull_spheres_p64",
        rays: 16,
        cases: &[Case { name: "none seen", objects: SPHERES, place: cull_spheres }],
        error: None,
        equal: None,
    },
    Kernel {
        name: "list_places_p64",
        rays: 1,
        cases: &[Case { name: "all named", objects: NAMED, place: list_places }],
        error: None,
        equal: None,
    },
    Kernel {
        name: "ray_setup_r16",
        rays: 16,
        cases: &[Case { name: "packets", objects: PACKETS, place: ray_setup }],
        error: Some(error::ray_setup),
        equal: None,
    },
    Kernel {
        name: "filter_spheres_r16",
        rays: 16,
        cases: &[Case { name: "all miss", objects: SPHERES, place: filter_spheres }],
        error: None,
        equal: None,
    },
    Kernel {
        name: "list_pairs_p64",
        rays: 1,
        cases: &[Case { name: "all named", objects: NAMED, place: list_pairs }],
        error: None,
        equal: None,
    },
    Kernel {
        name: "hidden_pairs_r16",
        rays: 16,
        cases: &[Case { name: "all hidden", objects: PACKETS, place: hidden_pairs }],
        error: None,
        equal: None,
    },
    formulation::row::<Perpendicular>(),
    Kernel {
        name: "mask_pairs_p64",
        rays: 1,
        cases: &[Case { name: "pairs", objects: PACKETS, place: mask_pairs }],
        error: None,
        equal: None,
    },
    Kernel {
        name: "shade_depth_r16",
        rays: 16,
        cases: &[Case { name: "all hit", objects: PACKETS, place: shade_depth }],
        error: Some(error::shade_depth),
        equal: None,
    },
    Kernel {
        name: "pack_r16",
        rays: 16,
        cases: &[Case { name: "packets", objects: PACKETS, place: pack }],
        error: Some(error::pack),
        equal: None,
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

fn put_spheres(bench: &mut Bench, bare: &BareSphere, count: u32) -> bench::Place {
    put(bench, &vec![limited(bare); count as usize])
}

fn packets(bench: &mut Bench, hits: &Hits, count: u32) -> Vec<bench::Place> {
    let packet = eye_records::packet(&rays(), hits);
    put_packets(bench, &vec![packet; count as usize])
}

fn frustum_spheres(bench: &mut Bench, bare: &BareSphere, count: u32) -> Vec<u32> {
    // The sides of a pyramid around -z that is half as wide as it is long.
    let (along, across) = (libm::sin(libm::atan(0.5_f64)), libm::cos(libm::atan(0.5_f64)));
    let frustum = Frustum {
        normal_x: [across, -across, 0.0, 0.0].map(|x| single(from_f64(x))),
        normal_y: [0.0, 0.0, across, -across].map(|y| single(from_f64(y))),
        normal_z: [single(from_f64(-along)); 4],
    };
    let frustum = put(bench, &[frustum]);
    let spheres = put_spheres(bench, bare, count);
    let list = list_room(bench, count as usize);
    vec![frustum.address, spheres.address, count, list.address]
}

fn cull_spheres(bench: &mut Bench, count: u32) -> Vec<u32> {
    let middles = eye_records::packet(&rays(), &error::NO_HITS);
    let middles = put(bench, &[middles; 4]);
    let spheres = put_spheres(bench, &beside(), count);
    let list: Vec<Pair> = (0..count as usize)
        .map(|number| eye_records::pair(address::<Sphere>(spheres, number), 0))
        .collect();
    let list = put(bench, &list);
    let masks = bench.place(&vec![0; 16 * count as usize]);
    vec![middles.address, list.address, count, masks.address]
}

fn tile_places(bench: &mut Bench) -> bench::Place {
    let packets = packets(bench, &error::NO_HITS, 64);
    put_places(bench, &packets, |_| [0; 3])
}

fn list_places(bench: &mut Bench, count: u32) -> Vec<u32> {
    let places = tile_places(bench);
    let origin = put(bench, &[Place::new_zeroed()]);
    let list = list_room(bench, count as usize);
    let masks = all_named(bench);
    vec![masks.address, places.address, origin.address, list.address]
}

fn list_pairs(bench: &mut Bench, count: u32) -> Vec<u32> {
    let places = tile_places(bench);
    let list = list_room(bench, count as usize);
    let masks = all_named(bench);
    vec![masks.address, places.address, places.address, list.address]
}

/// Masks that select all packets of a tile.
fn all_named(bench: &mut Bench) -> bench::Place {
    put(bench, &[0xffff_u32; 4].map(U32::new))
}

fn ray_setup(bench: &mut Bench, count: u32) -> Vec<u32> {
    let basis = twins::ray_setup::Basis {
        corner: [-0.5, 0.5, -1.0].map(from_f64),
        right: [0.001, 0.0, 0.0].map(from_f64),
        down: [0.0, -0.001, 0.0].map(from_f64),
    };
    let basis = put(bench, &[eye_records::basis(&basis)]);
    let packets = packets(bench, &error::NO_HITS, count);
    let places = put_places(bench, &packets, |number| {
        let number = number as u32;
        [0, number % 16 * 4, number / 16 * 4]
    });
    vec![basis.address, places.address, count, 0]
}

fn filter_spheres(bench: &mut Bench, count: u32) -> Vec<u32> {
    let packet = packets(bench, &error::NO_HITS, 1);
    let place = put_places(bench, &packet, |_| [0; 3]);
    let spheres = put_spheres(bench, &beside(), count);
    let list = list_room(bench, count as usize);
    vec![place.address, 1, spheres.address, count / 4, list.address]
}

fn hidden_pairs(bench: &mut Bench, count: u32) -> Vec<u32> {
    let hit = Hit { t: from_f64(1.0), object: 0 };
    let packets = packets(bench, &[hit; 16], count);
    let mut sphere = limited(&ahead());
    sphere.near = single(from_f64(4.0));
    let sphere = put(bench, &[sphere]);
    let pairs: Vec<Pair> =
        packets.iter().map(|packet| eye_records::pair(sphere.address, packet.address)).collect();
    let pairs = put(bench, &pairs);
    vec![pairs.address, count]
}

/// Each of the spheres paired with sixteen packets.
fn isect_pairs(bench: &mut Bench, spheres: &[Sphere; 4], count: u32) -> Vec<u32> {
    let packets = packets(bench, &error::NO_HITS, 64);
    let spheres = put(bench, spheres);
    let pairs: Vec<Pair> = (0..count as usize)
        .map(|number| {
            let object = address::<Sphere>(spheres, number / 16);
            eye_records::pair(object, packets[number % 16].address)
        })
        .collect();
    let pairs = put(bench, &pairs);
    vec![pairs.address, count]
}

fn mask_pairs(bench: &mut Bench, count: u32) -> Vec<u32> {
    let first = 0x1000;
    let pairs: Vec<Pair> = (0..count)
        .map(|number| eye_records::pair(0, first + number * size_of::<Packet>() as u32))
        .collect();
    let pairs = put(bench, &pairs);
    vec![pairs.address, count, first]
}

fn shade_depth(bench: &mut Bench, count: u32) -> Vec<u32> {
    let spheres = put_spheres(bench, &ahead(), 2);
    let hit = Hit { t: from_f64(4.0), object: address::<Sphere>(spheres, 1) };
    let packets = packets(bench, &[hit; 16], count);
    let places = put_places(bench, &packets, |_| [0; 3]);
    let depth = twins::shade_depth::Depth { far: from_f64(10.0), scale: from_f64(0.1) };
    let depth = put(bench, &[eye_records::depth(depth)]);
    let colours = bench.place(&vec![0; size_of::<Colours>() * count as usize]);
    let background = spheres.address;
    vec![places.address, count, depth.address, colours.address, background]
}

fn pack(bench: &mut Bench, count: u32) -> Vec<u32> {
    let colours = eye_records::colours(&[[from_f64(0.5); 3]; 16]);
    let colours = put(bench, &vec![colours; count as usize]);
    let shuffle = put(bench, &[eye_records::pixel_shuffle([16, 8, 0])]);
    let pixels = bench.place(&vec![0; 64 * count as usize]);
    let packets = vec![pixels; count as usize];
    let places = put_places(bench, &packets, |number| [pixels.address + 64 * number as u32, 0, 0]);
    vec![places.address, count, colours.address, shuffle.address, 16]
}
