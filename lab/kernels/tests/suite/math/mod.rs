//! Reciprocals, square roots and their reciprocals. Kernels are compared with their twins bit for
//! bit, and the twins with exact results for every fraction that an operand can have.

use kernels::cases::math::error::{accuracy, ulps};
use kernels::cases::math::{FUNCTIONS, Function, Quantity, call, operand};
use kernels::prelude::*;
use kernels::source::Source;
use spu_emulator::float::single::{LARGEST, SMALLEST};
use twins::math::{reciprocal, rsqrt};

/// The sign bit of a word.
const SIGN: u32 = 1 << 31;

/// The largest error and the operand that has it, as the header states them.
fn stated(function: &Function) -> (f64, Single) {
    let header = Source::find(function.kernel).and_then(Source::header);
    let header = header.expect("a header");
    let largest = header.stated_error().expect("an error");
    let worst = header.error.split_once("0x").expect("a worst operand").1;
    let worst = Single::from_str_radix(&worst[..8], 16).expect("a worst operand");
    (largest, worst)
}

/// Operands where the estimate changes to another entry of its table or to another exponent.
#[test]
fn estimates_at_table_borders_equal_twin() {
    let mut bench = Bench::new();
    let mut operands = Vec::new();
    for exponent in [0, 1, 2, 3, 26, 27, 28, 126, 127, 128, 251, 252, 253, 254, 255] {
        for entry in 0..32 {
            let border: Single = (exponent << 5 | entry) << 18;
            for beside in -2..=2 {
                let operand = border.wrapping_add_signed(beside);
                operands.extend([operand, operand ^ SIGN]);
            }
        }
    }
    let (operands, rest) = operands.as_chunks();
    assert!(rest.is_empty(), "a number of quadwords");
    for function in &FUNCTIONS {
        let found = call(&mut bench, function.kernel, operands);
        for (quadword, found) in operands.iter().zip(found) {
            let expected = quadword.map(function.twin);
            assert_eq!(found, expected, "{} of {quadword:x?}", function.kernel);
        }
    }
}

/// The largest error equals the header's: it is not larger and hardly smaller, and the operand
/// that the header names has it.
#[test]
fn errors_over_all_fractions_are_those_that_headers_state() {
    let mut bench = Bench::new();
    for function in &FUNCTIONS {
        let found = accuracy(function);
        println!("{}: {found:x?}", function.kernel);
        let (largest, worst) = stated(function);
        assert!(found.largest <= largest, "{}", function.kernel);
        let near = largest * 0.999 - 0.01;
        assert!(found.largest > near, "{} is better", function.kernel);
        assert_eq!(found.worst, worst, "{}: {worst:x}", function.kernel);
        let result = call(&mut bench, function.kernel, &[[worst; 4]])[0][0];
        let error = ulps(function, worst, result);
        assert!((error - found.largest).abs() < 1e-9, "{}", function.kernel);
        assert!(found.mean < found.most && found.most <= found.largest);
    }
}

/// At the ends of the domain, no relevant value is flushed or saturated.
#[test]
fn errors_hold_to_the_ends_of_the_domains() {
    for function in &FUNCTIONS {
        let all = function.quantity.all_fractions();
        let span = all.end() - all.start();
        let [min, max] = function.domain;
        let (stated, _) = stated(function);
        for operand in (min..min + span).chain(max - span..=max).step_by(3) {
            let error = ulps(function, operand, (function.twin)(operand));
            assert!(error <= stated, "{} of {operand:x}: {error}", function.kernel);
        }
    }
}

/// Each step is worth its cycles, because it lowers the mean error.
#[test]
fn every_step_lowers_the_error() {
    let all: Vec<f64> = FUNCTIONS.iter().map(|function| accuracy(function).mean).collect();
    for steps in all.chunks(4) {
        println!("{steps:?}");
        assert!(steps.is_sorted_by(|before, after| before > after), "{steps:?}");
    }
}

/// The manual states that with one Newton step the reciprocal is the truncated one or the single
/// below it, and that the reciprocal root is wrong by at most one single.
#[test]
fn one_newton_step_keeps_manuals_error() {
    for operand in Quantity::Reciprocal.all_fractions() {
        let exact = from_f64(1.0 / to_f64(operand));
        let below = exact.wrapping_sub(reciprocal(operand));
        assert!(below <= 1, "1/{operand:x} is {below} below");
    }
    for operand in Quantity::ReciprocalRoot.all_fractions() {
        let exact = from_f64(1.0 / to_f64(operand).sqrt());
        let off = exact.abs_diff(rsqrt(operand));
        assert!(off <= 1, "1/sqrt({operand:x}) is {off} off");
    }
}

/// Zeros, including words that would be denormal elsewhere.
const ZEROS: [Single; 5] = [0, SIGN, 1, SMALLEST - 1, SIGN | 0x0012_3456];

/// 2^128.
const ENORMOUS: Single = 0x7f80_0000;

#[test]
fn operand_0_gives_root_0_and_huge_reciprocal() {
    for function in &FUNCTIONS {
        for zero in ZEROS {
            let found = (function.twin)(zero);
            let as_stated = match function.quantity {
                Quantity::Root => found == 0,
                Quantity::Reciprocal => found & SIGN == zero & SIGN && found & !SIGN >= ENORMOUS,
                Quantity::ReciprocalRoot => found & SIGN == 0 && found >= ENORMOUS,
            };
            assert!(as_stated, "{} of {zero:x}: {found:x}", function.kernel);
        }
    }
    for function in &FUNCTIONS[2..4] {
        let found = [0, SIGN].map(function.twin);
        assert_eq!(found, [LARGEST, LARGEST | SIGN], "{}", function.kernel);
    }
}

#[test]
fn reciprocals_of_enormous_operands_are_zero() {
    for function in &FUNCTIONS[..4] {
        for operand in [0x7e80_0000, 0x7f12_3456, LARGEST] {
            for operand in [operand, operand | SIGN] {
                let found = to_f64((function.twin)(operand));
                assert!(found == 0.0, "{} of {operand:x}", function.kernel);
            }
        }
    }
}

/// Roots of negative operands are those of the magnitude, except with Newton's steps, whose result
/// is meaningless.
#[test]
fn unrefined_roots_of_negative_operands_are_those_of_their_magnitudes() {
    let mut random = random();
    for function in [&FUNCTIONS[4..6], &FUNCTIONS[8..10]].into_iter().flatten() {
        let sign = if function.quantity == Quantity::Root { SIGN } else { 0 };
        for _ in 0..10_000 {
            let operand = operand(&mut random, function);
            let negative = (function.twin)(operand | SIGN);
            assert_eq!(negative, (function.twin)(operand) | sign, "{operand:x}");
        }
    }
}

/// Operands below the domain of the refined roots.
#[test]
fn roots_of_tiny_operands_lose_what_is_flushed() {
    let largest = |function: &Function, power: i32, end: i32| {
        let [first, end] = [power, end].map(|power| ((power + 127) as Single) << 23);
        let operands = (first..end).step_by(7);
        let errors = operands.map(|operand| ulps(function, operand, (function.twin)(operand)));
        errors.fold(0.0, f64::max)
    };
    for function in &FUNCTIONS[10..] {
        let stated = stated(function).0;
        assert!(largest(function, -104, -102) <= stated, "{}", function.kernel);
        let at_106 = largest(function, -106, -104);
        assert!((stated..=4.0).contains(&at_106), "{}: {at_106}", function.kernel);
        for operand in (SMALLEST..=0x05ff_ffff).step_by(7) {
            let unrefined = (FUNCTIONS[9].twin)(operand);
            assert_eq!((function.twin)(operand), unrefined, "{operand:x}");
        }
    }
}
