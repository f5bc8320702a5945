//! Numbers in the SPU's single format: which ones it takes, and how they are rounded to it.

use glam::DVec3;
use zerocopy::big_endian::F32;

/// Largest magnitude of a coordinate or a radius: its square is still a single.
pub(crate) const LARGEST: f64 = (1_u64 << 62) as f64;
/// Smallest size, such as a radius: its square is still a single and not 0.
pub(crate) const SMALLEST: f64 = 1.0 / LARGEST;

/// A number, rounded to the nearest single.
pub(crate) fn single(value: f64) -> F32 {
    F32::new(value as f32)
}

/// Three coordinates or channels, each rounded so.
pub(crate) fn singles(vector: DVec3) -> [F32; 3] {
    vector.to_array().map(single)
}

/// The largest single that is no larger.
pub(crate) fn down(value: f64) -> F32 {
    let nearest = value.clamp(f64::from(-f32::MAX), f64::from(f32::MAX)) as f32;
    F32::new(if f64::from(nearest) > value {
        nearest.next_down()
    } else {
        nearest
    })
}

/// The smallest single that is no smaller; the largest there is for what is beyond it.
pub(crate) fn up(value: f64) -> F32 {
    F32::new(-down(-value).get())
}
