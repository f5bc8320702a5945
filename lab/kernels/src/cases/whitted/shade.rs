//! The kernels from hits to pixels, in the order in which a batch of packets passes through them.

pub mod call;
pub mod display;
pub mod error;
pub mod records;
pub mod shapes;

use spu_emulator::float::single::from_f64;
use twins::shadow_rays::{Place, shadow_ray};
use twins::surfaces::{Material, Ray, Surface};
use twins::{ONE, Single};

use crate::bench::{self, Bench};
use crate::cases::eye::call::{address, put};
use crate::catalogue::{Case, Kernel, Objects};
use crate::eye_records::pixel_shuffle;
use crate::single::single;
use call::Site;
use display::Values;
use protocol::layout;
use records::PacketRay;
use shapes::Shape;

/// The packets in a call. The cost of one more is what counts.
const PACKETS: Objects = Objects::List(4, 8);
/// The quadwords of a packet's row, and of a tile's.
const QUADS: Objects = Objects::List(4, 64);

/// The smallest share of a light of brightness 1 that is worth a shadow ray: 2^-12.
pub const LEAST: Single = 0x3980_0000;

/// The kernels in this file.
pub const KERNELS: &[Kernel] = &[
    Kernel {
        name: "surfaces_r16",
        rays: 16,
        cases: &[Case { name: "all hit", objects: PACKETS, place: surfaces }],
        error: Some(error::surfaces),
        equal: None,
    },
    Kernel {
        name: "same_objects_r16",
        rays: 16,
        cases: &[Case { name: "all the same", objects: PACKETS, place: same_objects }],
        error: None,
        equal: None,
    },
    Kernel {
        name: "surfaces_same_r16",
        rays: 16,
        cases: &[Case { name: "all hit", objects: PACKETS, place: surfaces }],
        error: Some(error::surfaces_same),
        equal: None,
    },
    Kernel {
        name: "ambient_r16",
        rays: 16,
        cases: &[Case { name: "all lit", objects: PACKETS, place: ambient }],
        error: Some(error::ambient),
        equal: None,
    },
    Kernel {
        name: "shadow_rays_r16",
        rays: 16,
        cases: &[Case { name: "all face the light", objects: PACKETS, place: shadow_rays }],
        error: Some(error::shadow_rays),
        equal: None,
    },
    Kernel {
        name: "lambert_r16",
        rays: 16,
        cases: &[Case { name: "all lit", objects: PACKETS, place: light }],
        error: Some(error::lambert),
        equal: None,
    },
    Kernel {
        name: "light_r16",
        rays: 16,
        cases: &[Case { name: "all lit", objects: PACKETS, place: light }],
        error: Some(error::light),
        equal: None,
    },
    Kernel {
        name: "accumulate_r16",
        rays: 16,
        cases: &[Case { name: "a pixel each", objects: PACKETS, place: accumulate }],
        error: Some(error::accumulate),
        equal: None,
    },
    Kernel {
        name: "pack_sums",
        rays: 64,
        cases: &[Case { name: "rows of a tile", objects: PACKETS, place: pack_sums }],
        error: Some(error::pack_sums),
        equal: None,
    },
    Kernel {
        rays: 1,
        cases: &[Case {
            name: "a row of sums",
            objects: QUADS,
            place: |bench, count| call::put_values(bench, &vec![[ONE; 4]; count as usize]).1,
        }],
        error: Some(error::encode_srgb),
        ..Kernel::of::<Values<false>>()
    },
    Kernel {
        rays: 1,
        cases: &[Case {
            name: "a row of sums",
            objects: QUADS,
            place: |bench, count| call::put_values(bench, &vec![[ONE; 4]; count as usize]).1,
        }],
        error: Some(error::roll_off),
        ..Kernel::of::<Values<true>>()
    },
];

/// A ray from the eye towards -z.
fn away() -> PacketRay {
    PacketRay {
        ray: Ray { origin: [0; 3], direction: [0.0, 0.0, -1.0].map(from_f64), t: from_f64(4.0) },
        object: 0,
        weight: from_f64(1.0),
        pixel: 0,
    }
}

/// A background and a sphere in front of the eye with their material, and packets of rays that hit
/// the sphere.
fn hits(bench: &mut Bench, count: u32) -> (bench::Place, bench::Place) {
    let half = from_f64(0.5);
    let material = put(
        bench,
        &[records::material(&Material {
            colour: [half; 3],
            diffuse: half,
            highlight: half,
            exponent: from_f64(40.0),
            mirror: half,
            transmittance: half,
            inverse_index: from_f64(0.75),
            index: from_f64(4.0 / 3.0),
            schlick: 0,
            grazing: 0,
            emission: [0; 3],
            flags: 0,
        })],
    );
    let sphere = Shape::sphere([0.0, 0.0, -5.0], 1.0).object();
    let objects = put(bench, &[records::object(&sphere, material.address); 2]);
    let ray = PacketRay { object: address::<layout::Object>(objects, 1), ..away() };
    let packets = vec![records::rays(&[ray; 16]); count as usize];
    (objects, put(bench, &packets))
}

fn surfaces(bench: &mut Bench, count: u32) -> Vec<u32> {
    let (objects, rays) = hits(bench, count);
    let size = size_of::<layout::Surfaces>() * count as usize;
    let found = bench.place(&vec![0; size]);
    vec![rays.address, count, found.address, objects.address]
}

fn same_objects(bench: &mut Bench, count: u32) -> Vec<u32> {
    let (_, rays) = hits(bench, count);
    vec![rays.address, count]
}

fn ambient(bench: &mut Bench, count: u32) -> Vec<u32> {
    let lit = records::lit_surfaces(&[[0; 3]; 16]);
    let surfaces = put(bench, &vec![lit; count as usize]);
    let brightness = put(bench, &[[single(from_f64(0.5)); 4]]);
    vec![surfaces.address, count, brightness.address]
}

/// A light next to the eye.
fn near_light() -> Place {
    Place { position: [1.0, 1.0, 0.0].map(from_f64), directional: false }
}

/// Hits on a sphere that this light reaches.
fn sites(count: u32) -> Vec<Site> {
    let half = from_f64(0.5);
    let surface = Surface {
        point: [0.0, 0.0, -4.0].map(from_f64),
        plane: [0.0, 0.0, 1.0].map(from_f64),
        leave: from_f64(shapes::LEAVE),
        colour: [half; 3],
        diffuse: half,
        highlight: half,
        exponent: from_f64(40.0),
        mirror: 0,
        transmittance: 0,
        ratio: 0,
        schlick: 0,
        grazing: 0,
        lit: [0; 3],
        flags: 0,
    };
    let shadow = shadow_ray(&surface, surface.plane, ONE, &near_light(), LEAST);
    let site = Site {
        surfaces: [surface; 16],
        normals: [surface.plane; 16],
        directions: [[0.0, 0.0, -1.0].map(from_f64); 16],
        weights: [ONE; 16],
        shines: true,
        shadow: [(shadow, false); 16],
    };
    vec![site; count as usize]
}

fn shadow_rays(bench: &mut Bench, count: u32) -> Vec<u32> {
    call::shadow_arguments(bench, &sites(count), &near_light(), LEAST).0
}

fn light(bench: &mut Bench, count: u32) -> Vec<u32> {
    call::light_arguments(bench, &sites(count), [from_f64(0.5); 3]).0
}

fn accumulate(bench: &mut Bench, count: u32) -> Vec<u32> {
    let sums = bench.place(&[0; 16 * 16]);
    let mut packet = records::rays(&[away(); 16]);
    for (lane, pixel) in packet.pixel.iter_mut().enumerate() {
        *pixel = (sums.address + 16 * lane as u32).into();
    }
    let rays = put(bench, &vec![packet; count as usize]);
    let lit = records::lit_surfaces(&[[from_f64(0.5); 3]; 16]);
    let surfaces = put(bench, &vec![lit; count as usize]);
    vec![rays.address, surfaces.address, count]
}

fn pack_sums(bench: &mut Bench, count: u32) -> Vec<u32> {
    let row_bytes = 4 * layout::TILE_WIDTH;
    let sums = bench.place(&vec![0; (4 * row_bytes * count) as usize]);
    let pixels = bench.place(&vec![0; (row_bytes * count) as usize]);
    let shuffle = put(bench, &[pixel_shuffle([16, 8, 0])]);
    vec![sums.address, pixels.address, count, row_bytes, shuffle.address]
}
