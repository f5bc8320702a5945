//! The kernels from hits to pixels: properties of their results.

mod display;
mod gather;
mod leave;
mod light;
mod sums;

use kernels::vector::Vector;
use spu_emulator::float::single::to_f64;
use twins::Single;

fn vector(v: [Single; 3]) -> Vector {
    v.map(to_f64)
}
