//! Numbers in the SPU's single format: their range and rounding.

use glam::DVec3;
use zerocopy::big_endian::F32;

/// The largest magnitude of a coordinate or a radius. Its square is still a single.
pub(crate) const LARGEST: f64 = (1_u64 << 62) as f64;
/// The smallest size, such as a radius. Its square is still a single, and not 0.
pub(crate) const SMALLEST: f64 = 1.0 / LARGEST;

/// Whether a number can be squared as a single; NaN can't.
#[inline]
pub(crate) fn is_number(value: f64) -> bool {
    value.abs() <= LARGEST
}

/// Whether a size is in range, and its square is not 0 as a single.
#[inline]
pub(crate) fn is_size(value: f64) -> bool {
    (SMALLEST..=LARGEST).contains(&value.abs())
}

/// Rounds a number to the nearest single.
pub(crate) fn single(value: f64) -> F32 {
    F32::new(value as f32)
}

/// Rounds three coordinates or channels to the nearest singles.
pub(crate) fn singles(vector: DVec3) -> [F32; 3] {
    vector.to_array().map(single)
}

/// Rounds a number down to a single.
pub(crate) fn down(value: f64) -> F32 {
    let nearest = value.clamp(f64::from(-f32::MAX), f64::from(f32::MAX)) as f32;
    F32::new(if f64::from(nearest) > value { nearest.next_down() } else { nearest })
}

/// Rounds a number up to a single; one beyond the largest single becomes the largest.
pub(crate) fn up(value: f64) -> F32 {
    F32::new(-down(-value).get())
}
