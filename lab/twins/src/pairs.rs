//! Twin of `spu/include/pairs.inc`: what the intersectors of candidates share.

use super::Single;
use super::sphere_ray::Ray;

/// From where a surface is seen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sides {
    /// From both sides; else only from the front.
    pub both: bool,
    /// Of a sphere or cone, and without `both`: only where a ray leaves it.
    pub exit: bool,
}

/// The ray with a hit at `t`, unless `misses` or what it has hit is as near. A ray that is not
/// there has a `t` below 0.
pub(super) fn nearer(ray: Ray, t: Single, object: u32, misses: bool) -> Ray {
    let ahead = t as i32 > 0;
    if ahead && (t as i32) < ray.t as i32 && !misses { Ray { t, object, ..ray } } else { ray }
}
