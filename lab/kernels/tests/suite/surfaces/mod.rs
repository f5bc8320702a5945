//! The kernels from hits to pixels. They are compared with their twins bit for bit, on inputs like
//! those of frames and on random bits, in lists of every relevant length, and with f64.

mod display;
mod gather;
mod leave;
mod light;
mod sums;

use kernels::vector::Vector;
use protocol::layout::Surfaces;
use rand::Rng as _;
use rand_chacha::ChaCha8Rng;
use spu_emulator::float::single::to_f64;
use twins::Single;
use twins::surfaces::Surface;
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

fn any_bits_of_a_surface(random: &mut ChaCha8Rng) -> Surface {
    Surface {
        point: random.random(),
        plane: random.random(),
        leave: random.random(),
        colour: random.random(),
        diffuse: random.random(),
        highlight: random.random(),
        exponent: random.random(),
        mirror: random.random(),
        transmittance: random.random(),
        ratio: random.random(),
        schlick: random.random(),
        grazing: random.random(),
        lit: random.random(),
        flags: random.random(),
    }
}

fn vector(v: [Single; 3]) -> Vector {
    v.map(to_f64)
}
