//! A binary tree over a mesh's triangles, over spheres or over cones, by the surface area
//! heuristic in bins.
//! Its leaves are the contents of leaf blocks.
//!
//! Invariant: every piece is in the range of exactly one leaf, and the pieces of a leaf fit a
//! block.

use std::ops::Range;

use super::NumberWidth;
use super::leaf::WIDTH;
use super::sweep::sweep;
use glam::Vec3;
use protocol::layout::{
    Boxes, MESH_BLOCK, MESH_FACES, MESH_UPPER, MeshColour, MeshCoordinates, MeshFace, MeshHeader,
    MeshVertex, MeshVisibility, SIDES_TEXTURED,
};
use scenes::Mesh;

/// Bins of an axis.
const BINS: usize = 16;
/// The planned part of a leaf block's capacity that its triangles take. Blocks differ in how
/// many vertices are on their border, and pieces that don't fit become two blocks.
const FILL: f64 = 0.82;
/// Nodes of a leaf block with two levels.
pub(super) const LEAF_NODES: usize = 5;
/// Spheres or cones of a leaf block: four for each of its lowest nodes.
const OBJECTS: usize = WIDTH * (LEAF_NODES - 1);
/// Pieces of at most this number of blocks are divided into whole blocks.
const FEW_BLOCKS: usize = 8;

/// A box; without points its lower corner is above its upper one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Bounds {
    pub low: Vec3,
    pub high: Vec3,
}

impl Bounds {
    pub const EMPTY: Self = Self { low: Vec3::INFINITY, high: Vec3::NEG_INFINITY };

    pub fn with(self, other: Self) -> Self {
        Self { low: self.low.min(other.low), high: self.high.max(other.high) }
    }

    /// Half of its surface; 0 if it is empty.
    pub fn area(self) -> f64 {
        let size = (self.high - self.low).as_dvec3();
        if size.min_element() < 0.0 {
            return 0.0;
        }
        size.x * size.y + size.y * size.z + size.z * size.x
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// Triangles with these `SIDES_` bits.
    Triangles(u32),
    Spheres,
    Cones,
    /// A height field, whose blocks are not the mesh's own.
    Heights,
    /// Leaf blocks.
    Blocks,
}

impl Kind {
    /// The bytes that a vertex takes.
    fn vertex(self, is_coloured: bool) -> usize {
        let colour = if is_coloured { size_of::<MeshColour>() } else { 0 };
        match self {
            Self::Triangles(sides) if sides & SIDES_TEXTURED != 0 => {
                size_of::<MeshVertex>() + size_of::<MeshCoordinates>() + colour
            }
            _ => size_of::<MeshVertex>() + colour,
        }
    }
}

/// A triangle, a sphere or a cone, and its box.
#[derive(Clone, Copy, Debug)]
pub(super) struct Piece {
    pub bounds: Bounds,
    /// The triangle's index in the mesh, or that of the sphere or the cone.
    pub index: u32,
}

impl Piece {
    /// Twice the middle of its box.
    pub fn middle(&self) -> Vec3 {
        // Half first: the sum of two coordinates may be beyond the largest single.
        self.bounds.low * 0.5 + self.bounds.high * 0.5
    }
}

pub(super) fn around(pieces: &[Piece]) -> Bounds {
    let boxes = pieces.iter().map(|piece| piece.bounds);
    boxes.fold(Bounds::EMPTY, Bounds::with)
}

#[derive(Clone, Debug)]
pub(super) struct Node {
    pub bounds: Bounds,
    /// The pieces below it.
    pub pieces: Range<usize>,
    /// The number of leaves below it, or 1 if it is one.
    pub leaves: usize,
    /// The nodes below it, if it is not a leaf.
    pub halves: Option<[usize; 2]>,
}

/// Grows trees. The pieces change their order.
pub(super) struct Tree<'a> {
    mesh: &'a Mesh,
    pub pieces: Vec<Piece>,
    pub nodes: Vec<Node>,
    pub width: NumberWidth,
    /// About how many vertices a triangle of a leaf block has for itself.
    vertices: f64,
    /// For each vertex the last leaf that it was counted for.
    counted: Vec<u32>,
    count: u32,
    /// A buffer for the surfaces around pieces.
    areas: Vec<f64>,
}

impl<'a> Tree<'a> {
    pub fn new(mesh: &'a Mesh, pieces: Vec<Piece>, width: NumberWidth) -> Self {
        let shared = mesh.positions.len().min(3 * pieces.len()) as f64 / pieces.len().max(1) as f64;
        // The vertices on the border of a block's triangles are in other blocks, too.
        let vertices = (1.2 * shared).min(3.0);
        Self {
            mesh,
            pieces,
            nodes: Vec::new(),
            width,
            vertices,
            counted: vec![0; mesh.positions.len()],
            count: 0,
            areas: Vec::new(),
        }
    }

    /// Grows the tree of some pieces of one kind, and returns the index of its root.
    pub fn grow(&mut self, kind: Kind, pieces: Range<usize>) -> usize {
        let bounds = around(&self.pieces[pieces.clone()]);
        let (fits, capacity) = match kind {
            Kind::Triangles(_) => (self.fits(kind, pieces.clone()), self.capacity(kind)),
            Kind::Spheres | Kind::Cones | Kind::Heights => (pieces.len() <= OBJECTS, OBJECTS),
            Kind::Blocks => (pieces.len() <= 1, 1),
        };
        if fits {
            self.nodes.push(Node { bounds, pieces, leaves: 1, halves: None });
            return self.nodes.len() - 1;
        }
        // The triangles of levels differ so much in size that whole blocks would be worse.
        let few_blocks = if self.mesh.visibility.is_empty() { FEW_BLOCKS } else { 1 };
        let own = &mut self.pieces[pieces.clone()];
        let middle = pieces.start + split(own, capacity, few_blocks);
        let halves = [self.grow(kind, pieces.start..middle), self.grow(kind, middle..pieces.end)];
        self.join(halves)
    }

    /// Grows the tree of one or more leaf blocks that are in a good order, which they keep. That
    /// takes a small part of the time of [`Tree::grow`].
    pub fn grow_in_order(&mut self, pieces: Range<usize>) -> usize {
        if let [Piece { bounds, .. }] = self.pieces[pieces.clone()] {
            self.nodes.push(Node { bounds, pieces, leaves: 1, halves: None });
            return self.nodes.len() - 1;
        }
        let middle = pieces.start + divide(&self.pieces[pieces.clone()], &mut self.areas);
        let halves =
            [self.grow_in_order(pieces.start..middle), self.grow_in_order(middle..pieces.end)];
        self.join(halves)
    }

    /// Puts a node above two, whose pieces follow each other.
    pub fn join(&mut self, halves: [usize; 2]) -> usize {
        let [first, second] = halves.map(|half| &self.nodes[half]);
        let node = Node {
            bounds: first.bounds.with(second.bounds),
            pieces: first.pieces.start..second.pieces.end,
            leaves: first.leaves + second.leaves,
            halves: Some(halves),
        };
        self.nodes.push(node);
        self.nodes.len() - 1
    }

    /// About how many triangles of a kind a leaf block holds.
    fn capacity(&self, kind: Kind) -> usize {
        let capacity = self.block() - size_of::<MeshHeader>() - LEAF_NODES * size_of::<Boxes>();
        let vertex = kind.vertex(!self.mesh.colours.is_empty()) as f64;
        let face = size_of::<MeshFace>()
            + if self.has_visibility() { size_of::<MeshVisibility>() } else { 0 };
        let each = face as f64 + self.vertices * vertex;
        ((FILL * capacity as f64 / each) as usize).clamp(8, MESH_FACES as usize)
    }

    /// Whether a leaf block has capacity for triangles of a kind.
    fn fits(&mut self, kind: Kind, pieces: Range<usize>) -> bool {
        if pieces.len() > MESH_FACES as usize {
            return false;
        }
        self.count += 1;
        let mut vertices = 0;
        for piece in &self.pieces[pieces.clone()] {
            for vertex in self.mesh.triangles[piece.index as usize] {
                let last = &mut self.counted[vertex as usize];
                vertices += usize::from(*last != self.count);
                *last = self.count;
            }
        }
        let needed = size_of::<MeshHeader>()
            + LEAF_NODES * size_of::<Boxes>()
            + self.arrays(kind, vertices)
            + (pieces.len() * size_of::<MeshFace>()).next_multiple_of(16)
            + if self.has_visibility() { pieces.len() * size_of::<MeshVisibility>() } else { 0 };
        needed <= self.block()
    }

    /// Whether blocks have the visibility of lights.
    fn has_visibility(&self) -> bool {
        !self.mesh.colours.is_empty() && !self.mesh.visibility.is_empty()
    }

    /// The bytes of the vertices, including the padding to quadwords between arrays.
    fn arrays(&self, kind: Kind, vertices: usize) -> usize {
        match self.mesh.colours.is_empty() {
            true => vertices * kind.vertex(false),
            false => {
                let colours = vertices * size_of::<MeshColour>();
                let colours =
                    if self.has_visibility() { colours.next_multiple_of(16) } else { colours };
                (vertices * kind.vertex(false)).next_multiple_of(16) + colours
            }
        }
    }

    /// The bytes of a leaf block up to the upper bytes of the materials' numbers.
    fn block(&self) -> usize {
        match self.width {
            NumberWidth::Byte => MESH_BLOCK as usize,
            NumberWidth::TwoBytes => MESH_UPPER as usize,
        }
    }
}

/// Sorts pieces into two parts, and returns the length of the first one. Neither is empty.
fn split(pieces: &mut [Piece], capacity: usize, few_blocks: usize) -> usize {
    let count = pieces.len();
    if count > capacity && count <= few_blocks * capacity {
        // Whole blocks on one side: only the last one of these pieces isn't full.
        let blocks = |count: usize| count.div_ceil(capacity);
        return sweep(pieces, &|index| {
            let is_whole = [index, count - index].iter().any(|part| part.is_multiple_of(capacity));
            is_whole.then_some([blocks(index), blocks(count - index)])
        });
    }
    let mut span = Bounds::EMPTY;
    for piece in &*pieces {
        let middle = piece.middle();
        span = span.with(Bounds { low: middle, high: middle });
    }
    let Some((axis, scale, bin)) = best(pieces, span) else {
        // All pieces have the same middle.
        return pieces.len() / 2;
    };
    let mut first = 0;
    for index in 0..pieces.len() {
        if bin_of(pieces[index].middle()[axis], span.low[axis], scale) <= bin {
            pieces.swap(first, index);
            first += 1;
        }
    }
    first
}

/// Where at least two pieces are divided with the minimum cost, with a quarter or more on each
/// side. `areas` is a buffer.
fn divide(pieces: &[Piece], areas: &mut Vec<f64>) -> usize {
    let count = pieces.len();
    if count <= 2 {
        return 1;
    }
    let fewest = (count / 4).max(1);
    let last = count - fewest;
    let middle = &pieces[fewest..=last];
    areas.clear();
    let mut after = around(&pieces[last + 1..]);
    areas.extend(middle.iter().rev().map(|piece| {
        after = after.with(piece.bounds);
        after.area()
    }));
    let mut before = around(&pieces[..fewest]);
    let mut best = (f64::INFINITY, fewest);
    for ((at, piece), after) in (fewest..).zip(middle).zip(areas.iter().rev()) {
        let cost = before.area() * at as f64 + after * (count - at) as f64;
        if cost < best.0 {
            best = (cost, at);
        }
        before = before.with(piece.bounds);
    }
    best.1
}

fn bin_of(middle: f32, low: f32, scale: f32) -> usize {
    (((middle - low) * scale) as usize).min(BINS - 1)
}

/// The axis, the bins per length, and the last bin of the first part, with the minimum cost.
fn best(pieces: &[Piece], span: Bounds) -> Option<(usize, f32, usize)> {
    let size = span.high - span.low;
    let scales = size.to_array().map(|size| {
        let scale = BINS as f32 / size;
        (size > 0.0 && scale.is_finite()).then_some(scale)
    });
    let mut bins = [[(Bounds::EMPTY, 0_usize); BINS]; 3];
    for piece in pieces {
        let middle = piece.middle();
        for axis in 0..3 {
            if let Some(scale) = scales[axis] {
                let (bounds, count) = &mut bins[axis][bin_of(middle[axis], span.low[axis], scale)];
                *bounds = bounds.with(piece.bounds);
                *count += 1;
            }
        }
    }
    let mut best = None;
    let mut minimum = f64::INFINITY;
    for axis in 0..3 {
        let Some(scale) = scales[axis] else { continue };
        let bins = &bins[axis];
        let mut after = [(Bounds::EMPTY, 0); BINS];
        for index in (0..BINS - 1).rev() {
            let (bounds, count) = bins[index + 1];
            after[index] = (after[index + 1].0.with(bounds), after[index + 1].1 + count);
        }
        let mut before = (Bounds::EMPTY, 0);
        for index in 0..BINS - 1 {
            before = (before.0.with(bins[index].0), before.1 + bins[index].1);
            let after = after[index];
            if before.1 == 0 || after.1 == 0 {
                continue;
            }
            let cost = before.0.area() * before.1 as f64 + after.0.area() * after.1 as f64;
            if cost < minimum || best.is_none() {
                minimum = cost;
                best = Some((axis, scale, index));
            }
        }
    }
    best
}
