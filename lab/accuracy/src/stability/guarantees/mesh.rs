//! The closed meshes that rays must not leave.

use crate::stability::prelude::*;
use kernels::cases::meshes::{FAR_OUT, Mesh};
use kernels::flat_records::point;

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
/// exactly covered by others.
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

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use kernels::flat_records::Point;

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
