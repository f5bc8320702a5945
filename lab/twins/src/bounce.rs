//! Twin of `spu/include/bounce.inc`: what rays thrown back and let through have in common.

use spu_emulator::float::estimate::frest;
use spu_emulator::float::single::{fcgt, fcmgt, fm, fma, fnms};

use super::{HALF, SIGN, Single, above_zero, dot};
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

/// How many times `leave` a ray's origin moves along it at most: 8.
const FARTHEST: Single = 0x4100_0000;
/// The same for surfaces that let light through, because a ray in a small body must not start
/// beyond the opposite wall: 2.
const FARTHEST_INSIDE: Single = 0x4000_0000;

/// On which side of a surface a ray leaves it.
#[derive(Clone, Copy, Debug)]
pub(super) enum Side {
    /// On the side of the ray that made the hit.
    Outside,
    /// On the other.
    Beyond,
}

/// How many times `leave` a ray's origin moves along it at most, at a surface of this
/// transmittance.
pub(super) fn farthest(transmittance: Single) -> Single {
    if above_zero(transmittance) { FARTHEST_INSIDE } else { FARTHEST }
}

/// How far the origin of a ray moves along the ray, and along the surface's own normal, to be
/// `leave` off the surface. `side` is the cosine between the two, `farthest` the limit of the first
/// in units of `leave`.
pub(super) fn leaving(leave: Single, side: Single, farthest: Single) -> [Single; 2] {
    let per_leave = frest(side);
    if fcmgt(per_leave, farthest) == 0 {
        return [fm(leave, per_leave), 0];
    }
    let ahead = fm(leave, farthest);
    [ahead, fnms(ahead, side, leave)]
}

impl Bounce {
    /// The ray of this share, if that is above 0 and `limits` allow it: as signed integers, singles
    /// above 0 are.
    pub(super) fn queued(
        &self,
        share: Single,
        limits: Limits,
        side: Side,
        direction: [Single; 3],
    ) -> Option<Queued> {
        let weight = fm(self.weight, share);
        let is_sent = share as i32 > 0
            && fcgt(limits.min_weight, weight) == 0
            && limits.deepest as i32 > self.pixel as i32;
        is_sent.then(|| Queued {
            origin: self.origin(side, direction),
            weight,
            direction: unit(direction),
            pixel: self.pixel.wrapping_add(CHAIN_STEP),
        })
    }

    /// Where a ray starts that leaves in this direction on this side.
    fn origin(&self, side: Side, direction: [Single; 3]) -> [Single; 3] {
        let cosine = dot(direction, self.plane);
        let (farthest, step): (_, fn(Single, Single, Single) -> Single) = match side {
            Side::Outside => (farthest(self.transmittance), fma),
            Side::Beyond => (FARTHEST_INSIDE | SIGN, fnms),
        };
        let [ahead, rest] = leaving(self.leave, cosine, farthest);
        std::array::from_fn(|axis| {
            step(rest, self.plane[axis], step(ahead, direction[axis], self.point[axis]))
        })
    }
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
