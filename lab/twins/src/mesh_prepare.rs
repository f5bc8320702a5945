//! Twin of `spu/isect/mesh_prepare.s`: what is done with a block of a mesh that has arrived.

use spu_emulator::float::single::{fa, fm, fs};

use super::mesh::{SLACK, maximum};
use super::{SIGN, Single, ZERO};

/// Words of a block.
pub const WORDS: usize = 512;
/// Words of its header.
pub const HEADER: usize = 8;
/// Words of a node: lower corners x, y, z, upper ones, children, of four lanes each.
pub const NODE: usize = 28;
/// Words of a sphere's record.
pub const OBJECT: usize = 12;
/// Words of a cone's record.
pub const CONE: usize = 16;
/// The first word.
pub const MAGIC: u32 = 0x4d45_5348;
/// The corner of a box that is not there.
pub const NO_BOX: Single = 0x6080_0000;
/// `kind`: the children are blocks.
pub const INNER: u32 = 0;
/// `kind`: the children are runs of triangles.
pub const LEAF: u32 = 1;
/// `kind`: the children are spheres.
pub const SPHERES: u32 = 2;
/// `kind`: the children are cones.
pub const CONES: u32 = 3;
/// In `sides`: vertices have texture coordinates.
const TEXTURED: u32 = 0x1000_0000;
/// A sphere's or a cone's word for its material.
const MATERIAL: usize = 10;

/// What is known of a block besides its bytes.
#[derive(Clone, Copy, Debug)]
pub struct Known {
    /// Its number.
    pub number: u32,
    /// The eye.
    pub eye: [Single; 3],
    /// How many blocks there are.
    pub blocks: u32,
    /// How many materials there are.
    pub materials: u32,
    /// The bits that `sides` may have.
    pub sides: u32,
}

/// The header's words, if they are right.
struct Header {
    kind: u32,
    levels: u32,
    nodes: usize,
    triangles: u32,
    vertices: usize,
}

/// The words of an object's record in a block of this kind; `None` if it has no objects.
#[must_use]
pub fn object(kind: u32) -> Option<usize> {
    match kind {
        SPHERES => Some(OBJECT),
        CONES => Some(CONE),
        _ => None,
    }
}

fn header(block: &[u32; WORDS], known: &Known) -> Option<Header> {
    let [magic, number, kind, levels, nodes, triangles, vertices, sides] = *block.first_chunk()?;
    let most_nodes = ((WORDS - HEADER) / NODE) as u32;
    let right = magic == MAGIC
        && number == known.number
        && kind <= CONES
        && (1..=3).contains(&levels)
        && (1..=most_nodes).contains(&nodes)
        && triangles <= 127
        && vertices <= 255
        && sides & !known.sides == 0
        && (kind == INNER) == (triangles == 0)
        && (kind == LEAF) == (vertices != 0);
    if !right {
        return None;
    }
    let record = object(kind).unwrap_or(1) as u32;
    let words = NODE as u32 * nodes + 4 * vertices + record * triangles;
    let textured = sides & TEXTURED != 0;
    let words = words.next_multiple_of(4) + if textured { 2 * vertices } else { 0 };
    (words as usize <= WORDS - HEADER).then_some(Header {
        kind,
        levels,
        nodes: nodes as usize,
        triangles,
        vertices: vertices as usize,
    })
}

fn child(block: &[u32; WORDS], node: usize) -> [u32; 4] {
    std::array::from_fn(|lane| block[HEADER + NODE * node + 24 + lane])
}

/// The number of the lowest level's first node, and whether the children above it are right; `None`
/// if the levels are not complete.
fn lowest(block: &[u32; WORDS], header: &Header) -> Option<(usize, bool)> {
    let [mut node, mut end] = [0, 1];
    let mut right = true;
    for _ in 1..header.levels {
        let mut below = end;
        for upper in node..end {
            let children = child(block, upper);
            for (lane, &child) in children.iter().enumerate() {
                let expected = 4 * (HEADER + NODE * (below + lane)) as u32;
                let first = lane == 0;
                let is_right = match child {
                    0 => !first,
                    _ => child == expected && (first || children[lane - 1] != 0),
                };
                right &= is_right;
            }
            below += children.iter().filter(|child| **child != 0).count();
        }
        [node, end] = [end, below];
        if end > header.nodes {
            return None;
        }
    }
    (end == header.nodes).then_some((node, right))
}

/// Whether a child of a lowest node is right.
fn is_right(child: u32, header: &Header, known: &Known) -> bool {
    if header.kind == INNER {
        return child > known.number && child < known.blocks;
    }
    if let Some(words) = object(header.kind) {
        let first = 4 * (HEADER + NODE * header.nodes) as u32;
        let size = 4 * words as u32;
        let offset = child.wrapping_sub(first);
        return offset < size * header.triangles && offset.is_multiple_of(size);
    }
    let [first, length] = [(child & 0xffff) >> 2, child >> 16];
    child & 3 == 0 && (1..=8).contains(&length) && first + length <= header.triangles
}

/// Prepares a block as `mesh_prepare` does. Returns whether it is whole; otherwise its positions
/// may be anything.
pub fn prepare(block: &mut [u32; WORDS], known: &Known) -> bool {
    let Some(header) = header(block, known) else {
        return false;
    };
    let Some((low, mut whole)) = lowest(block, &header) else {
        return false;
    };
    let root = child(block, 0);
    let mut size = ZERO;
    for plane in 0..24 {
        if root[plane % 4] != 0 {
            let relative = fs(block[HEADER + plane], known.eye[plane / 4 % 3]);
            size = maximum(size, relative & !SIGN);
        }
    }
    let slack = fm(size, SLACK);
    for node in 0..header.nodes {
        let at = HEADER + NODE * node;
        let children = child(block, node);
        for (lane, &child) in children.iter().enumerate() {
            let corners = [block[at + lane], block[at + 12 + lane]];
            whole &= child != 0 || corners == [NO_BOX, NO_BOX | SIGN];
            if node >= low {
                whole &= child == 0 || is_right(child, &header, known);
                if header.kind == INNER {
                    block[at + 24 + lane] |= ((4 * (node - low) + lane) as u32) << 25;
                }
            }
        }
        for plane in 0..24 {
            let relative = fs(block[at + plane], known.eye[plane / 4 % 3]);
            let moved = if plane < 12 { fs } else { fa };
            block[at + plane] = moved(relative, slack);
        }
    }
    let first = HEADER + NODE * header.nodes;
    let mut move_point = |at: usize| {
        for (axis, eye) in known.eye.iter().enumerate() {
            block[at + axis] = fs(block[at + axis], *eye);
        }
    };
    match (header.kind, object(header.kind)) {
        (LEAF, _) => {
            (0..header.vertices).for_each(|vertex| move_point(first + 4 * vertex));
            let faces = first + 4 * header.vertices;
            let quads = (header.triangles as usize).next_multiple_of(4);
            let [vertex, material] =
                [header.vertices as u32, known.materials].map(|count| count.wrapping_sub(1) as u8);
            whole &= block[faces..faces + quads].iter().all(|face| {
                let [a, b, c, of] = face.to_be_bytes();
                a.max(b).max(c) <= vertex && of <= material
            });
        }
        (_, Some(size)) => {
            let objects = (0..header.triangles as usize).map(|object| first + size * object);
            objects.clone().for_each(move_point);
            whole &= objects
                .clone()
                .all(|object| block[object + MATERIAL] <= known.materials.wrapping_sub(1));
        }
        _ => {}
    }
    whole
}
