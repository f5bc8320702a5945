//! Twin of `spu/shade/refract_r16.s`: the ray that a surface lets through.

use spu_emulator::float::single::{fa, fcgt, fm, fma, fnms, fs};

use super::bounce::{Bounce, Limits, Queued, Side, sub_scaled};
use super::math::sqrt;
use super::{ONE, Single, below_zero, dot};

/// Beyond a surface, by one normal.
struct Beyond {
    /// The part of the direction along the surface: its length is the sine.
    sine: [Single; 3],
    /// The square of the cosine; below 0, all is reflected.
    squared: Single,
    cosine: Single,
}

/// The refracted ray of the hit, if there is one within the limits, and the share `mirror` with the
/// share that it reflects.
#[must_use]
pub fn refract(hit: &Bounce, limits: Limits) -> (Option<Queued>, Single) {
    let along = dot(hit.direction, hit.normal);
    let first = beyond(hit, hit.normal, along);
    let side = fnms(first.cosine, dot(hit.normal, hit.plane), dot(first.sine, hit.plane));
    let crosses = below_zero(side | first.squared);
    let normal = if crosses { hit.normal } else { hit.plane };
    let taken = beyond(hit, normal, dot(hit.direction, normal));

    let off = if fcgt(hit.ratio, ONE) != 0 { fs(ONE, taken.cosine) } else { fa(ONE, along) };
    let squared = fm(off, off);
    let fifth = fm(fm(squared, squared), off);
    let share = if below_zero(taken.squared) { ONE } else { fma(fifth, hit.grazing, hit.schlick) };
    let mirror = fma(hit.transmittance, share, hit.mirror);
    let through = fnms(hit.transmittance, share, hit.transmittance);
    let direction = sub_scaled(taken.sine, taken.cosine, normal);
    (hit.queued(through, limits, Side::Beyond, direction), mirror)
}

fn beyond(hit: &Bounce, normal: [Single; 3], along: Single) -> Beyond {
    let sine = sub_scaled(hit.direction, along, normal).map(|component| fm(component, hit.ratio));
    let squared = sine.into_iter().fold(ONE, |rest, component| fnms(component, component, rest));
    Beyond { sine, squared, cosine: sqrt(squared) }
}
