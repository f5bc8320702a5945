//! Vectors, rays and random vectors, computed only with basic arithmetic and roots, which give the
//! same results on every host.

pub use kernels::vector::{cross, dot, in_cube, sub, unit};
use rand::Rng;
use twins::sphere_ray::Ray;
use twins::triangle::Triangle;
use twins::triangle_pairs::TriangleObject;
use twins::{FARTHEST, Single};

use crate::truth::Vector;

/// A ray that has hit nothing yet.
pub fn fresh(origin: [Single; 3], direction: [Single; 3]) -> Ray {
    Ray { origin, direction, t: FARTHEST, object: 0 }
}

/// A triangle that is visible from both sides.
pub fn two_sided(vertices: Triangle) -> TriangleObject {
    TriangleObject { vertices, both: true }
}

/// A vector's length.
pub fn length(vector: Vector) -> f64 {
    dot(vector, vector).sqrt()
}

/// The largest magnitude of a vector's components.
pub fn largest(vector: Vector) -> f64 {
    vector.map(f64::abs).into_iter().fold(0.0, f64::max)
}

/// a + scale b.
pub fn add_scaled(a: Vector, scale: f64, b: Vector) -> Vector {
    std::array::from_fn(|axis| a[axis] + scale * b[axis])
}

/// The nearest single, or 0 for a value that is too small.
pub fn nearest(value: f64) -> Single {
    (value as f32).to_bits()
}

/// The point with the nearest singles as coordinates.
pub fn point(vector: Vector) -> [Single; 3] {
    vector.map(nearest)
}

/// A random point within the sphere of this radius.
pub fn in_sphere(radius: f64, random: &mut impl Rng) -> Vector {
    loop {
        let vector = in_cube(1.0, random);
        if dot(vector, vector) < 1.0 {
            return vector.map(|component| radius * component);
        }
    }
}

/// A random direction, uniformly distributed.
pub fn direction(random: &mut impl Rng) -> Vector {
    loop {
        let vector = in_sphere(1.0, random);
        // Near 0, the quotient would lose digits.
        if dot(vector, vector) > 1e-4 {
            return unit(vector);
        }
    }
}

/// Two directions that are perpendicular to a third and to each other.
pub fn across(axis: Vector) -> [Vector; 2] {
    let smallest = (0..3).min_by(|a, b| axis[*a].abs().total_cmp(&axis[*b].abs())).unwrap_or(0);
    let mut other = [0.0; 3];
    other[smallest] = 1.0;
    let first = unit(add_scaled(other, -dot(other, axis), axis));
    [first, cross(axis, first)]
}

/// A random point within the disc of this radius around a point, perpendicular to an axis.
pub fn on_disc(centre: Vector, axis: Vector, radius: f64, random: &mut impl Rng) -> Vector {
    let [first, second] = across(axis);
    loop {
        let [x, y] = [(); 2].map(|()| random.random_range(-1.0..1.0));
        if x * x + y * y < 1.0 {
            return add_scaled(add_scaled(centre, radius * x, first), radius * y, second);
        }
    }
}
