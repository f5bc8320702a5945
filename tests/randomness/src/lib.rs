//! Seeded random bits for tests, and how many rounds of them.

#![allow(clippy::print_stdout, reason = "the harness shows the seed with a failed test")]

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{RngCore, SeedableRng};
use std::env;
use std::str::FromStr;

/// The number that a variable holds, or this one if it is not set.
///
/// # Panics
///
/// If it holds something else.
fn variable<T: FromStr>(name: &str, default: T) -> T {
    match env::var(name) {
        Ok(text) => text.parse().unwrap_or_else(|_| panic!("{name} is no number: {text}")),
        Err(_) => default,
    }
}

/// A seeded generator. `SPU_TEST_SEED` sets the seed.
pub struct Random(ChaCha8Rng);

impl Random {
    /// Prints the seed and what it is for.
    ///
    /// # Panics
    ///
    /// If `SPU_TEST_SEED` is no decimal number.
    #[must_use]
    pub fn new(purpose: &str) -> Self {
        let seed = variable("SPU_TEST_SEED", 0x5eed);
        println!("{purpose}: SPU_TEST_SEED={seed}");
        Self(ChaCha8Rng::seed_from_u64(seed))
    }

    /// 64 random bits.
    pub fn bits(&mut self) -> u64 {
        self.0.next_u64()
    }

    /// A number below `limit`, which is not 0.
    pub fn below(&mut self, limit: u64) -> u64 {
        self.bits() % limit
    }
}

/// As many rounds as a long random test makes, if it makes `usual` ones by default:
/// `CELLRAY_TEST_ROUNDS` times as many, and at least one.
///
/// # Panics
///
/// If `CELLRAY_TEST_ROUNDS` is no positive number.
#[must_use]
pub fn rounds(usual: u32) -> u32 {
    let factor: f64 = variable("CELLRAY_TEST_ROUNDS", 1.0);
    assert!(factor > 0.0 && factor.is_finite(), "CELLRAY_TEST_ROUNDS must be positive: {factor}");
    ((f64::from(usual) * factor) as u32).max(1)
}
