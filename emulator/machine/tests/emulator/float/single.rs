//! Compares single precision with the exact model: all pairs of edge cases, all pairs of
//! exponents, random operands.

use super::exact::Exact;
use crate::prelude::*;
use spu_emulator::float::convert;
use spu_emulator::float::single::{self, Lanes};

const SIGN: u32 = 0x8000_0000;
const RANDOM_OPERANDS: u32 = 500_000;

fn exact(x: u32) -> Exact {
    let exponent = x >> 23 & 255;
    let magnitude = if exponent == 0 { 0 } else { x & 0x7f_ffff | 0x80_0000 };
    Exact::new(x >> 31 != 0, magnitude.into(), i64::from(exponent) - 150)
}

fn negated(x: &Exact) -> Exact {
    Exact { integer: -&x.integer, exponent: x.exponent }
}

/// Whether IEEE arithmetic interprets the pattern differently: exponent 255 or denormal.
fn extended(x: u32) -> bool {
    let (exponent, fraction) = (x >> 23 & 255, x & 0x7f_ffff);
    exponent == 255 || exponent == 0 && fraction != 0
}

/// One truncation of the exact value, by the rules of the architecture, with the flags.
fn truncated(value: &Exact, operands: &[u32]) -> (u32, Flags) {
    let mut flags = Flags::DIFFERENT.when(operands.iter().any(|&x| extended(x)));
    if value.is_zero() {
        return (0, flags);
    }
    let sign = if value.is_negative() { SIGN } else { 0 };
    let largest = Exact::new(false, 0xff_ffff, 105);
    let magnitude = if value.is_negative() { negated(value) } else { value.clone() };
    if magnitude.plus(&negated(&largest)).integer > 0.into() {
        return (sign | 0x7fff_ffff, flags | Flags::OVERFLOW | Flags::DIFFERENT);
    }
    if value.top() < -126 {
        return (0, flags | Flags::UNDERFLOW | Flags::DIFFERENT);
    }
    let (significand, _) = value.in_units(value.top() - 23);
    let field = (value.top() + 127) as u32;
    let result = sign | field << 23 | significand as u32 & 0x7f_ffff;
    flags |= Flags::DIFFERENT.when(field == 255);
    (result, flags)
}

type Operation = fn([u32; 1], [u32; 1], [u32; 1]) -> Lanes<1>;

struct Case {
    name: &'static str,
    operation: Operation,
    model: fn(&Exact, &Exact, &Exact) -> Exact,
    operands: usize,
}

const fn case(
    name: &'static str,
    operands: usize,
    operation: Operation,
    model: fn(&Exact, &Exact, &Exact) -> Exact,
) -> Case {
    Case { name, operation, model, operands }
}

const CASES: [Case; 6] = [
    case("fa", 2, |a, b, _| single::fa_lanes(a, b), |a, b, _| a.plus(b)),
    case("fs", 2, |a, b, _| single::fs_lanes(a, b), |a, b, _| a.plus(&negated(b))),
    case("fm", 2, |a, b, _| single::fm_lanes(a, b), |a, b, _| a.times(b)),
    case("fma", 3, single::fma_lanes, |a, b, c| a.times(b).plus(c)),
    case("fms", 3, single::fms_lanes, |a, b, c| a.times(b).plus(&negated(c))),
    case("fnms", 3, single::fnms_lanes, |a, b, c| c.plus(&negated(&a.times(b)))),
];

fn check(case: &Case, [a, b, c]: [u32; 3]) {
    let ([result], [flags]) = (case.operation)([a], [b], [c]);
    let value = (case.model)(&exact(a), &exact(b), &exact(c));
    let expected = truncated(&value, &[a, b, c][..case.operands]);
    assert_eq!(
        (result, flags),
        expected,
        "{} {a:08x} {b:08x} {c:08x}: {result:08x}, expected {:08x}",
        case.name,
        expected.0
    );
}

fn edges() -> Vec<u32> {
    let positive = [
        0x0000_0000,
        0x0000_0001,
        0x007f_ffff,
        0x0080_0000,
        0x0080_0001,
        0x00ff_ffff,
        0x0100_0000,
        0x337f_ffff,
        0x3380_0000,
        0x3400_0001,
        0x3f00_0000,
        0x3f7f_ffff,
        0x3f80_0000,
        0x3f80_0001,
        0x3fff_ffff,
        0x4000_0000,
        0x4b7f_ffff,
        0x4b80_0000,
        0x7f00_0000,
        0x7f7f_ffff,
        0x7f80_0000,
        0x7f80_0001,
        0x7fc0_0000,
        0x7fff_fffe,
        0x7fff_ffff,
        0x2000_0000,
        0x5f7f_ffff,
        0x5f80_0000,
    ];
    positive.into_iter().flat_map(|x| [x, x | SIGN]).collect()
}

#[test]
fn edges_by_edges() {
    let edges = edges();
    for case in &CASES {
        for &a in &edges {
            for &b in &edges {
                let third = if case.operands == 3 { &edges[..] } else { &[0] };
                for &c in third {
                    check(case, [a, b, c]);
                }
            }
        }
    }
}

#[test]
fn all_pairs_of_exponents() {
    let mut random = Random::new("all pairs of exponents");
    for a in 0..256u32 {
        for b in 0..256u32 {
            let fraction = random.bits() as u32;
            for case in &CASES {
                for fractions in [(0, 0), (0x7f_ffff, 1), (fraction & 0x7f_ffff, fraction >> 9)] {
                    let (a, b) = (a << 23 | fractions.0, b << 23 | fractions.1);
                    // As a sum, it is the product with one, plus the third operand.
                    let operands = if case.operands == 3 { [a, 0x3f80_0000, b] } else { [a, b, 0] };
                    check(case, operands);
                    check(case, operands.map(|x| x ^ fraction & SIGN));
                    check(case, [operands[0] ^ SIGN, operands[1], operands[2]]);
                    if case.operands == 3 {
                        check(case, [a, b, fraction]);
                    }
                }
            }
        }
    }
}

/// Operands of several kinds: any bits, near each other, near 1, or the third near the product.
fn random_operands(random: &mut Random) -> [u32; 3] {
    let bits = random.bits();
    let [a, b, c] = [bits as u32, (bits >> 32) as u32, random.bits() as u32];
    let moderate = |x: u32| x & 0x83ff_ffff | 0x3c00_0000;
    match random.below(5) {
        0 => [a, b, c],
        1 => [moderate(a), moderate(b), moderate(c)],
        2 => [a, a ^ SIGN ^ b & 0xff, a ^ SIGN ^ c & 0x1ff_ffff],
        3 => {
            let product = single::fm(a, b);
            [a, b, (product ^ SIGN).wrapping_add(c % 5).wrapping_sub(2)]
        }
        _ => {
            let distance = (b >> 27) << 23;
            [a, a.wrapping_add(distance) ^ c & SIGN, c]
        }
    }
}

macro_rules! random {
    ($($name:ident of $case:literal)*) => {$(
        #[test]
        fn $name() {
            let mut random = Random::new(CASES[$case].name);
            for _ in 0..rounds(RANDOM_OPERANDS) {
                check(&CASES[$case], random_operands(&mut random));
            }
        }
    )*};
}
random!(fa_random of 0 fs_random of 1 fm_random of 2 fma_random of 3 fms_random of 4 fnms_random of 5);

#[test]
fn four_lanes_are_four_times_one() {
    let mut random = Random::new("lanes");
    for _ in 0..rounds(25_000) {
        let lanes: [[u32; 3]; 4] = std::array::from_fn(|_| random_operands(&mut random));
        let [a, b, c] = std::array::from_fn(|operand| lanes.map(|lane| lane[operand]));
        let (results, flags) = single::fma_lanes(a, b, c);
        for n in 0..4 {
            let ([result], [flag]) = single::fma_lanes([a[n]], [b[n]], [c[n]]);
            assert_eq!((results[n], flags[n]), (result, flag));
        }
        assert_eq!(single::fma(a[0], b[0], c[0]), results[0]);
        assert_eq!(single::fs(a[1], b[1]), single::fs_lanes(a, b).0[1]);
    }
}

/// Provenance: another emulator's model, which passed a self-test on hardware.
#[test]
fn distant_terms_of_unlike_sign_are_truncated_exactly() {
    assert_eq!(single::fs(0x0080_0000, 0x3f80_0000), 0xbf7f_ffff);
}

#[test]
fn compares_order_as_values_do() {
    let edges = edges();
    let mask = |condition| if condition { u32::MAX } else { 0 };
    let key = |x: u32| single::to_f64(x);
    for &a in &edges {
        for &b in &edges {
            assert_eq!(single::fceq(a, b), mask(key(a) == key(b)), "{a:08x} {b:08x}");
            assert_eq!(single::fcgt(a, b), mask(key(a) > key(b)), "{a:08x} {b:08x}");
            assert_eq!(single::fcmeq(a, b), mask(key(a).abs() == key(b).abs()));
            assert_eq!(single::fcmgt(a, b), mask(key(a).abs() > key(b).abs()));
        }
    }
}

#[test]
fn widening_is_exact_and_narrowing_truncates() {
    let mut random = Random::new("widening");
    for x in edges().into_iter().chain((0..rounds(RANDOM_OPERANDS)).map(|_| random.bits() as u32)) {
        let wide = single::to_f64(x);
        let value = exact(x);
        let expected = value.in_units(value.exponent).0 as f64 * 2f64.powi(value.exponent as i32);
        assert_eq!(wide.abs(), expected, "{x:08x}");
        let canonical = if x >> 23 & 255 == 0 { 0 } else { x };
        assert_eq!(single::from_f64(wide), canonical, "{x:08x}");
        if canonical != 0 {
            let above = f64::from_bits(wide.to_bits() | 0x1fff_ffff);
            assert_eq!(single::from_f64(above), x, "{x:08x}");
        }
    }
    assert_eq!(single::from_f64(f64::INFINITY), 0x7fff_ffff);
    assert_eq!(single::from_f64(f64::NEG_INFINITY), 0xffff_ffff);
    assert_eq!(single::from_f64(f64::NAN) & !SIGN, 0x7fff_ffff);
    assert_eq!(single::from_f64(-1e-39), 0);
    assert_eq!(single::from_f64(5e-324), 0);
}

#[test]
fn conversions_match_the_model() {
    let mut random = Random::new("conversions");
    for round in 0..u64::from(rounds(100_000)) {
        let scale = (round % 128) as i32;
        let x = if round % 3 == 0 { edges()[round as usize % 56] } else { random.bits() as u32 };
        // Exponents at which integers neither vanish nor saturate.
        let near = (x & 0x807f_ffff)
            | ((127 + 33 - scale).max(1) as u32
                - (x >> 8) % 34 % (161 - scale).clamp(1, 34) as u32)
                << 23;
        let x = if round % 2 == 0 { near } else { x };

        let integer = |value: i64| Exact::new(value < 0, value.unsigned_abs(), -i64::from(scale));
        assert_eq!(
            convert::csflt_flagged(x, scale),
            truncated(&integer((x as i32).into()), &[]),
            "csflt {x:08x} {scale}"
        );
        assert_eq!(
            convert::cuflt_flagged(x, scale),
            truncated(&integer(x.into()), &[]),
            "cuflt {x:08x} {scale}"
        );

        let value = exact(x);
        let scaled = Exact { exponent: value.exponent + i64::from(scale), ..value };
        let whole = if !scaled.is_zero() && scaled.top() > 40 {
            u64::MAX >> 1
        } else {
            scaled.in_units(0).0
        } as i64;
        let signed = if x & SIGN != 0 { -whole } else { whole };
        let saturated = signed.clamp(i32::MIN.into(), i32::MAX.into()) as u32;
        assert_eq!(convert::cflts(x, scale), saturated, "cflts {x:08x} {scale}");
        assert_eq!(
            convert::cfltu(x, scale),
            signed.clamp(0, u32::MAX.into()) as u32,
            "cfltu {x:08x} {scale}"
        );
    }
}

/// The relative error of estimate and interpolation, over the whole step of every table entry.
/// Provenance: the published accuracy of the two instructions, 12 bits.
#[test]
fn every_entry_estimates_to_twelve_bits() {
    for exponent in 1..=252u32 {
        for entry in 0..32u32 {
            for position in [0, 1, 0x1_ffff, 0x2_0000, 0x3_fffe, 0x3_ffff] {
                let x = exponent << 23 | entry << 18 | position;
                for sign in [0, SIGN] {
                    let reciprocal =
                        single::to_f64(estimate::fi(x | sign, estimate::frest(x | sign)));
                    let error = (reciprocal * single::to_f64(x | sign) - 1.0).abs();
                    assert!(error < 2f64.powi(-12), "frest {x:08x}: {error:e}");
                    let root = single::to_f64(estimate::fi(x, estimate::frsqest(x | sign)));
                    let error = (root * single::to_f64(x).sqrt() - 1.0).abs();
                    assert!(error < 2f64.powi(-12), "frsqest {x:08x}: {error:e}");
                }
            }
        }
    }
}

/// Provenance: worked from the rules of the architecture.
#[test]
fn estimates_at_the_ends() {
    assert_eq!(estimate::frest(0) >> 23, 255);
    assert_eq!(estimate::frest(SIGN) >> 23, 511);
    assert_eq!(estimate::frsqest(SIGN) >> 23, 255);
    assert!(estimate::divides_by_zero(0x007f_ffff) && !estimate::divides_by_zero(0x0080_0000));
    let refined = |x: u32| {
        let y = estimate::fi(x, estimate::frest(x));
        single::fma(single::fnms(x, y, 0x3f80_0000), y, y)
    };
    assert_eq!(refined(0), 0x7fff_ffff);
    assert_eq!(refined(0x7e80_0000), 0, "2^126");
    assert_eq!(refined(0x3f80_0000), 0x3f7f_ffff, "1 ulp below");
    assert_eq!(estimate::frest(0x7e80_0000) >> 23, 0);
    assert_ne!(estimate::frest(0x7e80_0000), 0, "the word itself is not flushed");
}

#[test]
fn interpolation_is_exact_and_truncated() {
    let mut random = Random::new("fi");
    for _ in 0..rounds(RANDOM_OPERANDS) {
        let bits = random.bits();
        let (a, estimate_word) = (bits as u32, (bits >> 32) as u32);
        // 1.base - 0.000step * Y, with base and step in units of 2^-13 and Y in units of 2^-19.
        let one = Exact::new(false, 1 << 13 | u64::from(estimate_word >> 10 & 0x1fff), -13);
        let step = Exact::new(true, u64::from(estimate_word & 0x3ff), -13);
        let part = Exact::new(false, u64::from(a & 0x7_ffff), -19);
        let exponent = estimate_word >> 23 & 255;
        let mut value = one.plus(&step.times(&part));
        value.exponent += i64::from(exponent) - 127;
        if estimate_word & SIGN != 0 {
            value = negated(&value);
        }
        if exponent == 0 {
            value = Exact::new(false, 0, 0);
        }
        assert_eq!(
            estimate::fi_flagged(a, estimate_word),
            truncated(&value, &[estimate_word]),
            "fi {a:08x} {estimate_word:08x}"
        );
    }
}
