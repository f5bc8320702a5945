//! Twin of `spu/shade/smooth_r16.s`: the normal that shades a point of a patch.

use spu_emulator::float::single::{fm, fma, fms, fs};

use super::math::rsqrt;
use super::triangle::Triangle;
use super::{Single, below_zero, dot};
use zerocopy::FromBytes;

/// A triangle with normals at its vertices.
#[derive(Clone, Copy, Debug, FromBytes)]
pub struct Patch {
    /// Its vertices.
    pub vertices: Triangle,
    /// Their normals.
    pub normals: [[Single; 3]; 3],
}

/// The normal at a point of the patch, whose own normal on the ray's side is `plane`.
#[must_use]
pub fn smooth(
    patch: &Patch,
    point: [Single; 3],
    plane: [Single; 3],
    direction: [Single; 3],
) -> [Single; 3] {
    let seen = patch
        .vertices
        .map(|vertex| -> [Single; 3] { std::array::from_fn(|axis| fs(vertex[axis], point[axis])) });
    let [a, b, c] = seen;
    let share = |from: [Single; 3], to: [Single; 3]| {
        let turn =
            [[1, 2], [2, 0], [0, 1]].map(|[i, j]| fms(plane[i], from[j], fm(plane[j], from[i])));
        dot(turn, to)
    };
    let shares = [share(b, c), share(c, a), share(a, b)];
    let normal: [Single; 3] = std::array::from_fn(|axis| {
        let [a, b, c] = patch.normals.map(|normal| normal[axis]);
        fma(shares[2], c, fma(shares[1], b, fm(shares[0], a)))
    });
    if !below_zero(dot(normal, direction)) {
        return plane;
    }
    let inverse = rsqrt(dot(normal, normal));
    normal.map(|component| fm(component, inverse))
}
