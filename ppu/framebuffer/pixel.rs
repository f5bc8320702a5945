//! The positions of a pixel's channels.
//!
//! An SPU stores a pixel as a big-endian word. A driver describes a pixel by bit offsets in the
//! host's native word. One is converted to the other when a framebuffer is opened.

/// The positions of the 8-bit channels in the big-endian 32-bit word that an SPU stores, as left
/// shifts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PixelFormat {
    /// Left shift of red: 0, 8, 16 or 24.
    pub red_shift: u32,
    /// Left shift of green.
    pub green_shift: u32,
    /// Left shift of blue.
    pub blue_shift: u32,
}

impl PixelFormat {
    /// Bytes A, R, G, B in memory: the format of ps3fb, of files and of frames in memory.
    pub const ARGB: PixelFormat = PixelFormat { red_shift: 16, green_shift: 8, blue_shift: 0 };

    /// The format of a driver whose native 32-bit words have their channels at these bit offsets.
    /// `None` if a channel isn't a byte of its own.
    pub(super) fn from_native_offsets(
        red: u32,
        green: u32,
        blue: u32,
        big_endian: bool,
    ) -> Option<PixelFormat> {
        let shift = |offset: u32| match offset {
            0 | 8 | 16 | 24 => Some(if big_endian { offset } else { 24 - offset }),
            _ => None,
        };
        if red == green || green == blue || blue == red {
            return None;
        }
        Some(PixelFormat {
            red_shift: shift(red)?,
            green_shift: shift(green)?,
            blue_shift: shift(blue)?,
        })
    }

    /// The word of an opaque colour; the byte that no channel uses is zero.
    pub fn word(self, [red, green, blue]: [u8; 3]) -> u32 {
        u32::from(red) << self.red_shift
            | u32::from(green) << self.green_shift
            | u32::from(blue) << self.blue_shift
    }

    /// Red, green and blue of a word.
    pub fn channels(self, word: u32) -> [u8; 3] {
        [self.red_shift, self.green_shift, self.blue_shift].map(|shift| (word >> shift) as u8)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ps3_offsets_on_a_big_endian_host_are_argb() {
        assert_eq!(PixelFormat::from_native_offsets(16, 8, 0, true), Some(PixelFormat::ARGB));
        assert_eq!(PixelFormat::ARGB.word([0x11, 0x22, 0x33]).to_be_bytes(), [0, 0x11, 0x22, 0x33]);
    }

    #[test]
    fn same_offsets_on_a_little_endian_host_are_bgra_in_memory() {
        let format = PixelFormat::from_native_offsets(16, 8, 0, false).unwrap();
        assert_eq!(format, PixelFormat { red_shift: 8, green_shift: 16, blue_shift: 24 });
        let native = 0x11u32 << 16 | 0x22 << 8 | 0x33;
        assert_eq!(format.word([0x11, 0x22, 0x33]).to_be_bytes(), native.to_le_bytes());
    }

    #[test]
    fn every_byte_order_agrees_with_the_native_word() {
        for red in [0, 8, 16, 24] {
            for green in [0, 8, 16, 24] {
                for blue in [0, 8, 16, 24] {
                    if red == green || green == blue || blue == red {
                        assert_eq!(PixelFormat::from_native_offsets(red, green, blue, true), None);
                        continue;
                    }
                    let native = 0xA1u32 << red | 0xB2 << green | 0xC3 << blue;
                    let colour = [0xA1, 0xB2, 0xC3];
                    let big = PixelFormat::from_native_offsets(red, green, blue, true).unwrap();
                    assert_eq!(big.word(colour).to_be_bytes(), native.to_be_bytes());
                    let little = PixelFormat::from_native_offsets(red, green, blue, false).unwrap();
                    assert_eq!(little.word(colour).to_be_bytes(), native.to_le_bytes());
                    assert_eq!(big.channels(big.word(colour)), colour);
                }
            }
        }
    }

    #[test]
    fn channels_across_bytes_are_refused() {
        for offsets in [(11, 5, 0), (20, 10, 0), (32, 8, 0), (16, 8, u32::MAX)] {
            assert_eq!(
                PixelFormat::from_native_offsets(offsets.0, offsets.1, offsets.2, false),
                None
            );
        }
    }
}
