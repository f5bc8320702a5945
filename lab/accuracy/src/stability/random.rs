//! Random numbers with the same bits on every host: no logarithms, powers or sines are used.

use crate::generator::generator;
use crate::stability::prelude::*;

/// The random numbers for one round of a family, independent of the thread that tries it.
pub fn of_round(seed: u64, family: &str, subject: &str, round: u32) -> Generator {
    generator(seed, &[family, subject], round)
}

/// 2^exponent.
pub fn power_of_two(exponent: i32) -> f64 {
    assert!((-1022..=1023).contains(&exponent), "2^{exponent}");
    f64::from_bits(((exponent + 1023) as u64) << 52)
}

/// A random number from 2^low to below 2^high, in which all powers are equally likely.
pub fn magnitude(low: i32, high: i32, random: &mut Generator) -> f64 {
    power_of_two(random.random_range(low..high)) * random.random_range(1.0..2.0)
}

/// Two directions that are perpendicular to a third and to each other.
pub fn across(axis: Vector, random: &mut Generator) -> [Vector; 2] {
    loop {
        let across = cross(axis, direction(random));
        if dot(across, across) > 0.01 {
            let first = unit(across);
            return [first, cross(axis, first)];
        }
    }
}

/// The vector rounded to singles.
pub fn rounded(vector: Vector) -> Vector {
    vector.map(|x| to_f64(from_f64(x)))
}

/// The direction from one place to another, or `otherwise` if they are too close for one.
pub fn towards(from: Vector, to: Vector, otherwise: Vector) -> Vector {
    let way = sub(to, from);
    if dot(way, way) > 0.0 { unit(way) } else { otherwise }
}

/// This number with a random sign.
pub fn either_side(number: f64, random: &mut Generator) -> f64 {
    if random.random() { number } else { -number }
}

/// The singles nearest to a vector. Half of them are moved by one ulp.
pub fn nearby(vector: Vector, random: &mut Generator) -> [Single; 3] {
    vector.map(|x| {
        let single = from_f64(x);
        if single == 0 || random.random() {
            single
        } else {
            single.wrapping_add_signed(random.random_range(-1..=1))
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_are_exact() {
        for n in [-300, -126, -1, 0, 1, 127, 300] {
            assert_eq!(power_of_two(n), 2_f64.powi(n));
        }
    }

    #[test]
    fn rounds_differ_and_repeat() {
        let first = |family, round| of_round(7, family, "k", round).random::<u64>();
        assert_eq!(first("a", 3), first("a", 3));
        assert_ne!(first("a", 3), first("a", 4));
        assert_ne!(first("a", 3), first("b", 3));
    }

    #[test]
    fn magnitudes_keep_their_range() {
        let mut random = of_round(1, "a", "b", 0);
        for _ in 0..1000 {
            assert!((0.125..4.0).contains(&magnitude(-3, 2, &mut random)));
        }
    }
}
