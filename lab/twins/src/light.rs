//! Twin of `spu/shade/light_r16.s`, `lambert_r16.s`, `ambient_r16.s` and `fog_r16.s`: what lights
//! add to a surface, and what fog leaves of it.

use spu_emulator::float::convert::{cfltu, csflt};
use spu_emulator::float::single::{fm, fma, fnms, fs};

use super::math::reciprocal;
use super::shadow_rays::Place;
use super::surfaces::{Ray, Surface};
use super::{ONE, Single, dot, select};

/// A single's fraction.
const FRACTION: u32 = 0x007f_ffff;
const FRACTION_BITS: u32 = 23;
/// The single sqrt(2).
const ROOT2: Single = 0x3fb5_04f3;
/// From here on 2^-n is 0: 126 with 23 bits after the point.
const NONE: u32 = 126 << FRACTION_BITS;
/// log2(1 + u) / (2 u), from u^4 on.
const LOG: [Single; 5] = [0x3e02_6ed6, 0xbe48_230e, 0x3e78_7a18, 0xbeb8_764a, 0x3f38_a8a2];
/// 2^(1 - g), from g^3 on.
const EXP: [Single; 4] = [0xbd1f_cb52, 0x3eb1_b807, 0xbfa2_5452, 0x3ffa_e237];

fn polynomial(coefficients: &[Single], x: Single) -> Single {
    let further = coefficients[1..].iter();
    further.fold(coefficients[0], |sum, coefficient| fma(x, sum, *coefficient))
}

/// -log2(x) / 2.
fn minus_half_log2(x: Single) -> Single {
    let power = ROOT2.wrapping_sub(x) & !FRACTION;
    let mantissa = power.wrapping_add(x);
    let u = fs(mantissa, ONE);
    fnms(u, polynomial(&LOG, u), csflt(power, FRACTION_BITS as i32 + 1))
}

/// 2^-n, by n in fixed point.
fn exp2_of_minus(n: u32) -> Single {
    let fraction = ONE & !FRACTION | n & FRACTION;
    let result = polynomial(&EXP, fraction).wrapping_sub(n & !FRACTION);
    select(0, result, n < NONE)
}

/// (N.H)^exponent for H of any length, and N.H not below 0.
#[must_use]
pub fn highlight(
    normal: [Single; 3],
    direction: [Single; 3],
    to_light: [Single; 3],
    exponent: Single,
) -> Single {
    let half = std::array::from_fn(|k| fs(to_light[k], direction[k]));
    let cosine = dot(normal, half);
    let quotient = fm(fm(cosine, cosine), reciprocal(dot(half, half)));
    let n = fm(minus_half_log2(quotient), exponent);
    exp2_of_minus(cfltu(n, FRACTION_BITS as i32))
}

/// The light that a surface of this normal sends back from a light of this brightness, to which a
/// shadow ray goes; `blocked` if it does not reach it. `direction` is of the ray that sees the
/// surface; without it there is no highlight.
#[must_use]
pub fn light(
    surface: &Surface,
    normal: [Single; 3],
    direction: Option<[Single; 3]>,
    (shadow, blocked): (&Ray, bool),
    source: &Place,
    brightness: [Single; 3],
) -> [Single; 3] {
    let reaches = |value| select(value, 0, blocked);
    let fade = source.fade(fm(shadow.t, shadow.t));
    let fade = fm(fade, fade);
    let lambert = fm(surface.diffuse, dot(normal, shadow.direction));
    let diffuse = reaches(fm(lambert, fade));
    let shine = direction.map(|direction| {
        let power = highlight(normal, direction, shadow.direction, surface.exponent);
        reaches(fm(fm(surface.highlight, power), fade))
    });
    std::array::from_fn(|k| {
        let colour = match shine {
            Some(shine) => fma(surface.colour[k], diffuse, shine),
            None => fm(surface.colour[k], diffuse),
        };
        fma(brightness[k], colour, surface.lit[k])
    })
}

/// The ambient light that a surface sends back.
#[must_use]
pub fn ambient(surface: &Surface, brightness: [Single; 3]) -> [Single; 3] {
    std::array::from_fn(|k| {
        let colour = fm(surface.colour[k], surface.diffuse);
        fma(brightness[k], colour, surface.lit[k])
    })
}

/// The share of a surface's light that passes fog of this thickness on the way of a ray, whose
/// length is `t`, and the light with the fog's.
#[must_use]
pub fn fog(t: Single, lit: [Single; 3], fog: [Single; 4]) -> (Single, [Single; 3]) {
    let [thickness, colour @ ..] = fog;
    let share = exp2_of_minus(cfltu(fm(t, thickness), FRACTION_BITS as i32));
    let through = |k: usize| fma(fs(lit[k], colour[k]), share, colour[k]);
    (share, std::array::from_fn(through))
}
