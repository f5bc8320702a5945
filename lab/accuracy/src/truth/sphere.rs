//! Exact intersection of rays with spheres.

use std::cmp::Ordering;

use spu_emulator::float::single::to_f64;
use twins::Single;

use super::bounded::Bounded;
use super::exact::Exact;
use super::space::{Vector, cross, dot, sub};
use super::{DOUBT, Line, spacing};

/// A sphere as exact numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere {
    centre: Vector,
    radius_squared: f64,
}

/// The points where a ray's line enters and leaves a sphere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossing {
    /// Distance of the entry.
    pub entry: f64,
    /// Distance of the exit, not below that of the entry.
    pub exit: f64,
    /// Outward unit normal at the entry.
    pub entry_normal: Vector,
    /// Outward unit normal at the exit.
    pub exit_normal: Vector,
}

/// How a ray's line passes a sphere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Passing {
    /// How far outside the edge it passes, relative to the radius: (l^2 - r^2) / 2 r^2 for a line
    /// at distance l from the centre, which is about (l - r) / r near the edge. Below 0 for a hit.
    /// NaN if the direction is 0 or the radius is 0.
    pub beyond: f64,
    /// The entry and the exit, if the line hits. A line that touches the sphere hits, and a sphere
    /// of radius 0 is never hit.
    pub crossing: Option<Crossing>,
}

impl Passing {
    /// Made from the two ends, each a distance and an outward normal, or from a miss.
    fn new(beyond: f64, ends: Option<[(f64, Vector); 2]>) -> Self {
        let crossing = ends.map(|[(entry, entry_normal), (exit, exit_normal)]| Crossing {
            entry,
            exit,
            entry_normal,
            exit_normal,
        });
        Self { beyond, crossing }
    }
}

impl Crossing {
    /// The first distance that is above 0, and the outward normal there.
    pub fn first(&self) -> Option<(f64, Vector)> {
        let ends = [(self.entry, self.entry_normal), (self.exit, self.exit_normal)];
        ends.into_iter().find(|(distance, _)| *distance > 0.0)
    }
}

impl Sphere {
    /// A sphere that a kernel receives with its signed radius.
    pub fn of_radius(centre: [Single; 3], radius: Single) -> Self {
        let radius = to_f64(radius);
        Self {
            centre: centre.map(to_f64),
            // The product of two numbers with 24 digits is exact.
            radius_squared: radius * radius,
        }
    }

    /// A sphere that a kernel receives with the square of its radius.
    pub fn of_radius_squared(centre: [Single; 3], radius_squared: Single) -> Self {
        Self { centre: centre.map(to_f64), radius_squared: to_f64(radius_squared) }
    }

    /// A sphere that a kernel receives as its direction and distance from 0 and the square of
    /// radius over distance. Its own numbers are rounded to doubles.
    pub fn of_axis(axis: [Single; 3], k: Single, distance: Single) -> Self {
        let (axis, distance) = (axis.map(to_f64), to_f64(distance));
        let length = dot(&axis, &axis).sqrt();
        Self {
            centre: axis.map(|component| component / length * distance),
            radius_squared: to_f64(k) * distance * distance,
        }
    }

    /// The centre.
    pub fn centre(&self) -> Vector {
        self.centre
    }

    /// The radius, in double precision.
    pub fn radius(&self) -> f64 {
        self.radius_squared.sqrt()
    }

    /// How a ray passes it.
    pub fn passing(&self, line: &Line) -> Passing {
        self.in_double(line).unwrap_or_else(|| self.in_exact(line))
    }

    /// The result in double precision, unless its error is too large.
    ///
    /// The distance from the line is computed by a vector product, which keeps its precision far
    /// away.
    fn in_double(&self, line: &Line) -> Option<Passing> {
        let to = sub(&self.centre.map(Bounded::from), &line.origin.map(Bounded::from));
        let d = line.direction.map(Bounded::from);
        let square = Bounded::from(self.radius_squared);
        let dd = dot(&d, &d);
        let across = cross(&to, &d);
        let disc = square * dd - dot(&across, &across);
        if dd.sign()? == Ordering::Equal || self.radius_squared == 0.0 {
            return None;
        }
        let beyond = -disc.value / (2.0 * dd.value * self.radius_squared);
        if disc.sign()? == Ordering::Less {
            return Some(Passing::new(beyond, None));
        }
        let (along, root, length) = (dot(&to, &d), disc.sqrt(), dd.sqrt());
        let (near, far) = ((along - root) / length, (along + root) / length);
        // One of the two roots cancels. It is therefore computed as their product divided by the
        // other.
        let product = dot(&to, &to) - square;
        let (near, far) = (near.better(product / far), far.better(product / near));
        let sure = |t: Bounded| t.error <= DOUBT * spacing(t.value);
        if !(sure(near) && sure(far)) {
            return None;
        }
        let (half, shift) = (root.value / dd.value, along.value / dd.value);
        let radius = self.radius();
        let normal = |side: f64| {
            std::array::from_fn(|axis| {
                let d = line.direction[axis];
                (shift * d - to[axis].value + side * half * d) / radius
            })
        };
        let ends = [(near.value, normal(-1.0)), (far.value, normal(1.0))];
        Some(Passing::new(beyond, Some(ends)))
    }

    /// The result with exact numbers, computed by other steps than the one in double precision.
    fn in_exact(&self, line: &Line) -> Passing {
        let from = sub(&line.origin.map(Exact::from), &self.centre.map(Exact::from));
        let d = line.direction.map(Exact::from);
        let square = Exact::from(self.radius_squared);
        let dd = dot(&d, &d);
        let b = -dot(&from, &d);
        let c = dot(&from, &from) - square.clone();
        let disc = b.clone() * b.clone() - dd.clone() * c;
        let beyond = -disc.to_f64() / (2.0 * dd.to_f64() * self.radius_squared);
        let nowhere = dd.sign() == Ordering::Equal || square.sign() == Ordering::Equal;
        if nowhere || disc.sign() == Ordering::Less {
            return Passing::new(beyond, None);
        }
        let (root, length, radius) = (disc.sqrt(), dd.sqrt(), square.sqrt());
        let end = |root: Exact| {
            let parameter = (b.clone() + root) / dd.clone();
            let normal = std::array::from_fn(|axis| {
                let out = from[axis].clone() + parameter.clone() * d[axis].clone();
                (out / radius.clone()).to_f64()
            });
            ((parameter * length.clone()).to_f64(), normal)
        };
        Passing::new(beyond, Some([end(-root.clone()), end(root)]))
    }
}

#[cfg(test)]
mod tests {
    use crate::generator::Generator;
    use rand::{Rng as _, SeedableRng as _};
    use spu_emulator::float::single::from_f64;

    use super::*;

    fn sphere(centre: Vector, radius: f64) -> Sphere {
        Sphere::of_radius(centre.map(from_f64), from_f64(radius))
    }

    fn line(origin: Vector, direction: Vector) -> Line {
        Line::new(origin.map(from_f64), direction.map(from_f64))
    }

    impl Sphere {
        fn crossing(&self, line: &Line) -> Option<Crossing> {
            self.passing(line).crossing
        }
    }

    /// The results of both ways.
    fn both(sphere: &Sphere, line: &Line) -> [Passing; 2] {
        let double = sphere.in_double(line).expect("no doubt");
        [double, sphere.in_exact(line)]
    }

    #[test]
    fn whole_numbers_give_exact_results() {
        // 3, 4, 5: at height 3 the chord of the sphere is 8 long. The direction's length does not
        // matter.
        for direction in [[0.0, 0.0, -1.0], [0.0, 0.0, -16.0]] {
            let line = line([1.0, 5.0, 20.0], direction);
            for passing in both(&sphere([1.0, 2.0, 3.0], 5.0), &line) {
                let crossing = passing.crossing.unwrap();
                assert_eq!((crossing.entry, crossing.exit), (13.0, 21.0));
                assert_eq!(crossing.entry_normal, [0.0, 0.6, 0.8]);
                assert_eq!(crossing.exit_normal, [0.0, 0.6, -0.8]);
                assert_eq!(passing.beyond, -16.0 / 50.0);
            }
        }
    }

    #[test]
    fn ray_from_inside_first_hits_exit() {
        let inside = sphere([0.0; 3], 2.0);
        let crossing = inside.crossing(&line([0.5, 0.0, 0.0], [1.0, 0.0, 0.0]));
        assert_eq!(crossing.unwrap().first(), Some((1.5, [1.0, 0.0, 0.0])));
        let beyond = inside.crossing(&line([3.0, 0.0, 0.0], [1.0, 0.0, 0.0]));
        assert_eq!(beyond.unwrap().first(), None);
    }

    #[test]
    fn tangent_line_hits_and_next_single_misses() {
        let sphere = sphere([0.0; 3], 1.0);
        let at = |height| line([height, 0.0, 8.0], [0.0, 0.0, -1.0]);
        let touches = sphere.passing(&at(1.0));
        let crossing = touches.crossing.unwrap();
        assert_eq!((crossing.entry, crossing.exit), (8.0, 8.0));
        assert_eq!(touches.beyond, 0.0);
        let ulp = 2_f64.powi(-23);
        assert!(sphere.crossing(&at(1.0 + ulp)).is_none());
        assert!(sphere.crossing(&at(1.0 - ulp / 2.0)).is_some());
    }

    #[test]
    fn verdict_is_exact_beyond_double_precision() {
        // The edge of a sphere, a single ulp of 2^24 away: its square needs 50 digits more than a
        // double has.
        let far = 2_f64.powi(60);
        let sphere = sphere([0.0, 0.0, far], 1.0);
        let through = |slope: f64| line([0.0; 3], [slope, 0.0, 1.0]);
        let edge = 2_f64.powi(-60);
        let inside = sphere.passing(&through(edge));
        assert!(inside.crossing.is_some() && inside.beyond < 0.0);
        let outside = sphere.passing(&through(edge * (1.0 + 2_f64.powi(-23))));
        assert!(outside.crossing.is_none() && outside.beyond > 0.0);
    }

    #[test]
    fn sphere_at_ends_of_single_range_is_computed() {
        let (large, small) = (2_f64.powi(128), 2_f64.powi(-126));
        let huge = sphere([0.0; 3], large);
        let crossing = huge.crossing(&line([small; 3], [small, 0.0, 0.0])).unwrap();
        assert_eq!(crossing.exit, large);
        let tiny = sphere([small, 0.0, 0.0], small);
        let crossing = tiny.crossing(&line([-large, 0.0, 0.0], [large, 0.0, 0.0]));
        assert_eq!(crossing.unwrap().entry, large);
    }

    #[test]
    fn zero_direction_or_zero_radius_misses() {
        let ahead = line([0.0, 0.0, 4.0], [0.0, 0.0, -1.0]);
        assert_eq!(sphere([0.0; 3], 0.0).crossing(&ahead), None);
        assert_eq!(sphere([0.0; 3], 1.0).crossing(&line([0.0; 3], [0.0; 3])), None);
    }

    #[test]
    fn double_precision_keeps_its_bound() {
        let mut random = Generator::seed_from_u64(7);
        let mut sure = 0;
        for _ in 0..4000 {
            let radius = 10_f64.powi(random.random_range(-3..7));
            let distance = radius * 10_f64.powi(random.random_range(-2..6));
            let origin = [0; 3].map(|_| random.random_range(-distance..distance));
            let sphere = sphere([0.0; 3], radius);
            let direction =
                std::array::from_fn(|axis| radius * random.random_range(-1.0..1.0) - origin[axis]);
            let line = line(origin, direction);
            let Some(double) = sphere.in_double(&line) else {
                continue;
            };
            let exact = sphere.in_exact(&line);
            assert_eq!(double.crossing.is_some(), exact.crossing.is_some());
            let (Some(double), Some(exact)) = (double.crossing, exact.crossing) else {
                continue;
            };
            sure += 1;
            for (double, exact) in [(double.entry, exact.entry), (double.exit, exact.exit)] {
                assert!((double - exact).abs() <= 1.01 * DOUBT * spacing(exact));
            }
            for axis in 0..3 {
                let off = double.entry_normal[axis] - exact.entry_normal[axis];
                assert!(off.abs() < 1e-9 * (1.0 + distance / radius), "{off}");
            }
        }
        assert!(sure > 2000, "{sure} sure");
    }
}
