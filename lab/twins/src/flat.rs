//! Twin of `spu/include/flat.inc`: what the kernels of triangles and rectangles share.

use super::math::{recip_interpolated, recip_step};
use super::{SIGN, Single};
use zerocopy::{FromBytes, Immutable, IntoBytes};

/// The nearest hit of a ray so far, and where on the object it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, FromBytes, IntoBytes, Immutable)]
#[repr(C)]
pub struct FlatHit {
    /// Distance.
    pub t: Single,
    /// Number of the object; 0 for none.
    pub object: u32,
    /// First coordinate on the object.
    pub u: Single,
    /// Second coordinate on the object.
    pub v: Single,
}

/// A point where a ray meets the plane of an object.
#[derive(Clone, Copy, Debug)]
pub(super) struct Meeting {
    /// Less the distance.
    pub n: Single,
    /// Coordinates on the object.
    pub u: Single,
    pub v: Single,
    /// The sign is set if the point is not on the object.
    pub outside: u32,
}

impl Meeting {
    /// On the object, with 0 < t < `farthest`: compared as signed integers.
    pub fn hits(&self, farthest: Single) -> bool {
        (farthest ^ SIGN) as i32 > self.n as i32 && self.outside & SIGN == 0
    }

    /// The nearer of `hit` and this.
    pub fn nearer(&self, hit: FlatHit, object: u32) -> FlatHit {
        if self.hits(hit.t) {
            FlatHit { t: self.n ^ SIGN, object, u: self.u, v: self.v }
        } else {
            hit
        }
    }
}

/// k/x for a k of 1 or a few ulps beside it.
pub(super) fn over(k: Single, x: Single) -> Single {
    recip_step(k, x, recip_interpolated(x))
}
