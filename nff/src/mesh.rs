//! Meshes: triangles that share vertices, in far less memory than an [`Object`](crate::Object)
//! each.
//!
//! Invariant: the vertices and materials of a mesh that a loader returned exist, and all its
//! numbers are finite.

use glam::{DVec3, Vec3};

use crate::Shape;

/// Triangles, relative to an origin of their own.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Mesh {
    /// The point of the scene that the positions are relative to. Singles near it keep the digits
    /// that those of a mesh far from the scene's own origin would lose.
    pub origin: DVec3,
    /// Positions of the vertices, relative to the origin.
    pub positions: Vec<[f32; 3]>,
    /// A normal for each vertex, of any length, or none at all. A triangle with a normal of 0 at
    /// one of its vertices is flat.
    pub normals: Vec<[f32; 3]>,
    /// Texture coordinates of each vertex, or none at all; see [`Texture`](crate::Texture).
    pub texture_coordinates: Vec<[f32; 2]>,
    /// A colour of each vertex by which the material's colour is multiplied, encoded as that is, or
    /// none at all. In between, their light is interpolated.
    pub colours: Vec<[f32; 3]>,
    /// The vertices of each triangle, counter-clockwise as seen from its front.
    pub triangles: Vec<[u32; 3]>,
    /// The material of each triangle, as an index in [`Scene::materials`](crate::Scene::materials).
    pub materials: Vec<u32>,
    /// Whether all triangles are visible from both sides. Triangles whose material transmits light
    /// always are.
    pub two_sided: bool,
}

impl Mesh {
    /// The vertices of a triangle, relative to the origin.
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

    /// The colours of a triangle's vertices; `None` if the mesh has none.
    #[must_use]
    pub fn corner_colours(&self, triangle: usize) -> Option<[Vec3; 3]> {
        let [a, b, c] =
            self.triangles[triangle].map(|vertex| self.colours.get(vertex as usize).copied());
        Some([a?, b?, c?].map(Vec3::from))
    }

    /// A triangle's vertices in the scene's coordinates.
    #[must_use]
    pub fn places(&self, triangle: usize) -> [DVec3; 3] {
        self.corners(triangle)
            .map(|corner| self.origin + corner.as_dvec3())
    }

    /// A triangle as a shape of its own, in the scene's coordinates: a patch, or a polygon if it is
    /// flat.
    #[must_use]
    pub fn shape(&self, triangle: usize) -> Shape {
        let vertices = self.places(triangle).to_vec();
        let wide = |normals: [Vec3; 3]| normals.map(|normal| normal.as_dvec3()).to_vec();
        match self.corner_normals(triangle).map(wide) {
            Some(normals) => Shape::Patch { vertices, normals },
            None => Shape::Polygon { vertices },
        }
    }

    /// The lower and upper corner of the box around the triangles, in the scene's coordinates;
    /// `None` without any.
    #[must_use]
    pub fn bounds(&self) -> Option<(DVec3, DVec3)> {
        let used = self.triangles.iter().flatten();
        let mut positions = used.map(|&vertex| Vec3::from(self.positions[vertex as usize]));
        let first = positions.next()?;
        let (low, high) = positions.fold((first, first), |(low, high), position| {
            (low.min(position), high.max(position))
        });
        let place = |corner: Vec3| self.origin + corner.as_dvec3();
        Some((place(low), place(high)))
    }

    /// The origin for a mesh in a box: its middle if it is farther away than the box is large, so
    /// that singles would lose digits there; otherwise that of the scene.
    #[must_use]
    pub fn origin_for(low: DVec3, high: DVec3) -> DVec3 {
        let middle = low.midpoint(high);
        let is_far = middle.abs().max_element() > (high - low).max_element();
        if is_far { middle } else { DVec3::ZERO }
    }
}
