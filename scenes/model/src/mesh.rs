//! Meshes: triangles that share vertices, in far less memory than an [`Object`](crate::Object)
//! each.
//!
//! Invariant: the vertices and materials of a mesh that a loader returned exist, and all its
//! numbers are finite.

use glam::{BVec3, DVec3, Vec3};

use crate::Shape;

/// Which lights reach a triangle, for those of which that is known, so that they need no shadow
/// rays there. The bit 2^n is for all lights whose number in the scene is n modulo 16. SPUs use it
/// in meshes with colours of vertices.
///
/// It is a promise of who makes the mesh, for as long as it is traced. With a wrong bit light goes
/// through what is in its way, or is missing.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Visibility {
    /// Nothing will ever be between these lights and any place of the triangle in their range.
    pub lit: u16,
    /// Something will always be between these lights and every place of the triangle.
    pub dark: u16,
}

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
    /// What is known of the light that reaches each triangle, or nothing at all.
    pub visibility: Vec<Visibility>,
    /// Whether all triangles are visible from both sides. Triangles whose material transmits light
    /// always are.
    pub two_sided: bool,
}

/// The sides of a box, as corners of which bit 0 means high x, bit 1 high y and bit 2 high z:
/// counter-clockwise as seen from outside.
const SIDES: [[u32; 4]; 6] =
    [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]];

/// A corner of a box, numbered as in [`SIDES`].
fn corner(low: DVec3, high: DVec3, number: u32) -> DVec3 {
    DVec3::select(BVec3::new(number & 1 != 0, number & 2 != 0, number & 4 != 0), high, low)
}

/// The sides of the box between two corners, each counter-clockwise as seen from outside: those of
/// low x, high x, low y, high y, low z and high z.
#[must_use]
pub fn cuboid(low: DVec3, high: DVec3) -> [[DVec3; 4]; 6] {
    SIDES.map(|side| side.map(|number| corner(low, high, number)))
}

impl Mesh {
    /// A box between two corners, with a single material, 0. Its front is outside.
    #[must_use]
    pub fn cuboid(low: DVec3, high: DVec3) -> Self {
        let corners = [0, 1, 2, 3, 4, 5, 6, 7];
        let halves = |[a, b, c, d]: [u32; 4]| [[a, b, c], [a, c, d]];
        Self {
            positions: corners
                .map(|number| corner(low, high, number).as_vec3().to_array())
                .to_vec(),
            triangles: SIDES.into_iter().flat_map(halves).collect(),
            materials: vec![0; 2 * SIDES.len()],
            ..Self::default()
        }
    }

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
        normals.iter().all(|normal| *normal != Vec3::ZERO).then_some(normals)
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
        self.corners(triangle).map(|corner| self.origin + corner.as_dvec3())
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
        let (low, high) = positions
            .fold((first, first), |(low, high), position| (low.min(position), high.max(position)));
        let place = |corner: Vec3| self.origin + corner.as_dvec3();
        Some((place(low), place(high)))
    }

    /// The origin for a mesh in a box: its middle if it is so far away that singles would lose more
    /// than three binary digits there; otherwise that of the scene.
    #[must_use]
    pub fn origin_for(low: DVec3, high: DVec3) -> DVec3 {
        let middle = low.midpoint(high);
        let is_far = middle.abs().max_element() > 8.0 * (high - low).max_element();
        if is_far { middle } else { DVec3::ZERO }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::area_vector;

    #[test]
    fn box_is_closed_and_seen_from_outside() {
        let (low, high) = (DVec3::new(-1.0, 2.0, 0.5), DVec3::new(1.0, 3.0, 4.5));
        let middle = low.midpoint(high);
        let outwards = |polygon: &[DVec3]| {
            let centre = polygon.iter().sum::<DVec3>() / polygon.len() as f64;
            area_vector(polygon).dot(centre - middle) > 0.0
        };
        let sides = cuboid(low, high);
        assert!(sides.iter().all(|side| outwards(side)));
        assert_eq!(sides.iter().map(|side| area_vector(side)).sum::<DVec3>(), DVec3::ZERO);
        let mesh = Mesh::cuboid(low, high);
        assert_eq!(mesh.bounds(), Some((low, high)));
        let triangles = || (0..12).map(|number| mesh.places(number));
        assert!(triangles().all(|triangle| outwards(&triangle)));
        let area: f64 = triangles().map(|triangle| area_vector(&triangle).length()).sum();
        let whole: f64 = sides.iter().map(|side| area_vector(side).length()).sum();
        assert!((area - whole).abs() < 1e-12, "{area} {whole}");
    }
}
