//! The kernels from hits to pixels: properties of their results.

use kernels::prelude::*;

mod display;
mod gather;
mod leave;
mod light;
mod sums;

fn vector(v: [Single; 3]) -> Vector {
    v.map(to_f64)
}
