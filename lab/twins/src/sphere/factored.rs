//! Twin of `spu/include/sphere_factored.inc`: the discriminant as a product.

use spu_emulator::float::single::{fa, fm, fms, fs};

use super::super::math::sqrt;
use super::{Meeting, Rooted, Size, Vector, across, dot, root_by_newton};

/// (r - l)(r + l)
#[derive(Clone, Copy, Debug)]
pub struct Factored;

impl Rooted for Factored {
    const GENERAL: &'static str = "isect_sphere_pairs_factored_r16";
    const EYE: &'static str = "isect_pairs_factored_r16";

    fn meet(f: Vector, d: Vector, size: Size) -> Meeting {
        let radius = match size {
            Size::Radius(radius) => radius,
            Size::Squared(squared) => sqrt(squared),
        };
        let b = dot(f, d);
        let l = across(f, b, d);
        let [s, e] = root_by_newton(dot(l, l));
        let length = fm(s, e);
        let disc = fm(fs(radius, length), fa(radius, length));
        Meeting { b, disc, out: fms(b, b, disc), root: root_by_newton(disc) }
    }
}
