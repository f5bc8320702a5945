//! Explains the wrong pixels of a picture: how far the numbers of rays must be off for a pixel to
//! be right, and how far the pixel moves if its ray is off.
//!
//! The first is its backward error: the picture shows exactly what the scene looks like with rays
//! that are moved by this number of units in the last place. The second is its condition number,
//! which the scene alone determines.

use glam::DVec3;
use scenes::Scene;
use serde::Serialize;

use crate::compare::is_wrong;
use crate::whitted::{Options, Probe, Rounding};
use crate::{Error, Picture, Reference, Samples, rounded_to_singles, rows};

/// The units in the last place that are tried, in this order.
pub const ULPS: [u32; 7] = [1, 2, 4, 8, 16, 32, 64];

/// The number of perturbed pictures for each number of units.
const TRIES: u64 = 24;

/// The angle by which a primary ray is turned to find how far its pixel moves: 8 units in the last
/// place of a single just below 1.
const TURN: f64 = 8.0 * f32::EPSILON as f64 / 2.0;

/// The number of sides to which it is turned. With eight, an edge that passes at 7.4 to 8 units may
/// be between two sides and be missed.
const TURNS: u32 = 64;

/// The condition number below which a pixel is well-conditioned: a ray that is off by 8 units moves
/// no channel by more than 1/255.
pub const WELL_CONDITIONED: f64 = 1.0 / (255.0 * TURN);

/// A wrong pixel.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct WrongPixel {
    /// Its column.
    pub x: u32,
    /// Its row.
    pub y: u32,
    /// Its backward error in units in the last place: the first of [`ULPS`] that suffices. `None`
    /// if even the last does not.
    pub ulps: Option<u32>,
    /// Its condition number: by how much a channel changes, relative to white, for each radian by
    /// which the primary ray is turned. The ray differential is a quotient over 8 units in the last
    /// place, so that it includes edges, at which there is no derivative. It is the largest of
    /// 64 sides and of all channels.
    pub condition: f64,
}

/// The wrong pixels of a picture, row by row.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Explanation {
    /// The wrong pixels.
    pub wrong_pixels: Vec<WrongPixel>,
}

impl Explanation {
    /// For each of [`ULPS`], the number of wrong pixels with this backward error, and then the
    /// number of those with a larger one.
    #[must_use]
    pub fn by_ulps(&self) -> [u64; ULPS.len() + 1] {
        let mut counts = [0; ULPS.len() + 1];
        for pixel in &self.wrong_pixels {
            let place = ULPS.iter().position(|&ulps| pixel.ulps == Some(ulps));
            counts[place.unwrap_or(ULPS.len())] += 1;
        }
        counts
    }

    /// The number of wrong pixels with a condition number from `low` to below `high`.
    #[must_use]
    pub fn conditioned(&self, low: f64, high: f64) -> u64 {
        let within = |pixel: &&WrongPixel| (low..high).contains(&pixel.condition);
        self.wrong_pixels.iter().filter(within).count() as u64
    }
}

/// Explains the wrong pixels of a picture in Whitted's model with one sample a pixel. If there are
/// more than `most`, it explains about that number, evenly spread.
///
/// # Errors
/// As for [`crate::whitted::trace`]; the sizes differ; the pixels have several samples.
pub fn explain(
    picture: &Picture,
    reference: &Reference,
    scene: &Scene,
    options: &Options,
    most: usize,
) -> Result<Explanation, Error> {
    if options.pixels.samples != Samples::One || options.pixels.corners {
        return Err(Error::Samples);
    }
    let (width, height) = (picture.width(), picture.height());
    let exact = Probe::new(scene, width, height, options)?;
    let wrong = crate::compare::wrong_pixels(picture, &reference.picture)?;
    let step = wrong.len().div_ceil(most).max(1);
    let explained = wrong.into_iter().step_by(step).map(|pixel| {
        let (x, y) = (pixel as u32 % width, pixel as u32 / width);
        WrongPixel { x, y, ulps: None, condition: 0.0 }
    });
    let mut pixels: Vec<WrongPixel> = explained.collect();
    rows::each(pixels.iter_mut(), |pixel| {
        pixel.condition = condition(&exact, options, pixel.x, pixel.y);
    });
    let scene = rounded_to_singles(scene);
    let mut probe = Probe::new(&scene, width, height, options)?;
    for ulps in ULPS {
        for seed in 0..TRIES {
            probe.set_rounding(Rounding::Perturbed { ulps, seed });
            let left = pixels.iter_mut().filter(|pixel| pixel.ulps.is_none());
            rows::each(left, |pixel| {
                let shown = options.pixels.bytes(probe.light(pixel.x.into(), pixel.y.into()));
                let found = &picture.pixels()[(pixel.y * width + pixel.x) as usize];
                pixel.ulps = (!is_wrong(found, &shown)).then_some(ulps);
            });
        }
    }
    Ok(Explanation { wrong_pixels: pixels })
}

/// The condition number of a pixel.
fn condition(probe: &Probe<'_>, options: &Options, x: u32, y: u32) -> f64 {
    let way = probe.direction(x.into(), y.into()).normalize();
    let (right, up) = way.any_orthonormal_pair();
    let shown = |way: DVec3| options.pixels.shown(probe.along(way));
    let exact = shown(way);
    let moved = (0..TURNS).map(|turn| {
        let (sine, cosine) =
            libm::sincos(f64::from(turn) * std::f64::consts::TAU / f64::from(TURNS));
        (shown(way + TURN * (cosine * right + sine * up)) - exact).abs().max_element()
    });
    moved.fold(0.0, f64::max) / TURN
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn edges_within_the_turn_are_seen_on_all_sides() {
        let options = Options::default();
        for angle in 0..16 {
            let (y, x) = libm::sincos(f64::from(angle));
            let normal = DVec3::new(x, y, 0.0);
            let along = normal.cross(DVec3::Z);
            let condition_at = |turns: f64| {
                let edge = turns * TURN * normal - DVec3::Z;
                let corners = [edge - 2.0 * along, edge + 2.0 * along, edge + 4.0 * normal];
                let corners = corners.map(|DVec3 { x, y, z }| format!("{x} {y} {z}\n")).concat();
                let text = format!(
                    "v\nfrom 0 0 0\nat 0 0 -1\nup 0 1 0\nangle 40\nhither 0\nresolution 3 3\n\
                     b 0 0 0\nl 0 0 1\nf 1 1 1 1 0 0 0 1\np 3\n{corners}"
                );
                let limits = scenes::Limits::default();
                let scene = scenes::parse(text.as_bytes(), "t.nff", &limits).expect("a scene");
                let probe = Probe::new(&scene, 3, 3, &options).expect("a camera");
                condition(&probe, &options, 1, 1)
            };
            assert!(condition_at(0.97) > WELL_CONDITIONED, "{angle}");
            assert_eq!(condition_at(1.03), 0.0, "{angle}");
        }
    }
}
