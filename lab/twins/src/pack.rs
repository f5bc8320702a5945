//! Twin of `spu/shade/pack_r16.s`: a colour to the framebuffer's word.

use spu_emulator::float::convert::cfltu;
use spu_emulator::float::single::fma;

use super::Single;

/// The single 255/256.
const SCALE: Single = 0x3f7f_0000;
/// The single 1/512.
const ROUND: Single = 0x3b00_0000;

/// The byte of a channel: 0 for 0 and below, 255 for 1 and above.
#[must_use]
pub fn channel(value: Single) -> u8 {
    (cfltu(fma(value, SCALE, ROUND), 32) >> 24) as u8
}

/// The pixel of a colour; `shifts` place red, green and blue.
#[must_use]
pub fn pack(colour: [Single; 3], shifts: [u32; 3]) -> u32 {
    let channels = colour.into_iter().zip(shifts);
    channels.fold(0, |pixel, (value, shift)| pixel | u32::from(channel(value)) << shift)
}
