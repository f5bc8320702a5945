//! Twins of the kernels in `spu/build` by which SPUs sort triangles and pack them into leaf blocks.

use spu_emulator::float::convert::cflts;
use spu_emulator::float::single::fm;

use super::Single;
use super::mesh_prepare::{HEADER, LEAF, MAGIC, NODE, WORDS};

/// A triangle to sort: its code, and the vertices of its corners. The first also has its material,
/// and the second its sides.
pub type Triangle = [u32; 4];

const INDEX: u32 = 0x00ff_ffff;
const SIDES: u32 = 0x6000_0000;
/// Bytes of a block for vertices and faces.
const FULL: usize = 4 * (WORDS - HEADER - 5 * NODE);
/// Blocks do not end before they have as many, if they can help it.
const LEAST: usize = 896;
/// The most triangles of a block.
const FACES: usize = 127;

/// The elements of the list that fetches the corners of triangles; `None` if a vertex is missing.
#[must_use]
pub fn corners(triangles: &[Triangle], low: u32, vertices: u32) -> Option<Vec<[u32; 2]>> {
    let corners = triangles.iter().flat_map(|triangle| &triangle[1..]).map(|it| it & INDEX);
    let exist = corners.clone().all(|vertex| vertex < vertices);
    exist.then(|| corners.map(|vertex| [16, (vertex << 4).wrapping_add(low)]).collect())
}

/// How a centroid's code is made of its corners.
#[derive(Clone, Copy, Debug)]
pub struct Grid {
    /// The smallest cell of each axis.
    pub low: [u32; 3],
    /// By which coordinates are multiplied.
    pub scale: Single,
    /// By which a cell is shifted.
    pub shift: u32,
}

/// The codes of triangles with these corners.
pub fn codes(triangles: &mut [Triangle], corners: &[[Single; 4]], grid: Grid) {
    for (triangle, corners) in triangles.iter_mut().zip(corners.chunks(3)) {
        let mut code: u32 = 0;
        for axis in 0..3 {
            let whole = corners.iter().map(|corner| cflts(fm(corner[axis], grid.scale), 0));
            let sum = whole.fold(0, u32::wrapping_add).wrapping_sub(grid.low[axis]);
            let cell = sum.checked_shr(grid.shift & 63).unwrap_or_default();
            for bit in 0..10 {
                code |= (cell >> bit & 1) << (3 * bit + 2 - axis);
            }
        }
        for bits in [1, 2, 4, 8, 16] {
            code ^= code >> bits;
        }
        triangle[0] = (triangle[2] & SIDES) << 1 | code;
    }
}

/// Triangles in the order of their codes.
pub fn sort(triangles: &mut [Triangle]) {
    triangles.sort_by_key(|triangle| triangle[0]);
}

/// A block without vertices and boxes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Packed {
    /// Its words.
    pub block: [u32; WORDS],
    /// Its vertices.
    pub vertices: Vec<u32>,
    /// How many triangles it has.
    pub triangles: usize,
}

/// Packs the first triangles; `None` if one that was looked at has a vertex that does not exist.
#[must_use]
pub fn pack(triangles: &[Triangle], number: u32, vertices: u32) -> Option<Packed> {
    let sides = triangles[0][2] & SIDES;
    let mut own: Vec<u32> = Vec::new();
    let mut faces = Vec::new();
    let mut best = (0, 0, 0);
    let mut is_whole = true;
    let mut exist = true;
    for (at, triangle) in triangles.iter().enumerate() {
        if triangle[2] & SIDES != sides {
            break;
        }
        let before = own.len();
        let [a, b, c] = [1, 2, 3].map(|corner| {
            let vertex = triangle[corner] & INDEX;
            exist &= vertex < vertices;
            let known = own.iter().position(|it| *it == vertex);
            known.unwrap_or_else(|| {
                own.push(vertex);
                own.len() - 1
            }) as u8
        });
        let bytes = (4 * (at + 1)).next_multiple_of(16) + 16 * own.len();
        if bytes > FULL || at == FACES {
            own.truncate(before);
            is_whole = false;
            break;
        }
        faces.push(u32::from_be_bytes([a, b, c, (triangle[1] >> 24) as u8]));
        if let Some(next) = triangles.get(at + 1).filter(|_| bytes > LEAST) {
            let differs = next[0] ^ triangle[0];
            if differs >= best.0 {
                best = (differs, faces.len(), own.len());
            }
        }
    }
    if !is_whole && best.1 > 0 {
        faces.truncate(best.1);
        own.truncate(best.2);
    }
    let count = faces.len();
    let (levels, nodes) = if count > 16 { (2, 5) } else { (1, 1) };
    let mut block = [0; WORDS];
    block[..HEADER].copy_from_slice(&[
        MAGIC,
        number,
        LEAF,
        levels,
        nodes,
        count as u32,
        own.len() as u32,
        sides,
    ]);
    let child = |node: usize, lane: usize| HEADER + NODE * node + 24 + lane;
    let word = |first: usize, last: usize| (first << 2 | (last - first) << 16) as u32;
    for run in 0..4 {
        if levels == 1 {
            let [first, last] = [run, run + 1].map(|it| count.min(it * count.div_ceil(4)));
            block[child(0, run)] = if first < last { word(first, last) } else { 0 };
            continue;
        }
        block[child(0, run)] = 4 * (HEADER + NODE * (1 + run)) as u32;
        for lane in 0..4 {
            let at = 4 * run + lane;
            block[child(1 + run, lane)] = word(at * count / 16, (at + 1) * count / 16);
        }
    }
    let first = HEADER + NODE * nodes as usize + 4 * own.len();
    block[first..][..count].copy_from_slice(&faces);
    exist.then_some(Packed { block, vertices: own, triangles: count })
}
