//! Twin of `spu/include/sphere_stable.inc`: the root that does not cancel.

use spu_emulator::float::single::{fm, fma};

use super::{
    BareSphere, Crossing, Eye, General, Ray, SIGN, Single, Size, SphereObject, Vector, across,
    below_zero, beyond_surface, dot, from_origin, leaves, reciprocal, root_by_newton, within,
};

/// Perpendicular, and crossings at q and cc/q.
#[derive(Clone, Copy, Debug)]
pub struct Stable;

struct Meeting {
    b: Single,
    disc: Single,
    cc: Single,
    /// Both factors of the root, and so below 0 if b is.
    root: [Single; 2],
}

fn meet(f: Vector, d: Vector, size: Size) -> Meeting {
    let radius_squared = size.squared();
    let b = dot(f, d);
    let disc = within(radius_squared, across(f, b, d));
    let [s, e] = root_by_newton(disc);
    Meeting { b, disc, cc: beyond_surface(f, radius_squared), root: [s & !SIGN | b & SIGN, e] }
}

impl Meeting {
    /// The crossings: the one that does not cancel, and the other.
    fn crossings(&self) -> [Single; 2] {
        let [s, e] = self.root;
        let q = fma(s, e, self.b);
        [q, fm(self.cc, reciprocal(q))]
    }
}

impl General for Stable {
    const GENERAL: &'static str = "isect_sphere_pairs_stable_r16";

    fn crossing(ray: &Ray, sphere: &SphereObject) -> Crossing {
        let f = from_origin(sphere.centre, ray.origin);
        let meeting = meet(f, ray.direction, Size::Radius(sphere.offset));
        let at_q = leaves(sphere.sides, meeting.cc) != below_zero(meeting.b);
        let [q, other] = meeting.crossings();
        Crossing { t: if at_q { q } else { other }, outside: meeting.disc }
    }
}

impl Eye for Stable {
    const EYE: &'static str = "isect_pairs_stable_r16";
    type Sphere = BareSphere;

    fn entry(direction: [Single; 3], sphere: &BareSphere) -> Crossing {
        let size = Size::Squared(sphere.radius_squared);
        let meeting = meet(sphere.centre, direction, size);
        let [_, t] = meeting.crossings();
        Crossing {
            t,
            // A sphere whose centre is behind the eye is not entered.
            outside: meeting.disc | meeting.b,
        }
    }
}
