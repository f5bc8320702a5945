//! Twins of the kernels in `spu/build` that pack spheres and cones into leaf blocks.

use spu_emulator::float::single::{fa, fma, fnms, fs};

use super::mesh::{maximum, minimum};
use super::mesh_prepare::{CONE, CONES, HEADER, MAGIC, NO_BOX, NODE, OBJECT, SPHERES, WORDS};
use super::sort::Triangle;
use super::{ONE, SIGN, Single, ZERO};

const INDEX: u32 = 0x00ff_ffff;
/// In the second word to sort: it is a cone.
const IS_CONE: u32 = 0x4000_0000;
/// The fewest objects of a block that is not the last one of its kind.
const FEWEST: usize = 10;
/// The most.
const MOST: usize = 16;
/// Words of an object's record: offset of a sphere, and radius, growth and height of a cone.
const OFFSET: usize = 8;
const RADIUS: usize = 12;
/// Tangents to a square root: how steep they are, and a little more than how high they begin.
const TANGENTS: [[Single; 2]; 5] = [
    [0x3f00_0000, 0x3f01_0000],
    [0x3f80_0000, 0x3e81_0000],
    [0x4000_0000, 0x3e01_0000],
    [0x4080_0000, 0x3d81_0000],
    [0x4100_0000, 0x3d01_0000],
];

/// A block without records and boxes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Packed {
    /// Its words.
    pub block: [u32; WORDS],
    /// The first quadword of each record.
    pub records: Vec<u32>,
    /// Bytes of a record.
    pub bytes: u32,
}

/// Packs the first objects; `None` if one is not among the records, which have `quads` quadwords.
#[must_use]
pub fn pack(objects: &[Triangle], number: u32, quads: u32) -> Option<Packed> {
    let cone = objects[0][2] & IS_CONE;
    let is_such = |object: &&Triangle| object[2] & IS_CONE == cone;
    let (kind, size) = if cone == 0 { (SPHERES, OBJECT) } else { (CONES, CONE) };
    let there = objects.iter().take_while(is_such).take(MOST + 1).count();
    let own = &objects[..there.min(MOST)];
    let exist = own.iter().all(|object| (object[1] & INDEX) + size as u32 / 4 <= quads);
    let mut count = own.len();
    if there > MOST {
        let differs = |end: usize| objects[end][0] ^ objects[end - 1][0];
        // Of equal ones the last.
        count = (FEWEST..=MOST).max_by_key(|&end| differs(end)).unwrap_or(MOST);
    }
    let lowest = count.div_ceil(4);
    let (levels, nodes) = if lowest > 1 { (2, lowest + 1) } else { (1, 1) };
    let mut block = [0; WORDS];
    let [nodes_word, count_word] = [nodes, count].map(|it| it as u32);
    block[..6].copy_from_slice(&[MAGIC, number, kind, levels, nodes_word, count_word]);
    let child = |node: usize, lane: usize| HEADER + NODE * node + 24 + lane;
    if levels == 2 {
        for lane in 0..lowest {
            block[child(0, lane)] = 4 * (HEADER + NODE * (1 + lane)) as u32;
        }
    }
    for at in 0..count {
        let first = HEADER + NODE * nodes + size * at;
        block[child(nodes - lowest + at / 4, at % 4)] = 4 * first as u32;
    }
    let records = own[..count].iter().map(|object| object[1] & INDEX).collect();
    exist.then_some(Packed { block, records, bytes: 4 * size as u32 })
}

/// A box: its lower and its upper corner.
type Corners = [[Single; 3]; 2];

/// Makes the boxes of a block that has its records, and returns its bounds.
#[must_use]
pub fn boxes(block: &mut [u32; WORDS]) -> [u32; 8] {
    let [_, _, kind, levels, nodes, ..] = *block.first_chunk::<HEADER>().unwrap_or(&[0; HEADER]);
    let (nodes, lowest) = (nodes as usize, (nodes - (levels - 1)) as usize);
    let size = if kind == CONES { CONE } else { OBJECT };
    let none: Corners = [[NO_BOX; 3], [NO_BOX | SIGN; 3]];
    let mut around = [none; 4];
    for at in 0..4 * lowest {
        let (node, lane) = (nodes - lowest + at / 4, at % 4);
        let first = HEADER + NODE * nodes + size * at;
        let found = match block[HEADER + NODE * node + 24 + lane] {
            0 => none,
            _ if kind == CONES => of_cone(&block[first..first + CONE]),
            _ => of_sphere(&block[first..first + OBJECT]),
        };
        put(block, node, lane, found);
        around[at / 4] = if lane == 0 { found } else { with(around[at / 4], found) };
    }
    if levels > 1 {
        (0..4).for_each(|lane| put(block, 0, lane, around[lane]));
    }
    let [_, others @ ..] = around;
    let [[low_x, low_y, low_z], [high_x, high_y, high_z]] =
        others.into_iter().fold(around[0], with);
    [low_x, low_y, low_z, ZERO, high_x, high_y, high_z, 0]
}

fn put(block: &mut [u32; WORDS], node: usize, lane: usize, corners: Corners) {
    for (corner, axes) in corners.into_iter().enumerate() {
        for (axis, number) in axes.into_iter().enumerate() {
            block[HEADER + NODE * node + 12 * corner + 4 * axis + lane] = number;
        }
    }
}

fn with([low, high]: Corners, [other_low, other_high]: Corners) -> Corners {
    let axes = |pick: fn(Single, Single) -> Single, a: [Single; 3], b: [Single; 3]| {
        std::array::from_fn(|axis| pick(a[axis], b[axis]))
    };
    [axes(minimum, low, other_low), axes(maximum, high, other_high)]
}

fn of_sphere(record: &[u32]) -> Corners {
    let radius = record[OFFSET] & !SIGN;
    [fs, fa].map(|op| std::array::from_fn(|axis| op(record[axis], radius)))
}

fn of_cone(record: &[u32]) -> Corners {
    let [radius, growth, height] = [RADIUS, RADIUS + 1, RADIUS + 2].map(|at| record[at]);
    let top = maximum(fma(growth, height, radius), ZERO);
    let ends = std::array::from_fn::<_, 3, _>(|axis| {
        let (base, along) = (record[axis], record[4 + axis]);
        // How far a disc of radius 1 across the axis reaches, or a little farther.
        let square = fnms(along, along, ONE);
        let tangents = TANGENTS.map(|[slope, start]| fma(square, slope, start));
        let across = tangents[1..].iter().fold(tangents[0], |lowest, it| minimum(lowest, *it));
        let apex = fma(along, height, base);
        let low = minimum(fnms(across, radius, base), fnms(across, top, apex));
        let high = maximum(fma(across, radius, base), fma(across, top, apex));
        [low, high]
    });
    [0, 1].map(|end| ends.map(|axis| axis[end]))
}
