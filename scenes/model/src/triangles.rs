//! The triangles of a polygon whose edges do not cross, by cutting ears.
//!
//! Invariant: the triangles are of the polygon's own vertices, counter-clockwise as it is, overlap
//! nowhere, and are the same ones on every machine. A convex polygon gives the fan around its
//! first vertex.

use glam::{DVec2, DVec3};

use crate::unit;

/// The vector at right angles to a planar polygon, on the side from which it is counter-clockwise,
/// as long as twice its area. Newell's sum, which corners on a line and concave ones do not upset.
#[must_use]
pub fn area_vector(vertices: &[DVec3]) -> DVec3 {
    let Some(&first) = vertices.first() else {
        return DVec3::ZERO;
    };
    // From a vertex of its own: far from the origin the products would lose the polygon.
    let edges = vertices.windows(2).map(|edge| (edge[0], edge[1]));
    edges.fold(DVec3::ZERO, |sum, (from, to)| sum + (from - first).cross(to - first))
}

/// The triangles of a polygon, as indices of its vertices. Of the remaining corners, starting with
/// the second, the first one that is an ear is cut off until three are left. The time grows with
/// the square of the number of vertices.
///
/// `None` if the triangles would not fill the inside by the even-odd rule, because edges cross.
/// Use [`even_odd`](crate::even_odd) then.
#[must_use]
pub fn triangles(vertices: &[DVec3]) -> Option<Vec<[u32; 3]>> {
    if vertices.len() == 3 {
        return Some(vec![[0, 1, 2]]);
    }
    let flat = flat(vertices);
    let found = cut((0..vertices.len() as u32).collect(), &flat, 0.0);
    is_cover(&found, &flat).then_some(found)
}

/// Cuts the ears off a ring of points, given by their indices. Points within `slack` of an edge
/// count as on it.
pub(crate) fn cut(mut ring: Vec<u32>, flat: &[DVec2], slack: f64) -> Vec<[u32; 3]> {
    let mut found = Vec::with_capacity(ring.len().saturating_sub(2));
    while ring.len() > 3 {
        let ear = first_ear(flat, &ring, slack);
        found.push(corner(&ring, ear));
        ring.remove(ear);
    }
    if let [a, b, c] = ring[..] {
        found.push([a, b, c]);
    }
    found
}

/// Whether the triangles of a ring are all counter-clockwise and don't overlap. The number of
/// triangles that contain a point is the ring's winding number there, so that is then at most 1.
fn is_cover(triangles: &[[u32; 3]], flat: &[DVec2]) -> bool {
    let rounding = rounding(flat);
    let mut sound: Vec<([DVec2; 3], DVec2, DVec2)> = Vec::with_capacity(triangles.len());
    for triangle in triangles {
        let corners = triangle.map(|index| flat[index as usize]);
        let [a, b, c] = corners;
        match height(corners) {
            height if height > rounding => {}
            height if height < -rounding => return false,
            _ => continue,
        }
        let (low, high) = (a.min(b).min(c), a.max(b).max(c));
        let mut others = sound.iter();
        let overlaps = |(other, other_low, other_high): &([DVec2; 3], DVec2, DVec2)| {
            other_low.cmplt(high).all()
                && low.cmplt(*other_high).all()
                && !lies_beside(other, &corners, rounding)
                && !lies_beside(&corners, other, rounding)
        };
        if others.any(overlaps) {
            return false;
        }
        sound.push((corners, low, high));
    }
    true
}

/// Whether a triangle is on the outer side of another one's edge.
fn lies_beside(corners: &[DVec2; 3], other: &[DVec2; 3], rounding: f64) -> bool {
    let [a, b, c] = *other;
    [(a, b), (b, c), (c, a)].iter().any(|&(from, to)| {
        let within = rounding * from.distance(to);
        corners.iter().all(|&corner| turn(from, to, corner) <= within)
    })
}

/// A negligible distance: the error of points by rounding, which is far less than a picture shows.
pub(crate) fn rounding(flat: &[DVec2]) -> f64 {
    let reach = flat.iter().map(|point| point.abs().max_element());
    reach.fold(0.0, f64::max) / (1_u64 << 40) as f64
}

/// The height of a triangle over its longest edge, negative if it is clockwise.
pub(crate) fn height([a, b, c]: [DVec2; 3]) -> f64 {
    let longest = a.distance(b).max(b.distance(c)).max(c.distance(a));
    if longest > 0.0 { turn(a, b, c) / longest } else { 0.0 }
}

/// The polygon's vertices in its own plane, counter-clockwise.
pub(crate) fn flat(vertices: &[DVec3]) -> Vec<DVec2> {
    let normal = unit(area_vector(vertices)).unwrap_or(DVec3::Z);
    let (right, up) = normal.any_orthonormal_pair();
    let project = |&vertex: &DVec3| {
        let from_first = vertex - vertices[0];
        DVec2::new(from_first.dot(right), from_first.dot(up))
    };
    vertices.iter().map(project).collect()
}

/// The corner at a place of the ring: the previous vertex, the vertex itself, and the next one.
fn corner(ring: &[u32], place: usize) -> [u32; 3] {
    let len = ring.len();
    [ring[(place + len - 1) % len], ring[place], ring[(place + 1) % len]]
}

/// The place of the first corner, from the second on, whose triangle is inside the polygon. If
/// there is none, which is possible if edges cross, the second corner's place.
fn first_ear(flat: &[DVec2], ring: &[u32], slack: f64) -> usize {
    let at = |vertex: u32| flat[vertex as usize];
    let turn = |a: u32, b: u32, c: u32| turn(at(a), at(b), at(c));
    let tolerance = |from: u32, to: u32| slack * at(from).distance(at(to));
    let is_convex = |[a, b, c]: [u32; 3]| turn(a, b, c) > tolerance(a, c);
    let is_right = |from: u32, to: u32, vertex: u32| turn(from, to, vertex) < -tolerance(from, to);
    // Only a vertex at which the polygon is concave can be the deepest one within an ear.
    let hollow: Vec<u32> = (0..ring.len())
        .filter(|&place| !is_convex(corner(ring, place)))
        .map(|place| ring[place])
        .collect();
    let is_ear = |place: usize| {
        let [a, b, c] = corner(ring, place);
        is_convex([a, b, c])
            && hollow.iter().all(|&vertex| {
                let own = [a, b, c].map(|own| at(own) == at(vertex));
                own.contains(&true)
                    || is_right(a, b, vertex)
                    || is_right(b, c, vertex)
                    || is_right(c, a, vertex)
            })
    };
    let len = ring.len();
    (1..=len).map(|place| place % len).find(|&place| is_ear(place)).unwrap_or(1)
}

/// Twice the area of a triangle, negative if it is clockwise.
pub(crate) fn turn(a: DVec2, b: DVec2, c: DVec2) -> f64 {
    (b - a).perp_dot(c - a)
}
