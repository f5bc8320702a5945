//! The triangles of a polygon, by cutting ears.
//!
//! Invariant: a polygon of n vertices gives n - 2 triangles of its vertices, each counter-clockwise
//! as the polygon is where that is simple; and the same ones on every machine. A convex polygon
//! gives the fan around its first vertex.

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
    edges.fold(DVec3::ZERO, |sum, (from, to)| {
        sum + (from - first).cross(to - first)
    })
}

/// The triangles of a polygon, as indices of its vertices: of the corners left, beginning with the
/// second, the first that is an ear is cut, until three are left. Takes time with the square of the
/// number of vertices.
#[must_use]
pub fn triangles(vertices: &[DVec3]) -> Vec<[u32; 3]> {
    let flat = flat(vertices);
    let mut left: Vec<u32> = (0..vertices.len() as u32).collect();
    let mut found = Vec::with_capacity(vertices.len().saturating_sub(2));
    while left.len() > 3 {
        let ear = first_ear(&flat, &left);
        found.push(corner(&left, ear));
        left.remove(ear);
    }
    if let [a, b, c] = left[..] {
        found.push([a, b, c]);
    }
    found
}

/// The polygon's vertices in its own plane, counter-clockwise.
fn flat(vertices: &[DVec3]) -> Vec<DVec2> {
    let normal = unit(area_vector(vertices)).unwrap_or(DVec3::Z);
    let (right, up) = normal.any_orthonormal_pair();
    let project = |&vertex: &DVec3| {
        let from_first = vertex - vertices[0];
        DVec2::new(from_first.dot(right), from_first.dot(up))
    };
    vertices.iter().map(project).collect()
}

/// The corner at a place of the ring: the vertex before, its own and the one after.
fn corner(ring: &[u32], place: usize) -> [u32; 3] {
    let len = ring.len();
    [
        ring[(place + len - 1) % len],
        ring[place],
        ring[(place + 1) % len],
    ]
}

/// Place of the first corner, from the second on, whose triangle lies in the polygon; without one,
/// as where edges cross, that of the second.
fn first_ear(flat: &[DVec2], ring: &[u32]) -> usize {
    let turn = |[a, b, c]: [u32; 3]| turn(flat[a as usize], flat[b as usize], flat[c as usize]);
    // Only a vertex at which the polygon is not convex can be the deepest within an ear.
    let hollow: Vec<u32> = (0..ring.len())
        .filter(|&place| turn(corner(ring, place)) <= 0.0)
        .map(|place| ring[place])
        .collect();
    let is_ear = |place: usize| {
        let [a, b, c] = corner(ring, place);
        turn([a, b, c]) > 0.0
            && hollow.iter().all(|&vertex| {
                let at = flat[vertex as usize];
                let own = [a, b, c].map(|index| flat[index as usize] == at);
                own.contains(&true)
                    || turn([a, b, vertex]) < 0.0
                    || turn([b, c, vertex]) < 0.0
                    || turn([c, a, vertex]) < 0.0
            })
    };
    let len = ring.len();
    (1..=len)
        .map(|place| place % len)
        .find(|&place| is_ear(place))
        .unwrap_or(1)
}

/// Twice the area of a triangle, negative if it is clockwise.
fn turn(a: DVec2, b: DVec2, c: DVec2) -> f64 {
    (b - a).perp_dot(c - a)
}
