//! Twin of `spu/trace/sample_rays_r16.s`: a primary ray through a sample of a pixel.

use spu_emulator::float::convert::csflt;
use spu_emulator::float::single::{fa, from_f64};

use super::primary_rays::{ABSENT, Ray};
use super::ray_setup::{Basis, ray_through};
use super::{FARTHEST, ONE, ZERO};
use zerocopy::FromBytes;

/// A sample, from the pixel's centre: of `across` squared, the one in this column and row.
#[must_use]
pub fn sample(across: u32, [column, row]: [u32; 2]) -> [f64; 2] {
    let side = f64::from(across);
    // A sample is in the middle of its cell, but for the turn.
    let [x, y] = [column, row].map(|cell| (f64::from(cell) + 0.5) / side - 0.5);
    let [turned_x, turned_y] = [y, -x].map(|turn| turn / side);
    [x + turned_x, y + turned_y]
}

/// The pixel of a packet's row of rays, by the address of its sum, its column and its row.
#[derive(Clone, Copy, Debug, FromBytes)]
pub struct Pixel {
    /// The address of its sum.
    pub sum: u32,
    /// Column, or a number below 0 if the row's rays are absent.
    pub x: i32,
    /// Row.
    pub y: i32,
}

/// The ray of a packet's lane, in the row of `pixel`; a pixel has `across` squared samples.
#[must_use]
pub fn sample_ray(basis: &Basis, background: u32, pixel: Pixel, across: u32, lane: usize) -> Ray {
    let (column, row) = (lane as u32 % 4, lane as u32 / 4);
    let cell = if across == 2 { [column % 2, column / 2] } else { [column, row] };
    let offset = sample(across, cell).map(from_f64);
    let [fx, fy] = [pixel.x, pixel.y].map(|at| csflt(at as u32, 0));
    let within = pixel.x >= 0;
    Ray {
        origin: [ZERO; 3],
        direction: ray_through(basis, fa(fx, offset[0]), fa(fy, offset[1])),
        t: if within { FARTHEST } else { ABSENT },
        object: background,
        weight: if within { ONE } else { ZERO },
        pixel: pixel.sum,
    }
}
