//! Twin of `lab/spu/isect/shear_r16.s`, `shear_packets_r16.s`, `isect_triangles_r16.s`,
//! `any_triangles_r16.s` and `isect_triangle_r1.s`: rays and triangles, watertight.

use spu_emulator::float::single::{fa, fcmgt, fm, fma, fms, fnms, fs};

use super::flat::{FlatHit, Meeting, over};
use super::math::reciprocal;
use super::{SIGN, Single};

/// 1 + 2^-22: makes up for what truncation takes off on average.
const ABOVE_ONE: Single = 0x3f80_0002;

/// A triangle's vertices.
pub type Triangle = [[Single; 3]; 3];

/// A ray's direction and origin after the shear: its axes in a new order, the longest last, and
/// the slopes against that one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shear {
    /// Which component of a point is x, y, z here.
    pub axes: [usize; 3],
    /// Origin, in that order.
    pub origin: [Single; 3],
    /// Direction x/z and y/z.
    pub slopes: [Single; 2],
    /// -1 / direction z.
    pub minus_per_z: Single,
}

/// The shear of a ray.
#[must_use]
pub fn shear(origin: [Single; 3], direction: [Single; 3]) -> Shear {
    let [dx, dy, dz] = direction;
    let of_two = usize::from(fcmgt(dy, dx) != 0);
    let longest = if fcmgt(dz, direction[of_two]) != 0 { 2 } else { of_two };
    let axes = [(longest + 1) % 3, (longest + 2) % 3, longest];
    let [x, y, z] = axes.map(|axis| direction[axis]);
    let inverse = reciprocal(z);
    let slopes = [x, y].map(|component| {
        let quotient = fm(component, inverse);
        let remainder = fnms(quotient, z, component);
        fma(remainder, inverse, quotient)
    });
    Shear { axes, origin: axes.map(|axis| origin[axis]), slopes, minus_per_z: inverse ^ SIGN }
}

/// a b - c d, right to its last bits.
fn side_of_edge(a: Single, b: Single, c: Single, d: Single) -> Single {
    let product = fm(c, d);
    let remainder = fms(c, d, product);
    fs(fms(a, b, product), remainder)
}

/// Where the ray meets the triangle's plane; and the sum of the edges, which has the sign of the
/// ray's direction z if the vertices go counter-clockwise.
pub(super) fn meet(ray: &Shear, triangle: &Triangle) -> (Meeting, Single) {
    let seen = triangle.map(|vertex| {
        let [x, y, z]: [Single; 3] =
            std::array::from_fn(|axis| fs(vertex[ray.axes[axis]], ray.origin[axis]));
        [fnms(ray.slopes[0], z, x), fnms(ray.slopes[1], z, y), z]
    });
    let [[xa, ya, za], [xb, yb, zb], [xc, yc, zc]] = seen;
    let u = side_of_edge(xc, yb, yc, xb);
    let v = side_of_edge(xa, yc, ya, xc);
    let w = side_of_edge(xb, ya, yb, xa);
    let sum = fa(fa(u, v), w);
    let inverse = over(ABOVE_ONE, sum);
    let [u, v, w] = [u, v, w].map(|edge| fm(edge, inverse));
    let depth = fma(w, zc, fma(v, zb, fm(u, za)));
    let meeting = Meeting { n: fm(depth, ray.minus_per_z), u, v, outside: u | v | w };
    (meeting, sum)
}

/// The nearest of `hit` and the hits with `triangles`, whose numbers begin with `first`.
#[must_use]
pub fn isect_triangles(ray: &Shear, triangles: &[Triangle], first: u32, hit: FlatHit) -> FlatHit {
    (first..)
        .zip(triangles)
        .fold(hit, |nearest, (object, triangle)| meet(ray, triangle).0.nearer(nearest, object))
}

/// Whether any of `triangles` is hit nearer than `farthest`.
#[must_use]
pub fn any_triangle(ray: &Shear, triangles: &[Triangle], farthest: Single) -> bool {
    triangles.iter().any(|triangle| meet(ray, triangle).0.hits(farthest))
}
