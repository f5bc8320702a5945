//! The kernels that trace packets through blocks of meshes.

pub mod block;
pub mod call;

use rand::SeedableRng as _;
use rand_chacha::ChaCha8Rng;
use spu_emulator::float::single::{from_f64, fs, to_f64};
use twins::mesh::{Corners, MeshBound, mesh_bound};
use twins::mesh_pairs::MeshBlock;
use twins::mesh_prepare::{CONES, INNER, LEAF, SPHERES};
use twins::mesh_rays::Visit;
use twins::mesh_rows::mesh_window;
use twins::primary_rays::Ray;
use twins::{FARTHEST, ONE, Single, ZERO, sphere_ray};
use zerocopy::FromZeros as _;

use super::isect;
use super::isect::error::SCALES;
use super::isect::shape::Shape as _;
use super::isect::triangle::TriangleObject;
use crate::bench::Bench;
use crate::cases::sphere_ray::case_rays;
use crate::catalogue::{Case, Kernel, Objects};
use crate::vector::{cross, dot, sub, unit};
use call::{Node, Rows};
use protocol::layout::{self, MESH_HIT};

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
        equal: None,
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
        equal: None,
    },
    Kernel {
        name: "mesh_rays_r16",
        rays: 16,
        cases: &[Case {
            name: "packets",
            objects: PACKETS,
            place: |bench, count| call::put_for_rays(bench, &vec![rays(); count as usize]).1,
        }],
        error: None,
        equal: None,
    },
    Kernel {
        name: "mesh_alive_r16",
        rays: 16,
        cases: &[Case {
            name: "packets",
            objects: PACKETS,
            place: |bench, count| {
                call::put_for_alive(bench, &vec![rays(); count as usize], ZERO, u128::MAX).1
            },
        }],
        error: None,
        equal: None,
    },
    Kernel {
        name: "mesh_filter_rays",
        rays: 16,
        cases: &[
            Case {
                name: "all miss",
                objects: PACKETS,
                place: |bench, count| filter(bench, 50.0, count),
            },
            Case {
                name: "all meet",
                objects: PACKETS,
                place: |bench, count| filter(bench, 0.0, count),
            },
        ],
        error: None,
        equal: None,
    },
    Kernel {
        name: "mesh_few_rays",
        rays: 1,
        cases: &[Case {
            name: "all meet",
            objects: Objects::List(4, 16),
            place: |bench, count| few(bench, count),
        }],
        error: None,
        equal: None,
    },
    Kernel {
        name: "mesh_candidates",
        rays: 16,
        cases: &[Case {
            name: "visits of two packets",
            objects: Objects::List(4, 16),
            place: |bench, count| visits(bench, count),
        }],
        error: None,
        equal: None,
    },
    Kernel {
        name: "mesh_prepare",
        rays: 1,
        cases: &[
            Case {
                name: "inner block",
                objects: Objects::Fixed(1),
                place: |bench, _| arrived(bench, INNER),
            },
            Case {
                name: "triangles",
                objects: Objects::Fixed(1),
                place: |bench, _| arrived(bench, LEAF),
            },
            Case {
                name: "spheres",
                objects: Objects::Fixed(1),
                place: |bench, _| arrived(bench, SPHERES),
            },
            Case {
                name: "cones",
                objects: Objects::Fixed(1),
                place: |bench, _| arrived(bench, CONES),
            },
        ],
        error: None,
        equal: None,
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
        error: Some(|bench, random| error(bench, random, from_anywhere, |aimed| aimed)),
        equal: None,
    },
    Kernel {
        name: "mesh_eye_bounds_r16",
        rays: 16,
        cases: &[Case {
            name: "packets",
            objects: PACKETS,
            place: |bench, count| {
                let packets = vec![case_rays(); count as usize];
                call::put_for_eye_bounds(bench, &packets, 0).2
            },
        }],
        error: None,
        equal: None,
    },
    Kernel {
        name: "filter_triangles_r16",
        rays: 16,
        cases: &[
            Case {
                name: "all left out",
                objects: TRIANGLES,
                place: |bench, count| filtered(bench, 9.0, count),
            },
            Case {
                name: "all kept",
                objects: TRIANGLES,
                place: |bench, count| filtered(bench, 0.0, count),
            },
        ],
        error: None,
        equal: None,
    },
    Kernel {
        name: "isect_mesh_rows_r4",
        rays: 4,
        cases: &[
            Case {
                name: "all miss",
                objects: TRIANGLES,
                place: |bench, count| rows_of_triangles(bench, 9.0, count),
            },
            Case {
                name: "all hit, each nearer",
                objects: TRIANGLES,
                place: |bench, count| rows_of_triangles(bench, 0.0, count),
            },
        ],
        error: Some(|bench, random| error(bench, random, from_the_eye, relative_to_the_eye)),
        equal: None,
    },
    Kernel {
        name: "mesh_list_hits_r16",
        rays: 16,
        cases: &[Case {
            name: "packets",
            objects: PACKETS,
            place: |bench, count| {
                let hits: [u32; 16] = std::array::from_fn(|ray| MESH_HIT + ray as u32);
                call::put_for_hits(bench, &vec![hits; count as usize]).2
            },
        }],
        error: None,
        equal: None,
    },
    Kernel {
        name: "mesh_flat_patches",
        rays: 1,
        cases: &[Case {
            name: "all there",
            objects: TRIANGLES,
            place: |bench, count| {
                let hits: Vec<u32> = (0..count).map(|at| MESH_HIT + (1 << 7) + at % 4).collect();
                call::put_for_patches(bench, &hits, &[one_behind_another(0.0)], 0).2
            },
        }],
        error: Some(patch_error),
        equal: None,
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
        equal: None,
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

/// A node with four equal boxes, in front of the rays or above them.
fn node(y: f64) -> Node {
    let corners: Corners =
        [[-5.0, y - 5.0, -60.0], [5.0, y + 5.0, -50.0]].map(|corner| corner.map(from_f64));
    Node { boxes: [corners; 4], words: [4; 4] }
}

/// All rays of this number of packets, and one node.
fn filter(bench: &mut Bench, y: f64, count: u32) -> Vec<u32> {
    let bits = u128::MAX << (128 - 16 * count);
    call::put_for_filter(bench, &vec![rays(); count as usize], &[node(y)], bits).1
}

/// One ray, and this number of nodes.
fn few(bench: &mut Bench, count: u32) -> Vec<u32> {
    let nodes = vec![node(0.0); count as usize];
    call::put_for_few(bench, &[rays()], &nodes, 1 << 120, 0).2
}

/// Visits by rays of two packets.
fn visits(bench: &mut Bench, count: u32) -> Vec<u32> {
    let visit = Visit { child: 4, near: ONE, rays: 1 << 120 | 1 << 30 };
    call::put_for_candidates(bench, &vec![visit; count as usize], 0).1
}

/// A block with eight lowest nodes.
fn arrived(bench: &mut Bench, kind: u32) -> Vec<u32> {
    let mut random = ChaCha8Rng::seed_from_u64(0);
    let (block, known) = block::block(kind, 8, [0.0; 3], 10.0, &mut random);
    call::put_block(bench, &block, &known).1
}

/// Candidates of one packet and a node with four equal boxes, in front of the rays or above them.
fn candidates(bench: &mut Bench, y: f64, count: u32) -> Vec<u32> {
    let corners: Corners =
        [[-5.0, y - 5.0, -60.0], [5.0, y + 5.0, -50.0]].map(|corner| corner.map(from_f64));
    let node = Node { boxes: [corners; 4], words: [ZERO; 4] };
    let packet: ([Ray; 16], MeshBound) = (rays(), mesh_bound(&rays()));
    let pairs = vec![[0, 0]; count as usize];
    call::put_candidates(bench, &[node], &[packet], &pairs, 0).arguments
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

/// Runs of these four triangles, for this many triangles in all.
fn triangles(bench: &mut Bench, x: f64, count: u32) -> Vec<u32> {
    let rays = case_rays().map(|ray| sphere_ray::Ray { t: FARTHEST, ..ray });
    let packets = vec![isect::call::packet(&rays, 0); count as usize / 4];
    let runs: Vec<_> = (0..packets.len()).map(|packet| (0..4, packet)).collect();
    call::put_runs(bench, &packets, &one_behind_another(x), &runs, 0).1
}

/// The same runs with a packet from the eye.
fn filtered(bench: &mut Bench, x: f64, count: u32) -> Vec<u32> {
    let rays = case_rays().map(|ray| sphere_ray::Ray { t: FARTHEST, ..ray });
    let runs = vec![(0..4, 0); count as usize / 4];
    let windows = [mesh_window(&rays)];
    call::put_filter(bench, &windows, &one_behind_another(x), &runs, 0).1
}

/// Rows that may hit these triangles, a quarter of a packet's rows with each.
fn rows_of_triangles(bench: &mut Bench, x: f64, count: u32) -> Vec<u32> {
    let rays = case_rays().map(|ray| sphere_ray::Ray { t: FARTHEST, ..ray });
    let packets = vec![isect::call::packet(&rays, 0); count as usize / 4];
    let rows: Vec<_> = (0..count as usize)
        .map(|at| Rows {
            triangle: at % 4,
            rows: std::array::from_fn(|row| row == at % 4),
            packet: at / 4,
        })
        .collect();
    call::put_rows(bench, &packets, &one_behind_another(x), &rows, 0).1
}

/// A triangle, and rays to it and around it.
type Aimed = (TriangleObject, [sphere_ray::Ray; 16]);

/// A change to the triangle and its rays before the test.
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
type Test = fn(&mut Bench, &[sphere_ray::Ray; 16], &MeshBlock) -> layout::RayPacket;

fn from_anywhere(
    bench: &mut Bench,
    rays: &[sphere_ray::Ray; 16],
    block: &MeshBlock,
) -> layout::RayPacket {
    call::isect_runs(bench, &[*rays], block, &[(0..1, 0)], 0)[0]
}

fn from_the_eye(
    bench: &mut Bench,
    rays: &[sphere_ray::Ray; 16],
    block: &MeshBlock,
) -> layout::RayPacket {
    let all = Rows { triangle: 0, rows: [true; 4], packet: 0 };
    call::isect_rows(bench, &[*rays], block, &[all], 0)[0]
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
            for (ray, after) in rays.iter().zip(isect::call::rays(&after)) {
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
            let (_, made) = call::flat_patches(bench, &[MESH_HIT + (5 << 7)], &[block], 0);
            for (found, axis) in made[0][0].normal.iter().zip(normal) {
                worst = worst.max((to_f64(*found) - axis).abs() * 2_f64.powi(23));
            }
        }
    }
    worst
}
