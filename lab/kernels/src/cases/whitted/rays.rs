//! The kernels that make packets of rays, and those that cull objects that no ray of a packet can
//! hit.

pub mod call;
pub mod faces;
pub mod fans;

use rand::Rng as _;
use rand_chacha::ChaCha8Rng;
use spu_emulator::float::single::from_f64;
use twins::bound::{Bound, bound};
use twins::cull_faces::Face;
use twins::load_rays::Queued;
use twins::primary_rays::{Ray, View};
use twins::ray_setup::Basis;
use twins::sample_rays::{Pixel, sample};
use twins::{FARTHEST, ONE, ZERO};

use crate::bench::Bench;
use crate::cases::eye::error::{camera, error_of_directions, error_of_directions_through};
use crate::cases::sphere_ray::unit;
use crate::catalogue::{Case, Kernel, Objects};
use call::{BareBox, BareSphere, Child, Point, Volume};

/// One packet, and a batch of them.
const PACKETS: Objects = Objects::List(1, 8);
/// A short list of candidates, and a long one.
const NODES: Objects = Objects::List(16, 64);

/// The kernels in this file.
pub const KERNELS: &[Kernel] = &[
    Kernel {
        name: "primary_rays_r16",
        rays: 16,
        cases: &[Case {
            name: "packets",
            objects: PACKETS,
            place: |bench, count| {
                let corners: Vec<[u32; 2]> = (0..count).map(|packet| [4 * packet, 0]).collect();
                call::put_primary_rays(bench, &view(), &corners, 0).1
            },
        }],
        error: Some(primary_rays_error),
    },
    Kernel {
        name: "sample_rays_r16",
        rays: 16,
        cases: &[Case {
            name: "packets",
            objects: PACKETS,
            place: |bench, count| {
                let pixels: Vec<_> = (0..4 * count).map(|at| pixel([at, 0])).collect();
                call::put_sample_rays(bench, &view().basis, 0, &pixels, 2).1
            },
        }],
        error: Some(sample_rays_error),
    },
    Kernel {
        name: "load_rays_r16",
        rays: 16,
        cases: &[Case {
            name: "packets",
            objects: PACKETS,
            place: |bench, count| {
                let queue = vec![QUEUED; 16 * count as usize];
                call::put_queue(bench, &queue, 16 * count, 0, 0).1
            },
        }],
        error: None,
    },
    Kernel {
        name: "bound_origins_r16",
        rays: 16,
        cases: &[Case {
            name: "packets",
            objects: PACKETS,
            place: |bench, count| {
                let bounds = vec![bound(&rays()); count as usize];
                call::put_for_bounds(bench, &vec![rays(); count as usize], &bounds).1
            },
        }],
        error: None,
    },
    Kernel {
        name: "bound_fan_r16",
        rays: 16,
        cases: &[Case {
            name: "packets",
            objects: PACKETS,
            place: |bench, count| call::put_for_fans(bench, &vec![rays(); count as usize], &EYE).1,
        }],
        error: None,
    },
    Kernel {
        name: "cull_faces",
        rays: 16,
        cases: &[
            Case {
                name: "all left out",
                objects: NODES,
                place: |bench, count| cull_faces(bench, -1.0, count),
            },
            Case {
                name: "all kept",
                objects: NODES,
                place: |bench, count| cull_faces(bench, 1.0, count),
            },
        ],
        error: None,
    },
    Kernel {
        name: "cull_nodes",
        rays: 16,
        cases: &[
            Case {
                name: "all left out",
                objects: NODES,
                place: |bench, count| cull_nodes(bench, sphere([0.0, 50.0, -50.0]), count),
            },
            Case {
                name: "all kept",
                objects: NODES,
                place: |bench, count| cull_nodes(bench, sphere([0.0, 0.0, -50.0]), count),
            },
        ],
        error: None,
    },
    Kernel {
        name: "filter_children_r16",
        rays: 16,
        cases: &[
            Case {
                name: "all left out",
                objects: NODES,
                place: |bench, count| filter_children(bench, sphere([0.0, 50.0, -50.0]), count),
            },
            Case {
                name: "all kept",
                objects: NODES,
                place: |bench, count| filter_children(bench, sphere([0.0, 0.0, -50.0]), count),
            },
        ],
        error: None,
    },
    Kernel {
        name: "cull_box_nodes",
        rays: 16,
        cases: &[
            Case {
                name: "all left out",
                objects: NODES,
                place: |bench, count| cull_nodes(bench, cube([0.0, 50.0, -50.0]), count),
            },
            Case {
                name: "all kept",
                objects: NODES,
                place: |bench, count| cull_nodes(bench, cube([0.0, 0.0, -50.0]), count),
            },
        ],
        error: None,
    },
    Kernel {
        name: "filter_box_children_r16",
        rays: 16,
        cases: &[
            Case {
                name: "all left out",
                objects: NODES,
                place: |bench, count| filter_children(bench, cube([0.0, 50.0, -50.0]), count),
            },
            Case {
                name: "all kept",
                objects: NODES,
                place: |bench, count| filter_children(bench, cube([0.0, 0.0, -50.0]), count),
            },
        ],
        error: None,
    },
];

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

/// A queued ray.
const QUEUED: Queued =
    Queued { origin: [ONE; 3], weight: ONE, direction: [ZERO, ZERO, ONE], pixel: 0 };

/// The origin of the cases' rays.
const EYE: Point = Point { place: [ZERO; 3], near: ZERO, along: ONE };

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
fn cull_nodes(bench: &mut Bench, volume: impl Volume, count: u32) -> Vec<u32> {
    let pairs = vec![[0, 0]; count as usize];
    let bounds: [Bound; 1] = [bound(&rays())];
    call::put_candidates(bench, &[[child(volume); 4]], &bounds, None, &pairs).arguments
}

/// Candidates of one packet and the four equal children of nodes.
fn filter_children(bench: &mut Bench, volume: impl Volume, count: u32) -> Vec<u32> {
    let pairs = vec![[0, 0]; count as usize / 4];
    let packets = [rays()];
    let bounds: [Bound; 1] = [bound(&rays())];
    let nodes = [[child(volume); 4]];
    call::put_candidates(bench, &nodes, &bounds, Some(&packets), &pairs).arguments
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
fn cull_faces(bench: &mut Bench, z: f64, count: u32) -> Vec<u32> {
    let face = Face {
        point: [0.0, 0.0, -5.0].map(from_f64),
        normal: [0.0, 0.0, z].map(from_f64),
        leave: ZERO,
        both: false,
    };
    let bounds: [Bound; 1] = [bound(&rays())];
    let pairs = vec![[0, 0]; count as usize];
    faces::put(bench, &[face], &bounds, &pairs, ONE).arguments
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
        let packets = call::sample_rays(bench, &basis, 0, &[pixel(at); 4], 4);
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
        let packets = call::primary_rays(bench, &View { basis, ..view() }, &[corner], 0);
        let directions = packets[0].map(|ray| ray.direction);
        error_of_directions(&basis, corner, &directions)
    });
    errors.fold(0.0, f64::max)
}
