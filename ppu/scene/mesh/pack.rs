//! Packs triangles, or spheres and cones, in the order of their codes into leaf blocks, as SPUs do:
//! the blocks are theirs bit for bit.

use std::collections::HashMap;

use protocol::layout::{
    Boxes, BuildTriangle, MESH_BLOCK, MESH_FACES, MESH_LEAF, MeshFace, MeshHeader, SIDES_BOTH,
    SIDES_SMOOTH,
};
use scenes::Mesh;
use zerocopy::big_endian::F32;
use zerocopy::{FromBytes as _, IntoBytes as _};

use super::pack_objects::pack_objects;
use super::refit::refit;
use super::sorted::{Sorted, SortedMesh};
use super::tree::{Bounds, Piece};
use super::write::{RUN_SHIFT, header, no_boxes, offset};
use super::{Block, MeshBlocks};

/// Nodes of a block with two levels.
const NODES: usize = 5;
/// The most triangles of a block with one node.
const FEW: usize = 16;
/// Bytes for vertices and faces.
const FULL: usize = MESH_BLOCK as usize - size_of::<MeshHeader>() - NODES * size_of::<Boxes>();
/// Bytes of those that a block has before it may end.
const LEAST: usize = 896;
const INDEX: u32 = 0x00ff_ffff;

impl MeshBlocks {
    /// Makes the blocks of a mesh, or of spheres and cones, in the order of codes.
    pub(crate) fn make_sorted(&mut self, mesh: &Mesh, sorted: &SortedMesh) {
        let count = self.count();
        self.blocks = vec![Block([0; MESH_BLOCK as usize]); count as usize];
        let mut triangles: Vec<BuildTriangle> = sorted.triangles().collect();
        for triangle in &mut triangles {
            let corners = corners(triangle).map(|vertex| sorted.vertices.position(vertex));
            triangle.code = (sides(triangle) << 1 | sorted.grid.code(corners)).into();
        }
        for unit in sorted.chunks() {
            let first = unit.first.get() as usize;
            triangles[first..][..unit.triangles.get() as usize].sort_by_key(|it| it.code.get());
        }
        let (units, words) = sorted.ranges(|at| triangles[at as usize].code.get());
        let mut leaves = Vec::new();
        for unit in units {
            let own =
                unit.source.get() as usize..(unit.source.get() + unit.source_count.get()) as usize;
            let parts = words[own].iter().map(|word| word.get());
            let mut range: Vec<BuildTriangle> = parts
                .flat_map(|part| &triangles[(part & INDEX) as usize..][..(part >> 24) as usize])
                .copied()
                .collect();
            range.sort_by_key(|it| it.code.get());
            let mut rest = &range[..];
            let mut number = unit.first.get();
            while !rest.is_empty() {
                let (block, bounds, packed) = match sorted.what {
                    Sorted::Objects => pack_objects(rest, number, &sorted.vertices),
                    Sorted::Triangles => {
                        let (mut block, vertices, packed) = pack(rest, number);
                        let sources = &mut &vertices[..];
                        let bounds = refit(&mut block, sources, mesh, &|_| None, &mut self.cost);
                        (block, bounds.unwrap_or(Bounds::EMPTY), packed)
                    }
                };
                leaves.push(Piece { bounds, index: number });
                self.blocks[number as usize] = block;
                number += 1;
                rest = &rest[packed..];
            }
        }
        self.statistics.leaves = leaves.len();
        sorted.what.join(leaves, |number, block| self.blocks[number].0.copy_from_slice(block));
        self.cost_when_built = self.cost;
    }
}

pub(super) fn corners(triangle: &BuildTriangle) -> [u32; 3] {
    [triangle.first, triangle.second, triangle.third].map(|it| it.get() & INDEX)
}

fn sides(triangle: &BuildTriangle) -> u32 {
    triangle.second.get() & (SIDES_BOTH | SIDES_SMOOTH)
}

/// The block of the first triangles, without vertices and boxes, its vertices, and how many
/// triangles it has.
fn pack(triangles: &[BuildTriangle], number: u32) -> (Block, Vec<u32>, usize) {
    let own_sides = sides(&triangles[0]);
    let mut known: HashMap<u32, u8> = HashMap::new();
    let mut own: Vec<u32> = Vec::new();
    let mut faces: Vec<MeshFace> = Vec::new();
    // Where the codes differ most, and how many triangles and vertices are before it.
    let mut best = (0, 0, 0);
    for (at, triangle) in triangles.iter().enumerate() {
        if sides(triangle) != own_sides {
            break;
        }
        let before = own.len();
        let vertex = corners(triangle).map(|vertex| {
            *known.entry(vertex).or_insert_with(|| {
                own.push(vertex);
                own.len() as u8 - 1
            })
        });
        let bytes = (size_of::<MeshFace>() * (at + 1)).next_multiple_of(16) + 16 * own.len();
        if bytes > FULL || at == MESH_FACES as usize {
            let (_, count, vertices) = best;
            let (count, vertices) = if count > 0 { (count, vertices) } else { (at, before) };
            faces.truncate(count);
            own.truncate(vertices);
            break;
        }
        faces.push(MeshFace { vertex, material: (triangle.first.get() >> 24) as u8 });
        if let Some(next) = triangles.get(at + 1).filter(|_| bytes > LEAST) {
            let differs = next.code.get() ^ triangle.code.get();
            if differs >= best.0 {
                best = (differs, faces.len(), own.len());
            }
        }
    }
    let count = faces.len();
    let (levels, nodes) = if count > FEW { (2, NODES) } else { (1, 1) };
    let mut block = Block([0; MESH_BLOCK as usize]);
    let header = MeshHeader {
        triangles: (count as u32).into(),
        vertices: (own.len() as u32).into(),
        sides: own_sides.into(),
        ..header(number, MESH_LEAF, levels, nodes)
    };
    let (start, rest) = block.0.split_at_mut(size_of::<MeshHeader>());
    start.copy_from_slice(header.as_bytes());
    let run = |first: usize, last: usize| match last - first {
        0 => 0,
        length => (first * size_of::<MeshFace>()) as u32 | (length as u32) << RUN_SHIFT,
    };
    if let Ok((nodes, rest)) = <[Boxes]>::mut_from_prefix_with_elems(rest, nodes) {
        let place = 16 * own.len();
        rest[place..][..size_of_val(&faces[..])].copy_from_slice(faces.as_bytes());
        nodes.fill(no_boxes());
        for at in 0..4 * nodes.len() {
            let word = match (at / 4, nodes.len()) {
                (0, 1) => {
                    let each = count.div_ceil(4);
                    run(count.min(at * each), count.min((at + 1) * each))
                }
                (0, _) => offset(1 + at),
                _ => run((at - 4) * count / 16, (at - 3) * count / 16),
            };
            if word != 0 {
                // Any box: this one is not absent.
                nodes[at / 4].lo_x[at % 4] = F32::ZERO;
                nodes[at / 4].child[at % 4] = word.into();
            }
        }
    }
    (block, own, count)
}
