//! What `mesh_prepare` guarantees of boxes.

use kernels::cases::whitted::mesh::block::Prepare;
use kernels::prelude::*;
use twins::mesh_prepare::{HEADER, NODE, WORDS};

/// Each box holds the old one relative to the eye, with a slack of 2^-20 of its largest coordinate
/// at least; half of the slack is left for the rounding of the tests.
#[test]
fn prepared_boxes_contain_original_boxes() {
    let mut random = random();
    let mut bench = Bench::new();
    for _ in 0..300 {
        let inputs = Prepare::sensible(random.random_range(1..=11), &mut random);
        let after = inputs.check(&mut bench).expect("a whole block");
        let Prepare { block: words, known } = inputs;
        let eye = known.eye.map(to_f64);
        for node in 0..words[4] as usize {
            let at = HEADER + NODE * node;
            for lane in (0..4).filter(|lane| words[at + 24 + lane] != 0) {
                let plane = |words: &[u32; WORDS], corner: usize, axis: usize| {
                    to_f64(words[at + 12 * corner + 4 * axis + lane])
                };
                let was = |corner, axis| plane(&words, corner, axis) - eye[axis];
                let size = (0..6).fold(0.0_f64, |size, of| size.max(was(of / 3, of % 3).abs()));
                let slack = size / f64::from(1 << 20);
                for axis in 0..3 {
                    assert!(plane(&after, 0, axis) <= was(0, axis) - slack);
                    assert!(plane(&after, 1, axis) >= was(1, axis) + slack);
                }
            }
        }
    }
}
