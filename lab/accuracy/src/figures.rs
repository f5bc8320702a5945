//! How far what a kernel finds is from what is so, over many rays, whatever the object is.

use serde::{Deserialize, Serialize};

use crate::metrics::Summary;
use crate::space::{along, dot, largest, length, less};
use crate::truth::{Line, Vector, spacing};

/// Ulps of a distance that half an ulp in what is given may move in the mean, for a family to be
/// well-conditioned.
pub const WELL_CONDITIONED: f64 = 1.5;

/// What is said of a kernel on a family. Verdicts are of all rays; errors are of the rays that the
/// kernel and exact arithmetic both let hit, as far as they count.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Figures {
    /// Ulps of the distance that half an ulp in each of the numbers given moves, of what counts.
    pub condition: Option<Summary>,
    /// Whether that is little in the mean.
    pub well_conditioned: bool,
    /// Rays.
    pub rays: usize,
    /// Of these, those that hit by exact arithmetic.
    pub hits: usize,
    /// Rays that the kernel lets hit, and exact arithmetic does not.
    pub wrong_hits: usize,
    /// Rays that exact arithmetic lets hit, and the kernel does not: where two triangles share an
    /// edge, that neither stops, which is a leak.
    pub wrong_misses: usize,
    /// Error of the distance in ulps.
    pub distance_ulps: Option<Summary>,
    /// The same in parts of the scene: of its farthest point's distance.
    pub distance_relative: Option<Summary>,
    /// Error of the hit's point, at its worst coordinate, in ulps of the largest from the origin.
    pub point_ulps: Option<Summary>,
    /// The same in parts of the scene.
    pub point_relative: Option<Summary>,
}

/// What is so of a ray.
pub struct Truth {
    /// The ray.
    pub line: Line,
    /// What it hits first.
    pub hit: Option<Hit>,
    /// How far the scene's farthest point is.
    pub scene: f64,
}

/// A hit.
pub struct Hit {
    /// How far it is.
    pub distance: f64,
    /// Where it is.
    pub point: Vector,
    /// Ulps that half an ulp in what is given moves, if errors count.
    pub condition: Option<f64>,
    /// The normal there, of an object that is asked for it.
    pub normal: Option<Normal>,
}

/// A sphere's normal at a hit, and what a kernel's is computed of.
pub struct Normal {
    /// The normal.
    pub exact: Vector,
    /// The sphere's centre.
    pub centre: Vector,
    /// The sphere's radius.
    pub radius: f64,
}

impl Figures {
    /// Whether they are of a family whose errors are the formulation's own; then, one of them.
    pub fn sound<T>(&self, figure: impl Fn(&Self) -> T) -> Option<T> {
        self.well_conditioned.then(|| figure(self))
    }

    /// The part of the rays of which the kernel says the wrong thing, in per cent.
    pub fn wrong(&self) -> f64 {
        100.0 * (self.wrong_hits + self.wrong_misses) as f64 / self.rays as f64
    }
}

/// Errors, each list of all rays that count.
#[derive(Default)]
struct Errors {
    distance_ulps: Vec<f64>,
    distance_relative: Vec<f64>,
    point_ulps: Vec<f64>,
    point_relative: Vec<f64>,
    normal_ulps: Vec<f64>,
}

impl Errors {
    /// Adds those of a hit that a kernel found at `t`, which is a distance unless directions have
    /// any length.
    fn add(&mut self, any_length: bool, t: f64, truth: &Truth, hit: &Hit) {
        let Truth { line, scene, .. } = truth;
        // Where directions have length 1 but for their rounding, what a kernel finds is a
        // distance.
        let unit = if any_length {
            length(line.direction)
        } else {
            1.0
        };
        let off = (t * unit - hit.distance).abs();
        self.distance_ulps.push(off / spacing(hit.distance));
        self.distance_relative.push(off / scene);

        let point = along(line.origin, t, line.direction);
        let off = largest(less(point, hit.point));
        let reach = largest(less(hit.point, line.origin));
        self.point_ulps.push(off / spacing(reach));
        self.point_relative.push(off / scene);

        if let Some(normal) = &hit.normal {
            let outward = less(point, normal.centre).map(|component| component / normal.radius);
            let off = largest(less(outward, normal.exact));
            self.normal_ulps.push(off / spacing(1.0));
        }
    }
}

/// The figures of what a kernel found of each ray, and the error of the normal, at its worst
/// coordinate, in ulps of 1.
pub fn compare<'a>(
    any_length: bool,
    found: impl Iterator<Item = Option<f64>>,
    truths: impl Iterator<Item = &'a Truth> + Clone,
) -> (Figures, Option<Summary>) {
    let conditions = truths
        .clone()
        .filter_map(|truth| truth.hit.as_ref()?.condition);
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

/// Ulps of a hit's distance that half an ulp in each of the numbers given moves, all at their
/// worst.
///
/// A surface of normal n has n.(do + t dd + d dt - dp) = ds: `places` is how far a coordinate of
/// the ray's origin and of the surface may move, twice over, `surface` the same of the surface
/// along its normal, and `unit` the length that the direction's numbers are parts of.
pub fn sensitivity(
    line: &Line,
    unit: f64,
    (distance, normal): (f64, Vector),
    places: impl Fn(usize) -> f64,
    surface: f64,
) -> f64 {
    let ahead = crate::space::unit(line.direction);
    let slant = dot(normal, ahead);
    // A direction's length is of no account: what moves the hit is what is across.
    let turned = along(normal, -slant, ahead);
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
    fn errors_are_those_of_what_was_found() {
        // From 0 along x to the sphere around 8 with radius 2: at 6, found an ulp too far.
        let hit = Hit {
            distance: 6.0,
            point: [6.0, 0.0, 0.0],
            condition: Some(1.0),
            normal: Some(Normal {
                exact: [-1.0, 0.0, 0.0],
                centre: [8.0, 0.0, 0.0],
                radius: 2.0,
            }),
        };
        let truth = Truth {
            line: Line {
                origin: [0.0; 3],
                direction: [1.0, 0.0, 0.0],
            },
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
