//! `mesh_bounds_r16` together with `cull_boxes` and `filter_boxes_r16`: no box is left out that a
//! ray of the packet enters, by f64 from the singles of the records, or that holds a triangle which
//! the ray hits by the SPU's own arithmetic.

use kernels::cases::whitted::mesh::bounds::Bounds;
use kernels::cases::whitted::mesh::boxes::Boxed;
use kernels::cases::whitted::mesh::call::Node;
use kernels::cases::whitted::rays::fans::{self, FANS, Fan};
use kernels::prelude::*;
use twins::mesh::{Corners, MeshBound};
use twins::primary_rays::{ABSENT, Ray};
use twins::sphere_ray;
use twins::triangle_pairs::{TriangleObject, isect_triangle};

/// By how much a box must exceed what it holds, as a share of its largest coordinate.
pub(super) const SLACK: f64 = 1.0 / (1 << 19) as f64;
/// Scales of scenes.
const SCALES: std::ops::Range<f64> = 1e-6..1e9;
const NODES: usize = 16;
const PACKETS: usize = 200;

/// What the kernels did with the boxes of packets.
#[derive(Clone, Copy, Debug, Default)]
struct Outcome {
    tested: usize,
    met: usize,
    /// By each kernel.
    kept: [usize; 2],
    /// Met by a ray, but left out.
    lost: [usize; 2],
}

/// Which components of a packet's directions are special.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Axes {
    /// None.
    Any,
    /// One is 0 in all rays.
    Flat,
    /// Two are 0 in all rays.
    Parallel,
    /// Of each ray another one is 0, with either sign.
    Mixed,
    /// Of each ray another one is far below 2^-60, with either sign.
    Tiny,
}

pub(super) const AXES: [Axes; 5] = [Axes::Any, Axes::Flat, Axes::Parallel, Axes::Mixed, Axes::Tiny];

pub(super) fn packet(fan: Fan, axes: Axes, scale: f64, random: &mut ChaCha8Rng) -> [Ray; 16] {
    let mut rays = fans::packet(fan, scale, random);
    let axis = random.random_range(0..3);
    let sign = |lane: usize| (lane as u32 & 4) << 29;
    for (lane, ray) in rays.iter_mut().enumerate() {
        match axes {
            Axes::Any => {}
            Axes::Flat => ray.direction[axis] = ZERO,
            Axes::Parallel => {
                let sign = ray.direction[axis] & 1 << 31;
                ray.direction = [ZERO; 3];
                ray.direction[axis] = ONE | sign;
            }
            Axes::Mixed => ray.direction[lane % 3] = sign(lane),
            Axes::Tiny => ray.direction[lane % 3] = 0x1180_0000 | sign(lane),
        }
    }
    rays
}

fn at(ray: &Ray, distance: f64) -> Vector {
    std::array::from_fn(|axis| to_f64(ray.origin[axis]) + distance * to_f64(ray.direction[axis]))
}

/// A distance along a ray: that of its origin, of its end, or another one.
fn along(ray: &Ray, scale: f64, random: &mut ChaCha8Rng) -> f64 {
    let end = to_f64(ray.t).min(1000.0 * scale);
    match random.random_range(0..5) {
        0 => 0.0,
        1 => end,
        _ => end * random.random_range(0.0..1.0_f64).powi(random.random_range(1..8)),
    }
}

/// A box as large as those of a mesh, near a point of a ray.
fn beside(ray: &Ray, scale: f64, random: &mut ChaCha8Rng) -> Corners {
    let point = at(ray, random.random_range(0.0..10.0) * scale);
    let size = scale * magnitude(0.01..1.0, random);
    let away = in_cube(3.0 * size, random);
    [-size, size].map(|half| std::array::from_fn(|axis| from_f64(point[axis] + away[axis] + half)))
}

/// A box that touches a ray with a corner, an edge or a face, or almost does, or holds a point of
/// it. It may be flat.
pub(super) fn touching(ray: &Ray, scale: f64, random: &mut ChaCha8Rng) -> Corners {
    let point = at(ray, along(ray, scale, random));
    let size = scale * magnitude(1e-6..10.0, random);
    let sides: [[f64; 2]; 3] = std::array::from_fn(|axis| {
        let side = size * magnitude(1e-3..1.0, random);
        let hair = side * magnitude(1e-9..1e-2, random);
        let [down, up] = match random.random_range(0..6) {
            0 => [0.0, side],
            1 => [side, 0.0],
            2 => [-hair, side],
            3 => [side, -hair],
            4 => [0.0, 0.0],
            _ => [side * random.random_range(0.0..1.0), side],
        };
        [point[axis] - down, point[axis] + up]
    });
    [0, 1].map(|corner| std::array::from_fn(|axis| from_f64(sides[axis][corner])))
}

/// Whether a ray is in a box between its origin and its t.
pub(super) fn meets(ray: &Ray, [lower, upper]: &Corners) -> bool {
    let [mut from, mut to] = [0.0, to_f64(ray.t)];
    for axis in 0..3 {
        let planes = [lower, upper].map(|corner| to_f64(corner[axis]) - to_f64(ray.origin[axis]));
        let direction = to_f64(ray.direction[axis]);
        if direction == 0.0 {
            if planes[0] > 0.0 || planes[1] < 0.0 {
                return false;
            }
        } else {
            let times = planes.map(|plane| plane / direction);
            from = times[0].min(times[1]).max(from);
            to = times[0].max(times[1]).min(to);
        }
    }
    from <= to
}

/// The corners with a slack.
pub(super) fn widened(corners: &Corners, slack: f64) -> Corners {
    let values = corners.map(|corner| corner.map(to_f64));
    let largest = values.iter().flatten().fold(0.0_f64, |top, c| top.max(c.abs()));
    let moved = |corner: usize, way: f64| {
        std::array::from_fn(|axis| from_f64(values[corner][axis] + way * slack * largest))
    };
    [moved(0, -1.0), moved(1, 1.0)]
}

/// The list that a kernel makes of all these nodes.
fn listed<const EVERY: bool>(
    bench: &mut Bench,
    nodes: &[Node],
    packet: ([Ray; 16], MeshBound),
) -> Vec<[u32; 4]> {
    let pairs = (0..nodes.len()).map(|node| [node, 0]).collect();
    Boxed::<EVERY> { nodes: nodes.to_vec(), packets: vec![packet], pairs, base: 0 }.call(bench)
}

/// Runs the kernels on boxes, of which some are met by a ray.
fn outcome(
    bench: &mut Bench,
    rays: &[Ray; 16],
    boxes: &[Corners],
    met: &[bool],
    slack: f64,
) -> Outcome {
    let nodes: Vec<Node> = (0..)
        .zip(boxes.chunks(4))
        .map(|(number, four)| Node {
            boxes: std::array::from_fn(|lane| widened(&four[lane], slack)),
            words: std::array::from_fn(|lane| 4 * number + lane as u32),
        })
        .collect();
    let bound = Bounds { packets: vec![*rays], shears: 0 }.call(bench)[0].0;
    let mut outcome = Outcome {
        tested: boxes.len(),
        met: met.iter().filter(|met| **met).count(),
        ..Outcome::default()
    };
    let found = [
        listed::<false>(bench, &nodes, (*rays, bound)),
        listed::<true>(bench, &nodes, (*rays, bound)),
    ];
    for (number, found) in found.iter().enumerate() {
        let mut kept = vec![false; boxes.len()];
        for [child, ..] in found {
            kept[*child as usize] = true;
        }
        outcome.kept[number] = found.len();
        let lost = met.iter().zip(&kept).filter(|(met, kept)| **met && !**kept);
        outcome.lost[number] = lost.count();
    }
    outcome
}

fn add(sum: &mut Outcome, one: Outcome) {
    sum.tested += one.tested;
    sum.met += one.met;
    for kernel in 0..2 {
        sum.kept[kernel] += one.kept[kernel];
        sum.lost[kernel] += one.lost[kernel];
    }
}

fn there(rays: &[Ray; 16]) -> Vec<Ray> {
    rays.iter().filter(|ray| ray.t >> 31 == 0).copied().collect()
}

/// Makes a box for a ray of a scene of some scale.
type Source = fn(&Ray, f64, &mut ChaCha8Rng) -> Corners;

fn boxes_of(
    bench: &mut Bench,
    fan: Fan,
    axes: Axes,
    source: Source,
    slack: f64,
    random: &mut ChaCha8Rng,
) -> Outcome {
    let mut sum = Outcome::default();
    for _ in 0..PACKETS {
        let scale = magnitude(SCALES, random);
        let rays = packet(fan, axes, scale, random);
        let those = there(&rays);
        if those.is_empty() {
            continue;
        }
        let boxes: Vec<Corners> = (0..4 * NODES)
            .map(|_| source(&those[random.random_range(0..those.len())], scale, random))
            .collect();
        let met: Vec<bool> =
            boxes.iter().map(|corners| those.iter().any(|ray| meets(ray, corners))).collect();
        add(&mut sum, outcome(bench, &rays, &boxes, &met, slack));
    }
    println!("{fan:?}, {axes:?}, slack {slack:.1e}: {sum:?}");
    sum
}

#[test]
fn entered_boxes_are_kept() {
    let mut random = random();
    let mut bench = Bench::new();
    for fan in FANS {
        for axes in AXES {
            let sum = boxes_of(&mut bench, fan, axes, touching, SLACK, &mut random);
            assert_eq!(sum.lost, [0; 2], "{fan:?} {axes:?}");
            assert!(sum.met > sum.tested / 10, "{fan:?} {axes:?}: {sum:?}");
        }
    }
}

/// The boxes are so near to the rays, and the tests so tight, that slightly smaller ones are lost.
#[test]
fn boxes_slightly_too_small_are_culled() {
    let mut random = random();
    let mut bench = Bench::new();
    for fan in [Fan::Eye, Fan::Coherent, Fan::Shadow, Fan::One] {
        let sum = boxes_of(&mut bench, fan, Axes::Any, touching, -4.0 * SLACK, &mut random);
        assert!(sum.lost.iter().all(|lost| *lost > 0), "{fan:?}: {sum:?}");
    }
}

/// What fills the box of a triangle: its vertices near a point of a ray, often with that point on
/// an edge, and often in one plane of the axes.
fn triangle(ray: &Ray, scale: f64, random: &mut ChaCha8Rng) -> [[Single; 3]; 3] {
    let point = at(ray, along(ray, scale, random));
    let size = scale * magnitude(1e-6..10.0, random);
    let mut corners: [Vector; 3] = std::array::from_fn(|_| in_cube(size, random));
    if random.random() {
        let axis = random.random_range(0..3);
        for corner in &mut corners {
            corner[axis] = 0.0;
        }
    }
    let hair = magnitude(1e-9..1e-2, random);
    let [u, v] = match random.random_range(0..3) {
        0 => [random.random_range(0.0..1.0), hair],
        1 => [random.random_range(0.0..1.0), -hair],
        _ => [(); 2].map(|()| random.random_range(0.0..0.7)),
    };
    let weights = [u, v, 1.0 - u - v];
    let middle: Vector =
        std::array::from_fn(|axis| (0..3).map(|k| weights[k] * corners[k][axis]).sum());
    corners.map(|corner| {
        std::array::from_fn(|axis| from_f64(point[axis] + corner[axis] - middle[axis]))
    })
}

/// The smallest box around a triangle.
fn around(vertices: &[[Single; 3]; 3]) -> Corners {
    let extreme = |pick: fn(f64, f64) -> f64| {
        std::array::from_fn(|axis| {
            let [a, b, c] = vertices.map(|vertex| to_f64(vertex[axis]));
            from_f64(pick(pick(a, b), c))
        })
    };
    [extreme(f64::min), extreme(f64::max)]
}

/// The packet's rays count as far as their hits with a triangle, and by one ulp more; those that
/// miss it are not there. Tiny components are left out: products with them underflow where a
/// triangle is seen edge-on, which is outside the domain of the triangles' kernels.
#[test]
fn boxes_of_hit_triangles_are_kept() {
    let mut random = random();
    let mut bench = Bench::new();
    for fan in FANS {
        for axes in AXES.into_iter().filter(|axes| *axes != Axes::Tiny) {
            let mut sum = Outcome::default();
            for _ in 0..randomness::rounds(500) {
                let scale = magnitude(SCALES, &mut random);
                let rays = packet(fan, axes, scale, &mut random);
                let those = there(&rays);
                if those.is_empty() {
                    continue;
                }
                let aimed = &those[random.random_range(0..those.len())];
                let vertices = triangle(aimed, scale, &mut random);
                let shape = TriangleObject { vertices, both: true };
                let rays = rays.map(|ray| {
                    let before = sphere_ray::Ray {
                        origin: ray.origin,
                        direction: ray.direction,
                        t: if ray.t >> 31 == 0 { FARTHEST } else { ABSENT },
                        object: 0,
                    };
                    let after = isect_triangle(before, &shape, 1);
                    let t = if after.object == 1 { after.t + 1 } else { ABSENT };
                    Ray { t, ..ray }
                });
                let hit = !there(&rays).is_empty();
                let boxes = [around(&vertices); 4];
                add(&mut sum, outcome(&mut bench, &rays, &boxes, &[hit; 4], SLACK));
            }
            println!("{fan:?}, {axes:?}: {sum:?}");
            assert_eq!(sum.lost, [0; 2], "{fan:?} {axes:?}");
            assert!(sum.met > sum.tested / 10, "{fan:?} {axes:?}: {sum:?}");
        }
    }
}

/// Of what coherent rays miss, most is left out by their common bound; of what any rays miss,
/// nearly everything by the rays themselves.
#[test]
fn packets_cull_many_missed_boxes() {
    let mut random = random();
    let mut bench = Bench::new();
    for fan in FANS {
        let sum = boxes_of(&mut bench, fan, Axes::Any, beside, SLACK, &mut random);
        assert_eq!(sum.lost, [0; 2], "{fan:?}");
        let missed = sum.tested - sum.met;
        let left_out = sum.kept.map(|kept| sum.tested - kept);
        assert!(10 * left_out[1] > 9 * missed, "{fan:?}: {sum:?}");
        if matches!(fan, Fan::Eye | Fan::Coherent | Fan::Shadow | Fan::One | Fan::Half) {
            assert!(2 * left_out[0] > missed, "{fan:?}: {sum:?}");
        }
    }
}
