//! Kernels of the SPU program, one by one, on the emulated SPU: against their twins bit for bit,
//! against f64 for their error, and held to the ABI.

mod harness;
mod isect_spheres;
mod pack;
mod ray_setup;
mod shade_depth;
