//! Twin of `spu/isect/cuts_cells.s`, `cuts_follow.s`, `spu/shade/cuts_rays_r16.s` and
//! `cuts_ground_r16.s`: the rays of the eye that are traced by cuts over a height field.

use spu_emulator::float::convert::{cflts, cfltu, csflt, cuflt};
use spu_emulator::float::single::{fa, fcgt, fcmgt, fm, fma, fms, fs};

use super::height::{FIVE, SIX};
use super::math::{reciprocal, rsqrt};
use super::mesh::{maximum, minimum};
use super::{FARTHEST, ONE, SIGN, Single, ZERO, below_zero, select};

/// Cells across and down in local store.
pub const CELLS: usize = 32;
/// Cells across and down that are made together.
pub const SIDE: usize = 8;
/// Words of a row of samples.
const PITCH: usize = 12;
/// Words of a row of samples of the next level, and the first of them.
const COARSE_PITCH: usize = 8;
const COARSE: usize = (SIDE + 1) * PITCH;
/// All of the samples.
pub const SAMPLES: usize = COARSE + (SIDE / 2 + 1) * COARSE_PITCH;
/// The mask of a colour's first part.
const TEN: u32 = 0xffc0_0000;
/// 2^-40.
const TINY: Single = 0x2b80_0000;
/// Most squares along a cut.
const MOST_CELLS: usize = 4096;
/// The part of a distance by which a shadow ray starts above the ground: 1/512.
const LEAVE: Single = 0x3b00_0000;
/// 1024 / 1023.
const PARTS: Single = 0x3f80_2008;

/// The heights at the corners of squares, and their colours.
pub type Cells = [Vec<[u32; 4]>; 2];

/// A level, as far as cells need it.
#[derive(Clone, Copy, Debug)]
pub struct Level {
    /// The side of a square.
    pub side: Single,
    /// The first sample relative to the eye.
    pub corner: [Single; 3],
    /// The square of the eye's height above the ground.
    pub above: Single,
    /// The square of the distance where it begins to fade.
    pub from: Single,
    /// One over what is from there to where it has faded.
    pub fade: Single,
    /// The length of a height of 1.
    pub unit: Single,
}

/// Makes cells of samples, as `cuts_cells` does.
pub fn cells(samples: &[u32; SAMPLES], level: &Level, [column, row]: [u32; 2], out: &mut Cells) {
    let place = |at: usize, first: u32, corner: Single| {
        fma(csflt(first.wrapping_add(at as u32), 0), level.side, corner)
    };
    let vertex = |down: usize, across: usize| {
        let x = place(across, column, level.corner[0]);
        let z = place(down, row, level.corner[2]);
        let distance = fa(fma(x, x, level.above), fm(z, z));
        let part = fm(fs(distance, level.from), level.fade);
        let part = minimum(maximum(part, ZERO), ONE);
        let own = samples[PITCH * down + across];
        let around = |mask: u32, shift: u32| {
            let [top, bottom] = [down / 2, down.div_ceil(2)];
            let [left, right] = [across / 2, across.div_ceil(2)];
            let at = |down: usize, across: usize| {
                (samples[COARSE + COARSE_PITCH * down + across] & mask) >> shift
            };
            at(top, left) + at(bottom, left) + at(top, right) + at(bottom, right)
        };
        let faded = |mask: u32, shift: u32| {
            let [own, other] = [csflt((own & mask) >> shift, 0), csflt(around(mask, shift), 2)];
            fma(part, fs(other, own), own)
        };
        let height = fma(faded(0xffff_0000, 16), level.unit, level.corner[1]);
        let bits = |mask: u32, shift: u32, scale: Single, place: i32| {
            cfltu(fm(faded(mask, shift), scale), place) & TEN >> (22 - place)
        };
        let red = bits(0xf800, 11, FIVE, 22);
        let green = bits(0x07e0, 5, SIX, 12);
        [height, red | green | bits(0x1f, 0, FIVE, 2)]
    };
    for down in 0..SIDE {
        for across in 0..SIDE {
            let at = |step: usize| (down + step / 2, across + step % 2);
            let corners = [0, 1, 2, 3].map(|step| vertex(at(step).0, at(step).1));
            let cell = cell_at(column as usize + across, row as usize + down);
            for (of, out) in out.iter_mut().enumerate() {
                out[cell] = corners.map(|corner| corner[of]);
            }
        }
    }
}

/// Where the cell of a square is.
fn cell_at(column: usize, row: usize) -> usize {
    row % CELLS * CELLS + column % CELLS
}

/// The numbers that the cuts of a tile share.
#[derive(Clone, Copy, Debug)]
pub struct Cuts {
    /// The tangent's numerator, its denominator, the slope's denominator and numerator: in the
    /// first column, and what each column adds.
    pub linear: [[Single; 2]; 4],
    /// The axis of the view: x, z.
    pub ahead: [Single; 2],
    /// Across it: x, z.
    pub aside: [Single; 2],
    /// One over the side of a square.
    pub per_side: Single,
    /// The eye in squares: x, z.
    pub origin: [Single; 2],
    /// Where the squares end.
    pub end: [Single; 2],
    /// Where to stop.
    pub limit: Single,
    /// From a difference of heights to a slope.
    pub slope: Single,
    /// Of each row: additions to numerators and denominators of slopes, the address of its first
    /// pixel, and how far the cuts are aside.
    pub rows: [[u32; 4]; 16],
}

/// A hit: the pixel's address and its quadword.
pub type Pixel = (u32, [u32; 4]);

/// One of four cuts.
struct Cut<'a> {
    cuts: &'a Cuts,
    cells: &'a Cells,
    along: [Single; 2],
    per: [Single; 2],
    at: [Single; 2],
}

fn between(from: Single, to: Single, part: Single) -> Single {
    fma(part, fs(to, from), from)
}

fn bilinear(corners: [Single; 4], [x, z]: [Single; 2]) -> Single {
    let [a, b, c, d] = corners;
    between(between(a, b, x), between(c, d, x), z)
}

/// A single's whole part.
fn whole(value: Single) -> u32 {
    cflts(value, 0)
}

impl Cut<'_> {
    fn square(&self) -> [usize; 2] {
        self.at.map(|at| whole(at) as usize & (CELLS - 1))
    }

    fn heights(&self) -> [Single; 4] {
        let [x, z] = self.square();
        self.cells[0][cell_at(x, z)]
    }

    /// Where a distance is in the square.
    fn within(&self, distance: Single) -> [Single; 2] {
        [0, 1]
            .map(|axis| fs(fma(distance, self.along[axis], self.cuts.origin[axis]), self.at[axis]))
    }

    fn above(&self, axis: usize) -> bool {
        fcgt(self.along[axis], ZERO) != 0
    }

    /// Where the cut leaves the square, along which axis, and the height there.
    fn end(&self) -> (Single, bool, Single) {
        let [x, z] = [0, 1].map(|axis| {
            let plus = if self.above(axis) { ONE } else { ZERO };
            let side = fs(fa(self.at[axis], plus), self.cuts.origin[axis]);
            fm(side, self.per[axis])
        });
        let is_x = fcgt(z, x) != 0;
        let s = select(z, x, is_x);
        (s, is_x, bilinear(self.heights(), self.within(s)))
    }

    /// The heights of the square beside it, or the same at the edge.
    fn beside(&self, axis: usize, way: i32) -> [Single; 4] {
        let mut at = self.at.map(|at| whole(at).cast_signed());
        let there = at[axis].wrapping_add(way);
        let inside =
            if way < 0 { at[axis] > 0 } else { whole(self.cuts.end[axis]).cast_signed() > there };
        at[axis] = if inside { there } else { at[axis] };
        let [x, z] = at.map(|at| at as usize & (CELLS - 1));
        self.cells[0][cell_at(x, z)]
    }

    fn slope(&self, axis: usize, at: [Single; 2]) -> Single {
        let other = at[1 - axis];
        let step = [1, 2][axis];
        let across = [2, 1][axis];
        let side = |cell: [Single; 4], far: usize| {
            between(cell[far * step], cell[far * step + across], other)
        };
        let own = self.heights();
        let [near, far] = [side(own, 0), side(own, 1)];
        let first = fs(far, side(self.beside(axis, -1), 0));
        let last = fs(side(self.beside(axis, 1), 1), near);
        between(first, last, at[axis])
    }

    fn pixel(&self, s: Single) -> [u32; 4] {
        let at = self.within(s);
        let [slope_x, slope_z] = [0, 1].map(|axis| fm(self.slope(axis, at), self.cuts.slope));
        let [x, z] = self.square();
        let colours = self.cells[1][cell_at(x, z)];
        let channel = |scale: i32| {
            let mask = TEN >> (22 - scale);
            let parts = colours.map(|colour| cuflt(colour & mask, scale));
            cfltu(bilinear(parts, at), scale) & mask
        };
        [s, slope_x, slope_z, channel(22) | channel(12) | channel(2)]
    }
}

/// Follows a cut, as `cuts_follow` does. Returns its distance and row, and what has been hit.
/// `most` are the passes of all four cuts, which the kernel counts together.
pub fn cut(
    cuts: &Cuts,
    cells: &Cells,
    column: i32,
    [mut state, row]: [u32; 2],
) -> ([u32; 2], Vec<Pixel>) {
    let x = csflt(column.cast_unsigned(), 0);
    let [lat, den_m, den_at, num_at] = cuts.linear.map(|[first, more]| fma(x, more, first));
    let tangent = fm(lat, reciprocal(den_m));
    let along = [0, 1].map(|axis| {
        let along = fm(fma(tangent, cuts.aside[axis], cuts.ahead[axis]), cuts.per_side);
        select(along, TINY, fcmgt(TINY, along) != 0)
    });
    let mut cut = Cut { cuts, cells, along, per: along.map(reciprocal), at: [ZERO; 2] };
    let [out_x, out_z] = [0, 1].map(|axis| {
        let end = if cut.above(axis) { cuts.end[axis] } else { ZERO };
        fm(fs(end, cuts.origin[axis]), cut.per[axis])
    });
    let out = minimum(out_x, out_z);
    let goes_on = |s: Single| fcgt(cuts.limit, s) != 0 && fcgt(out, s) != 0;
    let mut row = row.cast_signed();
    let mut active = row >= 0 && goes_on(state);
    let mut s0 = state;
    cut.at = [0, 1].map(|axis| {
        let at = fma(s0, cut.along[axis], cuts.origin[axis]);
        let at = minimum(maximum(at, ZERO), fs(cuts.end[axis], ONE));
        csflt(whole(at), 0)
    });
    let mut y0 = bilinear(cut.heights(), cut.within(s0));
    let mut pixels = Vec::new();
    let mut left = MOST_CELLS;
    while active {
        let (s1, is_x, y1) = cut.end();
        let [num, den, first, aside] = cuts.rows[row as usize & 15];
        let [num, den] = [fa(num_at, num), fa(den_at, den)];
        let above = fms(y1, den, fm(s1, num));
        if fcgt(above, ZERO) != 0 {
            let below = minimum(fms(y0, den, fm(s0, num)), ZERO);
            let part = fm(below, reciprocal(fs(below, above)));
            state = fma(part, fs(s1, s0), s0);
            let at = column.wrapping_add(aside.cast_signed());
            if (0..64).contains(&at) {
                let address = first.wrapping_add(column.cast_unsigned() << 4);
                pixels.push((address, cut.pixel(state)));
            }
            row -= 1;
            active = row >= 0;
        } else {
            (s0, y0) = (s1, y1);
            state = s1;
            let axis = usize::from(!is_x);
            let step = if cut.above(axis) { ONE } else { ONE | SIGN };
            cut.at[axis] = fa(cut.at[axis], step);
            active = goes_on(s1);
            left -= 1;
            active &= left > 0;
        }
    }
    let state = select(FARTHEST, state, fcgt(out, state) != 0);
    ([state, row.cast_unsigned()], pixels)
}

/// The distance of a ray from the eye whose pixel has one along the axis, if it is there.
#[must_use]
pub fn hit(direction: [Single; 3], ahead: [Single; 2], t: Single, s: Single) -> Option<Single> {
    let share = fma(direction[2], ahead[1], fm(direction[0], ahead[0]));
    let is_hit = fcgt(s, ZERO) != 0 && !below_zero(t);
    is_hit.then(|| fm(s, reciprocal(share)))
}

/// The normal, the colour and `leave` of ground, of whose material the colour is. Colours may be
/// square roots of light.
#[must_use]
pub fn ground(
    pixel: [u32; 4],
    t: Single,
    colour: [Single; 3],
    is_root: bool,
) -> ([Single; 3], [Single; 3], Single) {
    let [_, x, z, bits] = pixel;
    let y = rsqrt(fma(z, z, fma(x, x, ONE)));
    let normal = [fm(x, y) ^ SIGN, y, fm(z, y) ^ SIGN];
    let part = |number: usize| fm(cuflt((bits << (10 * number)) & TEN, 32), PARTS);
    let [square, light] = if is_root { [ONE, ZERO] } else { [ZERO, ONE] };
    let factor = |part: Single| fm(part, fma(part, square, light));
    let colours = std::array::from_fn(|number| fm(factor(part(number)), colour[number]));
    (normal, colours, fm(t, LEAVE))
}
