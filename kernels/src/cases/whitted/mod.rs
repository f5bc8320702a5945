//! The kernels of Whitted's model.

pub mod rays;
