//! Polygons, which become a parallelogram or triangles.
//!
//! Invariant: the triangles of a polygon are in one plane, except for rounding, and fill its
//! inside by the even-odd rule. Triangles that share a vertex have bit-identical coordinates
//! there.

use std::borrow::Cow;

use glam::DVec3;
use scenes::{area_vector, unit};

use super::error::BlockError;
use super::primitive::{FLAT, Primitive};
use super::source_location::SourceLocation;
use crate::scene::single::{LARGEST, SMALLEST};
use protocol::layout::MAX_OBJECTS;

/// By how much a corner of a parallelogram may be off, relative to the longer edge: half a unit in
/// the last place of the record's numbers.
const OFF_CORNER: f64 = 1.0 / (1 << 24) as f64;

/// Height of a triangle, relative to its longest edge, below which no ray hits it.
const SLIVER: f64 = 1.0 / (1 << 24) as f64;

/// Checks that all vertices are in range.
pub(super) fn check_vertices(
    vertices: &[DVec3],
    place: SourceLocation<'_>,
) -> Result<(), BlockError> {
    let mut vertices = vertices.iter();
    vertices.try_for_each(|&vertex| place.vector("vertex", vertex))
}

/// The polygon as a parallelogram, if it is one.
pub(super) fn rectangle(vertices: &[DVec3]) -> Option<Primitive> {
    let &[corner, second, opposite, last] = vertices else {
        return None;
    };
    let edges = [second - corner, last - corner];
    let longer = edges[0].length().max(edges[1].length());
    let off = (opposite - second) - edges[1];
    if off.length() > OFF_CORNER * longer {
        return None;
    }
    let normal = unit(area_vector(vertices))?;
    let [u, v] = edges;
    let dual = |along: DVec3, other: DVec3| {
        let across = other.cross(normal);
        across / across.dot(along)
    };
    let duals = [dual(u, v), dual(v, u)];
    // If it is too small for its duals to be singles, it becomes triangles instead.
    let sound = |dual: &DVec3| dual.is_finite() && dual.abs().max_element() <= LARGEST;
    duals.iter().all(sound).then_some(Primitive::Rectangle { corner, edges, normal, duals })
}

/// The vertices of a polygon, projected onto the plane that goes through their mean at right
/// angles to `normal`.
fn in_plane(vertices: &[DVec3], normal: DVec3) -> Cow<'_, [DVec3]> {
    // Three vertices are always in a plane.
    let [first, _, _, _, ..] = *vertices else {
        return Cow::Borrowed(vertices);
    };
    // Relative to a vertex, because the sum of vertices far from the origin would lose digits.
    let sum: DVec3 = vertices.iter().map(|&vertex| vertex - first).sum();
    let middle = first + sum / vertices.len() as f64;
    let above = |vertex: DVec3| (vertex - middle).dot(normal);
    let largest = |size: &dyn Fn(DVec3) -> f64| {
        let sizes = vertices.iter().map(|&vertex| size(vertex));
        sizes.fold(0.0, f64::max)
    };
    let size = largest(&|vertex| vertex.distance(middle));
    if largest(&|vertex| above(vertex).abs()) <= FLAT * size {
        return Cow::Borrowed(vertices);
    }
    let put = |&vertex: &DVec3| vertex - above(vertex) * normal;
    Cow::Owned(vertices.iter().map(put).collect())
}

/// Finds the triangles of a polygon, except those without area. If the edges of a patch cross, its
/// triangles don't interpolate normals.
pub(super) fn triangles(
    vertices: &[DVec3],
    normals: Option<&Vec<DVec3>>,
    place: SourceLocation<'_>,
    mut found: impl FnMut(Primitive) -> Result<(), BlockError>,
) -> Result<(), BlockError> {
    let too_large =
        || BlockError::LargePolygon { place: place.to_string(), vertices: vertices.len() };
    // Checked first, because the time to find triangles grows with the square of their number.
    if vertices.len() > MAX_OBJECTS as usize + 2 {
        return Err(too_large());
    }
    let Some(normal) = unit(area_vector(vertices)) else {
        return Ok(());
    };
    let vertices = &*in_plane(vertices, normal);
    let mut found = |vertices: [DVec3; 3], smooth: Option<[DVec3; 3]>| {
        let [a, b, c] = vertices;
        let area = area_vector(&vertices).length();
        let longest = (b - a).length().max((c - b).length()).max((a - c).length());
        if longest < SMALLEST || area / longest <= SLIVER * longest {
            return Ok(());
        }
        found(Primitive::Triangle { vertices, normal, smooth })
    };
    let cut;
    let corners = match vertices {
        // Without allocating memory, because a moving object may be a triangle.
        [_, _, _] => Some(&[[0, 1, 2]][..]),
        _ => {
            cut = scenes::triangles(vertices);
            cut.as_deref()
        }
    };
    let Some(corners) = corners else {
        let crossing = scenes::even_odd(vertices, MAX_OBJECTS as usize);
        let crossing = crossing.ok_or_else(too_large)?;
        return crossing.into_iter().try_for_each(|triangle| found(triangle, None));
    };
    let of = |values: &[DVec3], corners: [u32; 3]| corners.map(|index| values[index as usize]);
    corners.iter().try_for_each(|&corners| {
        let unit_normals = |normals: &Vec<DVec3>| {
            of(normals, corners).map(|normal| unit(normal).unwrap_or(DVec3::ZERO))
        };
        found(of(vertices, corners), normals.map(unit_normals))
    })
}
