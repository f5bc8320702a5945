//! Twin of `spu/shade/pack_r16.s`: a colour to the framebuffer's word.

use spu_emulator::float::convert::cfltu;
use spu_emulator::float::single::{fcgt, fma};

use super::{HALF, ONE, Single, select};

/// The single 255.
const FULL: Single = 0x437f_0000;

/// The pixel of a colour; `shifts` place red, green and blue.
#[must_use]
pub fn pack(colour: [Single; 3], shifts: [u32; 3]) -> u32 {
    let channel = |(value, shift): (Single, u32)| {
        let value = select(value, ONE, fcgt(value, ONE) != 0);
        cfltu(fma(value, FULL, HALF), 0) << shift
    };
    colour
        .into_iter()
        .zip(shifts)
        .map(channel)
        .fold(0, |pixel, channel| pixel | channel)
}
