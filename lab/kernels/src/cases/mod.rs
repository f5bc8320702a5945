//! Cases and measures of error, a file for each family of kernels.

pub mod eye;
pub mod flat;
pub mod formulation;
pub mod math;
pub mod sphere_ray;
pub mod spheres;
pub mod whitted;
