//! The kernels from hits to pixels. They are compared with their twins bit for bit, on inputs like
//! those of frames and on random bits, in lists of every relevant length, and with f64.

mod display;
mod gather;
mod leave;
mod light;
mod sums;

use kernels::vector::Vector;
use protocol::layout::Surfaces;
use spu_emulator::float::single::to_f64;
use twins::Single;
use zerocopy::IntoBytes as _;

/// Lengths of lists. A scheduled loop takes other paths for the short ones.
const COUNTS: [usize; 5] = [1, 2, 3, 5, 8];

/// Compares field by field.
fn assert_same(found: &Surfaces, expected: &Surfaces, of: &str) {
    for field in Surfaces::RECORD.fields {
        let bytes = field.offset..field.offset + field.size;
        assert_eq!(
            found.as_bytes()[bytes.clone()],
            expected.as_bytes()[bytes],
            "{} of {of}",
            field.name
        );
    }
}

fn vector(v: [Single; 3]) -> Vector {
    v.map(to_f64)
}
