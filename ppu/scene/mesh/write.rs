//! Writes a cut tree's blocks.

use std::collections::VecDeque;
use std::ops::Range;

use protocol::layout::{
    Boxes, Cone, HEIGHT_TREE, MESH_BLOCK, MESH_BLOCKS, MESH_CONES, MESH_INNER, MESH_LEAF,
    MESH_MAGIC, MESH_RUN, MESH_SPHERES, MESH_UPPER, MeshColour, MeshCoordinates, MeshFace,
    MeshHeader, MeshVertex, MeshVisibility, NO_BOX, Object, SIDES_COLOURED, SIDES_SMOOTH,
    SIDES_TEXTURED, SIDES_VISIBILITY, SIDES_WIDE,
};
use scenes::Mesh;
use zerocopy::big_endian::{F32, U32};
use zerocopy::{FromZeros as _, IntoBytes as _};

use super::cut::cut;
use super::leaf::{WIDTH, run_bounds, runs};
use super::normal::packed;
use super::objects::MeshObjects;
use super::statistics::MeshStatistics;
use super::tree::{Bounds, Kind, Node, Tree, around};
use super::{Block, MeshBlocks, MeshError, NumberWidth};

/// Bits of a run's word below the number of its triangles.
pub(super) const RUN_SHIFT: u32 = 16;

#[derive(Clone, Copy)]
pub(super) struct Content<'a> {
    pub mesh: &'a Mesh,
    pub objects: &'a MeshObjects,
    /// The number of each material of the scene.
    pub numbers: &'a [u32],
    /// The packed colours of the mesh's vertices, if there are any.
    pub colours: &'a [u32],
}

/// Writes the blocks of a tree. `ends` has the kind of the pieces before each index, and
/// `materials` the materials in the order of their numbers.
pub(super) fn blocks(
    content: Content<'_>,
    tree: Tree<'_>,
    root: usize,
    ends: &[(usize, Kind)],
    materials: Vec<u32>,
) -> Result<MeshBlocks, MeshError> {
    let Tree { mut pieces, nodes, width, .. } = tree;
    let Content { mesh, objects, .. } = content;
    let grounds = ends.iter().filter(|(_, kind)| *kind == Kind::Heights).count();
    let statistics = MeshStatistics {
        triangles: pieces.len() - objects.len() - grounds,
        spheres: objects.spheres.len(),
        cones: objects.cones.len(),
        left_out: mesh.triangles.len() + objects.len() + grounds - pieces.len(),
        ..MeshStatistics::default()
    };
    let mut writer = Writer::new(&nodes, root, content, width, statistics);
    let mut blocks: Vec<Block> = Vec::with_capacity(nodes[root].leaves * 17 / 16 + 1);
    let mut waiting = VecDeque::from([root]);
    let mut next = 1;
    let kind_of = |node: &Node| ends.iter().find(|(end, _)| node.pieces.start < *end);
    let is_ground =
        |node: &Node| node.halves.is_none() && matches!(kind_of(node), Some((_, Kind::Heights)));
    while let Some(at) = waiting.pop_front() {
        let number = blocks.len() as u32;
        let node = &nodes[at];
        if node.halves.is_none() && !is_ground(node) {
            let kind = kind_of(node);
            let own = &mut pieces[node.pieces.clone()];
            blocks.push(match kind {
                Some(&(_, Kind::Triangles(sides))) => writer.leaf(number, sides, own),
                Some(&(_, kind)) => writer.of_objects(number, kind, own),
                None => continue,
            });
        } else {
            let mut child = |at: usize| {
                if is_ground(&nodes[at]) {
                    return HEIGHT_TREE;
                }
                waiting.push_back(at);
                next += 1;
                next - 1
            };
            blocks.push(writer.inner(number, at, &mut child));
        }
    }
    match blocks.len() {
        count if count > MESH_BLOCKS as usize => Err(MeshError::TooManyBlocks(count)),
        _ => Ok(MeshBlocks {
            statistics: writer.statistics,
            sources: writer.sources,
            cost: writer.cost,
            cost_when_built: writer.cost,
            vertices: mesh.positions.len(),
            flat: flat(mesh).collect(),
            without_area: Vec::new(),
            uses_all: uses_all(mesh),
            most: blocks.len() as u32,
            blocks,
            materials,
            width,
            is_coloured: !content.colours.is_empty(),
            has_visibility: !content.colours.is_empty() && !mesh.visibility.is_empty(),
        }),
    }
}

/// The vertices with a normal of 0, in their order.
pub(super) fn flat(mesh: &Mesh) -> impl Iterator<Item = u32> {
    let numbered = mesh.normals.iter().zip(0..);
    numbered.filter(|(normal, _)| **normal == [0.0; 3]).map(|(_, vertex)| vertex)
}

pub(super) fn uses_all(mesh: &Mesh) -> bool {
    let mut is_used = vec![false; mesh.positions.len()];
    mesh.triangles.iter().flatten().for_each(|&vertex| is_used[vertex as usize] = true);
    is_used.into_iter().all(|is_used| is_used)
}

/// A coordinate in a block. A 0 has no sign, and there are no denormals, which SPUs take for 0: so
/// of equal numbers a box has the same bits, whoever compares them.
pub(super) fn coordinate(number: f32) -> F32 {
    F32::new(if number.abs() < f32::MIN_POSITIVE { 0.0 } else { number })
}

/// Writes the blocks above a tree's leaves, which are blocks themselves, and calls `store` with the
/// number and the bytes of each.
pub(super) fn above(tree: &Tree<'_>, root: usize, mut store: impl FnMut(usize, &[u8])) {
    let Tree { pieces, nodes, width, .. } = tree;
    let nothing = (&Mesh::default(), &MeshObjects::default());
    let (mesh, objects) = nothing;
    let content = Content { mesh, objects, numbers: &[], colours: &[] };
    let mut writer = Writer::new(nodes, root, content, *width, MeshStatistics::default());
    let mut waiting = VecDeque::from([root]);
    let mut next = 1;
    for number in 0.. {
        let Some(at) = waiting.pop_front() else { break };
        let mut child = |at: usize| match &nodes[at] {
            Node { halves: None, pieces: own, .. } => pieces[own.start].index,
            _ => {
                waiting.push_back(at);
                next += 1;
                next - 1
            }
        };
        store(number, &writer.inner(number as u32, at, &mut child).0);
    }
}

/// The first block of a tree that has nothing.
pub(super) fn without_boxes() -> Block {
    let mut block = Block([0; MESH_BLOCK as usize]);
    let all = [header(0, MESH_INNER, 1, 1).as_bytes(), no_boxes().as_bytes()].concat();
    block.0[..all.len()].copy_from_slice(&all);
    block
}

struct Writer<'a> {
    nodes: &'a [Node],
    content: Content<'a>,
    width: NumberWidth,
    /// The surface of the whole mesh's box.
    whole: f64,
    /// For each vertex its index in the last leaf block that has it.
    local: Vec<u8>,
    /// The vertices of all leaf blocks, block after block.
    sources: Vec<u32>,
    /// The surfaces of all boxes, each times the tests that a ray makes that meets it.
    cost: f64,
    statistics: MeshStatistics,
}

/// A child of a node: its box, and its word.
type Child = (Bounds, u32);

/// The children of a node of an inner block.
struct Children {
    all: [Child; WIDTH],
    count: usize,
}

impl Default for Children {
    fn default() -> Self {
        Self { all: [(Bounds::EMPTY, 0); WIDTH], count: 0 }
    }
}

impl Children {
    fn push(&mut self, child: Child) {
        self.all[self.count] = child;
        self.count += 1;
    }
}

impl AsRef<[Child]> for Children {
    fn as_ref(&self) -> &[Child] {
        &self.all[..self.count]
    }
}

impl<'a> Writer<'a> {
    fn new(
        nodes: &'a [Node],
        root: usize,
        content: Content<'a>,
        width: NumberWidth,
        statistics: MeshStatistics,
    ) -> Self {
        Self {
            nodes,
            content,
            width,
            // Boxes without a surface, of flat meshes along an axis, have edges at least.
            whole: nodes[root].bounds.area().max(f64::MIN_POSITIVE),
            local: vec![0; content.mesh.positions.len()],
            sources: Vec::new(),
            cost: 0.0,
            statistics,
        }
    }

    /// The part of all rays that meets a box.
    fn share(&self, bounds: Bounds) -> f64 {
        bounds.area() / self.whole
    }

    fn leaf(&mut self, number: u32, sides: u32, pieces: &mut [super::Piece]) -> Block {
        let groups = runs(pieces, MESH_RUN as usize);
        let mut first = 0;
        let mut lowest: Vec<Vec<Child>> = Vec::with_capacity(groups.len());
        for lengths in &groups {
            let mut children = Vec::with_capacity(lengths.len());
            for &length in lengths {
                let bounds = run_bounds(pieces, first, length);
                let word = first as u32 * size_of::<MeshFace>() as u32;
                children.push((bounds, word | (length as u32) << RUN_SHIFT));
                self.statistics.expected_triangles += self.share(bounds) * length as f64;
                self.cost += bounds.area() * (length - 1) as f64;
                first += length;
            }
            lowest.push(children);
        }
        self.statistics.leaves += 1;
        let (nodes, levels) = under_a_root(lowest);

        let Content { mesh, numbers, colours: packed_colours, .. } = self.content;
        // In the mesh's order, so that many follow one another there.
        let corners = pieces.iter().flat_map(|piece| mesh.triangles[piece.index as usize]);
        let mut own: Vec<u32> = corners.collect();
        own.sort_unstable();
        own.dedup();
        self.sources.extend_from_slice(&own);
        let mut vertices = Vec::with_capacity(own.len());
        let mut coordinates = Vec::new();
        let mut colours = Vec::new();
        for (&vertex, index) in own.iter().zip(0..) {
            let vertex = vertex as usize;
            self.local[vertex] = index;
            let normal = if sides & SIDES_SMOOTH != 0 {
                let [x, y, z] = mesh.normals[vertex].map(f64::from);
                packed(glam::DVec3::new(x, y, z))
            } else {
                0
            };
            if sides & SIDES_TEXTURED != 0 {
                let [u, v] = mesh.texture_coordinates[vertex].map(F32::new);
                coordinates.push(MeshCoordinates { u, v });
            }
            if let Some(&packed) = packed_colours.get(vertex) {
                colours.push(MeshColour { packed: packed.into() });
            }
            vertices.push(MeshVertex {
                position: mesh.positions[vertex].map(coordinate),
                normal: normal.into(),
            });
        }
        let mut faces = Vec::with_capacity(pieces.len());
        let mut upper = Vec::with_capacity(pieces.len());
        let mut visibility = Vec::new();
        for piece in &*pieces {
            let triangle = piece.index as usize;
            let vertex = mesh.triangles[triangle].map(|vertex| self.local[vertex as usize]);
            let number = numbers[mesh.materials[triangle] as usize];
            faces.push(MeshFace { vertex, material: number as u8 });
            upper.push((number >> 8) as u8);
            if let Some(known) = mesh.visibility.get(triangle).filter(|_| !colours.is_empty()) {
                let (dark, lit) = (known.dark.into(), known.lit.into());
                visibility.push(MeshVisibility { dark, lit });
            }
        }
        let wide = match self.width {
            NumberWidth::Byte => 0,
            NumberWidth::TwoBytes => SIDES_WIDE,
        };
        let coloured = match colours.is_empty() {
            true => 0,
            false => SIDES_COLOURED,
        };
        let marked = match visibility.is_empty() {
            true => 0,
            false => SIDES_VISIBILITY,
        };
        let header = MeshHeader {
            triangles: (faces.len() as u32).into(),
            vertices: (vertices.len() as u32).into(),
            sides: (sides | wide | coloured | marked).into(),
            ..header(number, MESH_LEAF, levels, nodes.len())
        };
        let mut block = self.block(
            around(pieces),
            &header,
            &nodes,
            &[
                vertices.as_bytes(),
                faces.as_bytes(),
                coordinates.as_bytes(),
                colours.as_bytes(),
                visibility.as_bytes(),
            ],
        );
        if wide != 0 {
            block.0[MESH_UPPER as usize..][..upper.len()].copy_from_slice(&upper);
        }
        block
    }

    fn of_objects(&mut self, number: u32, kind: Kind, pieces: &mut [super::Piece]) -> Block {
        let (kind_of_block, size, expected) = match kind {
            Kind::Cones => (MESH_CONES, size_of::<Cone>(), &mut self.statistics.expected_cones),
            _ => (MESH_SPHERES, size_of::<Object>(), &mut self.statistics.expected_spheres),
        };
        let groups = runs(pieces, 1);
        let nodes = groups.len() + usize::from(groups.len() > 1);
        let mut rest = pieces.iter();
        let mut records = Vec::with_capacity(pieces.len() * size);
        let mut lowest = Vec::with_capacity(groups.len());
        for group in &groups {
            let mut children = Vec::with_capacity(group.len());
            for piece in rest.by_ref().take(group.len()) {
                children.push((piece.bounds, offset(nodes) + records.len() as u32));
                let Content { objects, numbers, .. } = self.content;
                objects.write(kind, piece.index, numbers, &mut records);
                *expected += piece.bounds.area() / self.whole;
            }
            lowest.push(children);
        }
        self.statistics.leaves += 1;
        let (nodes, levels) = under_a_root(lowest);
        let header = MeshHeader {
            triangles: (pieces.len() as u32).into(),
            ..header(number, kind_of_block, levels, nodes.len())
        };
        self.block(around(pieces), &header, &nodes, &[&records])
    }

    /// Writes an inner block. `child` gives a node of the tree a block's number.
    fn inner(&mut self, number: u32, at: usize, child: &mut dyn FnMut(usize) -> u32) -> Block {
        let (branches, levels) = cut(self.nodes, at);
        let mut next = 1;
        let nodes = branches.iter().map(|items| {
            let mut children = Children::default();
            for &item in items.iter() {
                let word = if next < branches.len() { offset(next) } else { child(item) };
                next += 1;
                children.push((self.nodes[item].bounds, word));
            }
            children
        });
        let nodes: Vec<Children> = nodes.collect();
        self.statistics.inner += 1;
        let header = header(number, MESH_INNER, levels, nodes.len());
        self.block(self.nodes[at].bounds, &header, &nodes, &[])
    }

    fn block(
        &mut self,
        bounds: Bounds,
        header: &MeshHeader,
        nodes: &[impl AsRef<[Child]>],
        arrays: &[&[u8]],
    ) -> Block {
        self.statistics.expected_blocks += self.share(bounds);
        let mut block = Block([0; MESH_BLOCK as usize]);
        let mut at = 0;
        let mut put = |bytes: &[u8]| {
            let place: Range<usize> = at..at + bytes.len();
            block.0[place].copy_from_slice(bytes);
            // Each array begins at a quadword.
            at = (at + bytes.len()).next_multiple_of(16);
        };
        put(header.as_bytes());
        for children in nodes.iter().map(AsRef::as_ref) {
            self.statistics.expected_nodes += self.share(all(children));
            let boxes_of_children = children.iter().map(|(bounds, _)| bounds.area());
            self.cost += boxes_of_children.sum::<f64>();
            put(boxes(children).as_bytes());
        }
        for array in arrays {
            put(array);
        }
        block
    }
}

/// The nodes of a leaf with their root first, and their levels.
fn under_a_root(lowest: Vec<Vec<Child>>) -> (Vec<Vec<Child>>, usize) {
    if lowest.len() == 1 {
        return (lowest, 1);
    }
    let child = |(index, children): (usize, &Vec<Child>)| (all(children), offset(1 + index));
    let top = lowest.iter().enumerate().map(child).collect();
    ([vec![top], lowest].concat(), 2)
}

pub(crate) fn header(number: u32, kind: u32, levels: usize, nodes: usize) -> MeshHeader {
    MeshHeader {
        magic: MESH_MAGIC.into(),
        number: number.into(),
        kind: kind.into(),
        levels: (levels as u32).into(),
        nodes: (nodes as u32).into(),
        ..MeshHeader::new_zeroed()
    }
}

/// The offset in a block of its node `index`.
pub(super) fn offset(index: usize) -> u32 {
    (size_of::<MeshHeader>() + index * size_of::<Boxes>()) as u32
}

fn all(children: &[Child]) -> Bounds {
    let boxes = children.iter().map(|(bounds, _)| *bounds);
    boxes.fold(Bounds::EMPTY, Bounds::with)
}

/// A node without children.
pub(super) fn no_boxes() -> Boxes {
    let none = f32::from_bits(NO_BOX);
    Boxes {
        lo_x: [F32::new(none); 4],
        lo_y: [F32::new(none); 4],
        lo_z: [F32::new(none); 4],
        hi_x: [F32::new(-none); 4],
        hi_y: [F32::new(-none); 4],
        hi_z: [F32::new(-none); 4],
        child: [U32::ZERO; 4],
    }
}

fn boxes(children: &[Child]) -> Boxes {
    let mut boxes = no_boxes();
    for (lane, &(Bounds { low, high }, word)) in children.iter().enumerate() {
        boxes.lo_x[lane] = coordinate(low.x);
        boxes.lo_y[lane] = coordinate(low.y);
        boxes.lo_z[lane] = coordinate(low.z);
        boxes.hi_x[lane] = coordinate(high.x);
        boxes.hi_y[lane] = coordinate(high.y);
        boxes.hi_z[lane] = coordinate(high.z);
        boxes.child[lane] = word.into();
    }
    boxes
}
