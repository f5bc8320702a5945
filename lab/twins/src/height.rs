//! Twin of `spu/isect/height_block.s` and `height_corners.s`: the triangles of a height field's
//! block, and the normals at their vertices.

use spu_emulator::float::convert::{cflts, cfltu, csflt};
use spu_emulator::float::single::{fa, fcgt, fm, fma, fs};

use super::math::{reciprocal, rsqrt};
use super::mesh::{SLACK, maximum, minimum};
use super::mesh_prepare::{HEADER, LEAF, MAGIC, NO_BOX, NODE, WORDS};
use super::{ONE, SIGN, Single, ZERO, select};

/// Where the samples are in a block that has arrived, in words.
const SAMPLES: usize = 340;
/// Words of a row of samples.
const PITCH: usize = 16;
/// The first sample of the next level.
const COARSE: usize = 7 * PITCH;
/// Words of a row of the next level's samples.
const COARSE_PITCH: usize = 12;
/// Vertices of a row, of which nine are used.
const ACROSS: usize = 12;
/// Vertices of a block.
const VERTICES: usize = 5 * ACROSS;
/// `sides`: normals and colours at vertices.
const SIDES: u32 = 0x2400_0000;
/// The factor of a normal's parts, 32767.
const HALVES: Single = 0x46ff_fe00;
/// From five bits to ten.
pub(super) const FIVE: Single = 0x4204_0000;
/// From six bits to ten.
pub(super) const SIX: Single = 0x4181_e7a0;

/// 1 / 32767.
const INVERSE: Single = 0x3800_0100;

/// The unit normal whose parts a vertex has in two halves of a word, by `height_corners`: the lower
/// half of the octahedron is folded back.
#[must_use]
pub fn corner_normal(halves: u32) -> [Single; 3] {
    let part = |half: u32| fm(csflt((half as i16 as i32).cast_unsigned(), 0), INVERSE);
    let [u, v] = [part(halves >> 16), part(halves)];
    let z = fs(fs(ONE, u & !SIGN), v & !SIGN);
    let fold = if z & SIGN == 0 { ZERO } else { z & !SIGN };
    let [u, v] = [u, v].map(|part| fs(part, part & SIGN | fold));
    let inverse = rsqrt(fma(z, z, fma(v, v, fm(u, u))));
    [u, v, z].map(|part| fm(part, inverse))
}

/// The height field, as far as a block needs it.
#[derive(Clone, Copy, Debug)]
pub struct Field {
    /// The first sample relative to the eye.
    pub corner: [Single; 3],
    /// The square of the eye's height above the ground.
    pub above: Single,
    /// The distances between samples, and the length of a height of 1.
    pub step: [Single; 3],
    /// The last sample's column and row.
    pub last: [Single; 2],
    /// Where the level begins to fade, how fast, and the upward part of normals.
    pub fading: [Single; 3],
}

/// Height, slopes and colour.
type Attributes = [Single; 6];

/// Those of the sample at a word, whose rows are `pitch` words apart.
fn attributes(words: &[u32], at: usize, pitch: usize) -> Attributes {
    let height = |at: usize| words[at] >> 16;
    let slope = |one: usize, other: usize| csflt(height(other).wrapping_sub(height(one)), 0);
    let colour = |shift: u32, bits: u32| csflt(words[at] >> shift & bits, 0);
    [
        csflt(height(at), 0),
        slope(at - 1, at + 1),
        slope(at - pitch, at + pitch),
        colour(11, 31),
        colour(5, 63),
        colour(0, 31),
    ]
}

/// A sample's place, in samples of the first level.
fn placed(index: u32, level: u32, last: Single) -> Single {
    minimum(csflt(index << level, 0), last)
}

/// A unit normal in a word. The vector is (-x, up, -z).
fn normal(x: Single, up: Single, z: Single) -> u32 {
    let sum = fa(fa(x & !SIGN, z & !SIGN), up);
    let share = reciprocal(sum);
    let (u, v) = (fm(x, share) ^ SIGN, fm(up, share));
    let below = fcgt(z, ZERO) != 0;
    let folded = [fs(ONE, v) | u & SIGN, fs(ONE, u & !SIGN)];
    let [u, v] = [select(u, folded[0], below), select(v, folded[1], below)];
    let half = |part: Single| cflts(fm(part, HALVES), 0);
    half(u) << 16 | half(v) & 0xffff
}

/// Makes a block of the samples that it has, as `height_block` does.
pub fn block(block: &mut [u32; WORDS], field: &Field, number: u32) {
    let samples = block[SAMPLES..].to_vec();
    let level = number >> 19 & 15;
    let [first_row, first_column] = [(number >> 9 & 1023) * 4, (number & 511) * 8];
    let [from, fade, up] = field.fading;
    let below = |row: usize, column: usize| {
        attributes(&samples, COARSE + COARSE_PITCH * (row + 1) + 4 + column, COARSE_PITCH)
    };
    let mut places = [[[ZERO; 3]; ACROSS]; 5];
    let vertices = HEADER + 3 * NODE;
    let faces = vertices + 4 * VERTICES;
    let colours = faces + 64;
    for (down, places) in places.iter_mut().enumerate() {
        for (across, place) in places.iter_mut().enumerate() {
            let column = first_column + across as u32;
            let row = first_row + down as u32;
            let mut own = attributes(&samples, PITCH * (down + 1) + 4 + across, PITCH);
            let [x, z] = [(column, field.last[0]), (row, field.last[1])].map(|(index, last)| {
                (placed(index, level, last), placed(index >> 1, level + 1, last))
            });
            let [to_x, to_z] = [
                fma(x.0, field.step[0], field.corner[0]),
                fma(z.0, field.step[2], field.corner[2]),
            ];
            let distance = fma(to_z, to_z, fma(to_x, to_x, field.above));
            let part = fm(fs(distance, from), fade);
            let part = minimum(maximum(part, ZERO), ONE);
            let faded = |own: Single, other: Single| fma(part, fs(other, own), own);
            let [x, z] = [x, z].map(|(own, other)| faded(own, other));
            own[1] = fa(own[1], own[1]);
            own[2] = fa(own[2], own[2]);
            // Vertices that are not used move to where the last one does.
            for (own, next) in own.iter_mut().zip(below(down / 2, across.min(8) / 2)) {
                *own = faded(*own, next);
            }
            let [height, slope_x, slope_z, red, green, blue] = own;
            *place = [(x, 0), (height, 1), (z, 2)]
                .map(|(at, axis)| fma(at, field.step[axis], field.corner[axis]));
            let vertex = ACROSS * down + across;
            block[vertices + 4 * vertex..][..3].copy_from_slice(place);
            block[vertices + 4 * vertex + 3] = normal(slope_x, up, slope_z);
            let bits = |part: Single, scale: Single| cfltu(fm(part, scale), 0);
            block[colours + vertex] =
                bits(red, FIVE) << 22 | bits(green, SIX) << 12 | bits(blue, FIVE) << 2;
        }
    }
    block[..HEADER].copy_from_slice(&[MAGIC, number, LEAF, 2, 3, 64, VERTICES as u32, SIDES]);
    for (run, words) in block[faces..colours].chunks_mut(8).enumerate() {
        let squares = [0, 1, ACROSS, ACROSS + 1];
        for (square, words) in squares.into_iter().zip(words.chunks_mut(2)) {
            let first = (run / 4 * 2 * ACROSS + run % 4 * 2 + square) as u8;
            let [b, c, d] = [1, ACROSS as u8, ACROSS as u8 + 1].map(|step| first + step);
            words[0] = u32::from_be_bytes([first, c, d, 0]);
            words[1] = u32::from_be_bytes([first, d, b, 0]);
        }
    }
    nodes(&mut block[HEADER..vertices], &places);
}

/// Writes the root and the two nodes below it, of four runs each.
fn nodes(words: &mut [u32], places: &[[[Single; 3]; ACROSS]; 5]) {
    let mut root = [[ZERO; 2]; 6];
    let mut size = ZERO;
    let mut boxes = [[[ZERO; 4]; 6]; 2];
    for (of, boxes) in boxes.iter_mut().enumerate() {
        for (plane, lanes) in boxes.iter_mut().enumerate() {
            let extreme = if plane < 3 { minimum } else { maximum };
            *lanes = std::array::from_fn(|run| {
                let rows = places[2 * of..2 * of + 3].iter();
                let corners = rows.flat_map(|row| row[2 * run..2 * run + 3].iter());
                corners.map(|place| place[plane % 3]).reduce(extreme).unwrap_or_default()
            });
            root[plane][of] = lanes.iter().copied().reduce(extreme).unwrap_or_default();
            size = maximum(size, root[plane][of] & !SIGN);
        }
    }
    let slack = fm(size, SLACK);
    for plane in 0..6 {
        let (moved, none) =
            if plane < 3 { (fs as fn(_, _) -> _, NO_BOX) } else { (fa as _, NO_BOX | SIGN) };
        let [first, second] = root[plane];
        let lanes = [[first, second, none, none], boxes[0][plane], boxes[1][plane]];
        for (node, lanes) in lanes.iter().enumerate() {
            for (lane, &value) in lanes.iter().enumerate() {
                words[NODE * node + 4 * plane + lane] = moved(value, slack);
            }
        }
    }
    let offset = |node: usize| 4 * (HEADER + NODE * node) as u32;
    words[24..28].copy_from_slice(&[offset(1), offset(2), 0, 0]);
    for run in 0..8 {
        words[NODE * (1 + run / 4) + 24 + run % 4] = (8 << 16) | (32 * run as u32);
    }
}
