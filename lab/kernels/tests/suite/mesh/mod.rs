//! The kernels that trace packets through blocks of meshes: bit for bit against their twins, on
//! rays like those of frames and on random bits, in lists of every relevant length; and what they
//! guarantee against f64.

mod bounds;
mod boxes;
mod conservative;
mod patches;
mod prepare;
mod rays;
mod rows;
mod triangles;

/// Lengths of lists. A scheduled loop takes other paths for the short ones.
const COUNTS: [usize; 7] = [0, 1, 2, 3, 7, 16, 40];
