//! `mesh_prepare` compared with its twin, on whole blocks and on damaged ones; and what it
//! guarantees of boxes.

use kernels::bench::{Bench, random};
use kernels::cases::whitted::mesh::block::block;
use kernels::cases::whitted::mesh::call;
use kernels::vector::{in_cube, magnitude};
use rand::Rng as _;
use rand_chacha::ChaCha8Rng;
use spu_emulator::float::single::to_f64;
use twins::mesh_prepare::{CONES, HEADER, INNER, Known, LEAF, NODE, SPHERES, WORDS, prepare};

const KINDS: [u32; 4] = [INNER, LEAF, SPHERES, CONES];
/// The largest number of lowest nodes that leaves space for records in a block.
const LOWEST: usize = 11;

fn any_block(random: &mut ChaCha8Rng) -> ([u32; WORDS], Known) {
    let kind = KINDS[random.random_range(0..KINDS.len())];
    let lowest = random.random_range(1..=LOWEST);
    let half = magnitude(1e-3..1e3, random);
    let point = in_cube(100.0, random);
    block(kind, lowest, point, half, random)
}

/// Checks a block. Returns whether it is whole.
fn check(bench: &mut Bench, words: &[u32; WORDS], known: &Known) -> bool {
    let mut expected = *words;
    let whole = prepare(&mut expected, known);
    let found = call::prepare(bench, words, known);
    assert_eq!(found, whole.then_some(expected), "{words:x?} {known:x?}");
    whole
}

#[test]
fn whole_blocks_equal_the_twin() {
    let mut random = random();
    let mut bench = Bench::new();
    for _ in 0..600 {
        let (words, known) = any_block(&mut random);
        assert!(check(&mut bench, &words, &known), "{words:x?}");
    }
}

/// One word of the header or of the nodes is another one: often a bit, often a small number.
#[test]
fn damaged_blocks_are_rejected_as_by_twin() {
    let mut random = random();
    let mut bench = Bench::new();
    let mut refused = 0;
    for _ in 0..2000 {
        let (mut words, known) = any_block(&mut random);
        let nodes = words[4] as usize;
        let at = match random.random_range(0..4) {
            0 => random.random_range(0..HEADER),
            1 => random.random_range(0..WORDS),
            _ => HEADER + NODE * random.random_range(0..nodes) + 24 + random.random_range(0..4),
        };
        words[at] = match random.random_range(0..4) {
            0 => words[at] ^ 1 << random.random_range(0..32),
            1 => words[at].wrapping_add(random.random_range(0..20)).wrapping_sub(10),
            2 => random.random_range(0..20),
            _ => random.random(),
        };
        refused += usize::from(!check(&mut bench, &words, &known));
    }
    println!("{refused} of 2000");
    assert!((500..1900).contains(&refused));
}

/// A block of nothing but random bits after a header that may be right.
#[test]
fn any_bits_at_all_equal_the_twin() {
    let mut random = random();
    let mut bench = Bench::new();
    for _ in 0..1000 {
        let (mut words, known) = any_block(&mut random);
        words[HEADER..].fill_with(|| random.random());
        check(&mut bench, &words, &known);
    }
}

/// Each box holds the old one relative to the eye, with a slack of 2^-20 of its largest coordinate
/// at least; half of the slack is left for the rounding of the tests.
#[test]
fn prepared_boxes_contain_original_boxes() {
    let mut random = random();
    let mut bench = Bench::new();
    for _ in 0..300 {
        let (words, known) = any_block(&mut random);
        let after = call::prepare(&mut bench, &words, &known).expect("a whole block");
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
