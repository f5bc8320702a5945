//! The kernels that trace packets through blocks of meshes.

pub mod block;
pub mod bounds;
pub mod boxes;
pub mod build;
pub mod call;
pub mod objects;
pub mod patches;
pub mod rays;
pub mod sort;
pub mod triangles;

use spu_emulator::float::single::fs;
use twins::mesh::{Corners, mesh_bound};
use twins::mesh_pairs::MeshBlock;
use twins::mesh_prepare::{CONES, INNER, LEAF, SPHERES};
use twins::mesh_rays::Visit;
use twins::mesh_rows::mesh_window;
use twins::primary_rays::Ray;
use twins::sphere_ray;

use super::isect::error::SCALES;
use super::isect::shape::Shape as _;
use super::isect::triangle::TriangleObject;
use crate::cases::sphere_ray::case_rays;
use crate::prelude::*;
use block::Prepare;
use bounds::{Bounds, EyeBounds, Farthest};
use boxes::Boxed;
use build::{Leaf, Sources};
use call::Node;
use objects::{BoxObjects, PackObjects};
use patches::{FlatPatches, ListHits};
use protocol::layout::{BUILD_CONE, MESH_HIT};
use rays::{Alive, Batch, FewRays, FilterRays, Records, Visits};
use sort::{Codes, CornerList, Pack, Sort};
use triangles::{FilterTriangles, IsectRows, IsectRuns, Rows};

/// One packet, and a batch of them.
const PACKETS: Objects = Objects::List(1, 8);
/// A short list of candidates, and a long one.
const NODES: Objects = Objects::List(16, 64);
/// The same of triangles, in runs of four.
const TRIANGLES: Objects = Objects::List(16, 64);
/// Packets over which an error is measured.
const TESTED: u32 = 600;

/// The kernels in this file.
pub fn kernels() -> Vec<Kernel> {
    vec![
        Kernel::of([case("78 triangles", Objects::Fixed(1), |_| Leaf::full())]).rays(1),
        Kernel::of([case("runs in fours", Objects::List(4, 16), |count| {
            let sources = vec![[0; 4]; count as usize];
            Sources { sources, low: 0, vertices: 1, count: 0 }
        })])
        .rays(1),
        Kernel::of([case("triangles in twos", Objects::List(4, 16), |count| {
            CornerList::in_a_row(count as usize)
        })])
        .rays(1),
        Kernel::of([case("triangles in fours", Objects::List(4, 16), |count| {
            Codes::in_a_row(count as usize)
        })])
        .rays(1),
        Kernel::of([case("triangles in fours", Objects::List(16, 64), |count| {
            Sort::in_a_row(count as usize)
        })])
        .rays(1),
        Kernel::of([case("a strip of triangles", Objects::Fixed(1), |_| Pack::strip(100))]).rays(1),
        Kernel::of([case("30 spheres", Objects::Fixed(1), |_| PackObjects::spheres(30))]).rays(1),
        Kernel::of([
            case("16 spheres", Objects::Fixed(1), |_| BoxObjects::of(16, 0)),
            case("16 cones", Objects::Fixed(1), |_| BoxObjects::of(16, BUILD_CONE)),
        ])
        .rays(1),
        Kernel::of([case("packets", PACKETS, |count| Bounds {
            packets: packets(count),
            shears: 0,
        })]),
        Kernel::of([case("packets", PACKETS, |count| {
            let bounds = vec![mesh_bound(&rays()); count as usize];
            Farthest { packets: packets(count), bounds }
        })]),
        Kernel::of([case("packets", PACKETS, |count| Records { packets: packets(count) })]),
        Kernel::of([case("packets", PACKETS, |count| Alive {
            packets: packets(count),
            near: ZERO,
            bits: u128::MAX,
        })]),
        Kernel::of::<FilterRays>([
            case("all miss", PACKETS, |count| filter(count, 50.0)),
            case("all meet", PACKETS, |count| filter(count, 0.0)),
        ]),
        Kernel::of([case("all meet", Objects::List(4, 16), |count| {
            let nodes = vec![node(0.0); count as usize];
            let batch = Batch { packets: packets(1), nodes, bits: 1 << 120 };
            FewRays { batch, base: 0 }
        })])
        .rays(1),
        Kernel::of([case("visits of two packets", Objects::List(4, 16), |count| {
            let visit = Visit { child: 4, near: ONE, rays: 1 << 120 | 1 << 30 };
            Visits { visits: vec![visit; count as usize], base: 0 }
        })]),
        Kernel::of::<Prepare>([
            case("inner block", Objects::Fixed(1), |_| arrived(INNER)),
            case("triangles", Objects::Fixed(1), |_| arrived(LEAF)),
            case("spheres", Objects::Fixed(1), |_| arrived(SPHERES)),
            case("cones", Objects::Fixed(1), |_| arrived(CONES)),
        ])
        .rays(1),
        nodes::<false>(),
        nodes::<true>(),
        Kernel::of::<IsectRuns>([
            case("all miss", TRIANGLES, |count| runs(9.0, count)),
            case("all hit, each nearer", TRIANGLES, |count| runs(0.0, count)),
        ])
        .error(|bench, random| error(bench, random, from_anywhere, |aimed| aimed)),
        Kernel::of([case("packets", PACKETS, |count| EyeBounds {
            packets: vec![case_rays(); count as usize],
        })]),
        Kernel::of::<FilterTriangles>([
            case("all left out", TRIANGLES, |count| filtered(9.0, count)),
            case("all kept", TRIANGLES, |count| filtered(0.0, count)),
        ]),
        Kernel::of::<IsectRows>([
            case("all miss", TRIANGLES, |count| rows(9.0, count)),
            case("all hit, each nearer", TRIANGLES, |count| rows(0.0, count)),
        ])
        .rays(4)
        .error(|bench, random| error(bench, random, from_the_eye, relative_to_the_eye)),
        Kernel::of([case("packets", PACKETS, |count| {
            let hits: [u32; 16] = std::array::from_fn(|ray| MESH_HIT + ray as u32);
            ListHits { objects: vec![hits; count as usize] }
        })]),
        Kernel::of([case("all there", TRIANGLES, |count| {
            let objects = (0..count).map(|at| MESH_HIT + (1 << 7) + at % 4).collect();
            let leaves = vec![one_behind_another(0.0)];
            FlatPatches { objects, leaves, anything: 0 }
        })])
        .rays(1)
        .error(patch_error),
    ]
}

/// The row of a kernel that tests nodes with packets.
fn nodes<const EVERY: bool>() -> Kernel {
    Kernel::of::<Boxed<EVERY>>([
        case("all left out", NODES, |count| boxed::<EVERY>(50.0, count)),
        case("all kept", NODES, |count| boxed::<EVERY>(0.0, count)),
    ])
}

/// The rays of the cases, close to -z.
fn rays() -> [Ray; 16] {
    case_rays().map(|ray| Ray {
        origin: ray.origin,
        direction: ray.direction,
        t: FARTHEST,
        object: 0,
        weight: ONE,
        pixel: 0,
    })
}

fn packets(count: u32) -> Vec<[Ray; 16]> {
    vec![rays(); count as usize]
}

/// A node with four equal boxes, in front of the rays or above them.
fn node(y: f64) -> Node {
    let corners: Corners =
        [[-5.0, y - 5.0, -60.0], [5.0, y + 5.0, -50.0]].map(|corner| corner.map(from_f64));
    Node { boxes: [corners; 4], words: [4; 4] }
}

/// All rays of this number of packets, and one node.
fn filter(count: u32, y: f64) -> FilterRays {
    let bits = u128::MAX << (128 - 16 * count);
    FilterRays(Batch { packets: packets(count), nodes: vec![node(y)], bits })
}

/// A block with eight lowest nodes.
fn arrived(kind: u32) -> Prepare {
    let mut random = ChaCha8Rng::seed_from_u64(0);
    let (block, known) = block::block(kind, 8, [0.0; 3], 10.0, &mut random);
    Prepare { block, known }
}

/// Candidates of one packet and a node with four equal boxes, in front of the rays or above them.
fn boxed<const EVERY: bool>(y: f64, count: u32) -> Boxed<EVERY> {
    let node = Node { words: [ZERO; 4], ..node(y) };
    let packets = vec![(rays(), mesh_bound(&rays()))];
    Boxed { nodes: vec![node], packets, pairs: vec![[0, 0]; count as usize], base: 0 }
}

/// A block of four triangles, each one nearer than the one before.
fn one_behind_another(x: f64) -> MeshBlock {
    let faces = [20.0, 15.0, 10.0, 5.0].map(|distance| TriangleObject::ahead(x, distance));
    MeshBlock {
        number: 1,
        both: false,
        vertices: faces.iter().flat_map(|face| face.vertices).collect(),
        faces: (0..4).map(|face| [3 * face, 3 * face + 1, 3 * face + 2]).collect(),
    }
}

fn straight() -> [sphere_ray::Ray; 16] {
    case_rays().map(|ray| sphere_ray::Ray { t: FARTHEST, ..ray })
}

/// Runs of these four triangles, for this many triangles in all.
fn runs(x: f64, count: u32) -> IsectRuns {
    let packets = vec![straight(); count as usize / 4];
    let runs = (0..packets.len()).map(|packet| (0..4, packet)).collect();
    IsectRuns { packets, block: one_behind_another(x), runs, anything: 0 }
}

/// The same runs with a packet from the eye.
fn filtered(x: f64, count: u32) -> FilterTriangles {
    let windows = vec![mesh_window(&straight())];
    let runs = vec![(0..4, 0); count as usize / 4];
    FilterTriangles { windows, block: one_behind_another(x), runs, anything: 0 }
}

/// Rows that may hit these triangles, a quarter of a packet's rows with each.
fn rows(x: f64, count: u32) -> IsectRows {
    let packets = vec![straight(); count as usize / 4];
    let rows = (0..count as usize).map(|at| Rows {
        triangle: at % 4,
        rows: std::array::from_fn(|row| row == at % 4),
        packet: at / 4,
    });
    IsectRows { packets, block: one_behind_another(x), rows: rows.collect(), anything: 0 }
}

/// A triangle, and rays to it and around it.
type Aimed = (TriangleObject, [sphere_ray::Ray; 16]);

/// Their change before the test.
type From = fn(Aimed) -> Aimed;

/// With the rays' origin, which is that of all, as the eye.
#[must_use]
pub fn relative_to_the_eye((object, rays): Aimed) -> Aimed {
    let eye = rays[0].origin;
    let relative = |vertex: [Single; 3]| std::array::from_fn(|axis| fs(vertex[axis], eye[axis]));
    let object = TriangleObject { vertices: object.vertices.map(relative), ..object };
    let rays = rays.map(|ray| sphere_ray::Ray { origin: [ZERO; 3], ..ray });
    (object, rays)
}

/// Tests a packet with a triangle, the only one of a block. Returns the packet.
type Test = fn(&mut Bench, &[sphere_ray::Ray; 16], &MeshBlock) -> [Ray; 16];

fn from_anywhere(bench: &mut Bench, rays: &[sphere_ray::Ray; 16], block: &MeshBlock) -> [Ray; 16] {
    let (packets, runs) = (vec![*rays], vec![(0..1, 0)]);
    IsectRuns { packets, block: block.clone(), runs, anything: 0 }.call(bench)[0]
}

fn from_the_eye(bench: &mut Bench, rays: &[sphere_ray::Ray; 16], block: &MeshBlock) -> [Ray; 16] {
    let (packets, all) = (vec![*rays], Rows { triangle: 0, rows: [true; 4], packet: 0 });
    IsectRows { packets, block: block.clone(), rows: vec![all], anything: 0 }.call(bench)[0]
}

/// The largest error of t in ulps. Infinite for a missed or a false hit.
fn error(bench: &mut Bench, random: &mut ChaCha8Rng, test: Test, from: From) -> f64 {
    let mut worst = 0.0_f64;
    for _ in 0..TESTED {
        for scale in SCALES {
            let (object, rays) = from(TriangleObject::around(random, scale));
            let block = MeshBlock {
                number: 0,
                both: object.both,
                vertices: object.vertices.to_vec(),
                faces: vec![[0, 1, 2]],
            };
            let after = test(bench, &rays, &block);
            for (ray, after) in rays.iter().zip(after) {
                let truth = object.truth(ray);
                let found = (after.object == block.hit(0)).then(|| to_f64(after.t));
                match (found, truth.t) {
                    (Some(found), Some(t)) if truth.counts => {
                        worst = worst.max((found - t).abs() / truth.unit);
                    }
                    (None, Some(_)) | (Some(_), None) if truth.sure => worst = f64::INFINITY,
                    _ => {}
                }
            }
        }
    }
    worst
}

/// The largest error of a component of the normal, in ulps of 1. The length of the normal is twice
/// the triangle's area before it becomes 1.
fn patch_error(bench: &mut Bench, random: &mut ChaCha8Rng) -> f64 {
    let mut worst = 0.0_f64;
    for _ in 0..TESTED {
        for scale in SCALES {
            let (object, _) = TriangleObject::around(random, scale);
            let [a, b, c] = object.vertices.map(|vertex| vertex.map(to_f64));
            let edges = [sub(b, a), sub(c, a), sub(c, b)];
            let across = cross(edges[0], edges[1]);
            let longest = edges.map(|edge| dot(edge, edge)).into_iter();
            if dot(across, across).sqrt() < longest.fold(0.0, f64::max) / 20.0 {
                continue;
            }
            let normal = unit(across);
            let block = MeshBlock {
                number: 5,
                both: object.both,
                vertices: object.vertices.to_vec(),
                faces: vec![[0, 1, 2]],
            };
            let objects = vec![MESH_HIT + (5 << 7)];
            let (_, made) = FlatPatches { objects, leaves: vec![block], anything: 0 }.call(bench);
            for (found, axis) in made[0].0.axis.iter().zip(normal) {
                worst = worst.max((f64::from(found.get()) - axis).abs() * 2_f64.powi(23));
            }
        }
    }
    worst
}
