//! Packets of rays that occur in tracing, and packets that never would.

use twins::primary_rays::{ABSENT, Ray};

use super::bounds::Point;
use crate::prelude::*;

/// How the rays of a packet are related.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fan {
    /// All through the eye and almost parallel.
    Eye,
    /// From points of a small surface and almost parallel: reflected or refracted.
    Coherent,
    /// From points of a surface to one light, and no farther.
    Shadow,
    /// From about one place in any direction.
    Incoherent,
    /// From anywhere in any direction.
    Any,
    /// Coherent except for one ray of sixteen.
    One,
    /// Coherent, but only in about half of the lanes.
    Half,
    /// Coherent, and about as wide as a cone may be.
    Wide,
}

/// All relations.
pub const FANS: [Fan; 8] = [
    Fan::Eye,
    Fan::Coherent,
    Fan::Shadow,
    Fan::Incoherent,
    Fan::Any,
    Fan::One,
    Fan::Half,
    Fan::Wide,
];

/// Scales of scenes.
pub const SCALES: std::ops::Range<f64> = 1e-4..1e6;

fn moved(from: Vector, direction: Vector, distance: f64) -> Vector {
    std::array::from_fn(|axis| from[axis] + direction[axis] * distance)
}

/// A packet of a scene of this scale. Lanes without a ray contain junk.
pub fn packet(fan: Fan, scale: f64, random: &mut ChaCha8Rng) -> [Ray; 16] {
    let far = if random.random() { 1.0 } else { 100.0 };
    let place = in_cube(far * scale, random);
    let place = if fan == Fan::Eye { [0.0; 3] } else { place };
    let along = any_direction(random);
    let light = moved(place, along, scale * magnitude(0.1..100.0, random));
    let size = scale * magnitude(1e-5..1.0, random);
    let width = match fan {
        Fan::Wide => random.random_range(0.3..3.0),
        _ => magnitude(1e-5..0.3, random),
    };
    let reach = scale * magnitude(0.1..100.0, random);
    let only = random.random_range(0..16);
    std::array::from_fn(|lane| {
        let is_there = match fan {
            Fan::One => lane == only,
            Fan::Half => random.random(),
            _ => true,
        };
        if !is_there {
            let t = if random.random() { ABSENT } else { 0x8000_0000 };
            return Ray { t, ..any_bits(random) };
        }
        let origin = match fan {
            Fan::Eye => place,
            Fan::Any => in_cube(far * scale, random),
            _ => moved(place, in_cube(1.0, random), size),
        };
        let (direction, t) = match fan {
            Fan::Shadow => {
                let to_light = sub(light, origin);
                (to_light, from_f64(dot(to_light, to_light).sqrt()))
            }
            Fan::Incoherent | Fan::Any => (any_direction(random), FARTHEST),
            _ => (moved(along, in_cube(1.0, random), width), FARTHEST),
        };
        let t = if random.random_range(0..4) == 0 && t == FARTHEST { from_f64(reach) } else { t };
        ray(origin, direction, t)
    })
}

/// A packet of shadow rays to a light, and the light. The rays start at the largest allowed
/// distance from surfaces, and some are absent.
pub fn to_light(scale: f64, random: &mut ChaCha8Rng) -> ([Ray; 16], Point) {
    let far = if random.random() { 1.0 } else { 100.0 };
    let place = in_cube(far * scale, random);
    let along = any_direction(random);
    let light = moved(place, along, scale * magnitude(0.1..100.0, random));
    let light = light.map(|component| to_f64(from_f64(component)));
    let size = scale * magnitude(1e-5..1.0, random);
    let taxicab = |vector: Vector| vector.iter().map(|component| component.abs()).sum::<f64>();
    // The value that an object with this reach around the place would have.
    let leave = (taxicab(place) + 3.0 * size) / f64::from(1 << 22);
    let rays = std::array::from_fn(|_| {
        let point = moved(place, in_cube(1.0, random), size);
        let origin = moved(point, any_direction(random), 2.7 * leave);
        let to_light = sub(light, point);
        let t = from_f64(dot(to_light, to_light).sqrt());
        let is_there = random.random_range(0..8) > 0;
        Ray { t: if is_there { t } else { ABSENT }, ..ray(origin, to_light, t) }
    });
    let near = 2.0 * taxicab(light) / f64::from(1 << 18) + 32.0 * leave;
    let point = Point { place: light.map(from_f64), near: from_f64(near), along: from_f64(-1.0) };
    (rays, point)
}

/// A ray in singles.
#[must_use]
pub fn ray(origin: Vector, direction: Vector, t: Single) -> Ray {
    Ray {
        origin: origin.map(from_f64),
        direction: unit(direction).map(from_f64),
        t,
        object: ZERO,
        weight: ONE,
        pixel: 0,
    }
}
