//! The value of a register, as lanes of each size.
//!
//! Lanes count from the left, as in the architecture. On every host, word 0 is the preferred word
//! and holds the most significant bytes.

/// 128 bits as four words.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[repr(C, align(16))]
pub struct Quad(pub [u32; 4]);

impl Quad {
    /// All bits 0.
    pub const ZERO: Self = Self([0; 4]);

    /// The same word four times.
    #[inline]
    #[must_use]
    pub const fn splat(word: u32) -> Self {
        Self([word; 4])
    }

    /// A value in the preferred word. The other words are 0.
    #[inline]
    #[must_use]
    pub const fn scalar(word: u32) -> Self {
        Self([word, 0, 0, 0])
    }

    /// The preferred word.
    #[inline]
    #[must_use]
    pub const fn preferred(self) -> u32 {
        self.0[0]
    }

    /// The eight halfwords.
    #[inline]
    #[must_use]
    pub fn halfwords(self) -> [u16; 8] {
        std::array::from_fn(|lane| (self.0[lane / 2] >> (16 - lane % 2 * 16)) as u16)
    }

    /// Converts from eight halfwords.
    #[inline]
    #[must_use]
    pub fn from_halfwords(lanes: [u16; 8]) -> Self {
        Self(std::array::from_fn(|word| {
            u32::from(lanes[2 * word]) << 16 | u32::from(lanes[2 * word + 1])
        }))
    }

    /// The sixteen bytes.
    #[inline]
    #[must_use]
    pub const fn bytes(self) -> [u8; 16] {
        self.to_u128().to_be_bytes()
    }

    /// Converts from sixteen bytes.
    #[inline]
    #[must_use]
    pub const fn from_bytes(lanes: [u8; 16]) -> Self {
        Self::from_u128(u128::from_be_bytes(lanes))
    }

    /// The two doublewords.
    #[inline]
    #[must_use]
    pub const fn doublewords(self) -> [u64; 2] {
        let all = self.to_u128();
        [(all >> 64) as u64, all as u64]
    }

    /// Converts from two doublewords.
    #[inline]
    #[must_use]
    pub const fn from_doublewords(lanes: [u64; 2]) -> Self {
        Self::from_u128((lanes[0] as u128) << 64 | lanes[1] as u128)
    }

    /// The quadword as a number.
    #[inline]
    #[must_use]
    pub const fn to_u128(self) -> u128 {
        let [a, b, c, d] = self.0;
        (a as u128) << 96 | (b as u128) << 64 | (c as u128) << 32 | d as u128
    }

    /// Converts from a number.
    #[inline]
    #[must_use]
    pub const fn from_u128(all: u128) -> Self {
        Self([(all >> 96) as u32, (all >> 64) as u32, (all >> 32) as u32, all as u32])
    }
}
