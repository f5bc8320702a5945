//! Twin of `spu/isect/cull_nodes.s` and `filter_children_r16.s`: whether a ray of a packet may meet
//! a child of a node.

use spu_emulator::float::estimate::{fi, frsqest};
use spu_emulator::float::single::{fa, fm, fma, fnms, fs};

use super::bound::Bound;
use super::primary_rays::Ray;
use super::{SIGN, Single, below_zero};

/// 2^-18.
const SLACK: Single = 0x3680_0000;

/// Whether a ray of the bound may meet the sphere around `centre`.
#[must_use]
pub fn may_meet(bound: &Bound, centre: [Single; 3], radius: Single) -> bool {
    let v: [Single; 3] = std::array::from_fn(|k| fs(centre[k], bound.apex[k]));
    let [axis_x, axis_y, axis_z] = bound.axis;
    let along = fma(v[2], axis_z, fma(v[1], axis_y, fm(v[0], axis_x)));
    let square = across(bound, centre);
    let beside = fm(square, fi(square, frsqest(square)));

    let reach = fa(radius, bound.radius);
    let outside = fnms(beside, bound.cosine, fma(along, bound.sine, reach));
    let before = fa(reach, along);
    let too_far = fs(fa(reach, bound.farthest), along);
    !below_zero(outside | before | too_far)
}

/// The square of a point's distance from the axis of a bound.
pub(super) fn across(bound: &Bound, point: [Single; 3]) -> Single {
    let v: [Single; 3] = std::array::from_fn(|k| fs(point[k], bound.apex[k]));
    let [axis_x, axis_y, axis_z] = bound.axis;
    let along = fma(v[2], axis_z, fma(v[1], axis_y, fm(v[0], axis_x)));
    let [x, y, z] = std::array::from_fn(|k| fnms(along, bound.axis[k], v[k]));
    fma(z, z, fma(y, y, fm(x, x)))
}

/// A volume's size, larger by the slack for the rays' origins.
pub(super) fn with_slack(bound: &Bound, size: Single) -> Single {
    let [x, y, z] = bound.apex.map(|component| component & !SIGN);
    let extent = fa(fa(x, z), fa(y, bound.radius & !SIGN));
    fma(extent, SLACK, size)
}

/// Whether one of a packet's rays may meet the sphere around `centre`, by the rays themselves.
#[must_use]
pub fn any_may_meet(bound: &Bound, rays: &[Ray; 16], centre: [Single; 3], radius: Single) -> bool {
    let reach = with_slack(bound, radius);
    let squared = fm(reach, reach);
    rays.iter().any(|ray| {
        let f: [Single; 3] = std::array::from_fn(|k| fs(centre[k], ray.origin[k]));
        let d = ray.direction;
        let along = fma(f[2], d[2], fma(f[1], d[1], fm(f[0], d[0])));
        let [x, y, z] = std::array::from_fn(|k| fnms(along, d[k], f[k]));
        let inside = fnms(z, z, fnms(y, y, fnms(x, x, squared)));
        let ahead = fa(along, reach);
        !below_zero(inside | ahead | ray.t)
    })
}
