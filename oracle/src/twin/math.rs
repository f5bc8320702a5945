//! Twin of `spu/include/math.inc`: square roots.

use spu_emulator::float::estimate::{fi, frsqest};
use spu_emulator::float::single::{fm, fma, fnms};

use super::{HALF, ONE, Single};

/// Reciprocal of the square root: estimate, interpolation, one Newton step.
#[must_use]
pub fn rsqrt(x: Single) -> Single {
    let y = fi(x, frsqest(x));
    let e = fnms(fm(x, y), y, ONE);
    fma(e, fm(y, HALF), y)
}

/// Square root; 0 for 0.
#[must_use]
pub fn sqrt(x: Single) -> Single {
    let y = fi(x, frsqest(x));
    let s = fm(x, y);
    let r = fnms(s, s, x);
    fma(r, fm(y, HALF), s)
}
