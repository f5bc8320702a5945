//! Twin of `spu/plain/isect/isect_pairs_r16.s`: nearest entry of an eye ray into spheres.

use spu_emulator::float::estimate::{fi, frsqest};
use spu_emulator::float::single::{fm, fma, fnms};

use super::ball::Ball;
use super::{HALF, ONE, Single, below_zero};

/// What a ray has hit so far.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Hit {
    /// Distance.
    pub t: Single,
    /// Address of the record of the object hit; of the background's if none.
    pub object: u32,
}

/// The nearer of `hit` and the entry of a ray that starts at 0 into a sphere, whose record is at
/// `object`.
#[must_use]
pub fn isect_pair(direction: [Single; 3], sphere: &Ball, object: u32, hit: Hit) -> Hit {
    let ([dx, dy, dz], [cx, cy, cz]) = (direction, sphere.centre);
    let b = fma(cz, dz, fma(cy, dy, fm(cx, dx)));
    let (lx, ly, lz) = (fnms(b, dx, cx), fnms(b, dy, cy), fnms(b, dz, cz));
    let disc = fnms(lz, lz, fnms(ly, ly, fnms(lx, lx, sphere.radius_squared)));
    let y = fi(disc, frsqest(disc));
    let s = fm(disc, y);
    let e = fma(fnms(s, y, ONE), HALF, ONE);
    let t = fnms(s, e, b);
    // Unsigned: a t below 0 is larger than any other.
    if t < hit.t && !below_zero(disc) {
        Hit { t, object }
    } else {
        hit
    }
}
