//! Meshes: triangles that share vertices, in far less memory than an [`Object`](crate::Object)
//! each.
//!
//! Invariant: the vertices and materials of a mesh that a loader returned exist, and all its
//! numbers are finite.

use glam::{DVec3, Vec3};

use crate::Shape;

/// Triangles in the scene's coordinates.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Mesh {
    /// Positions of the vertices.
    pub positions: Vec<[f32; 3]>,
    /// A normal for each vertex, of any length, or none at all. A triangle with a normal of 0 at
    /// one of its vertices is flat.
    pub normals: Vec<[f32; 3]>,
    /// Texture coordinates of each vertex, or none at all; see [`Texture`](crate::Texture).
    pub texture_coordinates: Vec<[f32; 2]>,
    /// The vertices of each triangle, counter-clockwise as seen from its front.
    pub triangles: Vec<[u32; 3]>,
    /// The material of each triangle, as an index in [`Scene::materials`](crate::Scene::materials).
    pub materials: Vec<u32>,
    /// Whether all triangles are visible from both sides. Triangles whose material transmits light
    /// always are.
    pub two_sided: bool,
}

impl Mesh {
    /// The vertices of a triangle.
    #[must_use]
    pub fn corners(&self, triangle: usize) -> [Vec3; 3] {
        self.triangles[triangle].map(|vertex| self.positions[vertex as usize].into())
    }

    /// The normals at a triangle's vertices; `None` if it is flat.
    #[must_use]
    pub fn corner_normals(&self, triangle: usize) -> Option<[Vec3; 3]> {
        if self.normals.is_empty() {
            return None;
        }
        let normals = self.triangles[triangle].map(|vertex| self.normals[vertex as usize].into());
        normals
            .iter()
            .all(|normal| *normal != Vec3::ZERO)
            .then_some(normals)
    }

    /// The texture coordinates at a triangle's vertices; `None` if the mesh has none.
    #[must_use]
    pub fn corner_coordinates(&self, triangle: usize) -> Option<[[f32; 2]; 3]> {
        let [a, b, c] = self.triangles[triangle]
            .map(|vertex| self.texture_coordinates.get(vertex as usize).copied());
        Some([a?, b?, c?])
    }

    /// A triangle as a shape of its own: a patch, or a polygon if it is flat.
    #[must_use]
    pub fn shape(&self, triangle: usize) -> Shape {
        let wide = |vectors: [Vec3; 3]| vectors.map(|vector| vector.as_dvec3()).to_vec();
        let vertices = wide(self.corners(triangle));
        match self.corner_normals(triangle).map(wide) {
            Some(normals) => Shape::Patch { vertices, normals },
            None => Shape::Polygon { vertices },
        }
    }

    /// The lower and upper corner of the box around the triangles; `None` without any.
    #[must_use]
    pub fn bounds(&self) -> Option<(DVec3, DVec3)> {
        let used = self.triangles.iter().flatten();
        let mut positions = used.map(|&vertex| Vec3::from(self.positions[vertex as usize]));
        let first = positions.next()?;
        let (low, high) = positions.fold((first, first), |(low, high), position| {
            (low.min(position), high.max(position))
        });
        Some((low.as_dvec3(), high.as_dvec3()))
    }
}
