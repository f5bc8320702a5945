//! Twin of `spu/isect/cull_faces.s`: whether a ray of a packet may meet a seen side of a
//! flat object.

use spu_emulator::float::single::{fa, fm, fma, fnms, fs};

use super::bound::Bound;
use super::{Single, ZERO, below_zero};

/// The single 4.
const FOUR: Single = 0x4080_0000;

/// The properties of a flat object that decide whether rays may meet it.
#[derive(Clone, Copy, Debug)]
pub struct Face {
    /// A point of the plane.
    pub point: [Single; 3],
    /// Its unit normal.
    pub normal: [Single; 3],
    /// The share of the object's own numbers in `leave`.
    pub leave: Single,
    /// Whether its back is visible, too.
    pub both: bool,
}

/// Whether a ray of the bound may meet the face; `along` is 1, or -1 if the rays go against the
/// bound's axis.
#[must_use]
pub fn may_meet(bound: &Bound, face: &Face, along: Single) -> bool {
    let dot_normal = |vector: [Single; 3]| {
        let [x, y, z] = std::array::from_fn(|k| fm(vector[k], face.normal[k]));
        fa(fa(x, z), fa(y, ZERO))
    };
    let g = dot_normal(bound.axis);
    let h = dot_normal(std::array::from_fn(|k| fs(bound.apex[k], face.point[k])));
    let sine = fa(ZERO, bound.sine);
    let near = fma(face.leave, FOUR, bound.radius);
    let (with, before) = (fnms(g, along, sine), fnms(h, along, near));
    let (against, beyond) = (fma(g, along, sine), fma(h, along, near));
    let within = |of_front: Single, of_both: Single| {
        below_zero(of_front) && (!face.both || below_zero(of_both))
    };
    !(within(with, before) || within(beyond, against))
}
