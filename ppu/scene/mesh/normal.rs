//! Unit normals in a word: the octahedral map in two signed halves.

use glam::DVec3;

/// The largest magnitude of a half.
const SCALE: f64 = 32767.0;

/// The word of a normal, which need not have length 1 but must not be 0.
///
/// The normal is projected onto the octahedron |x| + |y| + |z| = 1. The lower half of that, where z
/// is below 0, is folded outwards over the upper half's edges.
pub(super) fn packed(normal: DVec3) -> u32 {
    let largest = normal.abs().max_element();
    // Scaled first, because the sum of huge components is infinite.
    let scaled = normal / largest;
    let on_octahedron = scaled / scaled.abs().element_sum();
    let (x, y) = (on_octahedron.x, on_octahedron.y);
    let (u, v) = if on_octahedron.z < 0.0 {
        ((1.0 - y.abs()) * sign(x), (1.0 - x.abs()) * sign(y))
    } else {
        (x, y)
    };
    let half = |value: f64| u32::from((libm::round(SCALE * value) as i16) as u16);
    half(u) << 16 | half(v)
}

fn sign(value: f64) -> f64 {
    if value < 0.0 { -1.0 } else { 1.0 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand::SeedableRng as _;
    use rand_chacha::ChaCha8Rng;

    use crate::scene::random::unit;

    fn unpacked(word: u32) -> DVec3 {
        let half = |bits: u32| f64::from(bits as u16 as i16) / SCALE;
        let (u, v) = (half(word >> 16), half(word));
        let z = 1.0 - u.abs() - v.abs();
        let fold = (-z).max(0.0);
        DVec3::new(u - fold * sign(u), v - fold * sign(v), z).normalize()
    }

    #[test]
    fn packed_normal_error_is_below_1e_4() {
        let mut random = ChaCha8Rng::seed_from_u64(1);
        for _ in 0..10_000 {
            let normal = unit(&mut random);
            let off = unpacked(packed(normal)).distance(normal);
            assert!(off < 1e-4, "{normal} {off}");
        }
        for axis in [DVec3::X, DVec3::Y, DVec3::Z] {
            assert_eq!(unpacked(packed(3e37 * axis)), axis);
            assert_eq!(unpacked(packed(-1e-30 * axis)), -axis);
        }
    }
}
