//! Finds the triangles of a polygon whose edges cross, by the even-odd rule.
//!
//! Crossings become points, and the edges are cut at all points. Because a polygon is one closed
//! line, the pieces divide the plane into faces without holes. Each face is cut into ears. The
//! pieces then determine whether a triangle is inside.
//!
//! Invariant: shared points have bit-identical coordinates, so no gap shows between triangles. The
//! result is the same on every machine.

use std::collections::{BTreeMap, BTreeSet};

use glam::{DVec2, DVec3};

use crate::triangles::{cut, flat, height, rounding, turn};

/// The triangles that fill the inside of a planar polygon, counter-clockwise like the polygon. A
/// point is inside if a line from it crosses the edges an odd number of times. `None` if there
/// would be more than `most` triangles. The time grows with the squares of the numbers of vertices
/// and of crossings.
#[must_use]
pub fn even_odd(vertices: &[DVec3], most: usize) -> Option<Vec<[DVec3; 3]>> {
    let outline = flat(vertices);
    let mut points = Points { rounding: rounding(&outline), flat: Vec::new(), places: Vec::new() };
    let ring: Vec<u32> =
        outline.iter().zip(vertices).map(|(&at, &place)| points.number(at, || place)).collect();
    // Each crossing is a corner of two triangles, and a triangle has three corners.
    points.add_crossings(&ring, ring.len() + most / 2 * 3)?;

    // For each piece, whether an odd number of edges covers it. If the number is even, both sides
    // of the piece are equally inside or outside.
    let mut pieces = BTreeMap::new();
    for edge in edges(&ring) {
        for piece in points.on(edge).windows(2) {
            let piece = [piece[0].min(piece[1]), piece[0].max(piece[1])];
            *pieces.entry(piece).or_insert(false) ^= true;
        }
    }
    let border = pieces.iter().filter(|&(_, &is_odd)| is_odd);
    let border: Vec<[DVec2; 2]> =
        border.map(|(piece, _)| piece.map(|number| points.flat[number as usize])).collect();
    let mut found = Vec::new();
    for face in faces(pieces.keys(), &points.flat) {
        for corners in cut(face, &points.flat, points.rounding) {
            let corners_flat = corners.map(|number| points.flat[number as usize]);
            let [a, b, c] = corners_flat;
            if height(corners_flat) > points.rounding && is_inside(&border, (a + b + c) / 3.0) {
                found.push(corners.map(|number| points.places[number as usize]));
            }
        }
    }
    (found.len() <= most).then_some(found)
}

/// Points of a plane that differ by more than rounding, with their positions in space.
struct Points {
    rounding: f64,
    flat: Vec<DVec2>,
    places: Vec<DVec3>,
}

impl Points {
    /// The number of a point. A point that is not at an existing one is added.
    fn number(&mut self, at: DVec2, place: impl FnOnce() -> DVec3) -> u32 {
        let is_there = |other: &DVec2| other.distance(at) <= self.rounding;
        let number = self.flat.iter().position(is_there).unwrap_or_else(|| {
            self.flat.push(at);
            self.places.push(place());
            self.flat.len() - 1
        });
        number as u32
    }

    /// Adds the points where edges cross; `None` if there are more than `most` points then.
    fn add_crossings(&mut self, ring: &[u32], most: usize) -> Option<()> {
        let edges: Vec<[u32; 2]> = edges(ring).collect();
        for (index, &first) in edges.iter().enumerate() {
            for &second in &edges[..index] {
                let Some(share) = self.crossing(first, second) else {
                    continue;
                };
                let [from, to] = first.map(|number| number as usize);
                let at = self.flat[from].lerp(self.flat[to], share);
                let place = self.places[from].lerp(self.places[to], share);
                self.number(at, || place);
                if self.flat.len() > most {
                    return None;
                }
            }
        }
        Some(())
    }

    /// The position along the first edge where the second one crosses it, if both extend beyond
    /// the crossing by more than rounding.
    fn crossing(&self, first: [u32; 2], second: [u32; 2]) -> Option<f64> {
        let [a, b] = first.map(|number| self.flat[number as usize]);
        let [c, d] = second.map(|number| self.flat[number as usize]);
        let sides = |from: DVec2, to: DVec2, ends: [DVec2; 2]| {
            let tolerance = self.rounding * from.distance(to);
            let [one, other] = ends.map(|end| turn(from, to, end));
            let crosses =
                one.abs() > tolerance && other.abs() > tolerance && (one < 0.0) != (other < 0.0);
            crosses.then(|| one / (one - other))
        };
        sides(a, b, [c, d])?;
        sides(c, d, [a, b])
    }

    /// The points on an edge, from its start to its end.
    fn on(&self, [from, to]: [u32; 2]) -> Vec<u32> {
        let (start, end) = (self.flat[from as usize], self.flat[to as usize]);
        let way = end - start;
        let length = way.length();
        let mut on: Vec<(f64, u32)> = Vec::new();
        for (number, &at) in (0..).zip(&self.flat) {
            let along = (at - start).dot(way) / length;
            let beside = (at - start).perp_dot(way) / length;
            if along > 0.0 && along < length && beside.abs() <= 2.0 * self.rounding {
                on.push((along, number));
            }
        }
        on.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        let between = on.into_iter().map(|(_, number)| number);
        let between = between.filter(|number| ![from, to].contains(number));
        [from].into_iter().chain(between).chain([to]).collect()
    }
}

/// The edges of a ring, except those without length.
fn edges(ring: &[u32]) -> impl Iterator<Item = [u32; 2]> {
    let next = ring.iter().cycle().skip(1);
    let edges = ring.iter().zip(next).map(|(&from, &to)| [from, to]);
    edges.filter(|[from, to]| from != to)
}

/// The counter-clockwise rings around the faces into which pieces of edges divide the plane,
/// except the outermost face.
fn faces<'a>(pieces: impl Iterator<Item = &'a [u32; 2]> + Clone, flat: &[DVec2]) -> Vec<Vec<u32>> {
    // The neighbours of each point, counter-clockwise.
    let mut around: BTreeMap<u32, Vec<u32>> = BTreeMap::new();
    for &[one, other] in pieces.clone() {
        around.entry(one).or_default().push(other);
        around.entry(other).or_default().push(one);
    }
    for (&point, neighbours) in &mut around {
        let angle = |&other: &u32| angle(flat[other as usize] - flat[point as usize]);
        neighbours.sort_by(|a, b| angle(a).total_cmp(&angle(b)));
    }
    // Walking along pieces and always taking the leftmost turn keeps one face at the left.
    let next = |[from, to]: [u32; 2]| {
        let neighbours = &around[&to];
        let place = neighbours.iter().position(|&point| point == from)?;
        let before = place.checked_sub(1).unwrap_or(neighbours.len() - 1);
        Some([to, neighbours[before]])
    };
    let mut left: BTreeSet<[u32; 2]> =
        pieces.flat_map(|&[one, other]| [[one, other], [other, one]]).collect();
    let mut found = Vec::new();
    while let Some(first) = left.pop_first() {
        let mut ring = vec![first[0]];
        let mut way = first;
        while let Some(step) = next(way).filter(|step| left.remove(step)) {
            ring.push(step[0]);
            way = step;
        }
        without_spikes(&mut ring);
        let area: f64 = edges(&ring)
            .map(|edge| edge.map(|number| flat[number as usize] - flat[ring[0] as usize]))
            .map(|[from, to]| from.perp_dot(to))
            .sum();
        if area > 0.0 {
            found.push(ring);
        }
    }
    found
}

/// Removes the parts of a ring that go to a point and back the same way.
fn without_spikes(ring: &mut Vec<u32>) {
    let mut place = 0;
    while ring.len() > 2 && place < ring.len() {
        let len = ring.len();
        let (before, after) = ((place + len - 1) % len, (place + 1) % len);
        if ring[before] == ring[after] {
            ring.remove(place.max(after));
            ring.remove(place.min(after));
            // The part before it may be a spike now.
            place = place.saturating_sub(2);
        } else {
            place += 1;
        }
    }
}

/// A number that grows with the counter-clockwise angle of a direction, over the full circle.
fn angle(way: DVec2) -> f64 {
    let slope = way.y / (way.x.abs() + way.y.abs());
    if way.x < 0.0 { 2.0 - slope } else { slope }
}

/// Whether a line from a point crosses a border an odd number of times.
fn is_inside(border: &[[DVec2; 2]], point: DVec2) -> bool {
    let crossed = border.iter().filter(|&&[from, to]| {
        let upwards = to.y > point.y;
        (from.y > point.y) != upwards && (turn(from, to, point) > 0.0) == upwards
    });
    crossed.count() % 2 == 1
}
