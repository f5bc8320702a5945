//! The plan of a map: triangles between its lines, each in a sector.
//!
//! The triangles are a constrained Delaunay triangulation of the map's vertices, so they share
//! their vertices with one another and with the walls, and no gap can show between them. Nodes that
//! a map has for its game are not read: whatever a file has there, a place is found by triangles.
//!
//! The sides of a line name their sectors. Regions that no line divides may still have lines of
//! several sectors, in maps that leave a sector open on purpose or by mistake. There the longest
//! lines decide.

use std::collections::{BTreeMap, HashMap};

use glam::DVec2;
use spade::handles::{FixedFaceHandle, FixedVertexHandle, InnerTag};
use spade::{ConstrainedDelaunayTriangulation, Point2, Triangulation as _};

use crate::Map;

/// The plan of a map.
#[derive(Clone, Debug, Default)]
pub struct Plan {
    /// The triangles that are in a sector.
    pub regions: Vec<Region>,
    /// For each line of the map, the places at which other lines cut it into pieces, from its first
    /// end to its last one. A line that is not part of the triangulation has only its ends.
    pub pieces: Vec<Vec<DVec2>>,
    /// Notes about omitted parts, as sentences.
    pub notes: Vec<String>,
}

/// A triangle of a plan.
#[derive(Clone, Copy, Debug)]
pub struct Region {
    /// Its corners, counter-clockwise on the map.
    pub corners: [DVec2; 3],
    /// The number of the sector that it is in.
    pub sector: u32,
}

impl Region {
    /// Whether a place is in it or on its edge.
    #[must_use]
    pub fn holds(&self, place: DVec2) -> bool {
        let [a, b, c] = self.corners;
        [(a, b), (b, c), (c, a)].iter().all(|&(from, to)| (to - from).perp_dot(place - from) >= 0.0)
    }
}

type Triangles = ConstrainedDelaunayTriangulation<Point2<f64>>;
type Face = FixedFaceHandle<InnerTag>;

/// The sectors on the two sides of an edge from one vertex to another: to the right and to the
/// left.
type Sides = [Option<u32>; 2];

impl Plan {
    /// Makes the plan of a map.
    #[must_use]
    pub fn of(map: &Map) -> Self {
        let mut plan = Self::default();
        let mut triangles = Triangles::new();
        let mut handles: Vec<Option<FixedVertexHandle>> = vec![None; map.vertices.len()];
        // Only vertices that lines have; nodes' builders add others.
        for vertex in map.lines.iter().flat_map(|line| line.ends) {
            let place = map.vertices[vertex as usize];
            let handle = &mut handles[vertex as usize];
            if handle.is_none() {
                // Coordinates of 16 bits are always in the triangulation's range.
                *handle = triangles.insert(Point2::new(place.x, place.y)).ok();
            }
        }
        let mut edges: HashMap<[usize; 2], Sides> = HashMap::new();
        for (number, line) in map.lines.iter().enumerate() {
            let mut piece = vec![map.vertices[line.ends[0] as usize]];
            let [from, to] = line.ends.map(|end| handles[end as usize]);
            if let (Some(from), Some(to)) = (from, to) {
                let made = triangles.try_add_constraint(from, to);
                if made.is_empty() {
                    plan.notes.push(format!("line {number} crosses another line"));
                }
                for edge in made {
                    let edge = triangles.directed_edge(edge);
                    let ends = [edge.from(), edge.to()];
                    let [from, to] = ends.map(|end| end.fix().index());
                    let back = line.back.as_ref().map(|side| side.sector);
                    let front = Some(line.front.sector);
                    edges.entry([from, to]).or_insert([front, back]);
                    edges.entry([to, from]).or_insert([back, front]);
                    let place = ends[1].position();
                    piece.push(DVec2::new(place.x, place.y));
                }
            }
            if piece.len() == 1 {
                piece.push(map.vertices[line.ends[1] as usize]);
            }
            plan.pieces.push(piece);
        }
        plan.add_regions(&triangles, &edges);
        plan
    }

    /// Finds the sector of each triangle.
    fn add_regions(&mut self, triangles: &Triangles, edges: &HashMap<[usize; 2], Sides>) {
        let mut is_done = vec![false; triangles.num_all_faces()];
        for first in triangles.inner_faces() {
            if std::mem::replace(&mut is_done[first.fix().index()], true) {
                continue;
            }
            // All triangles that no line divides from the first one.
            let mut faces: Vec<Face> = vec![first.fix()];
            // In the order of their numbers, so that the same one of equal lengths always decides.
            let mut votes: BTreeMap<Option<u32>, f64> = BTreeMap::new();
            let mut next = 0;
            while let Some(&face) = faces.get(next) {
                next += 1;
                for edge in triangles.face(face).adjacent_edges() {
                    let ends = [edge.from(), edge.to()].map(|end| end.fix().index());
                    // The face is to the left of its edges.
                    if let Some([_, left]) = edges.get(&ends) {
                        *votes.entry(*left).or_default() += edge.length_2().sqrt();
                    } else if let Some(other) = edge.rev().face().as_inner()
                        && !std::mem::replace(&mut is_done[other.fix().index()], true)
                    {
                        faces.push(other.fix());
                    }
                }
            }
            let decided = votes.iter().max_by(|one, other| one.1.total_cmp(other.1));
            let Some((&Some(sector), _)) = decided else { continue };
            self.regions.extend(faces.iter().map(|&face| {
                let corners = triangles.face(face).positions();
                Region { corners: corners.map(|place| DVec2::new(place.x, place.y)), sector }
            }));
        }
    }
}
