//! Twin of `spu/isect/cuts_extent_r16.s` and `spu/shade/cuts_shades_r16.s`: the shadow rays of
//! which it is known whether the ground blocks them.

use spu_emulator::float::convert::{cflts, csflt};
use spu_emulator::float::single::{fa, fcgt, fma, fnms, fs};

use super::mesh::minimum;
use super::{FARTHEST, Single, ZERO, below_zero};

/// Blocks across and down in local store, and cells of each.
pub const BLOCKS: usize = 8;

/// A ray's origin, t and object.
pub type Ray = ([Single; 3], Single, u32);

/// The numbers of a height field's shadows.
#[derive(Clone, Copy, Debug)]
pub struct Shades {
    /// A line's rate along x, its start, its rate along z, and the last line.
    pub line: [Single; 4],
    /// The same for the samples of a line.
    pub place: [Single; 4],
    /// The slant of lanes, their start, the fall from line to line, and the start of heights.
    pub lane: [Single; 4],
}

impl Shades {
    /// The line and the lane of a ray's origin, unless it is absent or starts beside the field.
    fn places(&self, ([x, _, z], t, _): Ray) -> Option<[Single; 2]> {
        let along = |[per_x, start, per_z, _]: [Single; 4]| fma(z, per_z, fma(x, per_x, start));
        let beside = |at: Single, [.., last]: [Single; 4]| fcgt(ZERO, at) | fcgt(at, last) != 0;
        let [line, place] = [along(self.line), along(self.place)];
        let is_outside = below_zero(t) || beside(line, self.line) || beside(place, self.place);
        let [slant, shift, ..] = self.lane;
        (!is_outside).then(|| [line, fa(fnms(line, slant, place), shift)])
    }

    /// The smallest line of rays, the largest, the smallest lane and the largest.
    #[must_use]
    pub fn extent(&self, rays: &[Ray]) -> [Single; 4] {
        let mut smallest = [FARTHEST; 4];
        for [line, lane] in rays.iter().filter_map(|ray| self.places(*ray)) {
            let found = [line, fs(ZERO, line), lane, fs(ZERO, lane)];
            smallest = std::array::from_fn(|nth| minimum(smallest[nth], found[nth]));
        }
        let [line, lines, lane, lanes] = smallest;
        [line, fs(ZERO, lines), lane, fs(ZERO, lanes)]
    }

    /// The t and the object that a ray gets, by the blocks from a line and a lane of a level on.
    #[must_use]
    pub fn shaded(
        &self,
        ray: Ray,
        blocks: &[[u32; 4]],
        [level, line, lane, length]: [u32; 4],
        ground: u32,
    ) -> (Single, u32) {
        let ([_, y, _], t, object) = ray;
        let Some(at) = self.places(ray) else {
            return (t, object);
        };
        let [_, _, fall, base] = self.lane;
        let height = fa(fma(at[0], fall, y), base);
        let cell = |at: Single, first: u32| {
            let cell = cflts(at, 0).cast_signed() >> level;
            cell.wrapping_sub(first.cast_signed()) as usize & 63
        };
        let [line, lane] = [cell(at[0], line), cell(at[1], lane)];
        let [first, last, low, high] = blocks[line / 8 * BLOCKS + lane / 8];
        let bits = u64::from(first) << 32 | u64::from(last);
        let is_lit = bits << (line % 8 * 8 + lane % 8) >> 63 != 0 || fcgt(height, high) != 0;
        if is_lit {
            (LIT, object)
        } else if fcgt(low, height) != 0 {
            (NO_RAY, ground)
        } else {
            let reach = high & ENDLESS;
            let end = fma(csflt(reach + line as u32 % 8, 0), length, length);
            (if reach == ENDLESS { t } else { end }, object)
        }
    }
}

/// The bits of an upper bound that count lines, and their value without an end.
const ENDLESS: u32 = 255;

/// The t of a ray that reaches the light, and that of one that does not: -2 and -1.
const LIT: Single = 0xc000_0000;
const NO_RAY: Single = 0xbf80_0000;
