//! The kernels from hits to pixels, in the order in which a batch of packets passes through them.

pub mod display;
pub mod error;
pub mod gather;
pub mod light;
pub mod records;
pub mod shapes;
pub mod sums;

use spu_emulator::float::single::from_f64;
use twins::accumulate::Share;
use twins::shadow_rays::{Place, shadow_ray};
use twins::surfaces::{Material, Ray, Surface};
use twins::{ONE, Single, ZERO};

use crate::bench::Bench;
use crate::catalogue::{Case, Kernel, Objects};
use crate::description::Description as _;
use display::Values;
use gather::{Hit, Hits, RefineHits, SameObjects};
use light::{AMBIENT, HIGHLIGHT, LAMBERT, Lit, Shadows, Site};
use protocol::layout;
use shapes::Shape;
use sums::{Rows, Shares};

/// The packets in a call. The cost of one more is what counts.
const PACKETS: Objects = Objects::List(4, 8);
/// The quadwords of a packet's row, and of a tile's.
const QUADS: Objects = Objects::List(4, 64);

/// Lengths of lists.
const LENGTHS: &[usize] = &[1, 2, 3, 5, 8];

/// The largest exponent of a highlight.
const EXPONENT: f64 = 4096.0;

/// The minimum share of a light of brightness 1 that is worth a shadow ray: 2^-12.
pub const MIN_SHARE: Single = 0x3980_0000;

/// The kernels in this file.
pub const KERNELS: &[Kernel] = &[
    Kernel {
        cases: &[Case { name: "all hit", objects: PACKETS, place: hits::<false> }],
        error: Some(error::surfaces),
        ..Kernel::of::<Hits<false>>()
    },
    Kernel {
        cases: &[Case { name: "all the same", objects: PACKETS, place: same_objects }],
        ..Kernel::of::<SameObjects>()
    },
    Kernel {
        cases: &[Case { name: "all hit", objects: PACKETS, place: hits::<true> }],
        error: Some(error::surfaces_same),
        ..Kernel::of::<Hits<true>>()
    },
    Kernel {
        cases: &[Case { name: "all hit", objects: PACKETS, place: refine_hits }],
        error: Some(error::refine_hits),
        ..Kernel::of::<RefineHits>()
    },
    Kernel {
        cases: &[Case { name: "all lit", objects: PACKETS, place: lit::<AMBIENT> }],
        error: Some(error::ambient),
        ..Kernel::of::<Lit<AMBIENT>>()
    },
    Kernel {
        cases: &[Case { name: "all face the light", objects: PACKETS, place: shadow_rays }],
        error: Some(error::shadow_rays),
        ..Kernel::of::<Shadows>()
    },
    Kernel {
        cases: &[Case { name: "all lit", objects: PACKETS, place: lit::<LAMBERT> }],
        error: Some(error::lambert),
        ..Kernel::of::<Lit<LAMBERT>>()
    },
    Kernel {
        cases: &[Case { name: "all lit", objects: PACKETS, place: lit::<HIGHLIGHT> }],
        error: Some(error::light),
        ..Kernel::of::<Lit<HIGHLIGHT>>()
    },
    Kernel {
        cases: &[Case { name: "a pixel each", objects: PACKETS, place: accumulate }],
        error: Some(error::accumulate),
        ..Kernel::of::<Shares>()
    },
    Kernel {
        rays: 64,
        cases: &[Case { name: "rows of a tile", objects: PACKETS, place: pack_sums }],
        error: Some(error::pack_sums),
        ..Kernel::of::<Rows>()
    },
    Kernel {
        rays: 1,
        cases: &[Case { name: "a row of sums", objects: QUADS, place: values }],
        error: Some(error::encode_srgb),
        ..Kernel::of::<Values<false>>()
    },
    Kernel {
        rays: 1,
        cases: &[Case { name: "a row of sums", objects: QUADS, place: values }],
        error: Some(error::roll_off),
        ..Kernel::of::<Values<true>>()
    },
];

/// A background and a sphere in front of the eye with their material, and packets of rays that hit
/// the sphere.
fn hits_of_sphere<const SAME: bool>(count: u32) -> Hits<SAME> {
    let half = from_f64(0.5);
    let material = Material {
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
    };
    let ray = Ray { origin: [0; 3], direction: [0.0, 0.0, -1.0].map(from_f64), t: from_f64(4.0) };
    Hits {
        packets: vec![[Hit { ray, object: 1 }; 16]; count as usize],
        objects: vec![(Shape::sphere([0.0, 0.0, -5.0], 1.0).object(), 0); 2],
        materials: vec![material],
    }
}

fn hits<const SAME: bool>(bench: &mut Bench, count: u32) -> Vec<u32> {
    hits_of_sphere::<SAME>(count).place(bench).1
}

fn refine_hits(bench: &mut Bench, count: u32) -> Vec<u32> {
    RefineHits(hits_of_sphere(count)).place(bench).1
}

fn same_objects(bench: &mut Bench, count: u32) -> Vec<u32> {
    SameObjects { packets: vec![[0; 16]; count as usize] }.place(bench).1
}

/// A light next to the eye.
fn near_light() -> Place {
    Place { position: [1.0, 1.0, 0.0].map(from_f64), falloff: ZERO }
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
    let shadow = shadow_ray(&surface, surface.plane, ONE, &near_light(), MIN_SHARE);
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
    Shadows { sites: sites(count), light: near_light(), min_share: MIN_SHARE }.place(bench).1
}

fn lit<const WAY: usize>(bench: &mut Bench, count: u32) -> Vec<u32> {
    let (sites, light) = (sites(count), near_light());
    Lit::<WAY> { sites, light, brightness: [from_f64(0.5); 3] }.place(bench).1
}

fn accumulate(bench: &mut Bench, count: u32) -> Vec<u32> {
    let lit = [from_f64(0.5); 3];
    let packet = std::array::from_fn(|pixel| Share { pixel, weight: ONE, lit });
    Shares { packets: vec![packet; count as usize], sums: vec![[0; 3]; 16] }.place(bench).1
}

fn pack_sums(bench: &mut Bench, count: u32) -> Vec<u32> {
    let row = vec![[0; 3]; layout::TILE_WIDTH as usize];
    Rows { rows: vec![row; count as usize], shifts: [16, 8, 0] }.place(bench).1
}

fn values(bench: &mut Bench, count: u32) -> Vec<u32> {
    Values::<false> { values: vec![[ONE; 4]; count as usize] }.place(bench).1
}
