//! IEEE numbers in integer arithmetic: unpacking, exact products and sums, and one rounding.
//!
//! Invariant of [`Number`]: the significand's highest bit is bit 125. Bit 0 may be sticky and then
//! represents everything that was shifted out below it. Sticky bits come only from aligning
//! operands whose exponents differ by more than 20. So a subtraction cancels one bit at most, and
//! enough bits remain for rounding.

use super::fpscr::{Flags, Rounding};

/// Position of the highest bit of a [`Number`]'s significand.
const TOP: u32 = 125;

/// An IEEE binary format.
#[derive(Clone, Copy)]
pub(super) struct Format {
    /// Number of fraction bits.
    pub fraction_bits: u32,
    /// Exponent of the largest numbers. The smallest normal numbers have 1 minus this exponent.
    pub largest_exponent: i32,
}

pub(super) const SINGLE: Format = Format { fraction_bits: 23, largest_exponent: 127 };
pub(super) const DOUBLE: Format = Format { fraction_bits: 52, largest_exponent: 1023 };

impl Format {
    const fn exponent_field(self) -> u64 {
        (2 * self.largest_exponent + 1) as u64
    }

    const fn fraction_mask(self) -> u64 {
        (1 << self.fraction_bits) - 1
    }

    const fn smallest_exponent(self) -> i32 {
        1 - self.largest_exponent
    }

    const fn sign_shift(self) -> u32 {
        self.fraction_bits + self.exponent_field().count_ones()
    }

    pub const fn signed(self, negative: bool, magnitude: u64) -> u64 {
        (negative as u64) << self.sign_shift() | magnitude
    }

    pub const fn infinity(self, negative: bool) -> u64 {
        self.signed(negative, self.exponent_field() << self.fraction_bits)
    }

    /// The quiet NaN that is every operation's NaN result: sign 0, and only the first fraction bit
    /// set.
    pub const fn default_nan(self) -> u64 {
        self.infinity(false) | 1 << (self.fraction_bits - 1)
    }
}

/// A finite number other than zero.
#[derive(Clone, Copy)]
pub(super) struct Number {
    pub negative: bool,
    /// The value is significand * 2^(exponent - 125).
    exponent: i32,
    significand: u128,
}

/// The value of a bit pattern.
#[derive(Clone, Copy)]
pub(super) enum Value {
    Nan { signalling: bool },
    Infinity { negative: bool },
    Zero { negative: bool },
    Finite(Number),
}

impl Value {
    /// The value in a format, with one rounding. Every NaN becomes the default NaN.
    pub fn round(self, format: Format, rounding: Rounding) -> (u64, Flags) {
        match self {
            Self::Nan { .. } => (format.default_nan(), Flags::NONE),
            Self::Infinity { negative } => (format.infinity(negative), Flags::NONE),
            Self::Zero { negative } => (format.signed(negative, 0), Flags::NONE),
            Self::Finite(number) => number.round(format, rounding),
        }
    }
}

/// Decodes a bit pattern. A denormal becomes a zero with its sign, and raises its flag.
pub(super) fn unpack(format: Format, bits: u64, flags: &mut Flags) -> Value {
    let negative = bits >> format.sign_shift() & 1 != 0;
    let field = bits >> format.fraction_bits & format.exponent_field();
    let fraction = bits & format.fraction_mask();
    if field == format.exponent_field() {
        return if fraction == 0 {
            Value::Infinity { negative }
        } else {
            let signalling = fraction >> (format.fraction_bits - 1) == 0;
            Value::Nan { signalling }
        };
    }
    if field == 0 {
        *flags |= Flags::DOUBLE_DENORMAL.when(fraction != 0);
        return Value::Zero { negative };
    }
    let significand = fraction | 1 << format.fraction_bits;
    Value::Finite(Number {
        negative,
        exponent: field as i32 - format.largest_exponent,
        significand: u128::from(significand) << (TOP - format.fraction_bits),
    })
}

const fn shift_right_sticky(x: u128, count: u32) -> u128 {
    if count == 0 {
        x
    } else if count > 127 {
        (x != 0) as u128
    } else {
        x >> count | (x << (128 - count) != 0) as u128
    }
}

impl Number {
    /// A number from any nonzero significand.
    fn normalised(negative: bool, exponent: i32, significand: u128) -> Self {
        let highest = 127 - significand.leading_zeros();
        let significand = if highest > TOP {
            shift_right_sticky(significand, highest - TOP)
        } else {
            significand << (TOP - highest)
        };
        Self { negative, exponent: exponent + highest as i32 - TOP as i32, significand }
    }

    /// The exact product of two unpacked numbers.
    pub fn times(self, other: Self) -> Self {
        // Unpacked significands have at most 53 bits.
        const SHIFT: u32 = TOP - DOUBLE.fraction_bits;
        let product = (self.significand >> SHIFT) * (other.significand >> SHIFT);
        Self::normalised(
            self.negative != other.negative,
            self.exponent + other.exponent + TOP as i32 - 2 * DOUBLE.fraction_bits as i32,
            product,
        )
    }

    /// The sum, exact except for the sticky bit. `None` if it is zero.
    pub fn plus(self, other: Self) -> Option<Self> {
        let (high, low) =
            if (self.exponent, self.significand) >= (other.exponent, other.significand) {
                (self, other)
            } else {
                (other, self)
            };
        let distance = high.exponent.abs_diff(low.exponent);
        let addend = shift_right_sticky(low.significand, distance);
        let sum = if high.negative == low.negative {
            high.significand + addend
        } else {
            high.significand - addend
        };
        (sum != 0).then(|| Self::normalised(high.negative, high.exponent, sum))
    }

    /// Converts the number to a format, with one rounding.
    fn round(self, format: Format, rounding: Rounding) -> (u64, Flags) {
        let tiny = self.exponent < format.smallest_exponent();
        let below = format.smallest_exponent().saturating_sub(self.exponent).max(0) as u32;
        let dropped = (TOP - format.fraction_bits + below).min(127);
        let kept = (self.significand >> dropped) as u64;
        let rest = self.significand & ((1 << dropped) - 1);
        let half = 1 << (dropped - 1);
        let inexact = rest != 0;
        let away = match rounding {
            Rounding::NearestEven => rest > half || rest == half && kept & 1 != 0,
            Rounding::TowardZero => false,
            Rounding::Up => inexact && !self.negative,
            Rounding::Down => inexact && self.negative,
        };
        let kept = kept + u64::from(away);
        // The leading bit in `kept` adds one to the exponent, so the field starts one lower.
        let field = if tiny { 0 } else { (self.exponent - format.smallest_exponent()) as u64 };
        let magnitude = (field << format.fraction_bits) + kept;
        let infinity = format.infinity(false);
        if magnitude >= infinity {
            let to_infinity = match rounding {
                Rounding::NearestEven => true,
                Rounding::TowardZero => false,
                Rounding::Up => !self.negative,
                Rounding::Down => self.negative,
            };
            let magnitude = infinity - u64::from(!to_infinity);
            return (
                format.signed(self.negative, magnitude),
                Flags::DOUBLE_OVERFLOW | Flags::DOUBLE_INEXACT,
            );
        }
        let flags =
            Flags::DOUBLE_INEXACT.when(inexact) | Flags::DOUBLE_UNDERFLOW.when(inexact && tiny);
        (format.signed(self.negative, magnitude), flags)
    }
}
