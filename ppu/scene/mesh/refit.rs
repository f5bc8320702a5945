//! Blocks of a mesh whose vertices have moved: the tree keeps its form, and its boxes are made
//! around the new positions.

use glam::Vec3;
use protocol::layout::{
    Boxes, BuildBounds, HEIGHT_TREE, MESH_CONES, MESH_INNER, MESH_LEAF, MESH_SPHERES, MeshFace,
    MeshHeader, MeshVertex, NO_BOX, SIDES_SMOOTH,
};
use scenes::Mesh;
use zerocopy::FromBytes as _;
use zerocopy::big_endian::F32;

use super::cut::NODES;
use super::normal::packed;
use super::tree::Bounds;
use super::write::{RUN_SHIFT, coordinate, flat};
use super::{Block, MeshBlocks};

impl From<&BuildBounds> for Bounds {
    fn from(BuildBounds { low, high, .. }: &BuildBounds) -> Self {
        let [low, high] = [low, high].map(|it| Vec3::from(it.map(F32::get)));
        Self { low, high }
    }
}

impl MeshBlocks {
    /// The blocks of the same triangles with other positions and normals.
    ///
    /// `None` if a new tree is needed: the mesh has other vertices or, at one of them, a normal
    /// that it had not or no longer has, or the blocks have spheres or cones, too.
    #[must_use]
    pub fn refitted(&self, mesh: &Mesh) -> Option<Self> {
        if !self.flat.iter().copied().eq(flat(mesh)) {
            return None;
        }
        let mut refitted = self.clone();
        let mut bounds = vec![Bounds::EMPTY; self.blocks.len()];
        let mut sources = &self.sources[..];
        let mut cost = 0.0;
        // Children have greater numbers than their parents.
        for number in (0..self.blocks.len()).rev() {
            let block = &mut refitted.blocks[number];
            bounds[number] = {
                let below = |number: usize| bounds.get(number).copied();
                refit(block, &mut sources, mesh, &below, &mut cost)?
            };
        }
        refitted.cost = cost;
        Some(refitted)
    }

    /// Refits the inner blocks after the leaves, which have these bounds, and calls `store` with
    /// the number and the bytes of each. Its own bounds are written. Returns what all blocks cost.
    pub(crate) fn refit_inner(
        &self,
        bounds: &mut [BuildBounds],
        mut store: impl FnMut(usize, &[u8]),
    ) -> f64 {
        let mut cost = 0.0;
        let no_vertices = Mesh::default();
        for (number, block) in self.blocks.iter().enumerate().rev() {
            let is_inner = MeshHeader::ref_from_prefix(&block.0)
                .is_ok_and(|(header, _)| header.kind.get() == MESH_INNER);
            if !is_inner {
                // An SPU's largest numbers are none for the PPU.
                cost += f64::from(bounds[number].cost.get()).min(f64::MAX);
                continue;
            }
            let mut block = block.clone();
            let below = |number: usize| bounds.get(number).map(Bounds::from);
            let around = refit(&mut block, &mut &[][..], &no_vertices, &below, &mut cost);
            let Bounds { low, high } = around.unwrap_or(Bounds::EMPTY);
            bounds[number].low = low.to_array().map(F32::new);
            bounds[number].high = high.to_array().map(F32::new);
            store(number, &block.0);
        }
        cost
    }

    /// How many times the tests rays make that they made when the tree was built: the surfaces of
    /// all boxes, each times the tests that a ray makes that meets it, against those at that time.
    #[must_use]
    pub fn wear(&self) -> f64 {
        self.cost / self.cost_when_built
    }
}

/// Refits a block whose children are refitted, and returns its box. The last of `sources` are the
/// mesh's vertices of the block's own, and are taken off.
pub(super) fn refit(
    block: &mut Block,
    sources: &mut &[u32],
    mesh: &Mesh,
    blocks: &dyn Fn(usize) -> Option<Bounds>,
    cost: &mut f64,
) -> Option<Bounds> {
    let (header, rest) = block.0.split_at_mut(size_of::<MeshHeader>());
    let header = MeshHeader::ref_from_bytes(header).ok()?;
    let (nodes, rest) =
        <[Boxes]>::mut_from_prefix_with_elems(rest, header.nodes.get() as usize).ok()?;
    let count = header.vertices.get() as usize;
    let (vertices, rest) = <[MeshVertex]>::mut_from_prefix_with_elems(rest, count).ok()?;
    let count = header.triangles.get() as usize;
    let is_leaf = header.kind.get() == MESH_LEAF;
    if matches!(header.kind.get(), MESH_SPHERES | MESH_CONES) {
        return None;
    }
    let (faces, _) = <[MeshFace]>::ref_from_prefix_with_elems(rest, count).ok()?;

    let (before, own) = sources.split_at_checked(sources.len().checked_sub(vertices.len())?)?;
    *sources = before;
    let is_smooth = header.sides.get() & SIDES_SMOOTH != 0;
    for (vertex, &source) in vertices.iter_mut().zip(own) {
        vertex.position = mesh.positions.get(source as usize)?.map(coordinate);
        if is_smooth {
            let normal = Vec3::from(*mesh.normals.get(source as usize)?).as_dvec3();
            vertex.normal = packed(normal).into();
        }
    }

    let lowest = lowest(nodes, header.levels.get());
    let mut around = [Bounds::EMPTY; NODES];
    let around = around.get_mut(..nodes.len())?;
    for (index, node) in nodes.iter_mut().enumerate().rev() {
        for lane in 0..node.child.len() {
            if node.lo_x[lane].get().to_bits() == NO_BOX {
                continue;
            }
            let word = node.child[lane].get();
            let (bounds, tests) = if word == HEIGHT_TREE {
                // A height field stays where it is.
                (lane_bounds(node, lane), 1)
            } else if index < lowest {
                (*around.get(node_index(word))?, 1)
            } else if is_leaf {
                let first = (word & 0xffff) as usize / size_of::<MeshFace>();
                let length = (word >> RUN_SHIFT) as usize;
                let run = faces.get(first..first + length)?;
                (around_faces(run, vertices)?, length)
            } else {
                (blocks(word as usize)?, 1)
            };
            *cost += bounds.area() * tests as f64;
            put(node, lane, bounds);
            around[index] = around[index].with(bounds);
        }
    }
    around.first().copied()
}

/// The index of the first node of the lowest level.
fn lowest(nodes: &[Boxes], levels: u32) -> usize {
    let mut first = 0;
    for _ in 1..levels {
        first = nodes.get(first).map_or(0, |node| node_index(node.child[0].get()));
    }
    first
}

/// The index of the node at an offset in its block.
fn node_index(offset: u32) -> usize {
    (offset as usize).saturating_sub(size_of::<MeshHeader>()) / size_of::<Boxes>()
}

fn around_faces(faces: &[MeshFace], vertices: &[MeshVertex]) -> Option<Bounds> {
    let mut corners = faces.iter().flat_map(|face| face.vertex);
    corners.try_fold(Bounds::EMPTY, |bounds, corner| {
        let position = vertices.get(usize::from(corner))?.position;
        let point = Vec3::from(position.map(F32::get));
        Some(bounds.with(Bounds { low: point, high: point }))
    })
}

fn lane_bounds(node: &Boxes, lane: usize) -> Bounds {
    let corner = |axes: [&[F32; 4]; 3]| Vec3::from(axes.map(|axis| axis[lane].get()));
    Bounds {
        low: corner([&node.lo_x, &node.lo_y, &node.lo_z]),
        high: corner([&node.hi_x, &node.hi_y, &node.hi_z]),
    }
}

pub(super) fn put(node: &mut Boxes, lane: usize, Bounds { low, high }: Bounds) {
    node.lo_x[lane] = coordinate(low.x);
    node.lo_y[lane] = coordinate(low.y);
    node.lo_z[lane] = coordinate(low.z);
    node.hi_x[lane] = coordinate(high.x);
    node.hi_y[lane] = coordinate(high.y);
    node.hi_z[lane] = coordinate(high.z);
}
