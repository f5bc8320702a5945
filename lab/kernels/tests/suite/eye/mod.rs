//! Properties of the kernels for primary rays.

mod conservative;
mod packets;
mod spheres;
