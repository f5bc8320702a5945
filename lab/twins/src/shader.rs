//! Twins of the shaders in `spu/shaders/`.

use spu_emulator::float::convert::{cflts, csflt};
use spu_emulator::float::single::{fa, fcgt, fm, fma, fnms, fs};

use super::math::reciprocal;
use super::shade_depth::{Depth, shade_depth};
use super::{ONE, Single};

/// The single 1/1024, by which a side of the cubes belongs to the next one.
const WITHIN: Single = 0x3a80_0000;

/// What `shader_depth` leaves of a surface: its lit colour.
#[must_use]
pub fn depth(t: Single, colour: [Single; 3], parameters: [Single; 4]) -> [Single; 3] {
    let [far, scale, ..] = parameters;
    shade_depth(t, colour, false, Depth { far, scale })
}

/// What `shader_sky` makes of the light at the horizon.
#[must_use]
pub fn sky(
    direction: [Single; 3],
    colour: [Single; 3],
    lit: [Single; 3],
    parameters: [Single; 4],
) -> [Single; 3] {
    let [along_x, along_y, along_z] = direction;
    let [up_x, up_y, up_z, _] = parameters;
    let height = fma(along_z, up_z, fma(along_y, up_y, fm(along_x, up_x)));
    let height = height & fcgt(height, 0);
    std::array::from_fn(|channel| {
        let lit = lit[channel];
        fma(height, fs(colour[channel], lit), lit)
    })
}

/// The colour that `shader_checker` gives a surface at a point relative to the eye.
#[must_use]
pub fn checker(
    point: [Single; 3],
    colour: [Single; 3],
    parameters: [Single; 4],
    eye: [Single; 3],
) -> [Single; 3] {
    let [red, green, blue, scale] = parameters;
    let cells = (0..3).fold(0_u32, |cells, axis| {
        let place = fma(fa(point[axis], eye[axis]), scale, WITHIN);
        let cell = cflts(place, 0);
        let above = fcgt(csflt(cell, 0), place);
        cells.wrapping_add(cell).wrapping_add(above)
    });
    if cells & 1 == 1 { [red, green, blue] } else { colour }
}

/// The way on from a portal.
#[derive(Clone, Copy, Debug)]
pub struct Portal {
    cosine: Single,
    sine: Single,
    by: [Single; 3],
}

impl Portal {
    /// The one that `shader_portal` makes of its parameters.
    #[must_use]
    pub fn new([by_x, by_y, by_z, h]: [Single; 4], [eye_x, _, eye_z]: [Single; 3]) -> Self {
        let inverse = reciprocal(fma(h, h, ONE));
        let cosine = fm(fnms(h, h, ONE), inverse);
        let sine = fm(fa(h, h), inverse);
        let by_x = fma(sine, eye_z, fma(cosine, eye_x, fs(by_x, eye_x)));
        let by_z = fnms(sine, eye_x, fma(cosine, eye_z, fs(by_z, eye_z)));
        Self { cosine, sine, by: [by_x, by_y, by_z] }
    }

    /// A normal or a direction beyond it.
    #[must_use]
    pub fn turned(&self, [x, y, z]: [Single; 3]) -> [Single; 3] {
        let Self { cosine, sine, .. } = *self;
        [fma(sine, z, fm(cosine, x)), y, fnms(sine, x, fm(cosine, z))]
    }

    /// A point beyond it, relative to the eye as the point before it.
    #[must_use]
    pub fn moved(&self, [x, y, z]: [Single; 3]) -> [Single; 3] {
        let Self { cosine, sine, by: [by_x, by_y, by_z] } = *self;
        let (along_x, along_z) = (fma(cosine, x, by_x), fma(cosine, z, by_z));
        [fma(sine, z, along_x), fa(y, by_y), fnms(sine, x, along_z)]
    }
}
