//! The kernels that trace packets through blocks of meshes: what they guarantee against f64 and
//! of each other.

mod bounds;
mod boxes;
mod conservative;
mod prepare;
mod rays;
mod rows;
mod triangles;
