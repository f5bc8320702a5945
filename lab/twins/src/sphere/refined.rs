//! Twin of `spu/include/sphere_refined.inc`: what truncation took from b, put back. All lengths
//! are halved.

use spu_emulator::float::single::{fm, fma, fms, fnms};

use super::{
    BareSphere, Crossing, Eye, General, HALF, ONE, Ray, Single, SphereObject, Vector, across, dot,
    interpolated, leaves, sign, within,
};

/// Perpendicular, with half of l.d added to b.
#[derive(Clone, Copy, Debug)]
pub struct Refined;

const QUARTER: Single = 0x3e80_0000;
/// The number from which a root's step is subtracted.
const REFINED_ONE: Single = 0x3f80_0001;
/// The factor of b.
const REFINED_TWO: Single = 0x4000_0001;
/// Twice the root by its estimate.
const REFINED_ROOT: Single = 0x4000_0002;

struct Meeting {
    b: Single,
    disc: Single,
    out: Single,
    rest: Single,
    /// Both factors of twice the root.
    root: [Single; 2],
}

fn meet(f: Vector, d: Vector, radius_squared: Single) -> Meeting {
    let b = dot(f, d);
    let l = across(f, b, d);
    let rest = dot(l, d);
    let disc = fma(rest, rest, within(radius_squared, l));
    let y = interpolated(disc);
    let s = fm(disc, y);
    Meeting {
        b,
        disc,
        out: fms(b, b, disc),
        rest,
        root: [s, fma(fnms(s, y, REFINED_ONE), ONE, REFINED_ROOT)],
    }
}

impl Meeting {
    fn crossing(&self, leaves: bool) -> Crossing {
        let [s, e] = self.root;
        let rest = fnms(s ^ sign(leaves), e, self.rest);
        Crossing { t: fma(self.b, REFINED_TWO, rest), outside: self.disc }
    }
}

impl General for Refined {
    const GENERAL: &'static str = "isect_sphere_pairs_refined_r16";

    fn crossing(ray: &Ray, sphere: &SphereObject) -> Crossing {
        let half_centre = sphere.centre.map(|component| fm(component, HALF));
        let f = std::array::from_fn(|axis| fnms(ray.origin[axis], HALF, half_centre[axis]));
        let radius = fm(sphere.offset, HALF);
        let meeting = meet(f, ray.direction, fm(radius, radius));
        meeting.crossing(leaves(sphere.sides, meeting.out))
    }
}

impl Eye for Refined {
    const EYE: &'static str = "isect_pairs_refined_r16";
    type Sphere = BareSphere;

    fn entry(direction: [Single; 3], sphere: &BareSphere) -> Crossing {
        let f = sphere.centre.map(|component| fm(component, HALF));
        meet(f, direction, fm(sphere.radius_squared, QUARTER)).crossing(false)
    }
}
