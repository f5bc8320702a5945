//! The twiddle factors, which the PPE computes once, by f64.

use std::f64::consts::TAU;

use crate::{Complex, Size};

/// Columns that a line holds.
const LINE: usize = 16;

/// The powers of `w = exp(-2 pi i / n)` that a butterfly needs, as multiply-adds want them: `w` is
/// `cosine (1 - i tangent)`. Where a cosine is 0, f64 has 6e-17 and a tangent of 2e16. The product
/// is the sine, and what the cosine adds is lost in rounding, as it should be.
#[derive(Clone, Copy, Debug)]
pub struct Butterfly {
    /// Tangent and cosine of `w` squared.
    pub square: [f32; 2],
    /// Tangent and cosine of `w`.
    pub first: [f32; 2],
}

impl Butterfly {
    /// The factors of butterfly `number` in the stage that makes transforms of length `length`.
    #[must_use]
    pub fn new(number: usize, length: usize) -> Self {
        let pair = |number: usize| {
            let (sine, cosine) = libm::sincos(TAU * number as f64 / length as f64);
            [(sine / cosine) as f32, cosine as f32]
        };
        Self { square: pair(2 * number), first: pair(number) }
    }

    /// A record of `kernels/transform.s`.
    pub(crate) fn bytes(&self) -> Vec<u8> {
        let words = [self.square, self.first].concat();
        let quadwords = words.iter().map(|word| word.to_be_bytes().repeat(4));
        quadwords.flatten().collect()
    }
}

/// `exp(-2 pi i power / n)`, for the n of a size.
fn root(power: usize, size: Size) -> Complex {
    let n = size.numbers();
    let (sine, cosine) = libm::sincos(TAU * (power % n) as f64 / n as f64);
    [cosine as f32, -sine as f32]
}

/// The factor between both passes at a row and column is that of its row and the column's place in
/// its batch, `fine`, times that of its row and the batch, `coarse`.
#[must_use]
pub fn fine(size: Size, row: usize, place: usize) -> Complex {
    root(row * place, size)
}

/// See [`fine`].
#[must_use]
pub fn coarse(size: Size, row: usize, batch: usize) -> Complex {
    root(row * LINE * batch, size)
}

/// Numbers as lines: 16 real parts, then the 16 imaginary ones.
pub(crate) fn lines(numbers: &[Complex]) -> Vec<u8> {
    split(numbers, LINE)
}

/// The coarse factors of one batch after the other, each for four rows at a time.
pub(crate) fn coarse_bytes(size: Size) -> Vec<u8> {
    let side = size.side();
    let batches = side / LINE;
    let factors: Vec<Complex> =
        (0..batches).flat_map(|batch| (0..side).map(move |row| coarse(size, row, batch))).collect();
    split(&factors, 4)
}

/// The fine factors, a line for each row.
pub(crate) fn fine_bytes(size: Size) -> Vec<u8> {
    let rows = 0..size.side();
    let factors: Vec<Complex> =
        rows.flat_map(|row| (0..LINE).map(move |place| fine(size, row, place))).collect();
    lines(&factors)
}

/// The records of all stages.
pub(crate) fn stage_bytes() -> Vec<u8> {
    let of = |length: usize| (0..length / 4).map(move |number| Butterfly::new(number, length));
    let all = [16, 64, 256].into_iter().flat_map(of);
    all.flat_map(|factors| factors.bytes()).collect()
}

fn split(numbers: &[Complex], together: usize) -> Vec<u8> {
    let mut bytes = Vec::with_capacity(8 * numbers.len());
    for group in numbers.chunks_exact(together) {
        for part in 0..2 {
            bytes.extend(group.iter().flat_map(|number| number[part].to_be_bytes()));
        }
    }
    bytes
}

/// The inverse of [`lines`].
pub(crate) fn numbers(bytes: &[u8]) -> Vec<Complex> {
    let word = |bytes: &[u8]| f32::from_be_bytes([bytes[0], bytes[1], bytes[2], bytes[3]]);
    let of_line = |line: &[u8]| {
        let words: Vec<f32> = line.chunks_exact(4).map(word).collect();
        (0..LINE).map(move |at| [words[at], words[LINE + at]])
    };
    bytes.chunks_exact(8 * LINE).flat_map(|line| of_line(line).collect::<Vec<_>>()).collect()
}
