//! Bounding spheres.
//!
//! Invariant: the spheres that [`enclose`] and [`enclose_quickly`] return contain all spheres that
//! they were given, in spite of `f64`'s rounding.

use glam::DVec3;

use super::bounds::Bounds;

/// Number of steps towards the farthest sphere. A test checks that the radius is at most 2 % above
/// the smallest possible one.
const STEPS: u32 = 100;

/// Around so few spheres the smallest one is looked for among those through two or three of them.
const FEW: usize = 4;

/// By how much a radius is rounded up, relative to the centre's coordinates and the radius.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

/// A sphere, or a point if the radius is 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct BoundingSphere {
    pub centre: DVec3,
    pub radius: f64,
}

impl BoundingSphere {
    pub fn point(centre: DVec3) -> Self {
        Self { centre, radius: 0.0 }
    }

    /// The radius of the smallest sphere around this one and another, except for rounding.
    fn radius_with(&self, other: &Self) -> f64 {
        let both = 0.5 * (self.centre.distance(other.centre) + self.radius + other.radius);
        both.max(self.radius).max(other.radius)
    }

    /// The smallest sphere around this one and another.
    pub fn with(&self, other: &Self) -> Self {
        let way = other.centre - self.centre;
        let distance = way.length();
        let (larger, smaller) = match self.radius < other.radius {
            true => (other, self),
            false => (self, other),
        };
        if distance + smaller.radius <= larger.radius {
            return larger.rounded();
        }
        let radius = 0.5 * (distance + self.radius + other.radius);
        let centre = self.centre + way * ((radius - self.radius) / distance);
        Self { centre, radius }.rounded()
    }

    /// A sphere that is larger by the rounding of the operations that made it.
    pub fn rounded(self) -> Self {
        let rounding = ROUNDING * (self.centre.abs().max_element() + self.radius);
        Self { radius: self.radius + rounding, ..self }
    }

    /// The largest distance of its points from `from`.
    fn farthest(&self, from: DVec3) -> f64 {
        from.distance(self.centre) + self.radius
    }
}

/// Up to four spheres that stand for a primitive; see
/// [`Primitive::hull`](super::primitive::Primitive::hull).
#[derive(Clone, Copy, Debug)]
pub(crate) struct Hull {
    spheres: [BoundingSphere; 4],
    count: usize,
    bounds: Bounds,
}

impl Hull {
    pub fn of<const COUNT: usize>(found: [BoundingSphere; COUNT]) -> Self {
        let mut spheres = [BoundingSphere::point(DVec3::ZERO); 4];
        spheres[..COUNT].copy_from_slice(&found);
        let bounds = found.iter().map(Bounds::of_sphere);
        Self { spheres, count: COUNT, bounds: bounds.fold(Bounds::NOTHING, Bounds::with) }
    }

    /// The same hull of a primitive that is known to be within these bounds.
    pub fn within(self, bounds: Bounds) -> Self {
        Self { bounds, ..self }
    }

    /// A box around the primitive.
    pub fn bounds(&self) -> Bounds {
        self.bounds
    }

    pub fn spheres(&self) -> &[BoundingSphere] {
        &self.spheres[..self.count]
    }
}

/// A nearly smallest sphere around all of `spheres`; `None` if there are none. Around a triangle
/// or a parallelogram it is the smallest one.
///
/// Otherwise uses the algorithm of Bădoiu and Clarkson: from the middle of the bounding box, steps
/// of decreasing length towards the farthest point. The best centre on the way is used.
pub(super) fn enclose(spheres: &[BoundingSphere]) -> Option<BoundingSphere> {
    let (&first, others) = spheres.split_first()?;
    if spheres.len() <= FEW {
        let widest = around_widest_pair(spheres)?;
        if spheres.iter().all(|it| it.farthest(widest.centre) <= widest.radius) {
            return Some(widest);
        }
        if let Some(circumscribed) = circumscribed(spheres) {
            return Some(circumscribed);
        }
    }
    let low = |sphere: &BoundingSphere| sphere.centre - sphere.radius;
    let high = |sphere: &BoundingSphere| sphere.centre + sphere.radius;
    let low = others.iter().map(low).fold(low(&first), DVec3::min);
    let high = others.iter().map(high).fold(high(&first), DVec3::max);
    let mut centre = low.midpoint(high);
    let mut best = (f64::INFINITY, centre);
    for step in 1..=STEPS {
        let start = (first.farthest(centre), &first);
        let (radius, sphere) = others.iter().fold(start, |found, sphere| {
            let radius = sphere.farthest(centre);
            if radius > found.0 { (radius, sphere) } else { found }
        });
        if radius < best.0 {
            best = (radius, centre);
        }
        let way = sphere.centre - centre;
        let beyond = way.try_normalize().unwrap_or(DVec3::X) * sphere.radius;
        centre += (way + beyond) / f64::from(step + 1);
    }
    let (radius, centre) = best;
    Some(BoundingSphere { centre, radius }.rounded())
}

/// Puts spheres around groups of neighbours, which together have all of `spheres`, in front, and
/// returns how many these are: at most `most`, a power of two.
pub(crate) fn enclose_groups(spheres: &mut [BoundingSphere], most: usize) -> usize {
    if most <= 1 || spheres.len() <= 1 {
        let around = enclose_many(spheres);
        spheres.iter_mut().zip(around).for_each(|(first, around)| *first = around);
        return spheres.len().min(1);
    }
    let bounds = spheres.iter().map(Bounds::of_sphere).fold(Bounds::NOTHING, Bounds::with);
    let axis = bounds.size().max_position();
    let middle = spheres.len() / 2;
    let along = |sphere: &BoundingSphere| sphere.centre[axis];
    spheres.select_nth_unstable_by(middle, |one, other| along(one).total_cmp(&along(other)));
    let (left, right) = spheres.split_at_mut(middle);
    let (left, right) = (enclose_groups(left, most / 2), enclose_groups(right, most / 2));
    spheres.copy_within(middle..middle + right, left);
    left + right
}

/// Puts spheres around neighbours, until there are at most `MOST`, a power of two: each time around
/// the two that together have the smallest one.
pub(crate) fn merge_nearest<const MOST: usize>(spheres: &mut Vec<BoundingSphere>) {
    let groups = enclose_groups(spheres, 2 * MOST);
    spheres.truncate(groups);
    // The partner of a sphere among those after it, and the radius of the sphere around both.
    let partner = |spheres: &[BoundingSphere], number: usize| {
        let others = spheres.iter().enumerate().skip(number + 1);
        let around = others.map(|(other, sphere)| (spheres[number].radius_with(sphere), other));
        around.min_by(|one, other| one.0.total_cmp(&other.0))
    };
    let mut partners = [[None; MOST]; 2];
    let partners = partners.as_flattened_mut();
    for (number, found) in partners.iter_mut().enumerate().take(spheres.len()) {
        *found = partner(spheres, number);
    }
    while spheres.len() > MOST {
        let found = partners.iter().enumerate().filter_map(|(one, found)| Some((one, (*found)?)));
        let nearest = found.min_by(|(_, one), (_, other)| one.0.total_cmp(&other.0));
        let Some((one, (_, other))) = nearest else { return };
        spheres[one] = spheres[one].with(&spheres[other]);
        spheres.remove(other);
        partners.copy_within(other + 1.., other);
        partners[spheres.len()] = None;
        for (number, found) in partners.iter_mut().enumerate().take(spheres.len()) {
            match found {
                Some((_, at)) if number != one && *at > other => *at -= 1,
                Some((_, at)) if number != one && *at != one && *at != other => {}
                _ => *found = partner(spheres, number),
            }
        }
    }
}

/// A sphere around any number of spheres: around the middle of their box.
fn enclose_many(spheres: &[BoundingSphere]) -> Option<BoundingSphere> {
    let bounds = spheres.iter().map(Bounds::of_sphere).fold(Bounds::NOTHING, Bounds::with);
    let centre = bounds.low.midpoint(bounds.high);
    let radius = spheres.iter().map(|sphere| sphere.farthest(centre)).reduce(f64::max)?;
    Some(BoundingSphere { centre, radius }.rounded())
}

/// The smallest sphere around the two spheres that are farthest apart.
fn around_widest_pair(spheres: &[BoundingSphere]) -> Option<BoundingSphere> {
    let mut around = *spheres.first()?;
    let mut widest = 0.0;
    for (number, one) in spheres.iter().enumerate() {
        for other in &spheres[number + 1..] {
            let width = one.farthest(other.centre) + other.radius;
            if width > widest {
                widest = width;
                around = one.with(other);
            }
        }
    }
    Some(around)
}

/// The sphere whose great circle goes through three points that are not on a line, which is the
/// smallest one around them if no angle of the triangle is more than a right one.
fn circumscribed(points: &[BoundingSphere]) -> Option<BoundingSphere> {
    let &[a, b, c] = points else { return None };
    if [a, b, c].iter().any(|point| point.radius != 0.0) {
        return None;
    }
    let (ab, ac) = (b.centre - a.centre, c.centre - a.centre);
    let normal = ab.cross(ac);
    let way = ac.length_squared() * normal.cross(ab) + ab.length_squared() * ac.cross(normal);
    let centre = a.centre + way / (2.0 * normal.length_squared());
    // Rounding may have moved the centre, if the triangle is narrow.
    let radius = [a, b, c].map(|point| point.farthest(centre));
    let radius = radius.into_iter().fold(0.0, f64::max);
    (centre.is_finite() && radius <= ab.length().max(ac.length()))
        .then(|| BoundingSphere { centre, radius }.rounded())
}

/// A sphere around a few spheres, for a fiftieth of the instructions of [`enclose`]. Around four it
/// is 3 % larger in the mean of a test, and at most 20 %.
///
/// It begins with the smallest sphere around the two that are farthest apart, and is widened for
/// each that sticks out, after Ritter.
pub(super) fn enclose_quickly(spheres: &[BoundingSphere]) -> Option<BoundingSphere> {
    let mut around = around_widest_pair(spheres)?;
    for sphere in spheres {
        if sphere.farthest(around.centre) > around.radius {
            around = around.with(sphere);
        }
    }
    Some(around)
}

#[cfg(test)]
mod tests {
    use rand::{Rng as _, SeedableRng as _};
    use rand_chacha::ChaCha8Rng;

    use super::*;
    use crate::scene::random::{magnitude, unit};

    #[test]
    fn every_sphere_is_inside() {
        let mut random = ChaCha8Rng::seed_from_u64(1);
        for _ in 0..2000 {
            let place = unit(&mut random) * magnitude(&mut random, -4.0, 30.0);
            let spread = magnitude(&mut random, -10.0, 10.0);
            let spheres: Vec<BoundingSphere> = (0..random.random_range(1..12))
                .map(|_| BoundingSphere {
                    centre: place + unit(&mut random) * spread,
                    radius: spread * random.random_range(0.0..2.0),
                })
                .collect();
            for enclose in [enclose, enclose_quickly] {
                let around = enclose(&spheres).expect("a sphere");
                for sphere in &spheres {
                    assert!(sphere.farthest(around.centre) <= around.radius, "{spheres:?}");
                }
            }
        }
        assert_eq!(enclose(&[]), None);
        assert_eq!(enclose_quickly(&[]), None);
    }

    #[test]
    fn neighbours_are_merged_and_everything_stays_inside() {
        let mut random = ChaCha8Rng::seed_from_u64(5);
        for count in [0, 1, 8, 9, 15, 16, 17, 100] {
            let spheres: Vec<BoundingSphere> = (0..count)
                .map(|_| BoundingSphere {
                    centre: unit(&mut random) * random.random_range(0.0..10.0),
                    radius: random.random_range(0.0..1.0),
                })
                .collect();
            let mut merged = spheres.clone();
            merge_nearest::<8>(&mut merged);
            assert_eq!(merged.len(), count.min(8));
            let is_inside = |sphere: &BoundingSphere| {
                merged.iter().any(|around| sphere.farthest(around.centre) <= around.radius)
            };
            assert!(count <= 8 || spheres.iter().all(is_inside));
        }
        // Two pairs of neighbours, far from each other.
        let at = |x: f64| BoundingSphere { centre: DVec3::X * x, radius: 1.0 };
        let mut pairs = vec![at(0.0), at(100.0), at(3.0), at(104.0)];
        merge_nearest::<2>(&mut pairs);
        let mut radii: Vec<f64> = pairs.iter().map(|pair| pair.radius).collect();
        radii.sort_by(f64::total_cmp);
        assert!((radii[0] - 2.5).abs() < 1e-9 && (radii[1] - 3.0).abs() < 1e-9, "{pairs:?}");
    }

    #[test]
    fn approximate_sphere_of_four_is_little_larger() {
        let mut random = ChaCha8Rng::seed_from_u64(3);
        let (mut sum, mut worst) = (0.0, 0.0_f64);
        const COUNT: u32 = 2000;
        for _ in 0..COUNT {
            let spheres = [(); 4].map(|()| BoundingSphere {
                centre: unit(&mut random) * random.random_range(0.0..1.0),
                radius: random.random_range(0.0..0.3),
            });
            let radius = |sphere: Option<BoundingSphere>| sphere.expect("a sphere").radius;
            let ratio = radius(enclose_quickly(&spheres)) / radius(enclose(&spheres));
            sum += ratio;
            worst = worst.max(ratio);
        }
        let mean = sum / f64::from(COUNT);
        assert!(mean < 1.04 && worst < 1.2, "{mean} {worst}");
    }

    /// No centre nearby is nearer to the farthest corner.
    #[test]
    fn sphere_around_triangle_or_parallelogram_is_smallest() {
        let mut random = ChaCha8Rng::seed_from_u64(4);
        for _ in 0..2000 {
            let place = unit(&mut random) * random.random_range(0.0..10.0);
            let [a, b, c] = [(); 3].map(|()| place + unit(&mut random));
            let corners = [a, b, c, b + c - a].map(BoundingSphere::point);
            for corners in [&corners[..3], &corners] {
                let around = enclose(corners).expect("a sphere");
                let farthest = |centre: DVec3| {
                    let distances = corners.iter().map(|corner| corner.farthest(centre));
                    distances.fold(0.0, f64::max)
                };
                assert!(farthest(around.centre) <= around.radius);
                for _ in 0..20 {
                    let centre = around.centre + 1e-3 * unit(&mut random);
                    assert!(around.radius < farthest(centre) + 1e-9, "{corners:?}");
                }
            }
        }
    }

    #[test]
    fn bounding_sphere_is_nearly_smallest() {
        let mut random = ChaCha8Rng::seed_from_u64(2);
        for _ in 0..200 {
            // The smallest sphere around the ends of a diameter and points inside is known.
            let (centre, axis) = (unit(&mut random) * 5.0, unit(&mut random));
            let mut spheres =
                vec![BoundingSphere::point(centre + axis), BoundingSphere::point(centre - axis)];
            for _ in 0..random.random_range(0..10) {
                let share = random.random_range(0.0..1.0);
                spheres.push(BoundingSphere {
                    centre: centre + unit(&mut random) * share,
                    radius: (1.0 - share) * random.random_range(0.0..1.0),
                });
            }
            let around = enclose(&spheres).expect("a sphere");
            assert!(around.radius < 1.02, "{}", around.radius);
        }
    }
}
