//! The kernels of Whitted's model.

pub mod rays;
pub mod shade;
pub mod isect;
//! Cases of the kernels of Whitted's model, a file for each step of it.

pub mod bounce;
