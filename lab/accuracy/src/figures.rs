//! Compares the results of a kernel with exact results over many rays, for any kind of object.

use serde::{Deserialize, Serialize};

use crate::metrics::Summary;
use crate::space::{add_scaled, dot, largest, length, sub};
use crate::truth::{Line, Vector, spacing};

/// A family is well-conditioned if half an ulp in the inputs moves the distance by at most this
/// many ulps in the mean.
pub const WELL_CONDITIONED: f64 = 1.5;

/// The figures of a kernel on a family. Verdicts are about all rays. Errors are about the rays
/// that hit both in the kernel and in exact arithmetic, and that count.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Figures {
    /// By how many ulps half an ulp in each input moves the distance, for the rays that count.
    pub condition: Option<Summary>,
    /// Whether the mean of these is small.
    pub well_conditioned: bool,
    /// The number of rays.
    pub rays: usize,
    /// The number of rays that hit in exact arithmetic.
    pub hits: usize,
    /// The number of rays that hit in the kernel but not in exact arithmetic.
    pub wrong_hits: usize,
    /// The number of rays that hit in exact arithmetic but not in the kernel. Where two triangles
    /// share an edge, these are rays that neither triangle stops: leaks.
    pub wrong_misses: usize,
    /// Error of the distance in ulps.
    pub distance_ulps: Option<Summary>,
    /// The same error relative to the scene's size, which is the distance of its farthest point.
    pub distance_relative: Option<Summary>,
    /// The largest error of a coordinate of the hit's point, in ulps of the largest component of
    /// the vector from the ray's origin to it.
    pub point_ulps: Option<Summary>,
    /// The same error relative to the scene's size.
    pub point_relative: Option<Summary>,
}

/// The exact result for a ray.
pub struct Truth {
    /// The ray.
    pub line: Line,
    /// The ray's first hit.
    pub hit: Option<Hit>,
    /// The distance of the scene's farthest point.
    pub scene: f64,
}

pub struct Hit {
    /// The hit's distance.
    pub distance: f64,
    /// The hit's position.
    pub point: Vector,
    /// By how many ulps half an ulp in the inputs moves the distance, if errors count.
    pub condition: Option<f64>,
    /// The normal at the hit, for objects whose normal is checked.
    pub normal: Option<Normal>,
}

/// A sphere's normal at a hit, and the values that a kernel computes it from.
pub struct Normal {
    /// The exact normal.
    pub exact: Vector,
    /// The sphere's centre.
    pub centre: Vector,
    /// The sphere's radius.
    pub radius: f64,
}

impl Figures {
    /// Returns one of the figures if the family's errors are due to the formulation.
    pub fn sound<T>(&self, figure: impl Fn(&Self) -> T) -> Option<T> {
        self.well_conditioned.then(|| figure(self))
    }

    /// The share of the rays for which the kernel's verdict is wrong, in per cent.
    pub fn wrong(&self) -> f64 {
        100.0 * (self.wrong_hits + self.wrong_misses) as f64 / self.rays as f64
    }
}

/// Errors. Each list has one for every ray that counts.
#[derive(Default)]
struct Errors {
    distance_ulps: Vec<f64>,
    distance_relative: Vec<f64>,
    point_ulps: Vec<f64>,
    point_relative: Vec<f64>,
    normal_ulps: Vec<f64>,
}

impl Errors {
    /// Adds the errors of a hit that a kernel found at `t`. `t` is a distance unless directions
    /// may have any length.
    fn add(&mut self, any_length: bool, t: f64, truth: &Truth, hit: &Hit) {
        let Truth { line, scene, .. } = truth;
        // If directions have length 1 except for rounding, the kernel's result is a distance.
        let unit = if any_length { length(line.direction) } else { 1.0 };
        let off = (t * unit - hit.distance).abs();
        self.distance_ulps.push(off / spacing(hit.distance));
        self.distance_relative.push(off / scene);

        let point = add_scaled(line.origin, t, line.direction);
        let off = largest(sub(point, hit.point));
        let reach = largest(sub(hit.point, line.origin));
        self.point_ulps.push(off / spacing(reach));
        self.point_relative.push(off / scene);

        if let Some(normal) = &hit.normal {
            let outward = sub(point, normal.centre).map(|component| component / normal.radius);
            let off = largest(sub(outward, normal.exact));
            self.normal_ulps.push(off / spacing(1.0));
        }
    }
}

/// Computes the figures from a kernel's results for each ray, and the largest error of a normal's
/// coordinate, in ulps of 1.
pub fn compare<'a>(
    any_length: bool,
    found: impl Iterator<Item = Option<f64>>,
    truths: impl Iterator<Item = &'a Truth> + Clone,
) -> (Figures, Option<Summary>) {
    let conditions = truths.clone().filter_map(|truth| truth.hit.as_ref()?.condition);
    let condition = Summary::of(conditions.collect());
    let mut errors = Errors::default();
    let (mut rays, mut hits, mut wrong_hits, mut wrong_misses) = (0, 0, 0, 0);
    for (found, truth) in found.zip(truths) {
        rays += 1;
        hits += usize::from(truth.hit.is_some());
        match (found, &truth.hit) {
            (Some(t), Some(hit)) if hit.condition.is_some() => {
                errors.add(any_length, t, truth, hit);
            }
            (Some(_), None) => wrong_hits += 1,
            (None, Some(_)) => wrong_misses += 1,
            _ => {}
        }
    }
    let figures = Figures {
        condition,
        well_conditioned: condition.is_some_and(|condition| condition.mean <= WELL_CONDITIONED),
        rays,
        hits,
        wrong_hits,
        wrong_misses,
        distance_ulps: Summary::of(errors.distance_ulps),
        distance_relative: Summary::of(errors.distance_relative),
        point_ulps: Summary::of(errors.point_ulps),
        point_relative: Summary::of(errors.point_relative),
    };
    (figures, Summary::of(errors.normal_ulps))
}

/// By how many ulps half an ulp in each input moves a hit's distance, in the worst case.
///
/// A surface with normal n satisfies n.(do + t dd + d dt - dp) = ds. `places` is twice the amount
/// by which a coordinate of the ray's origin and of the surface may move. `surface` is the same
/// for the surface along its normal. `unit` is the length to which the direction's numbers are
/// relative.
pub fn sensitivity(
    line: &Line,
    unit: f64,
    (distance, normal): (f64, Vector),
    places: impl Fn(usize) -> f64,
    surface: f64,
) -> f64 {
    let ahead = crate::space::unit(line.direction);
    let slant = dot(normal, ahead);
    // A direction's length does not matter. Only its change across the direction moves the hit.
    let turned = add_scaled(normal, -slant, ahead);
    let moved: f64 = (0..3)
        .map(|axis| {
            let turn = spacing(line.direction[axis]) / unit;
            normal[axis].abs() * places(axis) + distance * turned[axis].abs() * turn
        })
        .sum();
    (moved + surface) / 2.0 / slant.abs() / spacing(distance)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn errors_are_measured_on_found_hit() {
        // From 0 along x to the sphere around 8 with radius 2: the hit is at 6, and the kernel
        // finds it an ulp too far.
        let hit = Hit {
            distance: 6.0,
            point: [6.0, 0.0, 0.0],
            condition: Some(1.0),
            normal: Some(Normal { exact: [-1.0, 0.0, 0.0], centre: [8.0, 0.0, 0.0], radius: 2.0 }),
        };
        let truth = Truth {
            line: Line { origin: [0.0; 3], direction: [1.0, 0.0, 0.0] },
            hit: None,
            scene: 10.0,
        };
        let ulp = spacing(6.0);
        let mut errors = Errors::default();
        errors.add(false, 6.0 + ulp, &truth, &hit);
        assert_eq!(errors.distance_ulps, [1.0]);
        assert_eq!(errors.distance_relative, [ulp / 10.0]);
        assert_eq!(errors.point_ulps, [1.0]);
        assert_eq!(errors.normal_ulps, [2.0]);
    }
}
