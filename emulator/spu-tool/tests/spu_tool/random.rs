//! Seeded random bits for tests.

use std::env;

/// A seeded generator (splitmix64). `SPU_TEST_SEED` sets the seed, which is printed.
pub struct Random(u64);

impl Random {
    pub fn new(purpose: &str) -> Self {
        let seed = env::var("SPU_TEST_SEED")
            .map_or(0x5eed, |seed| seed.parse().expect("SPU_TEST_SEED must be a decimal number"));
        println!("{purpose}: SPU_TEST_SEED={seed}");
        Self(seed)
    }

    pub fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let x = (self.0 ^ self.0 >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let x = (x ^ x >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
        x ^ x >> 31
    }

    pub fn below(&mut self, limit: u64) -> u64 {
        self.next() % limit
    }
}
