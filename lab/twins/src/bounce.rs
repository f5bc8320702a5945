//! Twin of `spu/include/bounce.inc`: what rays thrown back and let through have in common.

use spu_emulator::float::single::{fcgt, fm, fma, fnms};

use super::{HALF, Single};
use zerocopy::FromBytes;

/// The single 3/2.
const THREE_HALVES: Single = 0x3fc0_0000;

/// A hit, and the ray that made it.
#[derive(Clone, Copy, Debug, FromBytes)]
pub struct Bounce {
    /// Unit direction of the ray.
    pub direction: [Single; 3],
    /// Its share in its pixel's colour.
    pub weight: Single,
    /// Its pixel, and `CHAIN_STEP` for each ray that came before it in its chain.
    pub pixel: u32,
    /// Point on the surface.
    pub point: [Single; 3],
    /// Unit normal that shades, on the ray's side.
    pub normal: [Single; 3],
    /// Unit normal of the surface itself, on the ray's side.
    pub plane: [Single; 3],
    /// How far off the surface a ray has to start.
    pub leave: Single,
    /// Share that is reflected.
    pub mirror: Single,
    /// Share that is let through.
    pub transmittance: Single,
    /// Index of refraction on the ray's side over that beyond.
    pub ratio: Single,
    /// Schlick's F0.
    pub schlick: Single,
    /// 1 - F0, or 0.
    pub grazing: Single,
}

/// The number that each ray adds to the `pixel` of those that it sends on.
pub const CHAIN_STEP: u32 = 0x0100_0000;

/// The limits that end chains of rays.
#[derive(Clone, Copy, Debug)]
pub struct Limits {
    /// The minimum weight of a ray that is sent on.
    pub min_weight: Single,
    /// `CHAIN_STEP` times the rays that may come before the last of a chain.
    pub deepest: u32,
}

impl Limits {
    /// Every ray is sent on.
    pub const NONE: Self = Self { min_weight: 0, deepest: i32::MAX as u32 };
}

/// A ray that waits to be traced.
#[derive(Clone, Copy, Debug, PartialEq, Eq, FromBytes)]
pub struct Queued {
    /// Where it begins.
    pub origin: [Single; 3],
    /// Its share in its pixel's colour.
    pub weight: Single,
    /// Unit direction.
    pub direction: [Single; 3],
    /// As of the hit, with one more ray before it.
    pub pixel: u32,
}

impl Bounce {
    /// The ray of this share, if that is above 0 and `limits` allow it: as signed integers, singles
    /// above 0 are.
    pub(super) fn queued(
        &self,
        share: Single,
        limits: Limits,
        origin: [Single; 3],
        direction: [Single; 3],
    ) -> Option<Queued> {
        let weight = fm(self.weight, share);
        let is_sent = share as i32 > 0
            && fcgt(limits.min_weight, weight) == 0
            && limits.deepest as i32 > self.pixel as i32;
        is_sent.then(|| Queued {
            origin,
            weight,
            direction: unit(direction),
            pixel: self.pixel.wrapping_add(CHAIN_STEP),
        })
    }
}

pub(super) fn dot(a: [Single; 3], b: [Single; 3]) -> Single {
    fma(a[2], b[2], fma(a[1], b[1], fm(a[0], b[0])))
}

/// c - k a.
pub(super) fn sub_scaled(c: [Single; 3], k: Single, a: [Single; 3]) -> [Single; 3] {
    std::array::from_fn(|axis| fnms(k, a[axis], c[axis]))
}

/// A vector of about length 1 at length 1: one Newton step.
fn unit(vector: [Single; 3]) -> [Single; 3] {
    let factor = fnms(dot(vector, vector), HALF, THREE_HALVES);
    vector.map(|component| fm(component, factor))
}
