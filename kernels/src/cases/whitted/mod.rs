//! The kernels of Whitted's model.

pub mod rays;
pub mod shade;
pub mod isect;
