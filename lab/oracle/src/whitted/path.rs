//! The record of a primary ray's chain: the numbers of rays, and the way that they took.

use std::ops::AddAssign;

use serde::Serialize;

use super::rounding::mixed;

/// Numbers of rays, with the Standard Procedural Databases' names. The sum of eye, reflected and
/// refracted rays equals the sum of `hit` and `background`.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize)]
pub struct Counts {
    /// Primary rays.
    pub eye: u64,
    /// Primary rays that hit an object.
    pub eye_hit: u64,
    /// Reflected rays, including totally reflected ones.
    pub reflected: u64,
    /// Refracted rays.
    pub refracted: u64,
    /// Of the reflected rays, those of total reflection. SPD counts these as refracted ones, too.
    pub totally_reflected: u64,
    /// Shadow rays.
    pub shadow: u64,
    /// Lights in front of a patch's shading normal, but on the back side of the patch. SPD, which
    /// speaks of one normal only, sends shadow rays to these, too.
    pub shadow_behind: u64,
    /// Primary, reflected and refracted rays that hit an object.
    pub hit: u64,
    /// Primary, reflected and refracted rays that hit nothing.
    pub background: u64,
}

impl Counts {
    /// The counts of rays whose result is not used.
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
        self.totally_reflected += other.totally_reflected;
        self.shadow += other.shadow;
        self.shadow_behind += other.shadow_behind;
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
    /// Records a step of the way, such as the object that was hit.
    pub(super) fn note(&mut self, step: u64) {
        self.hash = mixed(self.hash.wrapping_add(step));
    }

    /// A hash of the way. Rays with equal signatures hit the same objects from the same sides in
    /// the same order, and the same lights reach them.
    pub(super) fn signature(&self) -> u64 {
        self.hash
    }
}
