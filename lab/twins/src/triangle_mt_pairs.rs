//! Twin of `lab/spu/isect/isect_triangle_mt_pairs_r16.s`: a ray from anywhere and a triangle,
//! Möller and Trumbore's way.

use spu_emulator::float::single::{fm, fms, fnms, fs};

use super::math::reciprocal;
use super::pairs::nearer;
use super::sphere_ray::Ray;
use super::triangle_pairs::TriangleObject;
use super::{ONE, SIGN, Single, ZERO, below_zero, dot};

type Vector = [Single; 3];

fn sub(a: Vector, b: Vector) -> Vector {
    std::array::from_fn(|axis| fs(a[axis], b[axis]))
}

fn cross(a: Vector, b: Vector) -> Vector {
    std::array::from_fn(|axis| {
        let [x, y] = [(axis + 1) % 3, (axis + 2) % 3];
        fms(a[x], b[y], fm(a[y], b[x]))
    })
}

fn minus_dot(a: Vector, b: Vector) -> Single {
    fnms(a[2], b[2], fnms(a[1], b[1], fnms(a[0], b[0], ZERO)))
}

/// The ray after its test with a triangle, whose record is at `object`.
#[must_use]
pub fn isect_triangle(ray: Ray, shape: &TriangleObject, object: u32) -> Ray {
    let [a, b, c] = shape.vertices;
    let (e1, e2) = (sub(b, a), sub(c, a));
    let s = sub(ray.origin, a);
    let p = cross(e2, ray.direction);
    let q = cross(e1, s);
    let det = dot(e1, p);
    let inverse = reciprocal(det);
    let u = fm(dot(s, p), inverse);
    let v = fm(dot(ray.direction, q), inverse);
    let n = fm(minus_dot(e2, q), inverse);
    let w = fs(fs(ONE, u), v);
    let seen = shape.both || below_zero(det);
    nearer(ray, n ^ SIGN, object, below_zero(u | v | w) || !seen)
}
