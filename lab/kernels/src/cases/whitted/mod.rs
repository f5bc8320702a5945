//! The kernels of Whitted's model, a file for each step of it.

pub mod bounce;
pub mod isect;
pub mod rays;
pub mod shade;
pub mod shaders;
pub mod smooth;
