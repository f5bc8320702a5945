//! Twins of `spu/build`: how a leaf block of a mesh is refitted.

use spu_emulator::float::single::{fa, fm, fma, fs};

use super::mesh::{maximum, minimum};
use super::mesh_prepare::{HEADER, NO_BOX, NODE, WORDS};
use super::{ONE, SIGN, Single, ZERO};

/// In `sides`: vertices have normals.
const SMOOTH: u32 = 0x2000_0000;
/// The most triangles of a run.
const RUN: usize = 8;

/// A corner, and what is in the fourth lane beside it.
type Corner = [Single; 4];

/// The elements of the list that fetches these runs of vertices, in fours; `None` if one of them
/// does not exist, or if there are not `count`.
#[must_use]
pub fn list(sources: &[[u32; 4]], low: u32, vertices: u32, count: u32) -> Option<Vec<[u32; 2]>> {
    let runs = sources.as_flattened().iter().map(|word| [word & 0x00ff_ffff, word >> 24]);
    let exist = runs.clone().all(|[first, length]| first + length <= vertices);
    let total: u32 = runs.clone().map(|[_, length]| length).sum();
    let element = |[first, length]: [u32; 2]| [length << 4, (first << 4).wrapping_add(low)];
    (exist && total == count).then(|| runs.map(element).collect())
}

/// A box: its lower and its upper corner.
#[derive(Clone, Copy)]
struct Box([Corner; 2]);

impl Box {
    const NONE: Self = Self([[NO_BOX; 4], [NO_BOX | SIGN; 4]]);

    /// The box around two corners, of which one comparison has both limits.
    fn of(a: Corner, b: Corner) -> Self {
        Self([lanes(minimum, a, b), lanes(maximum, b, a)])
    }

    fn with(self, other: Self) -> Self {
        let ([low, high], [other_low, other_high]) = (self.0, other.0);
        Self([lanes(minimum, low, other_low), lanes(maximum, high, other_high)])
    }
}

fn lanes(pick: fn(Single, Single) -> Single, a: Corner, b: Corner) -> Corner {
    std::array::from_fn(|lane| pick(a[lane], b[lane]))
}

/// Refits a block that has new vertices, as `build_leaf` does. Returns its bounds.
#[must_use]
pub fn leaf(block: &mut [u32; WORDS]) -> [u32; 8] {
    let [_, _, _, levels, nodes, triangles, vertices, sides] =
        *block.first_chunk().unwrap_or(&[0; 8]);
    let first_vertex = HEADER + NODE * nodes as usize;
    let first_face = first_vertex + 4 * vertices as usize;
    if sides & SMOOTH == 0 {
        (0..vertices as usize).for_each(|vertex| block[first_vertex + 4 * vertex + 3] = 0);
    }
    let boxes: Vec<Box> = block[first_face..first_face + triangles as usize]
        .iter()
        .map(|face| {
            let [a, b, c, _] = face.to_be_bytes().map(|vertex| {
                let at = first_vertex + 4 * usize::from(vertex);
                std::array::from_fn(|lane| block[at + lane])
            });
            Box::of(a, b).with(Box([c; 2]))
        })
        .collect();
    let mut around = vec![Box::NONE; nodes as usize];
    let mut cost = [ZERO; 4];
    for node in (0..nodes as usize).rev() {
        let at = HEADER + NODE * node;
        let is_upper = node == 0 && levels > 1;
        for lane in 0..4 {
            let child = block[at + 24 + lane];
            let (found, tests) = match child {
                // No test.
                0 => (Box::NONE, ZERO),
                _ if is_upper => (around[1 + lane], ONE),
                _ => {
                    let [first, length] =
                        [(child & 0xffff) >> 2, child >> 16].map(|it| it as usize);
                    let run = &boxes[first..first + length.min(RUN)];
                    // The last triangle counts again for each that a run of eight would have.
                    let found = run[1..].iter().fold(run[0], |found, it| found.with(*it));
                    (found, (length as f32).to_bits())
                }
            };
            around[node] = if lane == 0 { found } else { around[node].with(found) };
            let Box([low, high]) = found;
            for axis in 0..3 {
                block[at + 4 * axis + lane] = low[axis];
                block[at + 12 + 4 * axis + lane] = high[axis];
            }
            if child != 0 {
                let [x, y, z] = std::array::from_fn(|axis| fs(high[axis], low[axis]));
                let area = fma(z, x, fma(y, z, fm(x, y)));
                cost[lane] = fa(cost[lane], fm(area, tests));
            } else {
                cost[lane] = fa(cost[lane], ZERO);
            }
        }
    }
    let [a, b, c, d] = cost;
    let Box([[low_x, low_y, low_z, _], [high_x, high_y, high_z, _]]) = around[0];
    [low_x, low_y, low_z, fa(fa(a, c), fa(b, d)), high_x, high_y, high_z, 0]
}
