//! Errors of the kernels that intersect candidates, against f64.

use super::call;
use super::shape::Shape;
use super::triangle::TriangleObject;
use crate::cases::flat::error::error_of_shear;
use crate::flat_records;
use crate::prelude::*;

/// The number of packets of each size over which an error is measured.
const PACKETS: u32 = 600;

/// The sizes of scenes.
pub const SCALES: [f64; 4] = [1e-4, 1.0, 1e3, 1e6];

/// The largest error of t, in the header's unit. Infinite for a missed or a false hit.
pub fn nearest<S: Shape>(bench: &mut Bench, random: &mut ChaCha8Rng) -> f64 {
    let mut worst = 0.0_f64;
    for _ in 0..PACKETS {
        for scale in SCALES {
            let (object, rays) = S::around(random, scale);
            let packet = call::packet(&rays, random.random());
            let list = [[0, 0]];
            let (after, objects) = call::pairs(bench, &[packet], &[object], &list, random.random());
            for (ray, after) in rays.iter().zip(call::rays(&after[0])) {
                let truth = object.truth(ray);
                let found = (after.object == objects[0]).then(|| to_f64(after.t));
                match (found, truth.t) {
                    (Some(found), Some(t)) if truth.counts => {
                        worst = worst.max((found - t).abs() / truth.unit);
                    }
                    (None, Some(_)) | (Some(_), None) if truth.sure => worst = f64::INFINITY,
                    _ => {}
                }
            }
        }
    }
    worst
}

/// The largest error of a slope in ulps of 1, or of 1 / direction z in its own ulps.
pub fn shear_packets(bench: &mut Bench, random: &mut ChaCha8Rng) -> f64 {
    let mut worst = 0.0_f64;
    for _ in 0..PACKETS {
        let (_, rays) = TriangleObject::around(random, 1.0);
        let packets = vec![rays; 2];
        for shears in (call::Sheared { packets, anything: random.random() }).call(bench) {
            for (ray, shear) in rays.iter().zip(shears) {
                let ray = flat_records::Ray::new(ray.origin, ray.direction);
                worst = worst.max(error_of_shear(&ray, &shear));
            }
        }
    }
    worst
}
