//! The floating-point status and control register.
//!
//! Flags are sticky: they stay set until `fscrwr` writes them. Unused bits are always 0.

use std::ops::{BitOr, BitOrAssign};

/// The exceptions of one slice, with the bit positions of the slice's word in the register.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Flags(u32);

impl Flags {
    /// No exception.
    pub const NONE: Self = Self(0);

    /// Single: the result before rounding was above the largest number.
    pub const OVERFLOW: Self = Self(0x4);
    /// Single: a nonzero result was below the smallest number.
    pub const UNDERFLOW: Self = Self(0x2);
    /// Single: IEEE arithmetic would have given a different result, or might have.
    pub const DIFFERENT: Self = Self(0x1);

    /// Double: overflow.
    pub const DOUBLE_OVERFLOW: Self = Self(0x2000);
    /// Double: tiny and inexact.
    pub const DOUBLE_UNDERFLOW: Self = Self(0x1000);
    /// Double: inexact.
    pub const DOUBLE_INEXACT: Self = Self(0x800);
    /// Double: invalid operation.
    pub const DOUBLE_INVALID: Self = Self(0x400);
    /// Double: an operand was a NaN.
    pub const DOUBLE_NAN: Self = Self(0x200);
    /// Double: an operand was denormal and was treated as zero.
    pub const DOUBLE_DENORMAL: Self = Self(0x100);

    /// These flags if `condition` holds, else no flags. Does not branch.
    #[inline]
    #[must_use]
    pub const fn when(self, condition: bool) -> Self {
        Self(self.0 & (condition as u32).wrapping_neg())
    }

    /// Whether all of `other` are set.
    #[must_use]
    pub const fn contains(self, other: Self) -> bool {
        self.0 & other.0 == other.0
    }

    /// The bits in the slice's word.
    #[must_use]
    pub const fn bits(self) -> u32 {
        self.0
    }
}

impl BitOr for Flags {
    type Output = Self;
    #[inline]
    fn bitor(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }
}

impl BitOrAssign for Flags {
    #[inline]
    fn bitor_assign(&mut self, other: Self) {
        self.0 |= other.0;
    }
}

/// Rounding mode of a double-precision slice.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Rounding {
    /// To the nearest, ties to even.
    #[default]
    NearestEven,
    /// Toward zero.
    TowardZero,
    /// Toward positive infinity.
    Up,
    /// Toward negative infinity.
    Down,
}

/// The implemented bits of each word.
const MASK: [u32; 4] = [0x0f07, 0x3f07, 0x3f07, 0x0f07];

/// For each word slice, the bit of the last word that records a reciprocal estimate of zero.
const DIVIDE_BY_ZERO: [u32; 4] = [0x800, 0x400, 0x200, 0x100];

/// The register: rounding modes and sticky flags.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Fpscr([u32; 4]);

impl Fpscr {
    /// The register after `fscrwr` writes these words. Unused bits are dropped.
    #[must_use]
    pub fn from_words(words: [u32; 4]) -> Self {
        Self(std::array::from_fn(|word| words[word] & MASK[word]))
    }

    /// The words that `fscrrd` reads.
    #[must_use]
    pub const fn words(self) -> [u32; 4] {
        self.0
    }

    /// The rounding mode of double slice 0 or 1.
    #[must_use]
    pub const fn rounding(self, slice: usize) -> Rounding {
        match self.0[0] >> (10 - 2 * (slice & 1)) & 3 {
            0 => Rounding::NearestEven,
            1 => Rounding::TowardZero,
            2 => Rounding::Up,
            _ => Rounding::Down,
        }
    }

    /// Sets single-precision flags, one set for each word slice.
    #[inline]
    pub fn raise_single(&mut self, flags: [Flags; 4]) {
        for (word, flags) in self.0.iter_mut().zip(flags) {
            *word |= flags.0;
        }
    }

    /// Sets double-precision flags, one set for each doubleword slice.
    pub fn raise_double(&mut self, flags: [Flags; 2]) {
        self.0[1] |= flags[0].0;
        self.0[2] |= flags[1].0;
    }

    /// Sets the divide-by-zero flags of the word slices that are `true`.
    #[inline]
    pub fn raise_divide_by_zero(&mut self, slices: [bool; 4]) {
        for (flag, raised) in DIVIDE_BY_ZERO.into_iter().zip(slices) {
            self.0[3] |= if raised { flag } else { 0 };
        }
    }
}
