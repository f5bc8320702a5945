//! Twin of `spu/shade/encode_srgb.s` and `spu/shade/roll_off.s`: light as displays expect it.

use spu_emulator::float::estimate::{fi, frest};
use spu_emulator::float::single::{fcgt, fm, fma, fnms, fs};

use super::math::rsqrt_interpolated;
use super::{HALF, ONE, Single, select};

/// The single 0.0031308, where sRGB's straight part ends.
const EDGE: Single = 0x3b4d_2e1c;
/// The single 12.92, its slope.
const SLOPE: Single = 0x414e_b852;
/// The polynomial's coefficients, of the highest power first.
const POWERS: [Single; 5] = [0x3d9c_a819, 0xbea5_98d6, 0x3f8e_58f4, 0x3e4c_c0a4, 0xbd85_4959];
/// The single 3/4, where the roll-off begins.
const KNEE: Single = 0x3f40_0000;
/// The single 1/16.
const SHARE: Single = 0x3d80_0000;

/// Linear light to sRGB's value.
#[must_use]
pub fn encode_srgb(x: Single) -> Single {
    let root = fm(x, rsqrt_interpolated(x));
    let fourth = fm(root, rsqrt_interpolated(root));
    let [first, rest @ ..] = POWERS;
    let power = rest.into_iter().fold(first, |power, next| fma(power, fourth, next));
    select(fm(x, SLOPE), power, fcgt(x, EDGE) != 0)
}

/// Light that is limited to less than 1 without a step.
#[must_use]
pub fn roll_off(x: Single) -> Single {
    let beyond = fs(x, HALF);
    let inverse = fi(beyond, frest(beyond));
    let bent = fnms(inverse, SHARE, ONE);
    select(x, bent, fcgt(x, KNEE) != 0)
}
