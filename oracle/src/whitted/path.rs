//! What the rays of a primary ray did: how many there were, and which way they took.

use std::ops::AddAssign;

use serde::Serialize;

/// Rays, by the Standard Procedural Databases' names. Eye, reflected and refracted rays are as
/// many as those that hit and those that see the background.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize)]
pub struct Counts {
    /// From the eye.
    pub eye: u64,
    /// Of them, those that meet an object.
    pub eye_hit: u64,
    /// Reflected, by mirrors and totally.
    pub reflected: u64,
    /// Refracted.
    pub refracted: u64,
    /// To lights.
    pub shadow: u64,
    /// Eye, reflected and refracted rays that meet an object.
    pub hit: u64,
    /// Those that meet none.
    pub background: u64,
}

impl Counts {
    /// Those of rays of which nothing is seen.
    pub(super) fn unseen(count: impl FnOnce(&mut Path)) -> Self {
        let mut path = Path::default();
        count(&mut path);
        path.counts
    }
}

impl AddAssign for Counts {
    fn add_assign(&mut self, other: Self) {
        self.eye += other.eye;
        self.eye_hit += other.eye_hit;
        self.reflected += other.reflected;
        self.refracted += other.refracted;
        self.shadow += other.shadow;
        self.hit += other.hit;
        self.background += other.background;
    }
}

/// The record of one primary ray.
#[derive(Debug, Default)]
pub(super) struct Path {
    pub counts: Counts,
    hash: u64,
}

impl Path {
    /// Notes a step of the way, such as the object met.
    pub(super) fn note(&mut self, step: u64) {
        // The mixing step of Steele's splitmix64.
        let mut mixed = self
            .hash
            .wrapping_add(step)
            .wrapping_add(0x9e37_79b9_7f4a_7c15);
        mixed = (mixed ^ (mixed >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        self.hash = mixed ^ (mixed >> 31);
    }

    /// A number that tells ways apart: rays of equal signature met the same objects from the same
    /// sides in the same order and were seen by the same lights.
    pub(super) fn signature(&self) -> u64 {
        self.hash
    }
}
