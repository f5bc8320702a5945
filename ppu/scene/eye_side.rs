//! On which side of a sphere the eye is, computed in double precision.
//!
//! A ray that starts on a surface doesn't hit it there, because a hit is at a distance above 0; it
//! hits a sphere only where it crosses it again. A kernel computes both crossings from a centre and
//! a radius that are rounded, so the first is at a distance of some ulps, of either sign, from ray
//! to ray. The PPU computes the side in double precision. It moves such a surface away from the eye
//! by [`MIN_GAP`], to the side on which each crossing has the sign that it should have.
//!
//! A crossing is at t = b -+ root, where root^2 = b^2 + e and e is twice the gap times the radius.
//! With u = 2^-23, the errors of b (three ulps of the distance), of the direction's length and of
//! the discriminant change the sign of t as an e of 20 u r^2 would, and the sign of b^2 - root^2 as
//! one of 12 u r^2. The gap makes it 32 u r^2. That holds for roots with a Newton step. It is also
//! half of the minimum distance from a surface at which rays leave it, so that the picture shows
//! the gap nowhere else.
//!
//! Known weakness: a ray within 2^-9 of the tangent plane passes a sphere that it should cross
//! again very near the eye.

use glam::DVec3;

/// The minimum gap between the eye and a surface, relative to the radius.
const MIN_GAP: f64 = 1.0 / (1 << 19) as f64;

/// The side of a surface that the eye is on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum EyeSide {
    Inside,
    Outside,
    /// On the surface, within tens of rounding errors of the eye's coordinates.
    On,
}

impl EyeSide {
    /// The eye's side of a sphere.
    pub(crate) fn of(eye: DVec3, centre: DVec3, radius: f64) -> Self {
        let to_centre = centre - eye;
        let gap = to_centre.length() - radius.abs();
        let largest = |vector: DVec3| vector.abs().max_element();
        let rounding = 64.0 * f64::EPSILON * (largest(eye) + largest(to_centre));
        if gap.abs() <= rounding {
            Self::On
        } else if gap < 0.0 {
            Self::Inside
        } else {
            Self::Outside
        }
    }

    /// The radius of a sphere at this distance from the eye, moved away from an eye on this side;
    /// the given radius if it is far enough from the eye, or if the eye is on the surface.
    pub(crate) fn clear_radius(self, distance: f64, radius: f64) -> f64 {
        let gap = MIN_GAP * radius.abs();
        if (distance - radius.abs()).abs() >= gap {
            return radius;
        }
        let moved = match self {
            Self::Inside => distance + gap,
            Self::Outside => distance - gap,
            Self::On => return radius,
        };
        moved.copysign(radius)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn eye_on_surface_is_detected_despite_rounding() {
        let side = |eye: [f64; 3], radius| EyeSide::of(DVec3::from(eye), DVec3::ZERO, radius);
        assert_eq!(side([0.3, 0.4, 1.2], 1.3), EyeSide::On);
        assert_eq!(side([0.3, 0.4, 1.2], -1.3), EyeSide::On);
        assert_eq!(side([0.0, 0.0, 1.0 + 1e-12], 1.0), EyeSide::Outside);
        assert_eq!(side([0.0, 0.0, 1.0 - 1e-12], 1.0), EyeSide::Inside);
    }

    #[test]
    fn radius_changes_only_near_eye() {
        for (side, distance, radius, expected) in [
            (EyeSide::Inside, 1.0, 1.0, 1.0 + MIN_GAP),
            (EyeSide::Outside, 1.0, -1.0, -1.0 + MIN_GAP),
            (EyeSide::Outside, 1.0 + 1e-9, 1.0, 1.0 + 1e-9 - MIN_GAP),
            (EyeSide::On, 1.0, 1.0, 1.0),
            (EyeSide::Inside, 1.0 - 2.0 * MIN_GAP, 1.0, 1.0),
            (EyeSide::Outside, 3.0, 1.0, 1.0),
        ] {
            let radius = side.clear_radius(distance, radius);
            assert!((radius - expected).abs() < 1e-15, "{side:?}: {radius}");
        }
    }
}
