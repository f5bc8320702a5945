//! Twin of `spu/trace/load_rays_r16.s`: a ray of a packet, from the rays that wait.

use super::primary_rays::{ABSENT, Ray};
use super::{FARTHEST, Single, ZERO};
use zerocopy::FromBytes;

/// A ray that waits to be traced.
#[derive(Clone, Copy, Debug, FromBytes)]
pub struct Queued {
    /// Where it starts.
    pub origin: [Single; 3],
    /// Share that its colour has in its pixel's.
    pub weight: Single,
    /// Unit direction.
    pub direction: [Single; 3],
    /// Address of its pixel's sum.
    pub pixel: u32,
}

/// The ray of a lane, of what the queue's memory holds there; `dummy` is the sum that nobody
/// reads.
#[must_use]
pub fn load_ray(queued: &Queued, is_there: bool, background: u32, dummy: u32) -> Ray {
    let &Queued { origin, weight, direction, pixel } = queued;
    let (t, weight, pixel) =
        if is_there { (FARTHEST, weight, pixel) } else { (ABSENT, ZERO, dummy) };
    Ray { origin, direction, t, object: background, weight, pixel }
}
