//! Twin of `spu/plain/isect/isect_ball_pairs_r16.s`: a ray from anywhere and a sphere that is seen from
//! one side or both.

use spu_emulator::float::estimate::{fi, frsqest};
use spu_emulator::float::single::{fm, fma, fnms};

use super::ball::{self, Meeting, Ray, SIGN};
use super::pairs::{Sides, nearer};
use super::{HALF, ONE, Single, below_zero};

/// A sphere as an object of a scene.
#[derive(Clone, Copy, Debug)]
pub struct SphereObject {
    /// Centre.
    pub centre: [Single; 3],
    /// Radius, of either sign.
    pub offset: Single,
    /// From where it is seen.
    pub sides: Sides,
}

/// The ray after its test with a sphere, whose record is at `object`.
#[must_use]
pub fn isect_ball(ray: Ray, sphere: &SphereObject, object: u32) -> Ray {
    let ball = ball::Ball {
        centre: sphere.centre,
        radius_squared: fm(sphere.offset, sphere.offset),
    };
    let Meeting { b, disc, out } = ball::meet(&ray, &ball);
    let Sides { both, exit } = sphere.sides;
    let sign = if exit && !both { SIGN } else { 0 };
    let y = fi(disc, frsqest(disc));
    let s = fm(disc, y);
    let e = fma(fnms(s, y, ONE), HALF | sign, ONE | sign);
    let s = if both { s & !SIGN | out & SIGN } else { s };
    nearer(ray, fnms(s, e, b), object, below_zero(disc))
}
