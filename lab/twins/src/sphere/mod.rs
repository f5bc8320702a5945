//! Twins of the formulations of a ray and a sphere, `spu/include/sphere_tmpl.inc` and what
//! includes it: each as it is for rays from anywhere and for the eye's, and the steps that several
//! share.
//!
//! Of lanes that pass the sphere by, `t` is anything: no kernel keeps it.

mod constants;
mod double;
mod factored;
mod newton2;
mod paper;
mod perpendicular;
mod refined;
mod stable;
mod unnormalised;

use std::fmt::Debug;

use spu_emulator::float::estimate::{fi, frest, frsqest};
use spu_emulator::float::single::{fm, fma, fms, fnms, fs};

use super::pairs::Sides;
use super::sphere_pairs::SphereObject;
use super::sphere_ray::{BareSphere, Ray};
use super::{HALF, ONE, SIGN, Single, below_zero, dot};

pub use constants::{Axis, Constants};
pub use double::InDouble;
pub use factored::Factored;
pub use newton2::Newton2;
pub use paper::Paper;
pub use perpendicular::{Estimate, Interpolated, Perpendicular};
pub use refined::Refined;
pub use stable::Stable;
pub use unnormalised::Unnormalised;

/// Where a ray crosses a sphere.
#[derive(Clone, Copy, Debug)]
pub struct Crossing {
    /// The distance.
    pub t: Single,
    /// Below 0 if the ray passes the sphere by.
    pub outside: Single,
}

/// A formulation for rays from anywhere.
pub trait General {
    /// The kernel.
    const GENERAL: &'static str;

    /// The crossing that is seen: the entry or the exit.
    fn crossing(ray: &Ray, sphere: &SphereObject) -> Crossing;
}

/// A formulation for primary rays, which start at 0.
pub trait Eye {
    /// The kernel.
    const EYE: &'static str;
    /// The part of a sphere's record that it reads.
    type Sphere: Copy + Debug;

    /// Where the ray enters the sphere.
    fn entry(direction: [Single; 3], sphere: &Self::Sphere) -> Crossing;
}

type Vector = [Single; 3];

/// How large a sphere is, as its record has it.
#[derive(Clone, Copy)]
enum Size {
    Radius(Single),
    Squared(Single),
}

impl Size {
    fn squared(self) -> Single {
        match self {
            Self::Radius(radius) => fm(radius, radius),
            Self::Squared(squared) => squared,
        }
    }
}

/// A formulation by the root that is taken off b for the entry, and added for the exit.
trait Rooted {
    const GENERAL: &'static str;
    const EYE: &'static str;

    fn meet(f: Vector, d: Vector, size: Size) -> Meeting;
}

/// How a ray meets a sphere.
struct Meeting {
    /// Where it passes the centre.
    b: Single,
    /// Below 0 if it passes the sphere by.
    disc: Single,
    /// Below 0 if it starts inside.
    out: Single,
    /// Both factors of the root.
    root: [Single; 2],
}

impl Meeting {
    fn crossing(&self, leaves: bool) -> Crossing {
        let [s, e] = self.root;
        Crossing { t: fnms(s ^ sign(leaves), e, self.b), outside: self.disc }
    }
}

impl<F: Rooted> General for F {
    const GENERAL: &'static str = F::GENERAL;

    fn crossing(ray: &Ray, sphere: &SphereObject) -> Crossing {
        let f = from_origin(sphere.centre, ray.origin);
        let meeting = F::meet(f, ray.direction, Size::Radius(sphere.offset));
        meeting.crossing(leaves(sphere.sides, meeting.out))
    }
}

impl<F: Rooted> Eye for F {
    const EYE: &'static str = F::EYE;
    type Sphere = BareSphere;

    fn entry(direction: [Single; 3], sphere: &BareSphere) -> Crossing {
        let size = Size::Squared(sphere.radius_squared);
        F::meet(sphere.centre, direction, size).crossing(false)
    }
}

/// Whether the crossing that is seen is the exit, for a ray that starts inside if `out` is below
/// 0.
fn leaves(sides: Sides, out: Single) -> bool {
    if sides.both { below_zero(out) } else { sides.exit }
}

fn sign(negative: bool) -> u32 {
    if negative { SIGN } else { 0 }
}

fn from_origin(centre: Vector, origin: Vector) -> Vector {
    std::array::from_fn(|axis| fs(centre[axis], origin[axis]))
}

/// f - b d
fn across(f: Vector, b: Single, d: Vector) -> Vector {
    std::array::from_fn(|axis| fnms(b, d[axis], f[axis]))
}

/// r^2 - l.l
fn within(radius_squared: Single, [lx, ly, lz]: Vector) -> Single {
    fnms(lz, lz, fnms(ly, ly, fnms(lx, lx, radius_squared)))
}

/// |f|^2 - r^2
fn beyond_surface([fx, fy, fz]: Vector, radius_squared: Single) -> Single {
    fma(fz, fz, fma(fy, fy, fms(fx, fx, radius_squared)))
}

/// 1/sqrt(x) to 12 bits.
fn interpolated(x: Single) -> Single {
    fi(x, frsqest(x))
}

/// Both factors of the square root by one Newton step.
fn root_by_newton(disc: Single) -> [Single; 2] {
    let y = interpolated(disc);
    let s = fm(disc, y);
    [s, fma(fnms(s, y, ONE), HALF, ONE)]
}

/// The reciprocal by one Newton step.
fn reciprocal(x: Single) -> Single {
    let y = fi(x, frest(x));
    fma(fnms(x, y, ONE), y, y)
}
