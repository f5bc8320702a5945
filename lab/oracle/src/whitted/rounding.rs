//! Rounds the numbers of rays, to find what a tracer must get wrong for that alone.
//!
//! A record of a ray has the coordinates of its origin, relative to the eye, and of its direction.
//! Only these and the normals that they are computed from are changed; everything else stays in
//! double precision.

use glam::DVec3;

/// What happens to the numbers of each ray's record.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Rounding {
    /// They stay in double precision.
    #[default]
    Double,
    /// They become the nearest singles.
    Nearest,
    /// They lose the bits that a single has no place for, as by the SPU's arithmetic.
    Truncated,
    /// They become the nearest singles, and are then moved by whole units in the last place: by a
    /// random number of them, at most `ulps` up or down.
    Perturbed {
        /// The largest number of units.
        ulps: u32,
        /// Another seed gives other numbers.
        seed: u64,
    },
}

/// The bits of a double's fraction that a single does not have.
const LOST_BITS: u32 = f64::MANTISSA_DIGITS - f32::MANTISSA_DIGITS;

/// Rays start at least so far off their surface, as a share of the sum of the coordinates'
/// magnitudes: more than the rounding of a point moves it.
const LEAVE: f64 = 1.0 / (1 << 21) as f64;

/// How many times that distance an origin moves along its ray at most.
const LEAVE_FARTHEST: f64 = 64.0;

impl Rounding {
    /// The rounded point. `way` is different for each ray of a picture.
    pub(super) fn point(self, point: DVec3, eye: DVec3, way: u64) -> DVec3 {
        if self == Self::Double { point } else { eye + self.vector(point - eye, way) }
    }

    /// The unit vector along the rounded one.
    pub(super) fn unit(self, direction: DVec3, way: u64) -> DVec3 {
        if self == Self::Double { direction } else { self.vector(direction, way).normalize() }
    }

    /// Where a ray starts that leaves a surface with this normal at a rounded point. The origin
    /// moves along the ray, so that the ray stays on its line; only where it grazes the surface
    /// does it move along the normal, too.
    pub(super) fn origin(self, point: DVec3, eye: DVec3, normal: DVec3, direction: DVec3) -> DVec3 {
        if self == Self::Double {
            return point;
        }
        let away = point - eye;
        let leave = LEAVE * away.abs().element_sum();
        let cosine = normal.dot(direction);
        let ahead = (leave / cosine.abs()).min(LEAVE_FARTHEST * leave);
        let rest = (leave - ahead * cosine.abs()) * cosine.signum();
        point + ahead * direction + rest * normal
    }

    fn vector(self, exact: DVec3, way: u64) -> DVec3 {
        match self {
            Self::Double => exact,
            Self::Nearest => exact.as_vec3().as_dvec3(),
            Self::Truncated => exact.map(|x| f64::from_bits(x.to_bits() >> LOST_BITS << LOST_BITS)),
            Self::Perturbed { ulps, seed } => {
                let mut bits = mixed(way ^ mixed(seed));
                exact.map(|x| {
                    bits = mixed(bits);
                    let most = i64::from(ulps);
                    let units = (bits % (2 * most as u64 + 1)) as i64 - most;
                    let single = f64::from(x as f32);
                    let unit = f64::from_bits(single.abs().to_bits() & EXPONENT) * SINGLE_EPSILON;
                    single + units as f64 * unit
                })
            }
        }
    }
}

/// The exponent's bits of a double.
const EXPONENT: u64 = 0x7ff0_0000_0000_0000;
/// The distance from 1 to the next single.
const SINGLE_EPSILON: f64 = f32::EPSILON as f64;

/// The mixing step of Steele's splitmix64.
pub(super) fn mixed(number: u64) -> u64 {
    let mut mixed = number.wrapping_add(0x9e37_79b9_7f4a_7c15);
    mixed = (mixed ^ (mixed >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    mixed ^ (mixed >> 31)
}

#[cfg(test)]
mod tests {
    use super::*;

    const EXACT: DVec3 = DVec3::new(1.0 / 3.0, -2.0 / 3.0, 1e-3);

    #[test]
    fn each_rounding_is_within_its_bound() {
        let ulp = DVec3::new(1.0 / (1 << 25) as f64, 1.0 / (1 << 24) as f64, 0.0);
        let off = |rounding: Rounding| (rounding.vector(EXACT, 7) - EXACT).abs();
        assert_eq!(off(Rounding::Double), DVec3::ZERO);
        for (rounding, ulps) in [
            (Rounding::Nearest, 0.5),
            (Rounding::Truncated, 1.0),
            (Rounding::Perturbed { ulps: 4, seed: 1 }, 4.5),
        ] {
            let off = off(rounding);
            assert!(off.x <= ulps * ulp.x && off.y <= ulps * ulp.y, "{rounding:?}: {off}");
            assert!(off.max_element() > 0.0, "{rounding:?}");
        }
        let truncated = Rounding::Truncated.vector(EXACT, 0);
        assert!(truncated.abs().cmple(EXACT.abs()).all());
    }

    #[test]
    fn perturbations_differ_by_seed_and_way() {
        let at = |seed, way| Rounding::Perturbed { ulps: 1 << 20, seed }.vector(EXACT, way);
        assert_eq!(at(1, 1), at(1, 1));
        assert!(at(1, 1) != at(2, 1) && at(1, 1) != at(1, 2));
    }

    #[test]
    fn rays_leave_a_surface_along_themselves() {
        let (point, normal) = (DVec3::new(3.0, 2.0, 1.0), DVec3::Z);
        let leave = 6.0 * LEAVE;
        for (x, z) in [(0.6, 0.8), (0.6, -0.8)] {
            let direction = DVec3::new(x, 0.0, z);
            let origin = Rounding::Nearest.origin(point, DVec3::ZERO, normal, direction);
            assert!((origin - point).cross(direction).length() < 1e-20);
            assert!(((origin - point).z.abs() - leave).abs() < 1e-15);
        }
        let grazing = DVec3::new(1.0, 0.0, 1e-4).normalize();
        let origin = Rounding::Nearest.origin(point, DVec3::ZERO, normal, grazing);
        assert!(((origin - point).z - leave).abs() < 1e-15);
        assert!((origin - point).x <= 64.0 * leave);
    }
}
