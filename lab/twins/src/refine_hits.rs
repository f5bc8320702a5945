//! Twin of `spu/shade/refine_hits_r16.s`: hits on round objects, moved along their rays.

use spu_emulator::float::single::{fcmgt, fm, fma, fms, fs};

use super::bounce::sub_scaled;
use super::math::{recip_interpolated, rsqrt};
use super::surfaces::{Object, Ray};
use super::{SIGN, Single, dot};

/// The cosine to the normal below which a ray grazes: 1/64.
const GRAZING: Single = 0x3c80_0000;
/// The point of a hit and the unit normal there, on the ray's side. `None` if the object is flat or
/// the ray grazes it.
#[must_use]
pub fn refine(ray: &Ray, object: &Object) -> Option<[[Single; 3]; 2]> {
    // The vector across the axis, gain over its length, and the height above the surface.
    let place = |from: [Single; 3]| {
        let along = dot(from, object.axis);
        let off = sub_scaled(from, along, object.axis);
        let squared = dot(off, off);
        let scale = fm(rsqrt(squared), object.gain);
        (off, scale, fma(object.slope, along, fms(squared, scale, object.offset)))
    };
    let from_centre = |point: [Single; 3]| std::array::from_fn(|k| fs(point[k], object.centre[k]));
    let ahead =
        |start: [Single; 3]| std::array::from_fn(|k| fma(ray.t, ray.direction[k], start[k]));
    let (off, scale, height) = place(ahead(from_centre(ray.origin)));
    let rise = dot(ray.direction, object.axis);
    let across = sub_scaled(ray.direction, rise, object.axis);
    let against = fma(scale, dot(off, across), fm(object.slope, rise));
    if object.gain == 0 || fcmgt(against, GRAZING) == 0 {
        return None;
    }
    let step = fm(height, recip_interpolated(against));
    let off = sub_scaled(off, step, across);
    let scale = fm(rsqrt(dot(off, off)), object.gain);
    let normal: [Single; 3] =
        std::array::from_fn(|k| fma(scale, off[k], fm(object.slope, object.axis[k])));
    let point = sub_scaled(ahead(ray.origin), step, ray.direction);
    let (_, _, height) = place(from_centre(point));
    Some([sub_scaled(point, height, normal), normal.map(|x| x ^ (SIGN & !against))])
}
