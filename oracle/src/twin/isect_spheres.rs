//! Twin of `spu/isect/isect_spheres_r16.s`: nearest entry of an eye ray into spheres.

use spu_emulator::float::single::{fcgt, fm, fma, fnms, fs};

use super::math::sqrt;
use super::{Single, ZERO, select};

/// A sphere as the eye sees it.
#[derive(Clone, Copy, Debug)]
pub struct EyeSphere {
    /// Centre less eye.
    pub centre: [Single; 3],
    /// Radius squared.
    pub radius_squared: Single,
}

/// What a ray has hit so far.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Hit {
    /// Distance.
    pub t: Single,
    /// Number of the object; 0 for none.
    pub object: u32,
}

/// The nearest of `hit` and the entries into `spheres`, whose numbers begin with `first`.
#[must_use]
pub fn isect_spheres(direction: [Single; 3], spheres: &[EyeSphere], first: u32, hit: Hit) -> Hit {
    let mut nearest = hit;
    for (object, sphere) in (first..).zip(spheres) {
        let ([dx, dy, dz], [cx, cy, cz]) = (direction, sphere.centre);
        let b = fma(cz, dz, fma(cy, dy, fm(cx, dx)));
        let (lx, ly, lz) = (fnms(b, dx, cx), fnms(b, dy, cy), fnms(b, dz, cz));
        let passes = fma(lz, lz, fma(ly, ly, fm(lx, lx)));
        let disc = fs(sphere.radius_squared, passes);
        let t = fs(b, sqrt(disc));
        let nearer = fcgt(nearest.t, t) != 0;
        let ahead = fcgt(t, ZERO) != 0;
        let past = fcgt(ZERO, disc) != 0;
        let hit = nearer && ahead && !past;
        nearest.t = select(nearest.t, t, hit);
        nearest.object = select(nearest.object, object, hit);
    }
    nearest
}
