//! Twin of `spu/shade/reflect_r16.s`: the ray that a mirror throws back.

use spu_emulator::float::single::{fa, fnms};

use super::bounce::{Bounce, Limits, Queued, Side, sub_scaled};
use super::dot;

/// The ray that the hit reflects; none if its share is not above 0 or the limits forbid it.
#[must_use]
pub fn reflect(hit: &Bounce, limits: Limits) -> Option<Queued> {
    let along = dot(hit.direction, hit.normal);
    let along_plane = dot(hit.direction, hit.plane);
    let cosine = dot(hit.normal, hit.plane);
    let off = fnms(fa(along, along), cosine, along_plane);
    let (normal, along) =
        if off as i32 > 0 { (hit.normal, along) } else { (hit.plane, along_plane) };
    let direction = sub_scaled(hit.direction, fa(along, along), normal);
    hit.queued(hit.mirror, limits, Side::Outside, direction)
}
