//! The kernel for smooth normals: patches, hits on them, its case and its error.

use twins::smooth::{Patch, smooth};
use twins::sphere_ray::Ray;

use super::isect::call;
use super::isect::error::SCALES;
use super::isect::shape::head_words;
use super::isect::sphere::FRONT;
use crate::flat_records::Point;
use crate::prelude::*;
use protocol::layout::SIDES_SMOOTH;

/// The kernels in this file.
pub fn kernels() -> Vec<Kernel> {
    vec![
        Kernel::of([case("a packet", Objects::Fixed(1), |_| {
            let hit = Hit {
                patch: Patch {
                    vertices: [[-1.0, -1.0, -5.0], [1.0, -1.0, -5.0], [0.0, 1.0, -5.0]].map(point),
                    normals: [[0.0, 0.0, 1.0]; 3].map(point),
                },
                smooth: true,
                point: point([0.0, 0.0, -5.0]),
                plane: point([0.0, 0.0, 1.0]),
                direction: point([0.0, 0.0, -1.0]),
            };
            Smooth { hits: [hit; 16], anything: 0 }
        })])
        .error(error),
    ]
}

/// A hit on a triangle.
#[derive(Clone, Copy, Debug)]
pub struct Hit {
    /// The triangle with its normals.
    pub patch: Patch,
    /// Whether the normals are used.
    pub smooth: bool,
    /// The point hit.
    pub point: Point,
    /// The triangle's geometric normal on the ray's side.
    pub plane: Point,
    /// The ray's direction.
    pub direction: Point,
}

fn record(hit: &Hit, anything: u32) -> layout::Patch {
    let [a, b, c] = hit.patch.vertices.map(|vertex| quad(vertex, anything));
    let [normal_a, normal_b, normal_c] = hit.patch.normals.map(|normal| quad(normal, anything));
    let smooth = if hit.smooth { SIDES_SMOOTH } else { 0 };
    let bits = anything & !SIDES_SMOOTH | smooth;
    let mut object = head_words([anything; 3], [anything; 3], anything, FRONT, anything);
    object[11] = U32::new(bits);
    let triangle = layout::Triangle { object, a, b, c };
    layout::Patch { triangle: zerocopy::transmute!(triangle), normal_a, normal_b, normal_c }
}

/// The surfaces of these hits. `anything` fills the lanes without a normal and all other fields.
#[must_use]
pub fn surfaces(hits: &[Hit; 16], anything: u32) -> Surfaces {
    let words = [U32::new(anything); size_of::<Surfaces>() / 4];
    let mut surfaces: Surfaces = zerocopy::transmute!(words);
    for (lane, hit) in hits.iter().enumerate() {
        [surfaces.point_x[lane], surfaces.point_y[lane], surfaces.point_z[lane]] =
            hit.point.map(single);
        [surfaces.plane_x[lane], surfaces.plane_y[lane], surfaces.plane_z[lane]] =
            hit.plane.map(single);
    }
    surfaces
}

/// Hits of a packet on triangles.
#[derive(Clone, Debug)]
pub struct Smooth {
    /// The hits.
    pub hits: [Hit; 16],
    /// Fills the lanes without a normal and all other fields.
    pub anything: u32,
}

impl Description for Smooth {
    const KERNEL: &'static str = "smooth_r16";
    const ROUNDS: [usize; 2] = [600, 1000];
    const LENGTHS: &'static [usize] = &[1];
    const SHARES: [Range<f64>; 2] = [0.05..0.5, ANY_SHARE];
    type Placed = Place;
    type Found = Bits<Surfaces>;

    fn sensible(_: usize, random: &mut ChaCha8Rng) -> Self {
        let scale = SCALES[random.random_range(0..SCALES.len())];
        Self { hits: [(); 16].map(|()| any_hit(random, scale)), anything: random.random() }
    }

    fn any(_: usize, random: &mut ChaCha8Rng) -> Self {
        let hits = [(); 16].map(|()| Hit {
            patch: any_bits(random),
            smooth: random.random(),
            point: random.random(),
            plane: random.random(),
            direction: random.random(),
        });
        Self { hits, anything: random.random() }
    }

    fn place(&self, bench: &mut Bench) -> (Place, Vec<u32>) {
        let Self { hits, anything } = *self;
        let records = hits.map(|hit| record(&hit, anything));
        let records = put(bench, &records);
        let rays = std::array::from_fn(|lane| Ray {
            origin: [anything; 3],
            direction: hits[lane].direction,
            t: FARTHEST,
            object: address::<layout::Patch>(records, lane),
        });
        let rays = put(bench, &[call::packet(&rays, anything)]);
        let surfaces = put(bench, &[surfaces(&hits, anything)]);
        (surfaces, vec![rays.address, surfaces.address])
    }

    fn found(&self, bench: &Bench, placed: &Place, _: u32) -> Bits<Surfaces> {
        Bits(bench.read(*placed))
    }

    fn twin(&self, _: &Place) -> Bits<Surfaces> {
        let mut rows = surfaces(&self.hits, self.anything);
        for (lane, hit) in self.hits.iter().enumerate().filter(|(_, hit)| hit.smooth) {
            let normal = smooth(&hit.patch, hit.point, hit.plane, hit.direction);
            [rows.normal_x[lane], rows.normal_y[lane], rows.normal_z[lane]] = normal.map(single);
        }
        Bits(rows)
    }

    /// How many have the plane's normal instead of their own.
    fn part(&self, found: &Bits<Surfaces>) -> [usize; 2] {
        let smooth = self.hits.iter().zip(normals(&found.0)).filter(|(hit, _)| hit.smooth);
        let planes = smooth.clone().filter(|(hit, normal)| *normal == hit.plane);
        [planes.count(), smooth.count()]
    }
}

/// The shading normals.
#[must_use]
pub fn normals(surfaces: &Surfaces) -> [Point; 16] {
    let axes = [surfaces.normal_x, surfaces.normal_y, surfaces.normal_z];
    std::array::from_fn(|lane| axes.map(|axis| bits(axis[lane])))
}

/// A hit from the stated domain, in a scene scaled by `scale`.
pub fn any_hit(random: &mut ChaCha8Rng, scale: f64) -> Hit {
    let distance = magnitude(1.0..100.0, random);
    let size = distance * magnitude(0.01..1.0, random);
    let middle = any_direction(random).map(|component| component * distance);
    let corners = loop {
        let corners: [Vector; 3] = std::array::from_fn(|_| {
            let offset = in_cube(size, random);
            std::array::from_fn(|axis| scale * (middle[axis] + offset[axis]))
        });
        let [a, b, c] = corners;
        let edges = [sub(b, a), sub(c, b), sub(a, c)];
        let lengths = edges.map(|edge| dot(edge, edge).sqrt());
        let area = cross(edges[0], edges[1]);
        let longest = lengths.into_iter().fold(0.0, f64::max);
        // No slivers, in which the rounding of a point would move it from one vertex to another.
        if longest > scale * size && dot(area, area).sqrt() > 0.3 * longest * longest {
            break corners;
        }
    };
    let [a, b, c] = corners;
    let outward = unit(cross(sub(b, a), sub(c, a)));
    let normals = std::array::from_fn(|_| {
        loop {
            let normal = any_direction(random);
            if dot(normal, outward) > 0.5 {
                break point(normal);
            }
        }
    });
    let weights: Vector = std::array::from_fn(|_| random.random_range(0.01..1.0));
    let sum: f64 = weights.iter().sum();
    let at = std::array::from_fn(|axis| {
        (weights[0] * a[axis] + weights[1] * b[axis] + weights[2] * c[axis]) / sum
    });
    let direction = any_direction(random);
    let way = if dot(direction, outward) < 0.0 { 1.0 } else { -1.0 };
    Hit {
        patch: Patch { vertices: corners.map(point), normals },
        smooth: random.random_range(0..4) > 0,
        point: point(at),
        plane: point(outward.map(|component| way * component)),
        direction: point(direction),
    }
}

/// The normal in f64, and its component towards the ray. If that is below 0, the plane's normal is
/// used.
#[must_use]
pub fn truth(hit: &Hit) -> (Vector, f64) {
    let [a, b, c] = hit.patch.vertices.map(|vertex| sub(vertex.map(to_f64), hit.point.map(to_f64)));
    let plane = hit.plane.map(to_f64);
    let part = |from: Vector, to: Vector| dot(cross(from, to), plane);
    let parts = [part(b, c), part(c, a), part(a, b)];
    let normals = hit.patch.normals.map(|normal| normal.map(to_f64));
    let normal = unit(std::array::from_fn(|axis| {
        (0..3).map(|corner| parts[corner] * normals[corner][axis]).sum()
    }));
    let towards = -dot(normal, hit.direction.map(to_f64));
    (if towards > 0.0 { normal } else { plane }, towards)
}

/// The largest error of a component, of 1.
fn error(bench: &mut Bench, random: &mut ChaCha8Rng) -> f64 {
    /// The smallest cosine to the ray for which a normal counts.
    const EDGE_ON: f64 = 1e-4;
    let mut worst = 0.0_f64;
    for _ in 0..500 {
        for scale in SCALES {
            let hits: [Hit; 16] = std::array::from_fn(|_| any_hit(random, scale));
            let found = Smooth { hits, anything: random.random() }.call(bench);
            for (hit, found) in hits.iter().zip(normals(&found.0)) {
                let (normal, towards) = truth(hit);
                if !hit.smooth || towards.abs() < EDGE_ON {
                    continue;
                }
                for (found, exact) in found.iter().zip(normal) {
                    worst = worst.max((to_f64(*found) - exact).abs());
                }
            }
        }
    }
    worst
}
