//! Twin of `spu/isect/bound_fan_r16.s` and `bound_origins_r16.s`: what the rays of a packet
//! are within.

use spu_emulator::float::single::{fa, fcgt, fm, fma, fms, fnms, fs};

use super::math::{reciprocal, rsqrt, sqrt};
use super::primary_rays::Ray;
use super::{ONE, SIGN, Single, ZERO, below_zero, dot};
use zerocopy::FromBytes;

/// 2 - 2 (3/16): the square of the longest chord of a cone.
const WIDE: Single = 0x3fd0_0000;
/// 1/32: less than (3/16)^2.
const SHORT: Single = 0x3d00_0000;
/// 1/4.
const QUARTER: Single = 0x3e80_0000;
/// 2^-18.
const SLACK: Single = 0x3680_0000;
/// 1 + 2^-18.
const GROWN: Single = 0x3f80_0020;
/// 1 - 2^-12, and half of it.
const SHRUNK: [Single; 2] = [0x3f7f_f000, 0x3eff_f000];
/// Less the largest single: the radius and the sine where there is nothing.
pub const NOTHING: Single = 0xffff_ffff;

/// A sphere moved along a cone.
#[derive(Clone, Copy, Debug, PartialEq, Eq, FromBytes)]
pub struct Bound {
    /// Middle of the rays' origins.
    pub apex: [Single; 3],
    /// Unit vector about which the directions are; 0 if they go every way.
    pub axis: [Single; 3],
    /// Cosine of the cone's half angle, a little less.
    pub cosine: Single,
    /// Its sine, a little more.
    pub sine: Single,
    /// Distance from the apex within which all rays start.
    pub radius: Single,
    /// Largest distance that a ray counts to.
    pub farthest: Single,
}

/// The bound of a packet's rays from anywhere.
#[must_use]
pub fn bound(rays: &[Ray; 16]) -> Bound {
    let weight = weights(rays, ONE);
    let count = lanes(std::array::from_fn(|lane| {
        let [first, second, third, fourth] = rows(&weight, lane);
        fa(fa(first, second), fa(third, fourth))
    }));
    let mean = reciprocal(count);
    let apex = sum(&rays.map(|ray| ray.origin), &weight).map(|sum| fm(sum, mean));
    let cone = Cone::of(rays, ONE);

    let apart = there(rays, |ray| {
        let apart = std::array::from_fn(|axis| fs(ray.origin[axis], apex[axis]));
        dot(apart, apart)
    });
    let [x, y, z] = apex.map(|component| component & !SIGN);
    let radius = fm(sqrt(largest(apart)), GROWN);
    let radius = fma(fa(fa(x, y), z), SLACK, radius);
    cone.bound(apex, radius, rays, count == ZERO)
}

/// The bound of a packet's rays that start at a point, with `along` 1, or end there, with -1.
#[must_use]
pub fn bound_fan(rays: &[Ray; 16], point: [Single; 3], near: Single, along: Single) -> Bound {
    let is_nobody_there = below_zero(largest(rays.map(|ray| ray.t)));
    Cone::of(rays, along).bound(point, fa(ZERO, near), rays, is_nobody_there)
}

/// A cone about directions.
struct Cone {
    axis: [Single; 3],
    cosine: Single,
    sine: Single,
}

impl Cone {
    /// The cone about those of the rays, turned round if `along` is -1.
    fn of(rays: &[Ray; 16], along: Single) -> Self {
        let sum = sum(&rays.map(|ray| ray.direction), &weights(rays, along));
        let [x, y, z] = sum.map(|sum| fm(sum, sum));
        let length = fa(fa(x, y), z);
        let inverse = rsqrt(length);
        let axis = sum.map(|sum| fm(sum, inverse));
        let chord = largest(there(rays, |ray| {
            let apart = std::array::from_fn(|k| fms(ray.direction[k], along, axis[k]));
            dot(apart, apart)
        }));
        let sine = sqrt(fnms(fm(chord, QUARTER), chord, chord));
        let [most, half] = SHRUNK;
        let is_wide = fcgt(chord, WIDE) != 0 || fcgt(SHORT, length) != 0;
        let of_cone = |value| if is_wide { ZERO } else { value };
        Self {
            axis: axis.map(of_cone),
            cosine: of_cone(fnms(chord, half, most)),
            sine: of_cone(fma(sine, ONE, SLACK)),
        }
    }

    /// The bound with a sphere.
    fn bound(
        self,
        apex: [Single; 3],
        radius: Single,
        rays: &[Ray; 16],
        is_nobody_there: bool,
    ) -> Bound {
        let unless_empty = |value| if is_nobody_there { NOTHING } else { value };
        Bound {
            apex,
            axis: self.axis,
            cosine: self.cosine,
            sine: unless_empty(self.sine),
            radius: unless_empty(radius),
            farthest: largest(rays.map(|ray| ray.t)),
        }
    }
}

/// The weights of rays that are there; of others 0.
fn weights(rays: &[Ray; 16], weight: Single) -> [Single; 16] {
    there(rays, |_| weight)
}

/// Of rays that are there some value; of others 0.
fn there(rays: &[Ray; 16], value: impl Fn(&Ray) -> Single) -> [Single; 16] {
    std::array::from_fn(|lane| {
        let ray = &rays[lane];
        if below_zero(ray.t) { ZERO } else { value(ray) }
    })
}

/// The values of a lane in each of the rows.
fn rows(values: &[Single; 16], lane: usize) -> [Single; 4] {
    std::array::from_fn(|row| values[4 * row + lane])
}

/// The sum of the lanes.
fn lanes([first, second, third, fourth]: [Single; 4]) -> Single {
    fa(fa(first, second), fa(third, fourth))
}

/// The sum of the vectors, each times its weight.
fn sum(vectors: &[[Single; 3]; 16], weight: &[Single; 16]) -> [Single; 3] {
    std::array::from_fn(|axis| {
        let values = vectors.map(|vector| vector[axis]);
        lanes(std::array::from_fn(|lane| {
            let (values, weight) = (rows(&values, lane), rows(weight, lane));
            (1..4).fold(fm(values[0], weight[0]), |sum, row| fma(values[row], weight[row], sum))
        }))
    })
}

/// The largest: the later one of equals.
fn largest(values: [Single; 16]) -> Single {
    let larger = |a, b| if fcgt(a, b) != 0 { a } else { b };
    let [first, second, third, fourth] = std::array::from_fn(|lane| {
        let [first, further @ ..] = rows(&values, lane);
        further.into_iter().fold(first, larger)
    });
    larger(larger(first, second), larger(third, fourth))
}
