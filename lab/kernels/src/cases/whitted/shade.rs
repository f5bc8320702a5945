//! The kernels from hits to pixels, in the order in which a batch of packets passes through them.

pub mod display;
pub mod error;
pub mod gather;
pub mod light;
pub mod records;
pub mod shapes;
pub mod sums;

use twins::accumulate::Share;
use twins::shadow_rays::{Place, shadow_ray};
use twins::surfaces::{Material, Ray, Surface};

use crate::prelude::*;
use display::Values;
use gather::{Hit, Hits, RefineHits, SameObjects};
use light::{AMBIENT, HIGHLIGHT, LAMBERT, Lit, Shadows, Site};
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
pub fn kernels() -> Vec<Kernel> {
    vec![
        Kernel::of::<Hits<false>>([case("all hit", PACKETS, hits_of_sphere::<false>)])
            .error(error::surfaces),
        Kernel::of::<SameObjects>([case("all the same", PACKETS, same_objects)]),
        Kernel::of::<Hits<true>>([case("all hit", PACKETS, hits_of_sphere::<true>)])
            .error(error::surfaces_same),
        Kernel::of::<RefineHits>([case("all hit", PACKETS, refine_hits)]).error(error::refine_hits),
        Kernel::of::<Lit<AMBIENT>>([case("all lit", PACKETS, lit::<AMBIENT>)])
            .error(error::ambient),
        Kernel::of::<Shadows>([case("all face the light", PACKETS, shadow_rays)])
            .error(error::shadow_rays),
        Kernel::of::<Lit<LAMBERT>>([case("all lit", PACKETS, lit::<LAMBERT>)])
            .error(error::lambert),
        Kernel::of::<Lit<HIGHLIGHT>>([case("all lit", PACKETS, lit::<HIGHLIGHT>)])
            .error(error::light),
        Kernel::of::<Shares>([case("a pixel each", PACKETS, accumulate)]).error(error::accumulate),
        Kernel::of::<Rows>([case("rows of a tile", PACKETS, pack_sums)])
            .rays(64)
            .error(error::pack_sums),
        Kernel::of::<Values<false>>([case("a row of sums", QUADS, values)])
            .rays(1)
            .error(error::encode_srgb),
        Kernel::of::<Values<true>>([case("a row of sums", QUADS, values)])
            .rays(1)
            .error(error::roll_off),
    ]
}

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

fn refine_hits(count: u32) -> RefineHits {
    RefineHits(hits_of_sphere(count))
}

fn same_objects(count: u32) -> SameObjects {
    SameObjects { packets: vec![[0; 16]; count as usize] }
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

fn shadow_rays(count: u32) -> Shadows {
    Shadows { sites: sites(count), light: near_light(), min_share: MIN_SHARE }
}

fn lit<const WAY: usize>(count: u32) -> Lit<WAY> {
    let (sites, light) = (sites(count), near_light());
    Lit::<WAY> { sites, light, brightness: [from_f64(0.5); 3] }
}

fn accumulate(count: u32) -> Shares {
    let lit = [from_f64(0.5); 3];
    let packet = std::array::from_fn(|pixel| Share { pixel, weight: ONE, lit });
    Shares { packets: vec![packet; count as usize], sums: vec![[0; 3]; 16] }
}

fn pack_sums(count: u32) -> Rows {
    let row = vec![[0; 3]; layout::TILE_WIDTH as usize];
    Rows { rows: vec![row; count as usize], shifts: [16, 8, 0] }
}

fn values<const ROLL_OFF: bool>(count: u32) -> Values<ROLL_OFF> {
    Values { values: vec![[ONE; 4]; count as usize] }
}
