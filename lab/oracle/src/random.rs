//! Numbers for tests.

use glam::DVec3;

/// A fixed sequence of well-mixed numbers (Steele's splitmix64).
pub(crate) struct Random(pub u64);

impl Random {
    pub(crate) fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        mixed ^ (mixed >> 31)
    }

    /// From -`most` to `most`.
    pub(crate) fn whole(&mut self, most: i64) -> i64 {
        (self.next() % (2 * most as u64 + 1)) as i64 - most
    }

    pub(crate) fn triple(&mut self, most: i64) -> [i64; 3] {
        [self.whole(most), self.whole(most), self.whole(most)]
    }

    /// From -1 to 1.
    pub(crate) fn real(&mut self) -> f64 {
        self.whole(1 << 52) as f64 / (1u64 << 52) as f64
    }

    /// In the cube from -1 to 1.
    pub(crate) fn point(&mut self) -> DVec3 {
        DVec3::new(self.real(), self.real(), self.real())
    }

    pub(crate) fn direction(&mut self) -> DVec3 {
        loop {
            let point = self.point();
            if (0.01..=1.0).contains(&point.length_squared()) {
                return point.normalize();
            }
        }
    }
}
