//! Twin of `spu/isect/isect_mesh_pairs_r16.s`: a ray and a run of a mesh's triangles.

use super::Single;
use super::sphere_ray::Ray;
use super::triangle_pairs::{TriangleObject, isect_triangle};

/// In `object`: a triangle of a mesh.
const MESH_HIT: u32 = 0x8000_0000;

/// A block of a mesh in local store.
#[derive(Clone, Debug)]
pub struct MeshBlock {
    /// Its number.
    pub number: u32,
    /// Whether its triangles are seen from both sides.
    pub both: bool,
    /// The vertices.
    pub vertices: Vec<[Single; 3]>,
    /// The vertices' indices of each triangle.
    pub faces: Vec<[u8; 3]>,
}

impl MeshBlock {
    /// A triangle, as an object of a scene.
    #[must_use]
    pub fn triangle(&self, index: usize) -> TriangleObject {
        TriangleObject {
            vertices: self.faces[index].map(|vertex| self.vertices[usize::from(vertex)]),
            both: self.both,
        }
    }

    /// The object that is written to a ray that has hit the triangle.
    #[must_use]
    pub fn hit(&self, index: usize) -> u32 {
        MESH_HIT | self.number << 7 | index as u32
    }

    /// The ray after its test with a run of triangles.
    #[must_use]
    pub fn isect_run(&self, ray: Ray, run: std::ops::Range<usize>) -> Ray {
        run.fold(ray, |ray, index| isect_triangle(ray, &self.triangle(index), self.hit(index)))
    }
}
