//! Twin of `spu/trace/ray_setup_r16.s`: a unit primary ray.

use spu_emulator::float::convert::csflt;
use spu_emulator::float::single::{fm, fma};

use super::Single;
use super::math::rsqrt;
use zerocopy::FromBytes;

/// Camera of a frame: directions of x, y, z.
#[derive(Clone, Copy, Debug, FromBytes)]
pub struct Basis {
    /// Through the centre of pixel (0, 0).
    pub corner: [Single; 3],
    /// To the next pixel of a row.
    pub right: [Single; 3],
    /// To the next row.
    pub down: [Single; 3],
}

/// Unit direction through the centre of pixel (x, y).
#[must_use]
pub fn ray_setup(basis: &Basis, x: i32, y: i32) -> [Single; 3] {
    let [fx, fy] = [x, y].map(|at| csflt(at as u32, 0));
    ray_through(basis, fx, fy)
}

/// Unit direction through a point of the picture; of pixel (0, 0) the centre is (0, 0).
#[must_use]
pub fn ray_through(basis: &Basis, fx: Single, fy: Single) -> [Single; 3] {
    let direction: [Single; 3] = std::array::from_fn(|axis| {
        let in_row = fma(fx, basis.right[axis], basis.corner[axis]);
        fma(fy, basis.down[axis], in_row)
    });
    let [dx, dy, dz] = direction;
    let length_squared = fma(dz, dz, fma(dy, dy, fm(dx, dx)));
    let inverse = rsqrt(length_squared);
    direction.map(|component| fm(component, inverse))
}
