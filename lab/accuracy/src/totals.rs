//! The sums of several pictures' errors.

use oracle::ULPS;

use crate::pictures::PictureRow;

/// The sums of several pictures.
#[derive(Clone, Copy, Debug, Default)]
pub struct Total {
    pixels: u64,
    squares: f64,
    /// [`PictureRow::cycles`].
    pub cycles: f64,
    /// [`PictureRow::wrong_pixels`].
    pub wrong_pixels: u64,
    /// [`PictureRow::floor`].
    pub floor: u64,
    /// [`PictureRow::by_ulps`].
    pub by_ulps: [u64; ULPS.len() + 1],
    /// [`PictureRow::well_conditioned`].
    pub well_conditioned: u64,
}

impl Total {
    /// The smallest floor that an excess is measured against; below it chance decides.
    pub const SMALLEST_FLOOR: u64 = 8;

    /// The sums of these pictures.
    pub fn of<'a>(rows: impl IntoIterator<Item = &'a PictureRow>) -> Self {
        let mut total = Self::default();
        for row in rows {
            let pixels = u64::from(row.width) * u64::from(row.height);
            total.pixels += pixels;
            total.squares += pixels as f64 * row.rmse * row.rmse;
            total.cycles += row.cycles;
            total.wrong_pixels += row.wrong_pixels;
            total.floor += row.floor;
            total.well_conditioned += row.well_conditioned;
            for (sum, count) in total.by_ulps.iter_mut().zip(row.by_ulps) {
                *sum += count;
            }
        }
        total
    }

    /// A number of pixels in per cent of all.
    pub fn percent(&self, pixels: u64) -> f64 {
        100.0 * pixels as f64 / self.pixels as f64
    }

    /// The wrong pixels over the floor, unless the floor is too small.
    pub fn excess(&self) -> Option<f64> {
        let measured = self.floor >= Self::SMALLEST_FLOOR;
        measured.then(|| self.wrong_pixels as f64 / self.floor as f64)
    }

    /// The root of the mean square error of all channels, in 1/255.
    pub fn rmse(&self) -> f64 {
        (self.squares / self.pixels as f64).sqrt()
    }

    /// The backward error that 99 % of the explained pixels do not exceed, if it was found.
    pub fn ulps_of_99_percent(&self) -> Option<u32> {
        let all: u64 = self.by_ulps.iter().sum();
        let mut within = 0;
        ULPS.into_iter().zip(self.by_ulps).find_map(|(ulps, count)| {
            within += count;
            (100 * within >= 99 * all).then_some(ulps)
        })
    }
}
