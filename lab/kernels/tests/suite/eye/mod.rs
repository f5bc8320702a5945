//! The kernels for primary rays. They are compared with their twins bit for bit, on inputs like
//! those of frames and on random bits, in lists of every relevant length. Kernels that guarantee
//! to cull nothing visible are also compared with f64.

mod conservative;
mod cull;
mod isect_pairs;
mod lists;
mod pack;
mod ray_setup;
mod shade_depth;

/// Lengths of lists. A scheduled loop takes other paths for the short ones.
const COUNTS: [usize; 6] = [1, 2, 3, 7, 16, 40];
