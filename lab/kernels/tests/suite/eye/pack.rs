//! `pack_r16`.

use kernels::bench::{Bench, random};
use kernels::cases::eye::call;
use kernels::eye_records::Vectors;
use rand::Rng as _;
use rand::seq::SliceRandom as _;
use rand_chacha::ChaCha8Rng;
use spu_emulator::float::single::from_f64;
use twins::pack::pack;

use super::COUNTS;

/// Compares with the twin, and returns the words.
fn check(bench: &mut Bench, colours: &[Vectors], shifts: [u32; 3]) -> Vec<[u32; 16]> {
    let words = call::pack(bench, colours, shifts);
    for (colours, words) in colours.iter().zip(&words) {
        for (colour, word) in colours.iter().zip(words) {
            let expected = pack(*colour, shifts);
            assert_eq!(*word, expected, "{colour:x?}, shifts {shifts:?}");
        }
    }
    words
}

/// Different positions for the channels.
fn any_shifts(random: &mut ChaCha8Rng) -> [u32; 3] {
    let mut shifts = [0, 8, 16, 24];
    shifts.shuffle(random);
    [shifts[0], shifts[1], shifts[2]]
}

#[test]
fn colours_equal_the_twin_in_lists_of_any_length() {
    let mut random = random();
    let mut bench = Bench::new();
    for _ in 0..30 {
        for count in COUNTS {
            let mut channel = || from_f64(random.random_range(-0.25..1.25));
            let colours: Vec<Vectors> = (0..count)
                .map(|_| [[(); 3]; 16].map(|colour| colour.map(|()| channel())))
                .collect();
            let shifts = any_shifts(&mut random);
            check(&mut bench, &colours, shifts);
        }
    }
}

#[test]
fn every_byte_comes_back() {
    let mut bench = Bench::new();
    for byte in 0..=255_u32 {
        let colour = [from_f64(f64::from(byte) / 255.0); 3];
        let words = check(&mut bench, &[[colour; 16]], [16, 8, 0]);
        assert_eq!(words[0], [byte * 0x01_01_01; 16]);
    }
}

#[test]
fn what_is_beyond_0_and_1_is_0_and_1() {
    let mut bench = Bench::new();
    for (value, byte) in [
        (0x8000_0000, 0),
        (0xffff_ffff, 0),
        (from_f64(-0.001), 0),
        (from_f64(1.001), 255),
        (0x7fff_ffff, 255),
    ] {
        let words = check(&mut bench, &[[[value; 3]; 16]], [24, 8, 0]);
        assert_eq!(words[0], [byte * 0x0100_0101; 16], "{value:x}");
    }
}

#[test]
fn any_bits_at_all_equal_the_twin() {
    let mut random = random();
    let mut bench = Bench::new();
    for _ in 0..1000 {
        let colours = random.random();
        let shifts = any_shifts(&mut random);
        check(&mut bench, &[colours], shifts);
    }
}
