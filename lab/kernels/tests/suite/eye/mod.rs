//! The eye-ray kernels: against their twins bit for bit, on inputs as frames have them and on any
//! bits at all, in lists of every kind of length; and against f64 where they promise to leave out
//! nothing that can be seen.

mod conservative;
mod cull;
mod isect_pairs;
mod lists;
mod pack;
mod ray_setup;
mod shade_depth;

/// Lengths of lists: a scheduled loop takes other paths for the short ones.
const COUNTS: [usize; 6] = [1, 2, 3, 7, 16, 40];
