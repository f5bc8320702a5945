//! Twin of `spu/shade/shade_depth_r16.s`: the paper's shader.

use spu_emulator::float::single::{fcgt, fm, fs};

use super::isect_spheres::Hit;
use super::{ONE, Single, ZERO, select};

/// Depth shading of a frame.
#[derive(Clone, Copy, Debug)]
pub struct Depth {
    /// Distance at which everything is black.
    pub far: Single,
    /// One over the distance in which it fades.
    pub scale: Single,
}

/// Colour of a hit; entry 0 of the table is the background.
#[must_use]
pub fn shade_depth(hit: Hit, table: &[[Single; 3]], depth: Depth) -> [Single; 3] {
    let bright = fm(fs(depth.far, hit.t), depth.scale);
    let bright = select(bright, ZERO, fcgt(ZERO, bright) != 0);
    let bright = select(bright, ONE, fcgt(bright, ONE) != 0);
    let bright = select(bright, ONE, hit.object == 0);
    table[hit.object as usize].map(|channel| fm(channel, bright))
}
