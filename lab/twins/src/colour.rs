//! Twin of `spu/shade/colour_vertices_r16.s`: what the colours of a triangle's vertices make of the
//! colour at a hit.

use spu_emulator::float::convert::csflt;
use spu_emulator::float::single::{fm, fma, fs};

use super::texture::shares;
use super::triangle::Triangle;
use super::{ONE, Single};
use zerocopy::FromBytes;

/// The single next to 1 / 1023 above.
const SCALE: Single = 0x3a80_2009;

/// A hit on a triangle with colours at its vertices.
#[derive(Clone, Copy, Debug, FromBytes)]
pub struct Hit {
    /// The triangle's vertices.
    pub vertices: Triangle,
    /// Their packed colours.
    pub colours: [u32; 3],
    /// The point.
    pub point: [Single; 3],
    /// The triangle's own normal, on the ray's side.
    pub plane: [Single; 3],
    /// The surface's colour.
    pub colour: [Single; 3],
}

/// The colour of the surface, multiplied by that of the vertices. Theirs are light, or its square
/// root.
#[must_use]
pub fn interpolated(hit: &Hit, are_roots: bool) -> [Single; 3] {
    let (of_b, of_c, _) = shares(&hit.vertices, hit.point, hit.plane);
    let (light, square) = if are_roots { (0, SCALE) } else { (ONE, 0) };
    std::array::from_fn(|channel| {
        let [a, b, c] = hit.colours.map(|packed| {
            let part = csflt(packed >> (22 - 10 * channel) & 1023, 0);
            fm(part, fma(part, square, light))
        });
        let mixed = fma(of_c, fs(c, a), fma(of_b, fs(b, a), a));
        fm(fm(mixed, SCALE), hit.colour[channel])
    })
}
