//! Twins of the kernels that leave tests out: `filter_spheres_r16`, `cull_spheres_p64`,
//! `frustum_spheres` and `hidden_pairs_r16` in `spu/isect/`.

use spu_emulator::float::single::{fcgt, fma, fnms};

use super::{Single, below_zero};

/// Whether a ray may enter the sphere around `centre`, or a ray of a packet with this middle:
/// whether the product of centre and direction is above the sphere's limit.
#[must_use]
pub fn may_enter(direction: [Single; 3], centre: [Single; 3], limit: Single) -> bool {
    let ([dx, dy, dz], [cx, cy, cz]) = (direction, centre);
    below_zero(fnms(cz, dz, fnms(cy, dy, fnms(cx, dx, limit))))
}

/// Whether a sphere reaches to the inner side of planes through the eye, given by their normals.
#[must_use]
pub fn reaches_into(normals: &[[Single; 3]; 4], centre: [Single; 3], reach: Single) -> bool {
    let [cx, cy, cz] = centre;
    let outside =
        |&[nx, ny, nz]: &[Single; 3]| below_zero(fma(cz, nz, fma(cy, ny, fma(cx, nx, reach))));
    !normals.iter().any(outside)
}

/// Whether rays with nearest hits at `t` have all hit something no farther than `near`.
#[must_use]
pub fn is_hidden(t: &[Single; 16], near: Single) -> bool {
    t.iter().all(|&t| fcgt(t, near) == 0)
}
