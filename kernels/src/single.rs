//! Singles of records, by their bits: the host's `f32` is another format than the SPU's.

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
