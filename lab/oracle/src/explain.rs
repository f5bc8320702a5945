//! Explains the wrong pixels of a picture: how far the numbers of rays must be off for a pixel to
//! be right.
//!
//! That is its backward error: the picture shows exactly what the scene looks like with rays that
//! are moved by this number of units in the last place.

use scenes::Scene;
use serde::Serialize;

use crate::compare::is_wrong;
use crate::whitted::{Options, Probe, Rounding};
use crate::{Error, Picture, Reference, Samples, rounded_to_singles, rows};

/// The units in the last place that are tried, in this order.
pub const ULPS: [u32; 7] = [1, 2, 4, 8, 16, 32, 64];

/// The number of perturbed pictures for each number of units.
const TRIES: u64 = 24;

/// The wrong pixels, by backward error.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Explanation {
    /// The number of wrong pixels.
    pub wrong_pixels: u64,
    /// For each number of units in the last place, the wrong pixels that it suffices for but the
    /// number before it does not.
    pub by_ulps: [(u32, u64); ULPS.len()],
    /// The wrong pixels that differ from all perturbed pictures, each with its column and row.
    pub unexplained: Vec<(u32, u32)>,
}

/// Explains the wrong pixels of a picture in Whitted's model with one sample a pixel.
///
/// # Errors
/// As for [`crate::whitted::trace`]; the sizes differ; the pixels have several samples.
pub fn explain(
    picture: &Picture,
    reference: &Reference,
    scene: &Scene,
    options: &Options,
) -> Result<Explanation, Error> {
    if options.pixels.samples != Samples::One || options.pixels.corners {
        return Err(Error::Samples);
    }
    let (width, height) = (picture.width(), picture.height());
    let wrong = crate::compare::wrong_pixels(picture, &reference.picture)?;
    let scene = rounded_to_singles(scene);
    let mut left: Vec<(usize, bool)> = wrong.iter().map(|&pixel| (pixel, true)).collect();
    let mut by_ulps = ULPS.map(|ulps| (ulps, 0));
    let mut probe = Probe::new(&scene, width, height, options)?;
    for (ulps, count) in &mut by_ulps {
        for seed in 0..TRIES {
            probe.set_rounding(Rounding::Perturbed { ulps: *ulps, seed });
            rows::each(left.iter_mut(), |(pixel, is_left)| {
                let (x, y) = (*pixel as u32 % width, *pixel as u32 / width);
                let shown = options.pixels.bytes(probe.light(f64::from(x), f64::from(y)));
                *is_left = is_wrong(&picture.pixels()[*pixel], &shown);
            });
            let before = left.len();
            left.retain(|&(_, is_left)| is_left);
            *count += (before - left.len()) as u64;
        }
    }
    let unexplained = left.iter().map(|&(pixel, _)| (pixel as u32 % width, pixel as u32 / width));
    Ok(Explanation {
        wrong_pixels: wrong.len() as u64,
        by_ulps,
        unexplained: unexplained.collect(),
    })
}
