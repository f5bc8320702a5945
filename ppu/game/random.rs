//! Random numbers for games.
//!
//! Invariant: a seed gives the same numbers on every machine and in every version of cellray, since
//! recorded sessions depend on them.

use rand_xoshiro::Xoshiro256PlusPlus;
use rand_xoshiro::rand_core::{RngCore as _, SeedableRng as _};

/// A source of random numbers that depend only on a seed. [`Start::random`](super::Start::random)
/// has the seed that a recording keeps.
///
/// ```
/// use cellray::game::Random;
///
/// let mut random = Random::new(1);
/// let (turn, face) = (random.between(-0.5, 0.5), 1 + random.below(6));
/// assert!((-0.5..0.5).contains(&turn) && (1..=6).contains(&face));
///
/// let mut order = [1, 2, 3, 4, 5, 6, 7];
/// random.shuffle(&mut order);
/// order.sort();
/// assert_eq!(order, [1, 2, 3, 4, 5, 6, 7]);
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Random(Xoshiro256PlusPlus);

impl Random {
    /// The numbers of a seed.
    #[must_use]
    pub fn new(seed: u64) -> Self {
        Self(Xoshiro256PlusPlus::seed_from_u64(seed))
    }

    /// A number from 0 to less than 1, a multiple of 2^-53.
    pub fn unit(&mut self) -> f64 {
        (self.0.next_u64() >> 11) as f64 / (1u64 << 53) as f64
    }

    /// A number from `low` to `high`.
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// An integer from 0 to less than `count`; 0 if there is none. Each is as likely as the others,
    /// but for a part in 2^64 / `count`.
    pub fn below(&mut self, count: usize) -> usize {
        ((u128::from(self.0.next_u64()) * count as u128) >> 64) as usize
    }

    /// One of these, or `None` of none.
    pub fn one_of<'a, T>(&mut self, all: &'a [T]) -> Option<&'a T> {
        all.get(self.below(all.len()))
    }

    /// Puts these into a random order.
    pub fn shuffle<T>(&mut self, all: &mut [T]) {
        for last in (1..all.len()).rev() {
            all.swap(last, self.below(last + 1));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Random;

    #[test]
    fn seed_gives_fixed_numbers() {
        let mut random = Random::new(0);
        // As computed by the published definitions of xoshiro256++ and, for the seed, SplitMix64.
        let units = [0; 3].map(|_| random.unit() * (1u64 << 53) as f64);
        assert_eq!(
            units,
            [2_923_514_112_319_844.0, 3_442_905_506_672_666.0, 3_239_143_844_713_295.0]
        );
        let mut order = [0, 1, 2, 3, 4, 5, 6, 7];
        random.shuffle(&mut order);
        assert_eq!(order, [1, 2, 5, 6, 4, 7, 3, 0]);
    }

    #[test]
    fn range_gives_every_number_within_bounds() {
        let mut random = Random::new(7);
        let mut seen = [0; 6];
        for _ in 0..6000 {
            seen[random.below(6)] += 1;
            assert!((-2.0..3.0).contains(&random.between(-2.0, 3.0)));
        }
        assert!(seen.iter().all(|&count| (850..1150).contains(&count)), "{seen:?}");
        assert_eq!(random.below(0), 0);
        assert_eq!(random.one_of::<u8>(&[]), None);
        assert_eq!(random.one_of(&[5]), Some(&5));
    }
}
