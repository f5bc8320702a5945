//! Random numbers and directions for tests.

use glam::DVec3;
use rand::Rng as _;
use rand_chacha::ChaCha8Rng;

/// A number between 2^`from` and 2^`to`, equally likely in each octave.
pub fn magnitude(random: &mut ChaCha8Rng, from: f64, to: f64) -> f64 {
    libm::exp2(random.random_range(from..to))
}

/// A random unit vector.
pub fn unit(random: &mut ChaCha8Rng) -> DVec3 {
    loop {
        let vector = DVec3::from_array(std::array::from_fn(|_| random.random_range(-1.0..1.0)));
        if (0.01..1.0).contains(&vector.length()) {
            return vector.normalize();
        }
    }
}

/// A vector at right angles to a unit vector.
pub fn across(random: &mut ChaCha8Rng, along: DVec3) -> DVec3 {
    along.cross(unit(random)).try_normalize().unwrap_or_else(|| along.any_orthonormal_vector())
}
