//! Closed meshes with a point inside each, and rays from there to their edges and vertices.
//!
//! Invariant: the surface encloses the point, however the vertices were rounded.

use crate::generator::Generator;
use kernels::flat_records::{Point, point};
use rand::Rng as _;
use spu_emulator::float::single::{from_f64, to_f64};
use twins::triangle::Triangle;

use crate::space::{along, dot, in_cube, less, unit};
use crate::stability::random::magnitude;
use crate::truth::Vector;

/// A place far from the origin, as in embree's tests.
const FAR_OUT: Vector = [148_376.0, 1234.0, -223_423.0];

/// A closed mesh and a point inside it.
#[derive(Clone, Debug)]
pub struct Mesh {
    vertices: Vec<Point>,
    faces: Vec<[usize; 3]>,
    inside: Point,
}

/// Makes a random mesh.
pub type Maker = fn(&mut Generator) -> Mesh;

/// An irregular sphere of any size, not far from the origin.
pub fn lumpy(random: &mut Generator) -> Mesh {
    let size = magnitude(-10, 10, random);
    let place = in_cube(10.0 * size, random);
    Mesh::icosahedron(place, size, [1.0; 3], random)
}

/// A mesh that is thin in one or two directions.
pub fn thin(random: &mut Generator) -> Mesh {
    let widths = std::array::from_fn(|_| magnitude(-13, 0, random));
    Mesh::icosahedron([0.0; 3], 1.0, widths, random)
}

/// A mesh so far from the origin that the vertices are on a coarse lattice, and many edges are
/// exactly behind others.
pub fn far_out(random: &mut Generator) -> Mesh {
    let size = magnitude(0, 10, random);
    Mesh::icosahedron(FAR_OUT, size, [1.0; 3], random)
}

/// A box of squares, each divided into triangles along a random diagonal, with all coordinates on
/// a lattice. Rays go exactly through vertices and along the edges of faces.
pub fn lattice(random: &mut Generator) -> Mesh {
    const CELLS: usize = 2;
    // Odd numbers, so that products have more digits than a single.
    let steps: Vector =
        std::array::from_fn(|_| f64::from(random.random_range(0..4096_u32) * 2 + 1));
    let corner: Vector = std::array::from_fn(|_| f64::from(random.random_range(-8..=4_i32)));
    let place = |at: Vector| point(std::array::from_fn(|k| (corner[k] + at[k]) * steps[k]));
    let mut vertices = Vec::new();
    let mut faces = Vec::new();
    for axis in 0..3 {
        for side in [0, CELLS] {
            for (u, v) in (0..CELLS).flat_map(|u| (0..CELLS).map(move |v| (u, v))) {
                let first = vertices.len();
                for (u, v) in [(u, v), (u + 1, v), (u + 1, v + 1), (u, v + 1)] {
                    let mut at = [side as f64; 3];
                    at[(axis + 1) % 3] = u as f64;
                    at[(axis + 2) % 3] = v as f64;
                    vertices.push(place(at));
                }
                let turn = random.random_range(0..2);
                let corner = |number: usize| first + (number + turn) % 4;
                faces.push([corner(0), corner(1), corner(2)]);
                faces.push([corner(0), corner(2), corner(3)]);
            }
        }
    }
    // The middle of the lattice is not on the surface, and is in line with its vertices.
    let inside = place([1.0; 3]);
    Mesh { vertices, faces, inside }
}

impl Mesh {
    /// The vertices of an icosahedron, each scaled. Every ray from `inside` in the direction of
    /// one of the icosahedron's vertices meets that vertex of the mesh, as long as rounding moves
    /// it by less than the mesh's smallest width.
    fn icosahedron(place: Vector, size: f64, widths: Vector, random: &mut Generator) -> Self {
        let golden = (1.0 + 5_f64.sqrt()) / 2.0;
        let mut vertices = Vec::new();
        for axis in 0..3 {
            for (one, long) in [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)] {
                let mut vertex = [0.0; 3];
                vertex[(axis + 1) % 3] = one;
                vertex[(axis + 2) % 3] = long * golden;
                vertices.push(unit(vertex));
            }
        }
        // All edges have the distance of neighbours as their length. Three vertices that are
        // neighbours of each other form a face.
        let near = |a: usize, b: usize| dot(vertices[a], vertices[b]) > 0.4;
        let mut faces = Vec::new();
        for a in 0..12 {
            for b in (a + 1..12).filter(|b| near(a, *b)) {
                faces.extend((b + 1..12).filter(|c| near(a, *c) && near(b, *c)).map(|c| [a, b, c]));
            }
        }
        let vertices = vertices
            .iter()
            .map(|vertex| {
                let stretch = size * random.random_range(0.5..2.0);
                point(std::array::from_fn(|axis| {
                    place[axis] + stretch * widths[axis] * vertex[axis]
                }))
            })
            .collect();
        let offset = in_cube(0.05 * size, random);
        let inside = point(std::array::from_fn(|axis| place[axis] + widths[axis] * offset[axis]));
        Self { vertices, faces, inside }
    }

    /// The triangles, each with a random orientation.
    pub fn triangles(&self, random: &mut Generator) -> Vec<Triangle> {
        let triangle = |face: &[usize; 3]| {
            let mut face = *face;
            if random.random() {
                face.swap(0, 1);
            }
            face.rotate_left(random.random_range(0..3));
            face.map(|vertex| self.vertices[vertex])
        };
        self.faces.iter().map(triangle).collect()
    }

    /// The origin and direction of a ray to a vertex or to a point on an edge, or within about an
    /// ulp of these.
    pub fn aimed(&self, random: &mut Generator) -> [Point; 2] {
        let face = self.faces[random.random_range(0..self.faces.len() as u32) as usize];
        let from = random.random_range(0..3_usize);
        let ends = [face[from], face[(from + 1) % 3]];
        let [a, b] = ends.map(|vertex| self.vertices[vertex].map(to_f64));
        let share = match random.random_range(0..4) {
            0 => 0.0,
            1 => 0.5,
            2 => random.random_range(0.0..1e-6),
            _ => random.random_range(0.0..1.0),
        };
        let target = along(a, share, less(b, a));
        let mut direction = unit(less(target, self.inside.map(to_f64))).map(from_f64);
        if random.random() {
            let axis = random.random_range(0..3_usize);
            if direction[axis] != 0 {
                direction[axis] = direction[axis].wrapping_add_signed(random.random_range(-1..=1));
            }
        }
        [self.inside, direction]
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use super::*;
    use crate::stability::random::of_round;

    /// Every edge belongs to two faces, so there is no hole.
    #[test]
    fn meshes_are_closed() {
        let mut random = of_round(1, "mesh", "", 0);
        for (maker, faces) in [(lumpy as Maker, 20), (thin, 20), (far_out, 20), (lattice, 48)] {
            for _ in 0..20 {
                let mesh = maker(&mut random);
                let triangles = mesh.triangles(&mut random);
                assert_eq!(triangles.len(), faces);
                let mut edges: BTreeMap<[Point; 2], u32> = BTreeMap::new();
                for triangle in triangles {
                    for k in 0..3 {
                        let mut edge = [triangle[k], triangle[(k + 1) % 3]];
                        edge.sort_unstable();
                        *edges.entry(edge).or_default() += 1;
                    }
                }
                assert!(edges.values().all(|faces| *faces == 2), "{edges:x?}");
            }
        }
    }
}
