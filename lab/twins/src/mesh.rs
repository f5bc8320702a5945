//! Twin of `spu/isect/mesh_bounds_r16.s`, `mesh_farthest_r16.s`, `cull_boxes.s` and
//! `filter_boxes_r16.s`: what a packet's rays have in common, and whether one of them may meet a
//! box.

use spu_emulator::float::single::{fa, fcgt, fcmgt, fm, fma, fnms, fs};

use super::math::{recip_interpolated, recip_step, reciprocal};
use super::primary_rays::{ABSENT, Ray};
use super::{HALF, SIGN, Single, ZERO, below_zero, select};

/// 1 - 2^-21.
const BELOW_ONE: Single = 0x3f7f_fff8;
/// 1 + 2^-21.
const ABOVE_ONE: Single = 0x3f80_0004;
/// 2^-19.
pub(super) const SLACK: Single = 0x3600_0000;
/// 2^-60.
pub(super) const TINY: Single = 0x2180_0000;
/// The largest single.
const MOST: Single = 0x7fff_ffff;

/// A box: its lower corner and its upper one.
pub type Corners = [[Single; 3]; 2];

/// When the rays of a packet meet the planes of an axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Slab {
    /// Whether the upper plane is met first.
    pub down: bool,
    /// The scale for the plane that is met first.
    pub near_scale: Single,
    /// Its shift.
    pub near_shift: Single,
    /// The scale for the opposite plane.
    pub far_scale: Single,
    /// Its shift.
    pub far_shift: Single,
}

/// The bound of a packet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MeshBound {
    /// Of each axis.
    pub slabs: [Slab; 3],
    /// By how much the origins are moved apart.
    pub slack: Single,
    /// The largest distance that a ray counts to.
    pub farthest: Single,
}

pub(super) fn maximum(a: Single, b: Single) -> Single {
    select(a, b, fcgt(b, a) != 0)
}

pub(super) fn minimum(a: Single, b: Single) -> Single {
    select(a, b, fcgt(a, b) != 0)
}

/// The extreme of the sixteen rays' values: first over the rows that have a ray in a lane, then
/// over the lanes.
fn extreme(
    rays: &[Ray; 16],
    none: Single,
    value: impl Fn(&Ray) -> Single,
    extend: impl Fn(Single, Single) -> Single,
    extreme: impl Fn(Single, Single) -> Single,
) -> Single {
    let lanes: [Single; 4] = std::array::from_fn(|lane| {
        rays.iter()
            .skip(lane)
            .step_by(4)
            .filter(|ray| !below_zero(ray.t))
            .map(&value)
            .fold(none, &extend)
    });
    extreme(extreme(lanes[0], lanes[1]), extreme(lanes[2], lanes[3]))
}

fn later(a: Single, b: Single) -> Single {
    select(a, b, b as i32 > a as i32)
}

/// The largest magnitude of the corners' coordinates, as `mesh_bounds_r16` turns them in a
/// register.
fn extent(corners: &Corners) -> Single {
    let axes: [Single; 4] = std::array::from_fn(|lane| {
        let [low, high] = corners.map(|corner| corner[lane.min(2)] & !SIGN);
        maximum(low, high)
    });
    let turned = |lane: usize| maximum(axes[lane % 4], axes[(lane + 2) % 4]);
    maximum(turned(0), turned(1))
}

/// k/x, by one Newton step.
fn over(k: Single, x: Single) -> Single {
    recip_step(k, x, recip_interpolated(x))
}

pub(super) fn slab([low, high]: [Single; 2], [min, max]: [Single; 2]) -> Slab {
    let minus_tiny = TINY | SIGN;
    let down = fcgt(minus_tiny, max) != 0;
    let up = fcgt(min, TINY) != 0;
    let near = select(maximum(TINY, max), min, down);
    let far = minimum(minus_tiny, min);
    let far = select(select(far, min, up), max, down);
    let [near_scale, far_scale] = [over(BELOW_ONE, near), over(ABOVE_ONE, far)];
    let [near_from, far_from] = if down { [low, high] } else { [high, low] };
    Slab {
        down,
        near_scale,
        near_shift: fnms(near_from, near_scale, ZERO),
        far_scale,
        far_shift: fnms(far_from, far_scale, ZERO),
    }
}

/// The bound of a packet's rays, by `mesh_bounds_r16`.
#[must_use]
pub fn mesh_bound(rays: &[Ray; 16]) -> MeshBound {
    let extremes = |value: fn(&Ray, usize) -> Single| -> Corners {
        let of = |none, fold: fn(Single, Single) -> Single| {
            std::array::from_fn(|axis| extreme(rays, none, |ray| value(ray, axis), fold, fold))
        };
        [of(MOST, minimum), of(u32::MAX, maximum)]
    };
    let origins = extremes(|ray, axis| ray.origin[axis]);
    let [min, max] = extremes(|ray, axis| ray.direction[axis]);
    let slack = fm(extent(&origins), SLACK).wrapping_add(0x3_ffff) & 0xfffc_0000;
    let [low, high] = origins;
    MeshBound {
        slabs: std::array::from_fn(|axis| {
            let from = [fs(low[axis], slack), fa(high[axis], slack)];
            slab(from, [min[axis], max[axis]])
        }),
        slack,
        farthest: extreme(rays, ABSENT, |ray| ray.t, later, maximum),
    }
}

/// The farthest distance that a ray of the packet counts to, by `mesh_farthest_r16`.
#[must_use]
pub fn mesh_farthest(rays: &[Ray; 16]) -> Single {
    let farthest = rays.iter().fold(0x8000_0000, |far, ray| later(far, ray.t));
    select(farthest, ABSENT, below_zero(farthest))
}

/// When a ray of the packet may enter a box at the earliest, or `None` if none enters it before it
/// ends, by `cull_boxes`.
#[must_use]
pub fn enters(bound: &MeshBound, [lower, upper]: &Corners) -> Option<Single> {
    let mut first = [ZERO; 3];
    let mut second = [ZERO; 3];
    let mut last = [ZERO; 3];
    for (axis, slab) in bound.slabs.iter().enumerate() {
        let mut planes = [lower[axis], upper[axis]];
        if slab.down {
            planes.reverse();
        }
        first[axis] = fma(planes[0], slab.near_scale, slab.near_shift);
        let far = fma(planes[1], slab.far_scale, slab.far_shift);
        let both = slab.near_scale as i32 > slab.far_scale as i32;
        second[axis] = select(ZERO, far, both);
        last[axis] = select(far, bound.farthest, both);
    }
    let plain = maximum(maximum(first[0], first[1]), maximum(first[2], second[2]));
    let others = maximum(maximum(second[0], second[1]), ZERO);
    let enter = maximum(plain, others);
    let leave = minimum(minimum(last[0], last[1]), minimum(last[2], bound.farthest));
    (fcgt(enter, leave) == 0).then_some(enter)
}

/// Whether one of a packet's rays may enter a box before it ends, by `filter_boxes_r16`.
#[must_use]
pub fn any_enters(slack: Single, rays: &[Ray; 16], [lower, upper]: &Corners) -> bool {
    let middle: [Single; 3] = std::array::from_fn(|axis| fm(fa(lower[axis], upper[axis]), HALF));
    let half: [Single; 3] =
        std::array::from_fn(|axis| fma(fs(upper[axis], lower[axis]), HALF, slack));
    rays.iter().any(|ray| {
        let times: [[Single; 2]; 3] = std::array::from_fn(|axis| {
            let direction = ray.direction[axis];
            let direction = select(direction, TINY, fcmgt(TINY, direction) != 0);
            let inverse = reciprocal(direction);
            let shift = fnms(ray.origin[axis], inverse, ZERO);
            let at = fma(middle[axis], inverse, shift);
            let magnitude = inverse & !SIGN;
            [fnms(half[axis], magnitude, at), fma(half[axis], magnitude, at)]
        });
        let [[near_x, far_x], [near_y, far_y], [near_z, far_z]] = times;
        let enter = maximum(maximum(near_x, near_y), near_z);
        let leave = minimum(minimum(far_x, far_y), far_z);
        !below_zero(fs(leave, enter) | fs(ray.t, enter) | leave | ray.t)
    })
}
