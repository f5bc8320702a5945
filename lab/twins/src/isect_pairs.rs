//! Twin of the eye form of `spu/include/sphere_tmpl.inc`: nearest entry of a primary ray into
//! spheres.

use super::sphere::Eye;
use super::{Single, below_zero};
use zerocopy::FromBytes;

/// The nearest hit of a ray so far.
#[derive(Clone, Copy, Debug, PartialEq, Eq, FromBytes)]
pub struct Hit {
    /// Distance.
    pub t: Single,
    /// Address of the record of the object hit; of the background's if none.
    pub object: u32,
}

/// The nearer of `hit` and the entry of a ray that starts at 0 into a sphere, whose record is at
/// `object`, by a formulation.
#[must_use]
pub fn isect_pair<F: Eye>(
    direction: [Single; 3],
    sphere: &F::Sphere,
    object: u32,
    hit: Hit,
) -> Hit {
    let found = F::entry(direction, sphere);
    // Unsigned: a t below 0 is larger than any other.
    if found.t < hit.t && !below_zero(found.outside) { Hit { t: found.t, object } } else { hit }
}
