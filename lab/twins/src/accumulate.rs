//! Twin of `spu/shade/accumulate_r16.s`: sums of what rays bring to their pixels.

use spu_emulator::float::single::{fa, fm};

use super::Single;

/// The contribution of a ray to its pixel.
#[derive(Clone, Copy, Debug)]
pub struct Share {
    /// Its pixel.
    pub pixel: usize,
    /// Its weight in it.
    pub weight: Single,
    /// Red, green, blue.
    pub lit: [Single; 3],
}

/// Adds what four rays bring to the sums of pixels. Rays of one pixel are summed first: a ray's
/// own share, then those of the earlier ones in order.
pub fn accumulate(shares: &[Share; 4], sums: &mut [[Single; 3]]) {
    let colours = shares.map(|share| share.lit.map(|channel| fm(channel, share.weight)));
    let before = shares.map(|share| sums[share.pixel]);
    for (lane, share) in shares.iter().enumerate() {
        let mut more = colours[lane];
        for (earlier, colour) in shares[..lane].iter().zip(&colours) {
            // The kernel adds 0 for another pixel, which makes +0 of a denormal or a -0.
            let same = earlier.pixel == share.pixel;
            more = std::array::from_fn(|k| fa(more[k], if same { colour[k] } else { 0 }));
        }
        sums[share.pixel] = std::array::from_fn(|k| fa(before[lane][k], more[k]));
    }
}
