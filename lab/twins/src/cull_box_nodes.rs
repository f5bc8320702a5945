//! Twin of `spu/isect/cull_box_nodes.s` and `filter_box_children_r16.s`: whether a ray of a packet
//! may meet a child of a node whose volumes are boxes.

use spu_emulator::float::estimate::{fi, frsqest};
use spu_emulator::float::single::{fa, fcmgt, fm, fma, fms, fnms, fs};

use super::bound::Bound;
use super::cull_nodes::with_slack;
use super::primary_rays::Ray;
use super::{SIGN, Single, below_zero};

fn magnitudes(vector: [Single; 3]) -> [Single; 3] {
    vector.map(|component| component & !SIGN)
}

/// The sum of `half`'s products with `along`, added to `start`.
fn reach(half: [Single; 3], along: [Single; 3], start: Single) -> Single {
    let first = fma(half[0], along[0], start);
    fma(half[2], along[2], fma(half[1], along[1], first))
}

/// Whether a ray of the bound may meet the box around `centre` with these half sizes.
#[must_use]
pub fn may_meet(bound: &Bound, centre: [Single; 3], half: [Single; 3]) -> bool {
    let v: [Single; 3] = std::array::from_fn(|k| fs(centre[k], bound.apex[k]));
    let axis = bound.axis;
    let along = fma(v[2], axis[2], fma(v[1], axis[1], fm(v[0], axis[0])));
    let v: [Single; 3] = std::array::from_fn(|k| fnms(along, axis[k], v[k]));
    let square = fma(v[2], v[2], fma(v[1], v[1], fm(v[0], v[0])));
    let t = fm(fi(square, frsqest(square)), bound.cosine);
    let perp = fm(square, t);
    let side = std::array::from_fn(|k| fms(v[k], t, fm(axis[k], bound.sine)));

    let beside = reach(half, magnitudes(side), bound.radius);
    let beside = fs(fma(along, bound.sine, beside), perp);
    let reach = reach(half, magnitudes(axis), bound.radius);
    let before = fa(reach, along);
    let too_far = fs(fa(reach, bound.farthest), along);
    !below_zero(beside | before | too_far | half[0])
}

/// Whether one of a packet's rays may meet the box, by the rays themselves.
#[must_use]
pub fn any_may_meet(
    bound: &Bound,
    rays: &[Ray; 16],
    centre: [Single; 3],
    half: [Single; 3],
) -> bool {
    let half = half.map(|half| with_slack(bound, half));
    rays.iter().any(|ray| {
        let f: [Single; 3] = std::array::from_fn(|k| fs(centre[k], ray.origin[k]));
        let d = ray.direction;
        let size = magnitudes(d);
        // Along each axis' cross product with the direction.
        let beside = [[1, 2], [2, 0], [0, 1]].map(|[j, k]| {
            let cross = fms(f[j], d[k], fm(f[k], d[j]));
            fcmgt(cross, fma(half[j], size[k], fm(half[k], size[j])))
        });
        let along = fma(f[2], d[2], fma(f[1], d[1], fm(f[0], d[0])));
        let ahead = reach(half, size, along);
        !below_zero(beside[0] | beside[1] | beside[2] | ahead | ray.t)
    })
}
