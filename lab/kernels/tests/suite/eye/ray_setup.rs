//! `ray_setup_r16`.

use kernels::bench::{Bench, random};
use kernels::cases::eye::{call, error};
use kernels::description::any_bits;
use kernels::eye_records;
use kernels::source::Source;
use rand::Rng as _;
use spu_emulator::float::single::from_f64;
use twins::FARTHEST;
use twins::ray_setup::{Basis, ray_setup};

use super::COUNTS;

/// The first column and row whose pixel numbers are not exact in single precision.
const PIXELS_END: u32 = 1 << 23;

fn check(bench: &mut Bench, basis: &Basis, pixels: &[[u32; 2]], background: u32) {
    let packets = call::ray_setup(bench, basis, pixels, background);
    for ([x, y], packet) in pixels.iter().zip(&packets) {
        for (lane, found) in (0..).zip(eye_records::directions(packet)) {
            let (x, y) = ((x + lane % 4) as i32, (y + lane / 4) as i32);
            let expected = ray_setup(basis, x, y);
            assert_eq!(found, expected, "{basis:x?}, pixel {x}, {y}");
        }
        for hit in eye_records::hits(packet) {
            assert_eq!((hit.t, hit.object), (FARTHEST, background));
        }
    }
}

#[test]
fn cameras_equal_the_twin_in_lists_of_any_length() {
    let mut random = random();
    let mut bench = Bench::new();
    for _ in 0..20 {
        for count in COUNTS {
            let basis = error::camera(&mut random);
            let pixels: Vec<[u32; 2]> =
                (0..count).map(|_| [0; 2].map(|_: u32| random.random_range(0..2048) * 4)).collect();
            check(&mut bench, &basis, &pixels, random.random());
        }
    }
}

#[test]
fn any_bits_at_all_equal_the_twin() {
    let mut random = random();
    let mut bench = Bench::new();
    for _ in 0..1000 {
        let basis = any_bits(&mut random);
        let pixels = [0; 2].map(|_: u32| random.random_range(0..PIXELS_END - 4));
        check(&mut bench, &basis, &[pixels], random.random());
    }
}

#[test]
fn directions_with_zeros_and_extreme_lengths() {
    let header = Source::find("ray_setup_r16").and_then(Source::header);
    let stated = header.and_then(|header| header.stated_error()).expect("an error");
    let mut bench = Bench::new();
    for scale in [1e-9, 1.0, 1e9] {
        for axis in 0..3 {
            let mut corner = [0; 3];
            corner[axis] = from_f64(scale);
            let basis = Basis { corner, right: [0; 3], down: [0x8000_0000; 3] };
            let error = error::error_of_rays(&mut bench, &basis, &[[0, 8188]]);
            assert!(error <= stated, "{basis:x?}: {error}");
        }
    }
}
