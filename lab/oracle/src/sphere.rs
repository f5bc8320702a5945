//! Intersects a ray and a sphere in `f64`.
//!
//! The ray's smallest distance from the centre decides about a hit. The discriminant b² - a c is
//! not used, because it loses the radius of a small sphere far away in the square of its distance.
//! The root is the roots' product divided by the other root, whose sum does not cancel.

use glam::DVec3;

/// A sphere as seen from the eye.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Sphere {
    /// The vector from the eye to the centre.
    to_centre: DVec3,
    radius: f64,
    /// The square of the length of a tangent from the eye; negative if the eye is inside.
    tangent_squared: f64,
}

/// The passage of a ray past a sphere, or through it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Passage {
    /// The smallest distance of the ray from the centre, in radii: 1 is the edge.
    pub offset: f64,
    /// The distance from the eye at which the ray enters; `None` for a miss, or if the eye is
    /// inside.
    pub entry: Option<f64>,
}

impl Sphere {
    pub(crate) fn new(eye: DVec3, centre: DVec3, radius: f64) -> Self {
        let to_centre = centre - eye;
        let distance = to_centre.length();
        let tangent_squared = (distance - radius) * (distance + radius);
        Self { to_centre, radius, tangent_squared }
    }

    /// Whether no ray in a plane comes within `reach` radii of the centre. The plane goes through
    /// the eye, at right angles to the unit vector `normal`. A normal of NaN excludes nothing.
    pub(crate) fn is_off_plane(&self, normal: DVec3, reach: f64) -> bool {
        // The rounding error of the dot product is about 1e-15 of the distance.
        let rounding = 1e-12 * self.to_centre.length();
        self.to_centre.dot(normal).abs() > reach * self.radius + rounding
    }

    /// How the ray from the eye in the unit direction `direction` passes the sphere. `None` if the
    /// centre is not in front of the eye, because then no ray can enter.
    pub(crate) fn passage(&self, direction: DVec3) -> Option<Passage> {
        let along = self.to_centre.dot(direction);
        if along <= 0.0 {
            return None;
        }
        let distance = (self.to_centre - along * direction).length();
        let entry = (distance <= self.radius && self.tangent_squared > 0.0).then(|| {
            let half_chord = ((self.radius - distance) * (self.radius + distance)).sqrt();
            self.tangent_squared / (along + half_chord)
        });
        Some(Passage { offset: distance / self.radius, entry })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Random;

    fn vector(triple: [i64; 3]) -> DVec3 {
        DVec3::from_array(triple.map(|n| n as f64))
    }

    fn dot(a: [i64; 3], b: [i64; 3]) -> i128 {
        (0..3).map(|axis| i128::from(a[axis]) * i128::from(b[axis])).sum()
    }

    #[test]
    fn hits_and_misses_are_those_of_whole_number_arithmetic() {
        let mut random = Random(1);
        let mut counts = [0; 3];
        for round in 0..200_000 {
            // Rays aimed near the sphere, from far away, from nearby, and from inside.
            let radius = 1 + random.whole(1 << 16).abs();
            let centre = random.triple(if round % 4 == 0 { radius } else { 1 << 20 });
            let aside = random.triple(2 * radius);
            let direction = [0, 1, 2].map(|axis| centre[axis] + aside[axis]);
            if direction == [0; 3] {
                continue;
            }
            let along = dot(centre, direction);
            let tangent_squared = dot(centre, centre) - i128::from(radius).pow(2);
            let discriminant = along.pow(2) - dot(direction, direction) * tangent_squared;
            let exact = along > 0 && tangent_squared > 0 && discriminant > 0;
            let near_edge = discriminant == 0;
            let found = Sphere::new(DVec3::ZERO, vector(centre), radius as f64)
                .passage(vector(direction).normalize())
                .and_then(|passage| passage.entry)
                .is_some();
            assert!(near_edge || found == exact, "{centre:?} {radius} {direction:?}");
            counts[if tangent_squared <= 0 { 2 } else { usize::from(exact) }] += 1;
        }
        assert!(counts.iter().all(|&count| count > 100), "misses, hits, inside: {counts:?}");
    }

    #[test]
    fn entries_lie_on_the_sphere_and_face_the_eye() {
        let mut random = Random(2);
        let mut hits = 0;
        for round in 0..100_000 {
            // From 2^-20 to 2^20 radii away.
            let radius = 1.0;
            let scale = libm::exp2((round % 41 - 20) as f64);
            let towards = vector(random.triple(1 << 20)).normalize();
            let to_centre = towards * (radius + scale);
            let aside = vector(random.triple(1 << 20)) / f64::from(1 << 20);
            let direction = (to_centre + aside * radius.min(scale)).normalize();
            let passage = Sphere::new(DVec3::ZERO, to_centre, radius).passage(direction);
            let Some(entry) = passage.and_then(|passage| passage.entry) else {
                continue;
            };
            let out = direction * entry - to_centre;
            assert!((out.length() - radius).abs() < 2e-15 * (radius + scale), "{out} at {scale}");
            assert!(out.dot(direction) <= 1e-7, "leaves at {scale}");
            assert!(entry > 0.0);
            hits += 1;
        }
        assert!(hits > 50_000, "{hits}");
    }

    #[test]
    fn an_entry_is_exact_to_some_ulps_however_near_or_far() {
        // Along the axis the exact distance is known: the centre's minus the radius.
        for exponent in -50..=50 {
            let gap = libm::exp2(f64::from(exponent));
            let sphere = Sphere::new(DVec3::ZERO, DVec3::new(0.0, 1.0 + gap, 0.0), 1.0);
            let entry = sphere.passage(DVec3::Y).and_then(|passage| passage.entry).expect("a hit");
            assert!((entry / gap - 1.0).abs() < 4e-16, "{entry} for {gap}");
        }
    }

    #[test]
    fn the_edge_is_offset_1() {
        // A triangle of 3, 4, 5: a ray from a distance of 5 with sine 3/5 touches a sphere of
        // radius 3.
        let sphere = Sphere::new(DVec3::ZERO, DVec3::new(0.0, 5.0, 0.0), 3.0);
        let passage = sphere.passage(DVec3::new(0.6, 0.8, 0.0)).expect("in front");
        assert!((passage.offset - 1.0).abs() < 1e-15);
        let miss = sphere.passage(DVec3::new(0.6001, 0.8, 0.0).normalize()).expect("in front");
        assert!(miss.offset > 1.0 && miss.entry.is_none());
    }

    #[test]
    fn spheres_behind_and_around_the_eye_are_not_entered() {
        assert!(Sphere::new(DVec3::ZERO, -DVec3::Y * 3.0, 1.0).passage(DVec3::Y).is_none());
        let around = Sphere::new(DVec3::ZERO, DVec3::Y * 0.5, 1.0).passage(DVec3::Y);
        assert!(around.expect("centre in front").entry.is_none());
    }
}
