//! The kernels that make packets of rays, and those that cull objects that no ray of a packet can
//! hit.

pub mod bounds;
pub mod call;
pub mod faces;
pub mod fans;
pub mod makers;
pub mod nodes;
pub mod paths;

use twins::bound::bound;
use twins::cull_faces::Face;
use twins::load_rays::Queued;
use twins::primary_rays::{Ray, View};
use twins::ray_setup::Basis;
use twins::sample_rays::{Pixel, sample};

use crate::cases::eye::error::{camera, error_of_directions, error_of_directions_through};
use crate::cases::sphere_ray::unit;
use crate::catalogue::CaseOf;
use crate::prelude::*;
use bounds::{Fans, Origins, Point};
use faces::CullFaces;
use makers::{LoadRays, PrimaryRays, SampleRays};
use nodes::{BareBox, BareSphere, Child, CullNodes, FilterChildren, Listed, Volume};
use paths::{PathBounds, PathsMeet};
use twins::paths::path;

/// One packet, and a batch of them.
const PACKETS: Objects = Objects::List(1, 8);
/// A short list of candidates, and a long one.
const NODES: Objects = Objects::List(16, 64);

/// The kernels in this file.
pub fn kernels() -> Vec<Kernel> {
    vec![
        Kernel::of([case("packets", PACKETS, |count| {
            let corners = (0..count).map(|packet| [4 * packet, 0]).collect();
            PrimaryRays { view: view(), corners, pixels: 0 }
        })])
        .error(primary_rays_error),
        Kernel::of::<SampleRays>([case("packets", PACKETS, |count| {
            let pixels = (0..4 * count).map(|at| pixel([at, 0])).collect();
            samples(view().basis, pixels, 2)
        })])
        .error(sample_rays_error),
        Kernel::of([case("packets", PACKETS, |count| {
            let count = 16 * count as usize;
            let queue = vec![QUEUED; count];
            LoadRays { queue, count, background: 0, dummy: 0 }
        })]),
        Kernel::of([case("packets", PACKETS, |count| Origins {
            packets: vec![rays(); count as usize],
        })]),
        Kernel::of([case("packets", PACKETS, |count| Fans {
            packets: vec![rays(); count as usize],
            point: Point::EYE,
        })]),
        Kernel::of([case("packets", Objects::List(4, 8), |count| {
            let packets = vec![rays(); count as usize];
            PathBounds::of(packets, true)
        })]),
        Kernel::of([case("paths and one node", NODES, |count| {
            let path = path(&rays(), &bound(&rays()), &[0; 16], true, 0);
            let nodes = vec![[child(sphere(BESIDE)); 4]];
            PathsMeet { paths: vec![path; count as usize], nodes }
        })]),
        Kernel::of::<CullFaces>([
            left_out(|count| cull_faces(-1.0, count)),
            kept(|count| cull_faces(1.0, count)),
        ]),
        Kernel::of::<CullNodes<BareSphere>>([
            left_out(|count| cull_nodes(sphere(BESIDE), count)),
            kept(|count| cull_nodes(sphere(AHEAD), count)),
        ]),
        Kernel::of::<FilterChildren<BareSphere>>([
            left_out(|count| filter_children(sphere(BESIDE), count)),
            kept(|count| filter_children(sphere(AHEAD), count)),
        ]),
        Kernel::of::<CullNodes<BareBox>>([
            left_out(|count| cull_nodes(cube(BESIDE), count)),
            kept(|count| cull_nodes(cube(AHEAD), count)),
        ]),
        Kernel::of::<FilterChildren<BareBox>>([
            left_out(|count| filter_children(cube(BESIDE), count)),
            kept(|count| filter_children(cube(AHEAD), count)),
        ]),
    ]
}

/// Where volumes are that no ray of the cases meets, and that all meet.
const BESIDE: [f64; 3] = [0.0, 50.0, -50.0];
const AHEAD: [f64; 3] = [0.0, 0.0, -50.0];

fn left_out<D>(inputs: fn(u32) -> D) -> CaseOf<D> {
    case("all left out", NODES, inputs)
}

fn kept<D>(inputs: fn(u32) -> D) -> CaseOf<D> {
    case("all kept", NODES, inputs)
}

/// The camera of the cases, which looks along -z.
fn view() -> View {
    View {
        basis: Basis {
            corner: [-0.5, 0.5, -1.0].map(from_f64),
            right: [0.001, 0.0, 0.0].map(from_f64),
            down: [0.0, -0.001, 0.0].map(from_f64),
        },
        background: 0,
        width: 1000,
        height: 1000,
    }
}

const QUEUED: Queued =
    Queued { origin: [ONE; 3], weight: ONE, direction: [ZERO, ZERO, ONE], pixel: 0 };

/// Rays close to -z.
fn rays() -> [Ray; 16] {
    std::array::from_fn(|lane| {
        let step = |at: usize| (at as f64 - 1.5) * 0.01;
        Ray {
            origin: [ZERO; 3],
            direction: unit([step(lane % 4), step(lane / 4), -1.0]).map(from_f64),
            t: FARTHEST,
            object: 0,
            weight: ONE,
            pixel: 0,
        }
    })
}

/// Candidates of one packet and nodes with four equal children.
fn cull_nodes<V: Volume>(volume: V, count: u32) -> CullNodes<V> {
    let pairs = vec![[0, 0]; count as usize];
    let (nodes, bounds) = (vec![[child(volume); 4]], vec![bound(&rays())]);
    CullNodes { nodes, bounds, pairs, what: Listed::Address }
}

/// Candidates of one packet and the four equal children of nodes.
fn filter_children<V: Volume>(volume: V, count: u32) -> FilterChildren<V> {
    let pairs = vec![[0, 0]; count as usize / 4];
    let (nodes, bounds) = (vec![[child(volume); 4]], vec![bound(&rays())]);
    FilterChildren { nodes, bounds, packets: vec![rays()], pairs, in_place: false }
}

/// A child whose address doesn't matter.
fn child<V>(volume: V) -> Child<V> {
    Child { volume, address: 0 }
}

/// A sphere of radius 1.
fn sphere(centre: [f64; 3]) -> BareSphere {
    BareSphere { centre: centre.map(from_f64), radius: ONE }
}

/// A cube around it.
fn cube(centre: [f64; 3]) -> BareBox {
    BareBox { centre: centre.map(from_f64), half: [ONE; 3] }
}

/// Candidates of one packet and a face in front of the rays, whose normal has this z.
fn cull_faces(z: f64, count: u32) -> CullFaces {
    let face = Face {
        point: [0.0, 0.0, -5.0].map(from_f64),
        normal: [0.0, 0.0, z].map(from_f64),
        leave: ZERO,
        both: false,
    };
    let pairs = vec![[0, 0]; count as usize];
    let (faces, bounds) = (vec![face], vec![bound(&rays())]);
    CullFaces { faces, bounds, pairs, along: ONE }
}

/// Samples of pixels, before a background that doesn't matter.
fn samples(basis: Basis, pixels: Vec<Pixel>, across: u32) -> SampleRays {
    SampleRays { basis, background: 0, pixels, across }
}

/// A pixel whose sum doesn't matter.
fn pixel([x, y]: [u32; 2]) -> Pixel {
    Pixel { sum: 0, x: x as i32, y: y as i32 }
}

/// The largest error of a direction's component, in ulps of 1.
fn sample_rays_error(bench: &mut Bench, random: &mut ChaCha8Rng) -> f64 {
    let errors = (0..1000).map(|_| {
        let basis = camera(random);
        let at = [0; 2].map(|_: u32| random.random_range(0..8192));
        let packets = samples(basis, vec![pixel(at); 4], 4).call(bench);
        let points = std::array::from_fn(|lane| {
            let offset = sample(4, [lane as u32 % 4, lane as u32 / 4]);
            [0, 1].map(|axis| f64::from(at[axis]) + offset[axis])
        });
        error_of_directions_through(&basis, &points, &packets[0].map(|ray| ray.direction))
    });
    errors.fold(0.0, f64::max)
}

/// The largest error of a direction's component, in ulps of 1.
fn primary_rays_error(bench: &mut Bench, random: &mut ChaCha8Rng) -> f64 {
    let errors = (0..1000).map(|_| {
        let basis = camera(random);
        let corner = [0; 2].map(|_: u32| random.random_range(0..2048) * 4);
        let view = View { basis, ..view() };
        let packets = PrimaryRays { view, corners: vec![corner], pixels: 0 }.call(bench);
        let directions = packets[0].map(|ray| ray.direction);
        error_of_directions(&basis, corner, &directions)
    });
    errors.fold(0.0, f64::max)
}
