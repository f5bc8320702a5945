//! Sphere records: what the rays of one eye need to know of each sphere, nearest first.
//!
//! Everything is worked out in f64 relative to the eye and rounded once. Invariant: the bounds are
//! on the safe side of the SPU's arithmetic: a ray or packet for which a kernel could find an
//! entry passes the tests of the sphere, and no entry is found nearer than the record's `near`. So
//! leaving tests out changes no picture.

use std::f64::consts::PI;

use zerocopy::IntoBytes as _;
use zerocopy::big_endian::F32;

use super::policy::Skip;
use super::projection::{Projection, seen_radius};
use crate::scene;
use crate::scene::single::{LARGEST, SMALLEST, down, singles, up};
use protocol::formulation::EyeRecord;
use protocol::layout::Sphere;

/// Rounding of the SPU's tests, in parts of the distance of a sphere's centre.
///
/// A dot product of three steps truncates each by up to 2^-23 of a sum of at most twice the
/// distance, a unit direction is off by up to four units in the last place, the centre by half of
/// one: 2^-20 in all. The distances of entries are off by as much again through the square root.
const ROUNDING: f64 = 1.0 / (1 << 18) as f64;

/// The sphere records of a frame; its buffers serve for the next.
#[derive(Default)]
pub struct EyeSpheres {
    /// `near` and index in the scene of each sphere that is sent.
    order: Vec<(f64, u32)>,
    records: Vec<Sphere>,
}

impl EyeSpheres {
    /// Makes the records of what a camera can see of `spheres`, of all of them with
    /// [`Skip::Nothing`], in the form that the kernel takes.
    pub fn cull(
        &mut self,
        spheres: &[scene::Sphere],
        projection: &Projection,
        skip: Skip,
        form: EyeRecord,
    ) {
        self.order.clear();
        for (index, sphere) in (0..).zip(spheres) {
            if skip == Skip::Nothing || can_be_seen(sphere, projection) {
                self.order.push((near(sphere, projection), index));
            }
        }
        // The index makes an unstable sort, which needs no memory, a stable one.
        self.order
            .sort_unstable_by(|(a, first), (b, second)| a.total_cmp(b).then(first.cmp(second)));
        self.records.clear();
        let records = self
            .order
            .iter()
            .map(|&(_, index)| record(&spheres[index as usize], projection, form));
        self.records.extend(records);
    }

    /// The records in rising order of `near`.
    #[must_use]
    pub fn records(&self) -> &[Sphere] {
        &self.records
    }

    /// The records as they lie in memory.
    #[must_use]
    pub fn bytes(&self) -> &[u8] {
        self.records.as_bytes()
    }
}

/// Whether any ray of the picture may enter the sphere from outside.
fn can_be_seen(sphere: &scene::Sphere, projection: &Projection) -> bool {
    let distance = projection.to(sphere.centre).length();
    let around_the_eye = sphere.radius >= distance * (1.0 + ROUNDING);
    !around_the_eye && !projection.bounds(sphere.centre, sphere.radius).is_empty()
}

/// A distance that no ray enters the sphere before.
fn near(sphere: &scene::Sphere, projection: &Projection) -> f64 {
    let distance = projection.to(sphere.centre).length();
    (distance - sphere.radius - ROUNDING * (distance + sphere.radius)).max(0.0)
}

fn record(sphere: &scene::Sphere, projection: &Projection, form: EyeRecord) -> Sphere {
    let to_centre = projection.to(sphere.centre);
    let distance = to_centre.length();
    let radius = sphere.radius;
    let part = match form {
        EyeRecord::Centre => 1.0,
        // An eye in the very centre is inside, in parts of any distance.
        EyeRecord::Axis => 1.0 / distance.max(SMALLEST),
    };
    let seen = seen_radius(distance, radius);
    let rounding = ROUNDING * distance;
    let always = f64::from(-f32::MAX);
    let ray_limit = if seen < distance {
        part * (((distance - seen) * (distance + seen)).sqrt() - rounding)
    } else {
        always
    };
    let angle = libm::asin((seen / distance).min(1.0)) + projection.packet_spread();
    let packet_limit = if seen < distance && angle < PI {
        part * (distance * libm::cos(angle) - rounding)
    } else {
        always
    };
    let plane_rounding = ROUNDING + 2.0 * projection.direction_error();
    let size = (radius * part).clamp(SMALLEST, LARGEST);
    Sphere {
        centre: singles(to_centre * part),
        radius_squared: F32::new((size * size) as f32),
        near: down(near(sphere, projection)),
        ray_limit: down(ray_limit),
        packet_limit: down(packet_limit),
        reach: up(part * (radius + plane_rounding * (distance + radius))),
        colour: singles(sphere.colour),
        distance: F32::new(distance as f32),
    }
}

#[cfg(test)]
mod tests;
