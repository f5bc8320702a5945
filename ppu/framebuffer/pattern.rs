//! A test picture, written as SPUs write: in whole groups of four pixels, with junk beyond the
//! right edge, and zero in the byte that no channel uses.

use super::{DMA_ALIGN, PIXEL_GROUP, Target};
use image::RgbImage;

/// The value of pixels outside of the picture.
const OUTSIDE: u32 = 0xEEEE_EEEE;

/// The colour at `x`, `y`: different for every pixel of a small picture and for every `seed`.
pub(super) fn colour(x: u32, y: u32, seed: u32) -> [u8; 3] {
    [x as u8, y as u8, (x / 256 * 16 + y / 256 + seed * 97 + 1) as u8]
}

/// Writes the picture of `seed` through `target`, after checking the rules for DMA.
pub(super) fn paint(target: Target, seed: u32) {
    let Target { base, bytes, stride, geometry, format } = target;
    assert_eq!(base.as_ptr() as usize % DMA_ALIGN, 0);
    assert_eq!(stride as usize % DMA_ALIGN, 0);
    assert!(stride >= geometry.written_row_bytes());
    assert!(bytes >= stride as usize * geometry.height as usize);
    for y in 0..geometry.height {
        for x in 0..geometry.width.next_multiple_of(PIXEL_GROUP) {
            let word = if x < geometry.width { format.word(colour(x, y, seed)) } else { OUTSIDE };
            let offset = (y * stride + x * 4) as usize;
            // SAFETY: the row and its last group end within `bytes`, as asserted above.
            unsafe { base.add(offset).cast::<[u8; 4]>().write(word.to_be_bytes()) };
        }
    }
}

/// Asserts that `picture` is the picture of `seed`, pixel by pixel.
pub(super) fn assert_shows(picture: &RgbImage, seed: u32) {
    for (x, y, pixel) in picture.enumerate_pixels() {
        assert_eq!(pixel.0, colour(x, y, seed), "pixel {x},{y} of seed {seed}");
    }
}
