//! Polygons, convex or concave, and patches.
//!
//! A point is inside if a line from it crosses the edges an odd number of times. Crossings are
//! counted in the plane across the ray: the vertices are sheared so that the ray is the third
//! axis, in the same way for all polygons, and an edge always starts at its lower end (as in Woop,
//! Benthin and Wald, JCGT 2(1) 2013). So two polygons with a common edge decide consistently, and
//! no ray passes between them. Vertices off the polygon's plane are moved onto it first.

use glam::DVec3;
use scenes::{area_vector, triangles, unit};

use super::{Place, Sides, rounding};
use crate::bvh::Bounds;
use crate::ray::Ray;

/// The most vertices of a patch. The time to find its triangles grows with their square.
pub(crate) const MAX_PATCH_VERTICES: usize = 512;

/// How far off the plane a vertex may be without being moved, relative to the farthest vertex's
/// distance from the middle. Rounded numbers cause such errors, and a moved vertex would leave a
/// gap to its neighbours.
const OFF_PLANE: f64 = 1.0 / 262_144.0;

#[derive(Debug, Clone)]
pub(crate) struct Polygon {
    vertices: Vec<DVec3>,
    /// The mean of the vertices, which is in the plane.
    middle: DVec3,
    normal: DVec3,
    smooth: Vec<Facet>,
    sides: Sides,
}

/// A triangle of a patch.
#[derive(Debug, Clone, Copy)]
struct Facet {
    corners: [DVec3; 3],
    normals: [DVec3; 3],
}

impl Polygon {
    /// A polygon, or a patch if there is a normal for each vertex.
    pub(super) fn new(
        vertices: &[DVec3],
        normals: Option<&Vec<DVec3>>,
        sides: Sides,
    ) -> Option<Self> {
        let normal = unit(area_vector(vertices))?;
        // Relative to a vertex, because the sum of vertices far from the origin would lose digits.
        let first = *vertices.first()?;
        let sum: DVec3 = vertices.iter().map(|&vertex| vertex - first).sum();
        let middle = first + sum / vertices.len() as f64;
        let height = |vertex: &DVec3| normal.dot(*vertex - middle);
        let highest = vertices.iter().map(|vertex| height(vertex).abs());
        let farthest = vertices.iter().map(|vertex| vertex.distance(middle));
        let is_bent = highest.fold(0.0, f64::max) > OFF_PLANE * farthest.fold(0.0, f64::max);
        let lowered = |vertex: &DVec3| *vertex - height(vertex) * normal;
        let vertices: Vec<DVec3> = if is_bent && vertices.len() > 3 {
            vertices.iter().map(lowered).collect()
        } else {
            vertices.to_vec()
        };
        let smooth = normals.map_or(Vec::new(), |normals| {
            let unit_normal = |index: u32| unit(normals[index as usize]).unwrap_or(DVec3::ZERO);
            let facet = |triangle: [u32; 3]| Facet {
                corners: triangle.map(|index| vertices[index as usize]),
                normals: triangle.map(unit_normal),
            };
            // A patch whose edges cross has no triangles, and its normal is constant.
            let corners = triangles(&vertices).unwrap_or_default();
            corners.into_iter().map(facet).collect()
        });
        Some(Self { middle, vertices, normal, smooth, sides })
    }

    pub(super) fn hit(&self, ray: &Ray, limit: f64) -> Option<f64> {
        let closing = self.normal.dot(ray.direction);
        if !self.sides.seen(closing < 0.0) {
            return None;
        }
        let from_middle = ray.origin - self.middle;
        let above = self.normal.dot(from_middle);
        if above.abs() <= rounding(ray.origin, from_middle) {
            return None;
        }
        let distance = -above / closing;
        (distance > 0.0 && distance < limit && self.surrounds(ray)).then_some(distance)
    }

    /// Whether the ray's line goes through the polygon.
    fn surrounds(&self, ray: &Ray) -> bool {
        let mut inside = false;
        let Some(&last) = self.vertices.last() else {
            return inside;
        };
        let mut from = ray.sheared(last);
        for &vertex in &self.vertices {
            let to = ray.sheared(vertex);
            if (from.y > 0.0) != (to.y > 0.0) {
                let (low, high) = if from.y < to.y { (from, to) } else { (to, from) };
                inside ^= low.perp_dot(high) > 0.0;
            }
            from = to;
        }
        inside
    }

    pub(super) fn place(&self, point: DVec3) -> Place {
        let above = self.normal.dot(point - self.middle);
        let point = point - above * self.normal;
        Place {
            point,
            normal: self.normal,
            smooth: self.smooth_normal(point).unwrap_or(self.normal),
        }
    }

    /// The normal interpolated over the triangle that the point is in; nothing for a polygon, or
    /// where the vertices' normals cancel.
    fn smooth_normal(&self, point: DVec3) -> Option<DVec3> {
        let shares = |facet: &Facet| {
            let [a, b, c] = facet.corners;
            let part = |from: DVec3, to: DVec3| (from - point).cross(to - point).dot(self.normal);
            let parts = DVec3::new(part(b, c), part(c, a), part(a, b));
            let whole = (b - a).cross(c - a).dot(self.normal);
            (whole > 0.0).then(|| parts / whole)
        };
        let facets = self.smooth.iter().filter_map(|facet| Some((facet, shares(facet)?)));
        // Rounding may put a point on an inner edge outside of both: it is outside of
        // one by the smallest distance.
        let (facet, shares) =
            facets.max_by(|(_, a), (_, b)| a.min_element().total_cmp(&b.min_element()))?;
        let [a, b, c] = facet.normals;
        unit(shares.x * a + shares.y * b + shares.z * c)
    }

    pub(super) fn bounds(&self) -> Bounds {
        let point = |vertex: DVec3| Bounds { low: vertex, high: vertex };
        self.vertices.iter().fold(point(self.middle), |bounds, &vertex| bounds.with(point(vertex)))
    }
}
