//! Twin of `spu/plain/isect/bound_r16.s`: what the rays of a packet are within.

use spu_emulator::float::single::{fa, fcgt, fm, fma, fnms, fs};

use super::eye_rays::{ABSENT, Ray};
use super::flat::{SIGN, reciprocal};
use super::math::{rsqrt, sqrt};
use super::{ONE, Single, ZERO, below_zero};

/// -3/16: less the smallest cosine of a cone.
const WIDE: Single = 0xbe40_0000;
/// 2^-18.
const SLACK: Single = 0x3680_0000;
/// 1 + 2^-18.
const GROWN: Single = 0x3f80_0020;
/// -(1 - 2^-12).
const SHRUNK: Single = 0xbf7f_f000;
/// Less the largest single: the radius where there is nothing.
pub const NOTHING: Single = 0xffff_ffff;

/// A ball moved along a cone.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
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

/// The bound of a packet's rays.
#[must_use]
pub fn bound(rays: &[Ray; 16]) -> Bound {
    let is_there = rays.map(|ray| !below_zero(ray.t));
    let weight = is_there.map(|there| if there { ONE } else { ZERO });
    let count = lanes(std::array::from_fn(|lane| {
        let [first, second, third, fourth] = rows(&weight, lane);
        fa(fa(first, second), fa(third, fourth))
    }));
    let mean = reciprocal(count);
    let apex = sum(&rays.map(|ray| ray.origin), &weight).map(|sum| fm(sum, mean));
    let sum = sum(&rays.map(|ray| ray.direction), &weight);
    let inverse = rsqrt(dot(sum, sum));
    let axis = sum.map(|sum| fm(sum, inverse));

    let apart = rays.map(|ray| std::array::from_fn(|axis| fs(ray.origin[axis], apex[axis])));
    let beyond = rays.map(|ray| {
        let [dx, dy, dz] = ray.direction;
        fnms(dz, axis[2], fnms(dy, axis[1], fnms(dx, axis[0], ZERO)))
    });
    let beside: [[Single; 3]; 16] = std::array::from_fn(|ray| {
        std::array::from_fn(|k| fma(beyond[ray], axis[k], rays[ray].direction[k]))
    });
    let square = |vectors: &[[Single; 3]; 16], ray: usize| {
        let vector = vectors[ray];
        if is_there[ray] {
            dot(vector, vector)
        } else {
            ZERO
        }
    };
    let largest_n = largest(std::array::from_fn(|ray| {
        if is_there[ray] { beyond[ray] } else { ABSENT }
    }));
    let sine = sqrt(largest(std::array::from_fn(|ray| square(&beside, ray))));
    let radius = sqrt(largest(std::array::from_fn(|ray| square(&apart, ray))));

    let [x, y, z] = apex.map(|component| component & !SIGN);
    let radius = fma(fa(fa(x, y), z), SLACK, fm(radius, GROWN));
    let is_wide = fcgt(largest_n, WIDE) != 0;
    let of_cone = |value| if is_wide { ZERO } else { value };
    Bound {
        apex,
        axis: axis.map(of_cone),
        cosine: of_cone(fm(largest_n, SHRUNK)),
        sine: of_cone(fa(sine, SLACK)),
        radius: if count == ZERO { NOTHING } else { radius },
        farthest: largest(rays.map(|ray| ray.t)),
    }
}

fn dot([ax, ay, az]: [Single; 3], [bx, by, bz]: [Single; 3]) -> Single {
    fma(az, bz, fma(ay, by, fm(ax, bx)))
}

/// What a lane has in each of the rows.
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
            (1..4).fold(fm(values[0], weight[0]), |sum, row| {
                fma(values[row], weight[row], sum)
            })
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
