//! Corner cases of floating point that no output from hardware decides. `docs/emulator.md` states
//! the result of each, and why.
//!
//! Provenance: the architecture's text. Where it is silent, the choice that the document states.

use crate::prelude::*;
use spu_emulator::float::fpscr::Rounding;
use spu_emulator::float::{convert, double, single};

const SIGN: u32 = 0x8000_0000;
const MODES: [Rounding; 4] =
    [Rounding::NearestEven, Rounding::TowardZero, Rounding::Up, Rounding::Down];

#[test]
fn fesd_of_a_denormal_is_a_zero_of_its_sign() {
    for denormal in [1, 0x0040_0000, 0x007f_ffff] {
        assert_eq!(double::fesd(denormal), (0, Flags::DOUBLE_DENORMAL));
        let negative = double::fesd(denormal | SIGN);
        assert_eq!(negative, (1 << 63, Flags::DOUBLE_DENORMAL));
    }
    assert_eq!(double::fesd(SIGN), (1 << 63, Flags::NONE));
}

#[test]
fn frds_of_a_denormal_is_a_zero_of_its_sign_in_every_mode() {
    for mode in MODES {
        for denormal in [1, 0x000f_ffff_ffff_ffff] {
            let expected = (0, Flags::DOUBLE_DENORMAL);
            assert_eq!(double::frds(denormal, mode), expected, "{mode:?}");
            let expected = (SIGN, Flags::DOUBLE_DENORMAL);
            assert_eq!(double::frds(denormal | 1 << 63, mode), expected, "{mode:?}");
        }
    }
    // The smallest normal double is rounded like any other.
    let (up, flags) = double::frds(0x0010_0000_0000_0000, Rounding::Up);
    assert_eq!(up, 1);
    assert_eq!(flags, Flags::DOUBLE_UNDERFLOW | Flags::DOUBLE_INEXACT);
}

/// Between the largest single and 2^129, truncation alone would also give the largest single.
#[test]
fn overflow_begins_just_above_the_largest_single() {
    let overflow = Flags::OVERFLOW | Flags::DIFFERENT;
    let (one, tiny) = (0x3f80_0000, 0x3f80_0001);
    for sign in [0, SIGN] {
        let largest = single::LARGEST | sign;
        let exact = single::fm_lanes([largest], [one]);
        assert_eq!(exact, ([largest], [Flags::DIFFERENT]));
        assert_eq!(single::fm_lanes([largest], [tiny]), ([largest], [overflow]));
        // A sum that exceeds it by less than half a unit in the last place.
        let added = single::fa_lanes([largest], [one | sign]);
        assert_eq!(added, ([largest], [overflow]));
        let fused = single::fma_lanes([largest], [one], [single::SMALLEST | sign]);
        assert_eq!(fused, ([largest], [overflow]));
        let below = single::fma_lanes([largest], [one], [single::SMALLEST | sign ^ SIGN]);
        assert_eq!(below, ([largest - 1], [Flags::DIFFERENT]));
    }
}

#[test]
fn fi_differs_where_its_estimate_or_its_result_is_no_ieee_number() {
    let ordinary = estimate::frest(0x4049_0fdb);
    // The first operand is a position within the step. A denormal, a zero or an exponent of 255
    // has no special meaning.
    for position in [0, 1, 0x0007_ffff, 0x7f80_0000, 0x7fff_ffff, SIGN] {
        assert_eq!(estimate::fi_flagged(position, ordinary).1, Flags::NONE);
    }
    let of_zero = estimate::frest(0);
    assert_eq!(estimate::fi_flagged(0, of_zero).1, Flags::DIFFERENT);
    // The estimate for 2^126 is a denormal pattern.
    let denormal = estimate::frest(0x7e80_0000);
    let flushed = (0, Flags::DIFFERENT);
    assert_eq!(estimate::fi_flagged(0x7e80_0000, denormal), flushed);
    assert_eq!(estimate::fi_flagged(0, 0), (0, Flags::NONE));
    // A step larger than the base lowers the exponent. Below the smallest single that is an
    // underflow.
    let underflow = Flags::UNDERFLOW | Flags::DIFFERENT;
    assert_eq!(estimate::fi_flagged(1, 0x0080_0001), (0, underflow));
}

/// Just below the smallest normal double: tiny before rounding, but not after it.
#[test]
fn fused_doubles_underflow_if_they_are_tiny_before_rounding() {
    const SMALLEST: u64 = 0x0010_0000_0000_0000;
    let underflow = Flags::DOUBLE_UNDERFLOW | Flags::DOUBLE_INEXACT;
    // The product 2^-1022 (1 - 2^-106) of 2^-511 (1 + 2^-53) and 2^-511 (1 - 2^-53).
    let (a, b) = (0x2000_0000_0000_0001, 0x1fff_ffff_ffff_fffe);
    let mode = Rounding::NearestEven;
    assert_eq!(double::dfma(a, b, 0, mode), (SMALLEST, underflow));
    assert_eq!(double::dfms(a, b, 0, mode), (SMALLEST, underflow));
    let negative = (SMALLEST | 1 << 63, underflow);
    assert_eq!(double::dfnma(a, b, 0, mode), negative);
    assert_eq!(double::dfnms(a, b, 0, mode), negative);
    // The same product alone, and a tiny result that is exact.
    assert_eq!(double::dfm(a, b, mode), (SMALLEST, underflow));
    let half = 0x3fe0_0000_0000_0000;
    let exact = double::dfma(SMALLEST, half, 0, mode);
    assert_eq!(exact, (SMALLEST >> 1, Flags::NONE));
}

/// At the largest scale, 2^-126 would become 2.
#[test]
fn cflts_and_cfltu_of_a_denormal_are_zero() {
    for denormal in [1, 0x0040_0000, 0x007f_ffff] {
        for scale in [0, 126, 127] {
            assert_eq!(convert::cflts(denormal, scale), 0);
            assert_eq!(convert::cflts(denormal | SIGN, scale), 0);
            assert_eq!(convert::cfltu(denormal, scale), 0);
        }
    }
    assert_eq!(convert::cflts(single::SMALLEST, 127), 2);
    assert_eq!(convert::cflts(single::SMALLEST | SIGN, 127), -2_i32 as u32);
}
