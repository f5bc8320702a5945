//! The twins of `encode_srgb` and `roll_off`.

use kernels::prelude::*;
use twins::display::{encode_srgb, roll_off};

type Twin = fn(Single) -> Single;

/// The kernels and their twins.
const KERNELS: [(&str, Twin); 2] = [("encode_srgb", encode_srgb), ("roll_off", roll_off)];

#[test]
fn display_is_monotonic_in_light() {
    for (name, twin) in KERNELS {
        // Of rounding, a step of the estimates' tables may be left.
        let values = (0..40_000).map(|step| to_f64(twin(from_f64(f64::from(step) / 10_000.0))));
        let mut most = 0.0_f64;
        for value in values {
            assert!(value > most - 1e-3, "{name}: {value} after {most}");
            most = most.max(value);
        }
    }
}

#[test]
fn display_keeps_0_and_1_and_rolls_off_beyond() {
    let inside = |value: Single| (0.0..=1.0).contains(&to_f64(value));
    assert_eq!(encode_srgb(0), 0);
    assert!((to_f64(encode_srgb(ONE)) - 1.0).abs() < 1e-3);
    for light in [1.01, 2.0, 100.0, 1e30] {
        assert!(to_f64(encode_srgb(from_f64(light))) > 1.0);
        assert!(inside(roll_off(from_f64(light))));
    }
    for light in [-1e-6, -0.1, -1e30] {
        assert!(to_f64(encode_srgb(from_f64(light))) <= 0.0);
        assert_eq!(roll_off(from_f64(light)), from_f64(light));
    }
}
