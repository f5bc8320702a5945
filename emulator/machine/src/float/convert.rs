//! Conversions between 32-bit integers and singles, scaled by a power of two.
//!
//! The architecture defines scales from 0 to 127. The other scales that instruction words can hold
//! work in the same way. A scale that no instruction word can hold acts as the nearest one that
//! can be held.

use super::fpscr::Flags;
use super::single::{finish, to_f64};

/// 2^scale, exactly.
#[inline]
pub(super) fn power_of_two(scale: i32) -> f64 {
    // The combined range of the two encodings, 155 - I8 and 173 - I8.
    let scale = scale.clamp(-173, 173);
    f64::from_bits(((1023 + scale) as u64) << 52)
}

#[inline]
fn converted(integer: f64, scale: i32) -> (u32, Flags) {
    let ([result], [flags]) = finish([integer * power_of_two(-scale)], [false]);
    (result, flags)
}

/// A signed integer divided by 2^scale, truncated.
#[inline]
#[must_use]
pub fn csflt(x: u32, scale: i32) -> u32 {
    csflt_flagged(x, scale).0
}

/// [`csflt`] with its exceptions.
#[inline]
#[must_use]
pub fn csflt_flagged(x: u32, scale: i32) -> (u32, Flags) {
    converted(f64::from(x as i32), scale)
}

/// An unsigned integer divided by 2^scale, truncated.
#[inline]
#[must_use]
pub fn cuflt(x: u32, scale: i32) -> u32 {
    cuflt_flagged(x, scale).0
}

/// [`cuflt`] with its exceptions.
#[inline]
#[must_use]
pub fn cuflt_flagged(x: u32, scale: i32) -> (u32, Flags) {
    converted(f64::from(x), scale)
}

/// A single times 2^scale as a signed integer, truncated and saturated.
#[inline]
#[must_use]
pub fn cflts(x: u32, scale: i32) -> u32 {
    (to_f64(x) * power_of_two(scale)) as i32 as u32
}

/// A single times 2^scale as an unsigned integer, truncated and saturated. A negative single gives
/// 0.
#[inline]
#[must_use]
pub fn cfltu(x: u32, scale: i32) -> u32 {
    (to_f64(x) * power_of_two(scale)) as u32
}
