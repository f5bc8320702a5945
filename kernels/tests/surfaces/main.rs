//! The kernels from hits to pixels: against their twins bit for bit, on inputs as frames have them and on
//! any bits at all, in lists of every kind of length; and against f64.

mod surfaces;

/// Lengths of lists: a scheduled loop takes other paths for the short ones.
const COUNTS: [usize; 5] = [1, 2, 3, 5, 8];
