//! Cases and measures of error. Each family of kernels has a file.

pub mod eye;
pub mod flat;
pub mod formulation;
pub mod math;
pub mod meshes;
pub mod sphere_ray;
pub mod spheres;
pub mod whitted;
