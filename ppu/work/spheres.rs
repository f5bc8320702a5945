//! Sphere records of depth shading: the data of each sphere for the rays of one eye, nearest
//! first.
//!
//! All numbers are computed in f64 relative to the eye, and rounded once. Invariant: the bounds
//! allow for the rounding of the SPU's arithmetic. If a kernel could find an entry of a ray or
//! packet into a sphere, the ray or packet passes the sphere's tests, and the entry is not nearer
//! than the record's `near`. So skipping tests changes no picture.

use std::f64::consts::PI;

use zerocopy::IntoBytes as _;
use zerocopy::big_endian::F32;

use super::policy::Skip;
use super::projection::{Projection, seen_radius};
use crate::scene;
use crate::scene::eye_side::EyeSide;
use crate::scene::single::{LARGEST, SMALLEST, down, singles, up};
use protocol::formulation::EyeRecord;
use protocol::layout::Sphere;

/// A bound of the rounding error in the SPU's tests, relative to the distance of a sphere's
/// centre.
///
/// Each of a dot product's three steps is truncated by up to 2^-23 of a sum of at most twice the
/// distance. A unit direction is off by up to four units in the last place, and the centre by half
/// of one. Together that is 2^-20. The square root adds as much again to the distances of entries.
const ROUNDING: f64 = 1.0 / (1 << 18) as f64;

/// The sphere records of a frame. Its buffers are reused for the next.
#[derive(Default)]
pub struct EyeSpheres {
    /// For each sphere that is sent, `near` and its index in the scene.
    order: Vec<(f64, u32)>,
    records: Vec<Sphere>,
}

impl EyeSpheres {
    /// Makes the records of the spheres that a camera can see, or of all spheres with
    /// [`Skip::Nothing`], in the form that the kernel expects.
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
        // Comparing the indices too makes the unstable sort, which allocates no memory, stable.
        self.order
            .sort_unstable_by(|(a, first), (b, second)| a.total_cmp(b).then(first.cmp(second)));
        self.records.clear();
        let records =
            self.order.iter().map(|&(_, index)| record(&spheres[index as usize], projection, form));
        self.records.extend(records);
    }

    /// The records, in ascending order of `near`.
    #[must_use]
    pub fn records(&self) -> &[Sphere] {
        &self.records
    }

    /// The records' bytes.
    #[must_use]
    pub fn bytes(&self) -> &[u8] {
        self.records.as_bytes()
    }
}

/// Whether any primary ray may enter the sphere from outside.
fn can_be_seen(sphere: &scene::Sphere, projection: &Projection) -> bool {
    let distance = projection.to(sphere.centre).length();
    let around_the_eye = sphere.radius >= distance * (1.0 + ROUNDING);
    let is_seen = !around_the_eye && eye_side(sphere, projection) == EyeSide::Outside;
    is_seen && !projection.bounds(sphere.centre, sphere.radius).is_empty()
}

/// The eye's side of a sphere. To an eye on its surface, a sphere is as invisible as from inside.
fn eye_side(sphere: &scene::Sphere, projection: &Projection) -> EyeSide {
    match EyeSide::of(projection.eye(), sphere.centre, sphere.radius) {
        EyeSide::On => EyeSide::Inside,
        side => side,
    }
}

/// A lower bound of the distance at which a ray enters the sphere.
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
        // An eye exactly at the centre is inside the sphere, whatever distance is used here.
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
    let clear = eye_side(sphere, projection).clear_radius(distance, radius);
    let size = (clear * part).clamp(SMALLEST, LARGEST);
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
