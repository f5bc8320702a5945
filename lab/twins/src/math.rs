//! Twin of `spu/include/math.inc`, of `spu/include/reciprocal.inc` and of the kernels in
//! `spu/math/`: reciprocals, square roots and their reciprocals, from the bare estimate to
//! two Newton steps.

use spu_emulator::float::estimate::{fi, frest, frsqest};
use spu_emulator::float::single::{fm, fma, fnms};

use super::{HALF, ONE, Single};

/// 1/x: the bare estimate, its step read as the fraction's last digits.
#[must_use]
pub fn recip_estimate(x: Single) -> Single {
    frest(x)
}

/// 1/x: estimate, interpolation.
#[must_use]
pub fn recip_interpolated(x: Single) -> Single {
    fi(x, frest(x))
}

/// k/x by one Newton step from `y`, for a k of 1 or a few ulps beside it.
pub(super) fn recip_step(k: Single, x: Single, y: Single) -> Single {
    fma(fnms(x, y, k), y, y)
}

/// 1/x: estimate, interpolation, one Newton step.
#[must_use]
pub fn reciprocal(x: Single) -> Single {
    recip_step(ONE, x, recip_interpolated(x))
}

/// 1/x: estimate, interpolation, two Newton steps.
#[must_use]
pub fn recip_newton2(x: Single) -> Single {
    recip_step(ONE, x, reciprocal(x))
}

/// Reciprocal of the square root: the bare estimate.
#[must_use]
pub fn rsqrt_estimate(x: Single) -> Single {
    frsqest(x)
}

/// Reciprocal of the square root: estimate, interpolation.
#[must_use]
pub fn rsqrt_interpolated(x: Single) -> Single {
    fi(x, frsqest(x))
}

/// Reciprocal of the square root by one Newton step from `y`.
fn rsqrt_step(x: Single, y: Single) -> Single {
    let e = fnms(fm(x, y), y, ONE);
    fma(e, fm(y, HALF), y)
}

/// Reciprocal of the square root: estimate, interpolation, one Newton step.
#[must_use]
pub fn rsqrt(x: Single) -> Single {
    rsqrt_step(x, rsqrt_interpolated(x))
}

/// Reciprocal of the square root: estimate, interpolation, two Newton steps.
#[must_use]
pub fn rsqrt_newton2(x: Single) -> Single {
    rsqrt_step(x, rsqrt(x))
}

/// Square root: `x` times the bare estimate.
#[must_use]
pub fn sqrt_estimate(x: Single) -> Single {
    fm(x, rsqrt_estimate(x))
}

/// Square root: `x` times the interpolated estimate.
#[must_use]
pub fn sqrt_interpolated(x: Single) -> Single {
    fm(x, rsqrt_interpolated(x))
}

/// Square root by one Newton step from `s`; `y` is near its reciprocal.
fn sqrt_step(x: Single, s: Single, y: Single) -> Single {
    fma(fnms(s, s, x), fm(y, HALF), s)
}

/// Square root: estimate, interpolation, one Newton step; 0 for 0.
#[must_use]
pub fn sqrt(x: Single) -> Single {
    let y = rsqrt_interpolated(x);
    sqrt_step(x, fm(x, y), y)
}

/// Square root: estimate, interpolation, two Newton steps; 0 for 0.
#[must_use]
pub fn sqrt_newton2(x: Single) -> Single {
    sqrt_step(x, sqrt(x), rsqrt_interpolated(x))
}
