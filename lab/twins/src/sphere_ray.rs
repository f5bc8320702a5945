//! Twin of `spu/include/sphere_ray_tmpl.inc` and of the kernels made of it, `isect_sphere_r1`,
//! `isect_sphere_r16`, `isect_spheres16_r16`, `any_sphere_r16` and `any_spheres_r16`: a ray from
//! anywhere and a sphere.

use spu_emulator::float::estimate::{fi, frsqest};
use spu_emulator::float::single::{fcgt, fm, fma, fms, fnms, fs};

use super::{HALF, ONE, SIGN, Single, ZERO, below_zero};
use zerocopy::{FromBytes, Immutable, IntoBytes};

/// A sphere.
#[derive(Clone, Copy, Debug, FromBytes)]
pub struct BareSphere {
    /// Centre.
    pub centre: [Single; 3],
    /// Radius squared.
    pub radius_squared: Single,
}

/// A ray, and what it has hit so far.
#[derive(Clone, Copy, Debug, PartialEq, Eq, FromBytes, IntoBytes, Immutable)]
#[repr(C)]
pub struct Ray {
    /// Where it starts.
    pub origin: [Single; 3],
    /// Unit direction.
    pub direction: [Single; 3],
    /// Distance of the nearest hit, or the farthest that counts.
    pub t: Single,
    /// Number of the object hit.
    pub object: u32,
}

/// How a ray passes a sphere.
pub(super) struct Meeting {
    /// Where it is nearest to the centre.
    pub b: Single,
    /// Below 0 if it does not come within the radius.
    pub disc: Single,
    /// Below 0 if it starts inside.
    pub out: Single,
}

pub(super) fn meet(ray: &Ray, sphere: &BareSphere) -> Meeting {
    let [dx, dy, dz] = ray.direction;
    let centre: [Single; 3] = std::array::from_fn(|axis| fs(sphere.centre[axis], ray.origin[axis]));
    let [cx, cy, cz] = centre;
    let b = fma(cz, dz, fma(cy, dy, fm(cx, dx)));
    let (lx, ly, lz) = (fnms(b, dx, cx), fnms(b, dy, cy), fnms(b, dz, cz));
    let disc = fnms(lz, lz, fnms(ly, ly, fnms(lx, lx, sphere.radius_squared)));
    Meeting { b, disc, out: fms(b, b, disc) }
}

/// The ray after its test with a sphere, which is object number `object`.
#[must_use]
pub fn nearest(ray: Ray, sphere: &BareSphere, object: u32) -> Ray {
    let Meeting { b, disc, out } = meet(&ray, sphere);
    let y = fi(disc, frsqest(disc));
    let s = fm(disc, y);
    let e = fma(fnms(s, y, ONE), HALF, ONE);
    let minus_t = fms(s & !SIGN | out & SIGN, e, b);
    // As signed numbers, singles below 0 are in turned order, and smaller than all others.
    let nearer = (minus_t as i32) < (ray.t ^ SIGN) as i32;
    if nearer && !below_zero(disc) {
        let t = minus_t ^ SIGN;
        Ray { t, object, ..ray }
    } else {
        ray
    }
}

/// Whether the sphere blocks the ray before its `t`.
#[must_use]
pub fn any(ray: &Ray, sphere: &BareSphere) -> bool {
    let Meeting { b, disc, out } = meet(ray, sphere);
    let ahead = fs(ray.t, b);
    let end_inside = below_zero(fms(ahead, ahead, disc));
    let blocked = if below_zero(out) {
        !end_inside
    } else {
        !below_zero(disc) && !below_zero(b) && (!below_zero(ahead) || end_inside)
    };
    blocked && fcgt(ray.t, ZERO) != 0
}
