//! Twin of `spu/include/sphere_paper.inc`: the textbook's discriminant.

use spu_emulator::float::single::fms;

use super::{Meeting, Rooted, Size, Vector, beyond_surface, dot, root_by_newton};

/// b^2 - (|f|^2 - r^2)
#[derive(Clone, Copy, Debug)]
pub struct Paper;

impl Rooted for Paper {
    const GENERAL: &'static str = "isect_sphere_pairs_paper_r16";
    const EYE: &'static str = "isect_pairs_paper_r16";

    fn meet(f: Vector, d: Vector, size: Size) -> Meeting {
        let b = dot(f, d);
        let out = beyond_surface(f, size.squared());
        let disc = fms(b, b, out);
        Meeting { b, disc, out, root: root_by_newton(disc) }
    }
}
