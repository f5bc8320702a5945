//! Twin of `spu/isect/cull_nodes.s`: whether a ray of a packet may meet a child of a node.

use spu_emulator::float::estimate::{fi, frsqest};
use spu_emulator::float::single::{fa, fm, fma, fnms, fs};

use super::bound::Bound;
use super::{Single, below_zero};

/// Whether a ray of the bound may meet the sphere around `centre`.
#[must_use]
pub fn may_meet(bound: &Bound, centre: [Single; 3], radius: Single) -> bool {
    let v: [Single; 3] = std::array::from_fn(|k| fs(centre[k], bound.apex[k]));
    let [axis_x, axis_y, axis_z] = bound.axis;
    let along = fma(v[2], axis_z, fma(v[1], axis_y, fm(v[0], axis_x)));
    let [x, y, z] = std::array::from_fn(|k| fnms(along, bound.axis[k], v[k]));
    let square = fma(z, z, fma(y, y, fm(x, x)));
    let beside = fm(square, fi(square, frsqest(square)));

    let reach = fa(radius, bound.radius);
    let outside = fnms(beside, bound.cosine, fma(along, bound.sine, reach));
    let behind = fa(reach, along);
    let too_far = fs(fa(reach, bound.farthest), along);
    !below_zero(outside | behind | too_far)
}
