//! Twin of `spu/isect/isect_cone_pairs_r16.s`: a ray from anywhere and an open cone or
//! cylinder that is seen from one side or both.

use spu_emulator::float::estimate::{fi, frsqest};
use spu_emulator::float::single::{fm, fma, fms, fnms, fs};

use super::math::reciprocal;
use super::pairs::{Sides, nearer};
use super::sphere_ray::Ray;
use super::{HALF, ONE, SIGN, Single, below_zero, dot};

/// The smallest single above 0.
const TINY: Single = 0x0080_0000;

/// A cone as an object of a scene.
#[derive(Clone, Copy, Debug)]
pub struct ConeObject {
    /// Centre of the base.
    pub base: [Single; 3],
    /// Unit axis.
    pub axis: [Single; 3],
    /// Radius at the base.
    pub radius: Single,
    /// Growth of the radius with the height.
    pub growth: Single,
    /// Height.
    pub height: Single,
    /// From where it is seen.
    pub sides: Sides,
}

/// The ray after its test with a cone, whose record is at `object`.
#[must_use]
pub fn isect_cone(ray: Ray, cone: &ConeObject, object: u32) -> Ray {
    let direction = ray.direction;
    let to_base = std::array::from_fn(|axis| fs(cone.base[axis], ray.origin[axis]));
    let near = dot(to_base, direction);
    let w = std::array::from_fn(|axis| fms(near, direction[axis], to_base[axis]));
    let (h, rise) = (dot(cone.axis, w), dot(cone.axis, direction));
    let across = |along: Single, vector: [Single; 3]| -> [Single; 3] {
        std::array::from_fn(|axis| fnms(along, cone.axis[axis], vector[axis]))
    };
    let (c, e) = (across(h, w), across(rise, direction));
    let (k, m) = (fma(cone.growth, h, cone.radius), fm(cone.growth, rise));
    let a = fnms(m, m, dot(e, e));
    let b = fnms(k, m, dot(c, e));
    let z = fnms(k, k, dot(c, c));
    let turn = [[1, 2], [2, 0], [0, 1]].map(|[i, j]| fms(c[i], e[j], fm(c[j], e[i])));
    let v: [Single; 3] = std::array::from_fn(|axis| fms(k, e[axis], fm(m, c[axis])));
    let most = fma(v[2], v[2], fma(v[1], v[1], fms(v[0], v[0], TINY)));
    let disc = turn.iter().fold(most, |disc, turn| fnms(*turn, *turn, disc));
    let y = fi(disc, frsqest(disc));
    let s = fm(disc, y);
    let step = fma(fnms(s, y, ONE), HALF, ONE);
    let q = fma(s & !SIGN | b & SIGN, step, b);
    let entry_is_first = !below_zero(b);
    let crossing = |back: Single, enters: bool| {
        let Sides { both, exit } = cone.sides;
        let seen = both || enters != exit;
        // As unsigned numbers: below 0 is above all.
        if fnms(back, rise, h) > cone.height {
            u32::MAX
        } else if seen {
            fs(near, back)
        } else {
            fs(near, back) | SIGN
        }
    };
    let first = crossing(fm(q, reciprocal(a)), entry_is_first);
    let second = crossing(fm(z, reciprocal(q)), !entry_is_first);
    nearer(ray, first.min(second), object, below_zero(disc))
}
