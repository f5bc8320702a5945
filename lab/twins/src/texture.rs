//! Twins of `spu/shade/texture_places_r16.s` and `texture_filter_r16.s`: where a hit's texels are
//! in its texture, and what they make of its colour.

use spu_emulator::float::convert::{cflts, csflt};
use spu_emulator::float::single::{fa, fcgt, fm, fma, fms, fnms, fs};

use super::math::{reciprocal, sqrt};
use super::triangle::Triangle;
use super::{HALF, ONE, Single, below_zero, dot, select};
use zerocopy::FromBytes;

/// A single without its sign.
const MAGNITUDE: u32 = 0x7fff_ffff;
/// The single next to 1 / 255.
const SCALE: Single = 0x3b80_8081;
/// Texels from one tile to the next, and of a row of a tile.
const STEP: u32 = 8;
const SIDE: u32 = 9;
/// Bits of `wraps` below the number of the first tile.
const WRAP_BITS: u32 = 4;

/// A hit on a triangle with texture coordinates.
#[derive(Clone, Copy, Debug, FromBytes)]
pub struct Hit {
    /// The triangle's vertices.
    pub vertices: Triangle,
    /// Their texture coordinates.
    pub coordinates: [[Single; 2]; 3],
    /// The point.
    pub point: [Single; 3],
    /// The triangle's own normal, on the ray's side.
    pub plane: [Single; 3],
    /// Where the ray starts, relative to the eye.
    pub origin: [Single; 3],
    /// The ray's direction.
    pub direction: [Single; 3],
    /// The distance from there to the point.
    pub t: Single,
}

/// A texture, as `TEXTURE` has it.
#[derive(Clone, Copy, Debug)]
pub struct Texture {
    /// Number of the last level.
    pub last: u32,
    /// Texels of the first level.
    pub texels: Single,
    /// `WRAP_` bits, and 2^`WRAP_BITS` times the number of the first tile.
    pub wraps: u32,
}

/// A level, as `LEVEL` has it.
#[derive(Clone, Copy, Debug)]
pub struct Level {
    /// Texels across.
    pub width: Single,
    /// Texels down.
    pub height: Single,
    /// Tiles across.
    pub across: u32,
    /// Number of the first tile, from the texture's first one on.
    pub first: u32,
}

/// Where a filter's four texels are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Texel {
    /// Number of the tile.
    pub tile: u32,
    /// Offset in it of the upper left texel.
    pub place: u32,
    /// Part of the way to the right ones.
    pub right: Single,
    /// Part of the way to the lower ones.
    pub down: Single,
}

/// The shares of the second and the third vertex in a point, and 1 over the double area of the
/// triangle; `plane` is its normal.
pub(super) fn shares(
    vertices: &Triangle,
    point: [Single; 3],
    plane: [Single; 3],
) -> (Single, Single, Single) {
    let [a, b, c] = vertices
        .map(|vertex| -> [Single; 3] { std::array::from_fn(|axis| fs(vertex[axis], point[axis])) });
    let share = |from: [Single; 3], to: [Single; 3]| {
        let turn =
            [[1, 2], [2, 0], [0, 1]].map(|[i, j]| fms(plane[i], from[j], fm(plane[j], from[i])));
        dot(turn, to)
    };
    let [share_a, share_b, share_c] = [share(b, c), share(c, a), share(a, b)];
    let inverse = reciprocal(fa(fa(share_a, share_b), share_c));
    (fm(share_b, inverse), fm(share_c, inverse), inverse)
}

/// The texture coordinates of a hit, and the square of a pixel's width there, in texels of a
/// texture that has one.
#[must_use]
pub fn footprint(hit: &Hit, angle: Single) -> ([Single; 2], Single) {
    let plane = hit.plane;
    let (of_b, of_c, inverse) = shares(&hit.vertices, hit.point, plane);
    let [from, to_b, to_c] = hit.coordinates;
    let b: [Single; 2] = std::array::from_fn(|axis| fs(to_b[axis], from[axis]));
    let c: [Single; 2] = std::array::from_fn(|axis| fs(to_c[axis], from[axis]));
    let place = std::array::from_fn(|axis| fma(of_c, c[axis], fma(of_b, b[axis], from[axis])));
    let area = fm(fnms(c[0], b[1], fm(b[0], c[1])), inverse) & MAGNITUDE;
    let cosine = dot(plane, hit.direction);
    let far = fa(sqrt(dot(hit.origin, hit.origin)), hit.t);
    let width = fm(far, angle);
    let breadth = fm(fm(width, width), area);
    (place, fm(breadth, reciprocal(fm(cosine, cosine))))
}

/// The level for this footprint.
#[must_use]
pub fn level(breadth: Single, texture: &Texture) -> u32 {
    let exponent = (fm(breadth, texture.texels) >> 23) as i32 - 126;
    (exponent >> 1).clamp(0, texture.last as i32) as u32
}

/// The texel of a hit on a triangle with this texture.
#[must_use]
pub fn texel(hit: &Hit, angle: Single, texture: &Texture, levels: &[Level]) -> Texel {
    let ([u, v], breadth) = footprint(hit, angle);
    let level = levels[level(breadth, texture) as usize];
    let wraps = texture.wraps;
    let u = fma(within(u, wraps & 8 != 0, wraps & 4 != 0), level.width, HALF);
    let v = fma(within(v, wraps & 2 != 0, wraps & 1 != 0), level.height, HALF);
    let (column, row) = (cflts(u, 0), cflts(v, 0));
    let tiles = (row / STEP) * level.across;
    Texel {
        tile: (column / STEP).wrapping_add(tiles).wrapping_add(level.first + (wraps >> WRAP_BITS)),
        place: 4 * (column % STEP) + 4 * SIDE * (row % STEP),
        right: fs(u, csflt(column, 0)),
        down: fs(v, csflt(row, 0)),
    }
}

/// A coordinate brought between 0 and 1.
fn within(place: Single, repeats: bool, mirrors: bool) -> Single {
    let whole = cflts(place, 0);
    let whole = whole.wrapping_add(fcgt(csflt(whole, 0), place));
    let inside = fs(place, csflt(whole, 0));
    let inside = select(inside, fs(ONE, inside), mirrors && whole & 1 == 1);
    let place = select(place, inside, repeats);
    let place = if below_zero(place) { 0 } else { place };
    select(place, ONE, fcgt(place, ONE) != 0)
}

/// The colour of a surface with these four texels: left and right, above and below. They are light,
/// or its square root.
#[must_use]
pub fn filter(
    colour: [Single; 3],
    texels: [u32; 4],
    are_roots: bool,
    right: Single,
    down: Single,
) -> [Single; 3] {
    let (light, square) = if are_roots { (0, SCALE) } else { (ONE, 0) };
    std::array::from_fn(|channel| {
        let [a, b, c, d] = texels.map(|texel| {
            let part = csflt(texel >> (24 - 8 * channel) & 255, 0);
            fm(part, fma(part, square, light))
        });
        let above = fma(fs(b, a), right, a);
        let below = fma(fs(d, c), right, c);
        let mixed = fma(fs(below, above), down, above);
        fm(fm(mixed, SCALE), colour[channel])
    })
}
