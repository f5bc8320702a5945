//! Random numbers that are the same on every host.

use rand::SeedableRng as _;
use rand_xoshiro::Xoshiro256PlusPlus;

/// The generator. rand_chacha is not used, because its numbers differ on big-endian hosts
/// (ppv-lite86).
pub type Generator = Xoshiro256PlusPlus;

/// A generator for one named purpose and one round. Its numbers do not depend on what else is
/// drawn.
pub fn generator(seed: u64, purpose: &[&str], round: u32) -> Generator {
    let bytes = purpose.iter().flat_map(|name| name.bytes().chain([0]));
    // FNV-1a.
    let hash = bytes.chain(round.to_le_bytes()).fold(0xcbf2_9ce4_8422_2325_u64, |hash, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
    });
    Generator::seed_from_u64(seed ^ hash)
}

#[cfg(test)]
mod tests {
    use rand::RngCore as _;

    use super::*;

    #[test]
    fn generator_differs_by_purpose_and_round() {
        let first = |purpose: &[&str], round| generator(7, purpose, round).next_u64();
        let numbers =
            [first(&["a"], 0), first(&["a"], 1), first(&["a", "b"], 0), first(&["ab"], 0)];
        for (place, number) in numbers.iter().enumerate() {
            assert!(!numbers[..place].contains(number), "{numbers:x?}");
        }
    }

    /// Checked here, and by the runs on hosts with another byte order that compare figures.
    #[test]
    fn generator_is_equal_on_every_host() {
        let mut random = Generator::seed_from_u64(1);
        assert_eq!(random.next_u64(), 0xcfc5_d07f_6f03_c29b);
    }
}
