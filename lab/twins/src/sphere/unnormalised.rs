//! Twin of `spu/include/sphere_unnormalised.inc`: directions of any length.

use spu_emulator::float::single::{fm, fms};

use super::{Meeting, Rooted, Size, Vector, across, dot, reciprocal, root_by_newton, within};

/// Perpendicular, with all lengths in the direction's.
#[derive(Clone, Copy, Debug)]
pub struct Unnormalised;

impl Rooted for Unnormalised {
    const GENERAL: &'static str = "isect_sphere_pairs_unnormalised_r16";
    const EYE: &'static str = "isect_pairs_unnormalised_r16";

    fn meet(f: Vector, d: Vector, size: Size) -> Meeting {
        let over_a = reciprocal(dot(d, d));
        let b = fm(dot(f, d), over_a);
        let disc = fm(within(size.squared(), across(f, b, d)), over_a);
        Meeting { b, disc, out: fms(b, b, disc), root: root_by_newton(disc) }
    }
}
