//! Twins of `spu/include/sphere_perpendicular.inc`, `sphere_estimate.inc` and
//! `sphere_interpolated.inc`: the discriminant by the perpendicular, and roots with the precision
//! of the estimate or the interpolated estimate.

use spu_emulator::float::estimate::frsqest;
use spu_emulator::float::single::fms;

use super::{
    Meeting, Rooted, Single, Size, Vector, across, dot, interpolated, root_by_newton, within,
};

/// One Newton step for the root.
#[derive(Clone, Copy, Debug)]
pub struct Perpendicular;

/// The root by the bare estimate.
#[derive(Clone, Copy, Debug)]
pub struct Estimate;

/// The root by estimate and `fi`.
#[derive(Clone, Copy, Debug)]
pub struct Interpolated;

/// A meeting by the perpendicular, with this root.
pub(super) fn meet(
    f: Vector,
    d: Vector,
    size: Size,
    root: impl Fn(Single) -> [Single; 2],
) -> Meeting {
    let b = dot(f, d);
    let disc = within(size.squared(), across(f, b, d));
    Meeting { b, disc, out: fms(b, b, disc), root: root(disc) }
}

impl Rooted for Perpendicular {
    const GENERAL: &'static str = "isect_sphere_pairs_r16";
    const EYE: &'static str = "isect_pairs_r16";

    fn meet(f: Vector, d: Vector, size: Size) -> Meeting {
        meet(f, d, size, root_by_newton)
    }
}

impl Rooted for Estimate {
    const GENERAL: &'static str = "isect_sphere_pairs_estimate_r16";
    const EYE: &'static str = "isect_pairs_estimate_r16";

    fn meet(f: Vector, d: Vector, size: Size) -> Meeting {
        meet(f, d, size, |disc| [disc, frsqest(disc)])
    }
}

impl Rooted for Interpolated {
    const GENERAL: &'static str = "isect_sphere_pairs_interpolated_r16";
    const EYE: &'static str = "isect_pairs_interpolated_r16";

    fn meet(f: Vector, d: Vector, size: Size) -> Meeting {
        meet(f, d, size, |disc| [disc, interpolated(disc)])
    }
}
