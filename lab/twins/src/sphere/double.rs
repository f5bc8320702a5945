//! Twin of `spu/include/sphere_double.inc`: crossings in double precision. Doubles are bit
//! patterns, as singles are.

use spu_emulator::float::double;
use spu_emulator::float::fpscr::Rounding::NearestEven;
use spu_emulator::float::single::fa;

use super::super::math::rsqrt;
use super::{
    BareSphere, Crossing, Eye, General, Ray, Single, SphereObject, Vector, leaves, reciprocal,
};

/// Perpendicular and c/q, two rays at a time.
#[derive(Clone, Copy, Debug)]
pub struct InDouble;

type Double = u64;

const SIGN: Double = 1 << 63;
/// The double 1/2.
const HALF: Double = 0x3fe0_0000_0000_0000;
/// The single 2^-120.
const TINY: Single = 0x0380_0000;
/// Added to the upper word of a double it gives half of it.
const HALVE: u32 = 0xfff0_0000;

fn fesd(x: Single) -> Double {
    double::fesd(x).0
}

fn frds(x: Double) -> Single {
    double::frds(x, NearestEven).0
}

fn dfs(a: Double, b: Double) -> Double {
    double::dfs(a, b, NearestEven).0
}

fn dfa(a: Double, b: Double) -> Double {
    double::dfa(a, b, NearestEven).0
}

fn dfm(a: Double, b: Double) -> Double {
    double::dfm(a, b, NearestEven).0
}

fn dfma(a: Double, b: Double, t: Double) -> Double {
    double::dfma(a, b, t, NearestEven).0
}

fn dfms(a: Double, b: Double, t: Double) -> Double {
    double::dfms(a, b, t, NearestEven).0
}

fn dfnms(a: Double, b: Double, t: Double) -> Double {
    double::dfnms(a, b, t, NearestEven).0
}

/// The upper word, whose sign is the double's.
fn upper(x: Double) -> u32 {
    (x >> 32) as u32
}

struct Meeting {
    b: Double,
    /// Below 0 if the ray passes the sphere by; 0 and what is less than a single is not.
    disc: Single,
    cc: Double,
    q: Double,
    /// cc/q
    other: Double,
}

fn meet(f: [Double; 3], d: Vector, radius_squared: Double) -> Meeting {
    let d = d.map(fesd);
    let b = dfma(f[2], d[2], dfma(f[1], d[1], dfm(f[0], d[0])));
    let [lx, ly, lz] = std::array::from_fn(|axis| dfnms(b, d[axis], f[axis]));
    let rest = dfma(lz, d[2], dfma(ly, d[1], dfm(lx, d[0])));
    let across = dfnms(lz, lz, dfnms(ly, ly, dfnms(lx, lx, radius_squared)));
    let disc = dfma(rest, rest, across);
    let b = dfma(rest, HALF, b);
    let near = fa(frds(disc), TINY);
    let y = fesd(rsqrt(near));
    let s = dfm(disc, y);
    let half = Double::from(upper(y).wrapping_add(HALVE)) << 32 | y & 0xffff_ffff;
    let root = dfma(dfnms(s, s, disc), half, s);
    let cc = dfms(b, b, disc);
    let q = dfa(b, root & !SIGN | b & SIGN);
    let y = fesd(reciprocal(fa(frds(q), TINY)));
    let t = dfm(cc, y);
    Meeting { b, disc: near, cc, q, other: dfma(dfnms(q, t, cc), y, t) }
}

impl General for InDouble {
    const GENERAL: &'static str = "isect_sphere_pairs_double_r16";

    fn crossing(ray: &Ray, sphere: &SphereObject) -> Crossing {
        let f = std::array::from_fn(|axis| dfs(fesd(sphere.centre[axis]), fesd(ray.origin[axis])));
        let radius = fesd(sphere.offset);
        let meeting = meet(f, ray.direction, dfm(radius, radius));
        let at_q = leaves(sphere.sides, upper(meeting.cc)) != (meeting.b & SIGN != 0);
        Crossing { t: frds(if at_q { meeting.q } else { meeting.other }), outside: meeting.disc }
    }
}

impl Eye for InDouble {
    const EYE: &'static str = "isect_pairs_double_r16";
    type Sphere = BareSphere;

    fn entry(direction: [Single; 3], sphere: &BareSphere) -> Crossing {
        let f = sphere.centre.map(fesd);
        let meeting = meet(f, direction, fesd(sphere.radius_squared));
        Crossing { t: frds(meeting.other), outside: meeting.disc | upper(meeting.b) }
    }
}
