//! The transform in Rust: the same operations in the same order, on the SPU's own arithmetic.
//!
//! Invariant: the SPU program gives these bits.

use spu_emulator::float::single::{fa, fm, fma, fms, fnms, fs};

use crate::factors::{Butterfly, coarse, fine};
use crate::{Complex, Size};

/// Lines of a batch, and columns of a line.
const LINES: usize = 256;
const LINE: usize = 16;

/// Real and imaginary part, as bit patterns of singles.
type Bits = [u32; 2];

/// The transform of `input`, as the SPUs compute it.
///
/// # Panics
///
/// `input` has another size.
#[must_use]
pub fn transform(size: Size, input: &[Complex]) -> Vec<Complex> {
    assert_eq!(input.len(), size.numbers());
    let input: Vec<Bits> = input.iter().map(|number| number.map(f32::to_bits)).collect();
    let output = match size {
        Size::Small => {
            let columns = stages(64, &input);
            let mut turned = Vec::new();
            for number in 0..4 {
                turned.extend(turn(size, number, &batch(size, &columns, number)));
            }
            stages(64, &turned)
        }
        Size::Large => {
            let mut turned = Vec::new();
            for number in 0..LINE {
                let columns = stages(256, &batch(size, &input, number));
                turned.extend(turn(size, number, &columns));
            }
            let mut output = vec![[0; 2]; size.numbers()];
            for number in 0..LINE {
                let columns = stages(256, &batch(size, &turned, number));
                for (row, line) in columns.chunks_exact(LINE).enumerate() {
                    let at = row * size.side() + number * LINE;
                    output[at..at + LINE].copy_from_slice(line);
                }
            }
            output
        }
    };
    output.iter().map(|number| number.map(f32::from_bits)).collect()
}

/// The lines of a matrix's columns 16 `number` to 16 `number` + 15.
fn batch(size: Size, matrix: &[Bits], number: usize) -> Vec<Bits> {
    let rows = matrix.chunks_exact(size.side());
    rows.flat_map(|row| &row[number * LINE..][..LINE]).copied().collect()
}

/// Transforms of length `length` of what is in the same place of lines `LINES / length` apart.
fn stages(length: usize, lines: &[Bits]) -> Vec<Bits> {
    let mut lines = stage_first(lines);
    let mut joined = 16;
    while joined <= length {
        lines = stage(joined, &lines);
        joined *= 4;
    }
    lines
}

/// The result of a stage: `butterfly` gets the number of a line and its four numbers.
fn each(
    distance: usize,
    lines: &[Bits],
    butterfly: impl Fn(usize, [Bits; 4]) -> [Bits; 4],
) -> Vec<Bits> {
    let mut result = vec![[0; 2]; lines.len()];
    for line in 0..LINES / 4 {
        let number = line / distance;
        for place in 0..LINE {
            let from = |part| lines[(line + (3 * number + part) * distance) * LINE + place];
            let joined = butterfly(number, [from(0), from(1), from(2), from(3)]);
            for (quarter, value) in joined.into_iter().enumerate() {
                result[(line + quarter * LINES / 4) * LINE + place] = value;
            }
        }
    }
    result
}

fn stage_first(lines: &[Bits]) -> Vec<Bits> {
    let add = |a: Bits, b: Bits| [fa(a[0], b[0]), fa(a[1], b[1])];
    let subtract = |a: Bits, b: Bits| [fs(a[0], b[0]), fs(a[1], b[1])];
    each(LINES / 4, lines, |_, [x0, x1, x2, x3]| {
        let (ap, am) = (add(x0, x2), subtract(x0, x2));
        let (bp, bm) = (add(x1, x3), subtract(x1, x3));
        [
            add(ap, bp),
            [fa(am[0], bm[1]), fs(am[1], bm[0])],
            subtract(ap, bp),
            [fs(am[0], bm[1]), fa(am[1], bm[0])],
        ]
    })
}

fn stage(joined: usize, lines: &[Bits]) -> Vec<Bits> {
    each(LINES / joined, lines, |number, [x0, x1, x2, x3]| {
        let factors = Butterfly::new(number, joined);
        let square = factors.square.map(f32::to_bits);
        let first = factors.first.map(f32::to_bits);
        let (ap, am) = twiddle(x0, x2, square);
        let (bp, bm) = twiddle(x1, x3, square);
        let (y0, y2) = twiddle(ap, bp, first);
        let [tangent, cosine] = first;
        let u = fma(bm[1], tangent, bm[0]);
        let v = fnms(bm[0], tangent, bm[1]);
        [
            y0,
            [fma(v, cosine, am[0]), fnms(u, cosine, am[1])],
            y2,
            [fnms(v, cosine, am[0]), fma(u, cosine, am[1])],
        ]
    })
}

/// `x + w z` and `x - w z`.
fn twiddle(x: Bits, z: Bits, [tangent, cosine]: [u32; 2]) -> (Bits, Bits) {
    let u = fma(z[1], tangent, z[0]);
    let v = fnms(z[0], tangent, z[1]);
    ([fma(u, cosine, x[0]), fma(v, cosine, x[1])], [fnms(u, cosine, x[0]), fnms(v, cosine, x[1])])
}

/// The lines of a batch times their factors, column after column.
fn turn(size: Size, number: usize, lines: &[Bits]) -> Vec<Bits> {
    let rows = size.side();
    let mut turned = vec![[0; 2]; lines.len()];
    for (row, line) in lines.chunks_exact(LINE).enumerate() {
        let coarse = coarse(size, row, number).map(f32::to_bits);
        for (place, value) in line.iter().enumerate() {
            let factor = times(fine(size, row, place).map(f32::to_bits), coarse);
            turned[place * rows + row] = times(*value, factor);
        }
    }
    turned
}

fn times(a: Bits, b: Bits) -> Bits {
    [fms(a[0], b[0], fm(a[1], b[1])), fma(a[0], b[1], fm(a[1], b[0]))]
}
