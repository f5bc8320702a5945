//! Triangles do not leak: every ray from inside a closed mesh hits it, including rays aimed at its
//! edges and vertices, however thin its triangles are and wherever it is.

use super::rays::sheared;
use kernels::cases::flat::put_triangles;
use kernels::flat_records::{Point, Ray, Rays, point};
use kernels::vector::{cross, dot, in_cube, less, magnitude, unit};
use kernels::{Bench, random};
use rand::Rng as _;
use rand_chacha::ChaCha8Rng;
use spu_emulator::float::single::to_f64;
use twins::triangle::Triangle;
use zerocopy::IntoBytes as _;

/// The faces of an icosahedron as vertex numbers: those around vertex 0, those around vertex 11,
/// and those between.
fn faces() -> Vec<[usize; 3]> {
    let next = |k: usize| k % 5 + 1;
    (1..=5)
        .flat_map(|k| {
            let (n, below, below_next) = (next(k), k + 5, next(k) + 5);
            [[0, k, n], [11, below_next, below], [k, below, n], [n, below, below_next]]
        })
        .collect()
}

/// The vertices of a unit icosahedron.
fn vertices() -> [[f64; 3]; 12] {
    let height = 1.0 / 5_f64.sqrt();
    let radius = 2.0 * height;
    let around = |k: f64, height: f64| {
        let angle = k * std::f64::consts::TAU / 5.0;
        [radius * libm::cos(angle), radius * libm::sin(angle), height]
    };
    std::array::from_fn(|number| match number {
        0 => [0.0, 0.0, 1.0],
        11 => [0.0, 0.0, -1.0],
        upper @ 1..=5 => around(upper as f64, height),
        lower => around(lower as f64 + 0.5, -height),
    })
}

/// A closed mesh and a point inside it.
pub struct Mesh {
    vertices: [Point; 12],
    inside: Point,
}

impl Mesh {
    /// Every ray from `inside` in the direction of a vertex of the unit icosahedron meets that
    /// vertex of the mesh, so `inside` is inside. This holds as long as rounding moves vertices by
    /// less than the mesh's smallest width.
    pub fn new(place: [f64; 3], size: f64, widths: [f64; 3], random: &mut ChaCha8Rng) -> Self {
        let vertices = vertices().map(|vertex| {
            let stretch = size * random.random_range(0.5..2.0);
            point(std::array::from_fn(|axis| place[axis] + stretch * widths[axis] * vertex[axis]))
        });
        let offset = in_cube(0.05 * size, random);
        let inside = point(std::array::from_fn(|axis| place[axis] + widths[axis] * offset[axis]));
        Self { vertices, inside }
    }

    /// Vertices on a lattice with so few points that many edges are in line, faces are seen
    /// edge-on, and some have no area. The surface encloses `inside`, however it is folded.
    pub fn on_lattice(random: &mut ChaCha8Rng) -> Self {
        // Odd numbers, so that products have more digits than a single.
        let steps: [f64; 3] =
            std::array::from_fn(|_| f64::from(random.random_range(0..4096_u32) * 2 + 1));
        loop {
            let mut on_lattice = || {
                let numbers: [i32; 3] = std::array::from_fn(|_| random.random_range(-4..=4));
                std::array::from_fn(|axis| f64::from(numbers[axis]) * steps[axis])
            };
            let mesh = Self {
                vertices: [(); 12].map(|()| point(on_lattice())),
                inside: point(on_lattice()),
            };
            if mesh.turns().abs() > 0.5 {
                return mesh;
            }
        }
    }

    /// How often the surface winds around `inside`: the sum of the faces' solid angles divided by
    /// the sphere's (Van Oosterom and Strackee). An integer, or 0 if `inside` is on the surface.
    fn turns(&self) -> f64 {
        let seen = self.vertices.map(|vertex| less(vertex.map(to_f64), self.inside.map(to_f64)));
        let mut turns = 0.0;
        for [a, b, c] in faces().into_iter().map(|face| face.map(|vertex| seen[vertex])) {
            let [la, lb, lc] = [a, b, c].map(|side| dot(side, side).sqrt());
            let volume = dot(a, cross(b, c));
            let corner = la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb;
            if volume == 0.0 && corner <= 1e-9 * la * lb * lc {
                return 0.0;
            }
            turns += libm::atan2(volume, corner) / std::f64::consts::TAU;
        }
        turns
    }

    pub fn triangles(&self, random: &mut ChaCha8Rng) -> Vec<Triangle> {
        faces()
            .into_iter()
            .map(|mut face| {
                // The faces of a mesh may have different orientations.
                if random.random() {
                    face.swap(0, 1);
                }
                face.rotate_left(random.random_range(0..3));
                face.map(|vertex| self.vertices[vertex])
            })
            .collect()
    }

    /// A ray to a vertex or to a point on an edge, or within about an ulp of these.
    pub fn aimed(&self, random: &mut ChaCha8Rng) -> Ray {
        let face = faces()[random.random_range(0..20)];
        let [a, b] = [face[0], face[1]].map(|vertex| self.vertices[vertex].map(to_f64));
        let along = match random.random_range(0..4) {
            0 => 0.0,
            1 => 0.5,
            2 => random.random_range(0.0..1e-6),
            _ => random.random_range(0.0..1.0),
        };
        let target: [f64; 3] = std::array::from_fn(|axis| a[axis] + along * (b[axis] - a[axis]));
        let mut towards = less(target, self.inside.map(to_f64));
        if random.random() {
            towards = unit(towards);
        }
        let mut direction = point(towards);
        if random.random() {
            let axis = random.random_range(0..3);
            if to_f64(direction[axis]) != 0.0 {
                direction[axis] = direction[axis].wrapping_add_signed(random.random_range(-1..=1));
            }
        }
        Ray::new(self.inside, direction)
    }
}

/// Traces this many packets of aimed rays in each of this many meshes. Panics at the first leak.
fn trace(
    bench: &mut Bench,
    random: &mut ChaCha8Rng,
    meshes: usize,
    packets: usize,
    mesh: fn(&mut ChaCha8Rng) -> Mesh,
) -> usize {
    let mut on_edges = 0;
    for _ in 0..meshes {
        let mesh = mesh(random);
        let triangles = mesh.triangles(random);
        let rays: Vec<[Ray; 16]> =
            (0..packets).map(|_| std::array::from_fn(|_| mesh.aimed(random))).collect();
        let packed: Vec<Rays> = rays.iter().map(Rays::pack).collect();
        let sheared = sheared(bench, &packed);
        let triangles_place = put_triangles(bench, triangles.iter().copied(), || random.random());
        for ((rays, packed), sheared) in rays.iter().zip(packed).zip(sheared) {
            let rays_place = bench.place(packed.as_bytes());
            let shear_place = bench.place(sheared.as_bytes());
            bench.call(
                "isect_triangles_r16",
                &[
                    rays_place.address,
                    shear_place.address,
                    triangles_place.address,
                    triangles.len() as u32,
                    1,
                ],
            );
            let found = bench.read::<Rays>(rays_place).hits();
            for (ray, found) in rays.iter().zip(found) {
                assert_ne!(found.object, 0, "{ray:x?} leaks out of {triangles:x?}");
                on_edges += usize::from(found.u == 0 || found.v == 0);
            }
        }
    }
    on_edges
}

#[test]
fn no_ray_leaves_a_closed_mesh() {
    let mut random = random();
    let mut bench = Bench::new();
    let mut on_edges = 0;
    on_edges += trace(&mut bench, &mut random, 2500, 8, |random| {
        let size = magnitude(1e-3..1e3, random);
        let place = in_cube(10.0 * size, random);
        Mesh::new(place, size, [1.0; 3], random)
    });
    // Thin in one or two directions.
    on_edges += trace(&mut bench, &mut random, 2500, 8, |random| {
        let widths = std::array::from_fn(|_| magnitude(1e-4..1.0, random));
        Mesh::new([0.0; 3], 1.0, widths, random)
    });
    // So far from the origin that the vertices are on a coarse lattice, and many edges are exactly
    // behind others.
    on_edges += trace(&mut bench, &mut random, 3000, 8, |random| {
        let size = magnitude(1.0..1e3, random);
        Mesh::new([148_376.0, 1234.0, -223_423.0], size, [1.0; 3], random)
    });
    on_edges += trace(&mut bench, &mut random, 4000, 8, Mesh::on_lattice);
    println!("{on_edges} rays exactly through an edge");
    assert!(on_edges > 10_000, "only {on_edges} rays were exactly on edges");
}
