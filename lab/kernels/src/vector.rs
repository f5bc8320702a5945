//! Vectors in f64, for cases and for exact results.

use rand::Rng;

/// x, y, z.
pub type Vector = [f64; 3];

/// The scalar product.
#[must_use]
pub fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// The vector product.
#[must_use]
pub fn cross(a: Vector, b: Vector) -> Vector {
    std::array::from_fn(|k| a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3])
}

/// a - b.
#[must_use]
pub fn sub(a: Vector, b: Vector) -> Vector {
    std::array::from_fn(|axis| a[axis] - b[axis])
}

/// The vector at length 1.
#[must_use]
pub fn unit(vector: Vector) -> Vector {
    let length = dot(vector, vector).sqrt();
    vector.map(|component| component / length)
}

/// A random point within the cube with this half side.
pub fn in_cube(half: f64, random: &mut impl Rng) -> Vector {
    std::array::from_fn(|_| random.random_range(-half..half))
}

/// A random number of this range, uniformly distributed over orders of magnitude.
pub fn magnitude(range: std::ops::Range<f64>, random: &mut impl Rng) -> f64 {
    libm::exp(random.random_range(libm::log(range.start)..libm::log(range.end)))
}

/// The error of `found` in ulps of a single at `exact`.
#[must_use]
pub fn ulps(found: f64, exact: f64) -> f64 {
    (found - exact).abs() / exact.abs() * 2_f64.powi(23)
}
