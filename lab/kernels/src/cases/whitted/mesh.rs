//! The kernels that trace packets through blocks of meshes.

pub mod call;

use rand_chacha::ChaCha8Rng;
use spu_emulator::float::single::{from_f64, to_f64};
use twins::mesh::{Corners, MeshBound, mesh_bound};
use twins::mesh_pairs::MeshBlock;
use twins::primary_rays::Ray;
use twins::{FARTHEST, ONE, ZERO, sphere_ray};
use zerocopy::FromZeros as _;

use super::isect;
use super::isect::error::SCALES;
use super::isect::shape::Shape as _;
use super::isect::triangle::TriangleObject;
use crate::bench::Bench;
use crate::cases::sphere_ray::case_rays;
use crate::catalogue::{Case, Kernel, Objects};
use call::Node;
use protocol::layout;

/// One packet, and a batch of them.
const PACKETS: Objects = Objects::List(1, 8);
/// A short list of candidates, and a long one.
const NODES: Objects = Objects::List(16, 64);
/// The same of triangles, in runs of four.
const TRIANGLES: Objects = Objects::List(16, 64);
/// Packets over which an error is measured.
const TESTED: u32 = 600;

/// The kernels in this file.
pub const KERNELS: &[Kernel] = &[
    Kernel {
        name: "mesh_bounds_r16",
        rays: 16,
        cases: &[Case {
            name: "packets",
            objects: PACKETS,
            place: |bench, count| bounds(bench, count),
        }],
        error: None,
    },
    Kernel {
        name: "mesh_farthest_r16",
        rays: 16,
        cases: &[Case {
            name: "packets",
            objects: PACKETS,
            place: |bench, count| bounds(bench, count)[..3].to_vec(),
        }],
        error: None,
    },
    nodes("cull_boxes"),
    nodes("filter_boxes_r16"),
    Kernel {
        name: "isect_mesh_pairs_r16",
        rays: 16,
        cases: &[
            Case {
                name: "all miss",
                objects: TRIANGLES,
                place: |bench, count| triangles(bench, 9.0, count),
            },
            Case {
                name: "all hit, each nearer",
                objects: TRIANGLES,
                place: |bench, count| triangles(bench, 0.0, count),
            },
        ],
        error: Some(error),
    },
];

/// The row of a kernel that tests nodes with packets.
const fn nodes(name: &'static str) -> Kernel {
    Kernel {
        name,
        rays: 16,
        cases: &[
            Case {
                name: "all left out",
                objects: NODES,
                place: |bench, count| candidates(bench, 50.0, count),
            },
            Case {
                name: "all kept",
                objects: NODES,
                place: |bench, count| candidates(bench, 0.0, count),
            },
        ],
        error: None,
    }
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

fn bounds(bench: &mut Bench, count: u32) -> Vec<u32> {
    let before = vec![layout::MeshBound::new_zeroed(); count as usize];
    call::put_for_bounds(bench, &vec![rays(); count as usize], &before, 0).1
}

/// Candidates of one packet and a node with four equal boxes, in front of the rays or above them.
fn candidates(bench: &mut Bench, y: f64, count: u32) -> Vec<u32> {
    let corners: Corners =
        [[-5.0, y - 5.0, -60.0], [5.0, y + 5.0, -50.0]].map(|corner| corner.map(from_f64));
    let node = Node {
        boxes: [corners; 4],
        words: [ZERO; 4],
    };
    let packet: ([Ray; 16], MeshBound) = (rays(), mesh_bound(&rays()));
    let pairs = vec![[0, 0]; count as usize];
    call::put_candidates(bench, &[node], &[packet], &pairs, 0).arguments
}

/// Runs of four triangles, each one nearer than the one before, for this many triangles in all.
fn triangles(bench: &mut Bench, x: f64, count: u32) -> Vec<u32> {
    let faces = [20.0, 15.0, 10.0, 5.0].map(|distance| TriangleObject::ahead(x, distance));
    let block = MeshBlock {
        number: 1,
        both: false,
        vertices: faces.iter().flat_map(|face| face.vertices).collect(),
        faces: (0..4)
            .map(|face| [3 * face, 3 * face + 1, 3 * face + 2])
            .collect(),
    };
    let rays = case_rays().map(|ray| sphere_ray::Ray { t: FARTHEST, ..ray });
    let packets = vec![isect::call::packet(&rays, 0); count as usize / 4];
    let runs: Vec<_> = (0..packets.len()).map(|packet| (0..4, packet)).collect();
    call::put_runs(bench, &packets, &block, &runs, 0).1
}

/// The largest error of t in ulps. Infinite for a missed or a false hit.
fn error(bench: &mut Bench, random: &mut ChaCha8Rng) -> f64 {
    let mut worst = 0.0_f64;
    for _ in 0..TESTED {
        for scale in SCALES {
            let (object, rays) = TriangleObject::around(random, scale);
            let block = MeshBlock {
                number: 0,
                both: object.both,
                vertices: object.vertices.to_vec(),
                faces: vec![[0, 1, 2]],
            };
            let after = call::isect_runs(bench, &[rays], &block, &[(0..1, 0)], 0);
            for (ray, after) in rays.iter().zip(isect::call::rays(&after[0])) {
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
