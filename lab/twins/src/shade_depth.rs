//! Twin of `spu/shade/shade_depth_r16.s`: the paper's shader.

use spu_emulator::float::single::{fcgt, fm, fs};

use super::{ONE, Single, ZERO, select};
use zerocopy::FromBytes;

/// Depth shading of a frame.
#[derive(Clone, Copy, Debug, FromBytes)]
pub struct Depth {
    /// Distance at which everything is black.
    pub far: Single,
    /// One over the distance in which it fades.
    pub scale: Single,
}

/// The colour that a ray sees: that of what it meets at `t`, faded by the distance unless `none`,
/// which means that it meets nothing and `colour` is the background's.
#[must_use]
pub fn shade_depth(t: Single, colour: [Single; 3], none: bool, depth: Depth) -> [Single; 3] {
    let bright = fm(fs(depth.far, t), depth.scale);
    let bright = select(bright, ZERO, fcgt(ZERO, bright) != 0);
    let bright = select(bright, ONE, fcgt(bright, ONE) != 0);
    let bright = select(bright, ONE, none);
    colour.map(|channel| fm(channel, bright))
}
