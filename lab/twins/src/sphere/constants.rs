//! Twin of `spu/include/sphere_constants.inc`: spheres by constants in double precision.

use spu_emulator::float::single::{fm, fma, fms, fnms, fs};
use zerocopy::FromBytes;

use super::{Crossing, Eye, HALF, ONE, Single, Vector, dot, root_by_newton};

/// A sphere by its direction and distance.
#[derive(Clone, Copy, Debug, FromBytes)]
pub struct Axis {
    /// The centre's direction, at length 1.
    pub axis: [Single; 3],
    /// The square of radius over distance.
    pub k: Single,
    /// The centre's distance.
    pub distance: Single,
}

/// The discriminant by the chord from the sphere's axis.
#[derive(Clone, Copy, Debug)]
pub struct Constants;

const QUARTER: Single = 0x3e80_0000;

impl Eye for Constants {
    const EYE: &'static str = "isect_pairs_constants_r16";
    type Sphere = Axis;

    fn entry(direction: [Single; 3], sphere: &Axis) -> Crossing {
        let difference: Vector = std::array::from_fn(|axis| fs(direction[axis], sphere.axis[axis]));
        let chord = dot(difference, difference);
        let disc = fma(chord, fms(chord, QUARTER, ONE), sphere.k);
        let [s, e] = root_by_newton(disc);
        let part = fma(s, e, fm(chord, HALF));
        Crossing { t: fnms(sphere.distance, part, sphere.distance), outside: disc }
    }
}
