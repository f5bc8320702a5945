//! The kernels that make packets of rays, and those that cull objects that no ray of a packet can
//! hit. They are compared with their twins bit for bit, on rays like those of frames and on random
//! bits, in lists of every relevant length. Kernels that guarantee to keep everything that a ray
//! meets are also compared with f64.

mod bound;
mod conservative;
mod cull_faces;
mod cull_nodes;
mod primary_rays;
mod sample_rays;
