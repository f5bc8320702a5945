//! The kernels that make packets of rays and those that leave out what no ray of a packet meets:
//! against their twins bit for bit, on rays as tracing makes them and on any bits at all, in lists
//! of every kind of length; and against f64 where they promise to leave out nothing that a ray
//! meets.

mod bound;
mod conservative;
mod cull_faces;
mod cull_nodes;
mod load_rays;
mod primary_rays;

/// Lengths of lists: a scheduled loop takes other paths for the short ones.
const COUNTS: [usize; 6] = [1, 2, 3, 7, 16, 40];
