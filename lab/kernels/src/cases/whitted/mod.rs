//! The kernels of Whitted's model. Each step of it has a file.

pub mod bounce;
pub mod colour;
pub mod cuts;
pub mod height;
pub mod isect;
pub mod mesh;
pub mod portal;
pub mod rays;
pub mod shade;
pub mod shaders;
pub mod shades;
pub mod smooth;
pub mod texture;
