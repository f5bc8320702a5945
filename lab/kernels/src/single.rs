//! The singles of records, given by their bits because the host's `f32` has another format than
//! the SPU's, and the distance between singles.

use zerocopy::big_endian::F32;

/// A record's single from its bits, whatever they mean on the host.
#[must_use]
pub fn single(bits: u32) -> F32 {
    F32::from_bytes(bits.to_be_bytes())
}

/// The bits of a record's single.
#[must_use]
pub fn bits(single: F32) -> u32 {
    u32::from_be_bytes(single.to_bytes())
}

/// The distance between singles at this number, which must not be 0.
#[must_use]
pub fn spacing(number: f64) -> f64 {
    const EXPONENT: u64 = 0x7ff << 52;
    f64::from_bits(number.to_bits() & EXPONENT) * 2_f64.powi(-23)
}
