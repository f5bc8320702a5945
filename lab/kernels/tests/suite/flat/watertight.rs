//! Triangles do not leak: every ray from inside a closed mesh hits it, including rays aimed at its
//! edges and vertices, however thin its triangles are and wherever it is.

use kernels::cases::flat::triangles::Triangles;
use kernels::cases::meshes::{FAR_OUT, Mesh};
use kernels::flat_records::Ray;
use kernels::prelude::*;

/// The ways in which meshes are made: of any size and not far from the origin; thin in one or two
/// directions; so far from the origin that the vertices are on a coarse lattice, and many edges
/// are exactly covered by others; and folded on a lattice.
pub const KINDS: [fn(&mut ChaCha8Rng) -> Mesh; 4] = [
    |random| {
        let size = magnitude(1e-3..1e3, random);
        Mesh::icosahedron(in_cube(10.0 * size, random), size, [1.0; 3], random)
    },
    |random| {
        let widths = std::array::from_fn(|_| magnitude(1e-4..1.0, random));
        Mesh::icosahedron([0.0; 3], 1.0, widths, random)
    },
    |random| {
        let size = magnitude(1.0..1e3, random);
        Mesh::icosahedron(FAR_OUT, size, [1.0; 3], random)
    },
    on_lattice,
];

/// An aimed ray. Half of the directions have any length, so that those on a lattice are exact.
pub fn aimed(mesh: &Mesh, random: &mut ChaCha8Rng) -> Ray {
    let towards = mesh.towards_edge(random);
    let towards = if random.random() { unit(towards) } else { towards };
    let [origin, direction] = mesh.nearly(towards, random);
    Ray::new(origin, direction)
}

/// Vertices on a lattice with so few points that many edges are in line, faces are seen
/// edge-on, and some have no area. The surface encloses `inside`, however it is folded.
fn on_lattice(random: &mut ChaCha8Rng) -> Mesh {
    // Odd numbers, so that products have more digits than a single.
    let Mesh { vertices, mut faces, .. } = Mesh::icosahedron([0.0; 3], 1.0, [1.0; 3], random);
    for face in &mut faces {
        let [a, b, c] = face.map(|vertex| vertices[vertex].map(to_f64));
        // Turns are counted by faces of one orientation.
        if dot(a, cross(b, c)) < 0.0 {
            face.swap(0, 1);
        }
    }
    let steps: [f64; 3] =
        std::array::from_fn(|_| f64::from(random.random_range(0..4096_u32) * 2 + 1));
    loop {
        let mut on_lattice = || {
            let numbers: [i32; 3] = std::array::from_fn(|_| random.random_range(-4..=4));
            std::array::from_fn(|axis| f64::from(numbers[axis]) * steps[axis])
        };
        let vertices = (0..12).map(|_| point(on_lattice())).collect();
        let mesh = Mesh { vertices, faces: faces.clone(), inside: point(on_lattice()) };
        if turns(&mesh).abs() > 0.5 {
            return mesh;
        }
    }
}

/// How often the surface winds around `inside`: the sum of the faces' solid angles divided by
/// the sphere's (Van Oosterom and Strackee). An integer, or 0 if `inside` is on the surface.
fn turns(mesh: &Mesh) -> f64 {
    let inside = mesh.inside.map(to_f64);
    let seen = |vertex: usize| sub(mesh.vertices[vertex].map(to_f64), inside);
    let mut turns = 0.0;
    for [a, b, c] in mesh.faces.iter().map(|face| face.map(seen)) {
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
            (0..packets).map(|_| std::array::from_fn(|_| aimed(&mesh, random))).collect();
        for rays in rays {
            let inputs = Triangles::<false> { rays, triangles: triangles.clone(), first: 1 };
            let (_, found) = inputs.call(bench);
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
    let (mut on_edges, mut meshes) = (0, 0);
    for (kind, count) in KINDS.into_iter().zip([625, 625, 750, 1000]) {
        let count = randomness::rounds(count) as usize;
        meshes += count;
        on_edges += trace(&mut bench, &mut random, count, 8, kind);
    }
    println!("{on_edges} rays exactly through an edge");
    assert!(on_edges > meshes / 2, "only {on_edges} rays were exactly on edges");
}
