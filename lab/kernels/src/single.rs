//! Singles of records, by their bits: the host's `f32` is another format than the SPU's. And how
//! far apart they are.

use zerocopy::big_endian::F32;

/// A single of a record from its bits, whatever the host makes of them.
#[must_use]
pub fn single(bits: u32) -> F32 {
    F32::from_bytes(bits.to_be_bytes())
}

/// The bits of a record's single.
#[must_use]
pub fn bits(single: F32) -> u32 {
    u32::from_be_bytes(single.to_bytes())
}

/// How far apart singles are at this number, which is none of 0.
#[must_use]
pub fn spacing(number: f64) -> f64 {
    const EXPONENT: u64 = 0x7ff << 52;
    f64::from_bits(number.to_bits() & EXPONENT) * 2_f64.powi(-23)
}
