//! Twin of `spu/include/sphere_newton2.inc`: two steps for the root.

use spu_emulator::float::single::{fm, fma, fnms};

use super::perpendicular::meet;
use super::{HALF, Meeting, ONE, Rooted, Size, Vector, interpolated};

/// Perpendicular, and a root of all bits.
#[derive(Clone, Copy, Debug)]
pub struct Newton2;

impl Rooted for Newton2 {
    const GENERAL: &'static str = "isect_sphere_pairs_newton2_r16";
    const EYE: &'static str = "isect_pairs_newton2_r16";

    fn meet(f: Vector, d: Vector, size: Size) -> Meeting {
        meet(f, d, size, |disc| {
            let y = interpolated(disc);
            let half = fm(y, HALF);
            let step = |s| fma(fnms(s, s, disc), half, s);
            [step(step(fm(disc, y))), ONE]
        })
    }
}
