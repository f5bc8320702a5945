//! Compares double precision with the exact model in four rounding modes, and with the host's IEEE
//! arithmetic.

use super::exact::Exact;
use crate::prelude::*;
use spu_emulator::float::double;
use spu_emulator::float::fpscr::Rounding;

const SIGN: u64 = 1 << 63;
const INFINITY: u64 = 0x7ff0_0000_0000_0000;
const NAN: u64 = 0x7ff8_0000_0000_0000;
const SIGNALLING: u64 = 0x7ff0_0000_0000_0001;
const RANDOM_OPERANDS: u32 = 500_000;
const MODES: [Rounding; 4] =
    [Rounding::NearestEven, Rounding::TowardZero, Rounding::Up, Rounding::Down];

/// A finite operand. Denormals count as zero.
fn exact(x: u64) -> Exact {
    let exponent = x >> 52 & 0x7ff;
    let magnitude = if exponent == 0 { 0 } else { x & ((1 << 52) - 1) | 1 << 52 };
    Exact::new(x >> 63 != 0, magnitude, exponent as i64 - 1075)
}

/// Rounds a nonzero value to a format with `fraction` bits and this largest exponent.
fn rounded(value: &Exact, rounding: Rounding, fraction: i64, largest: i64) -> (u64, Flags) {
    let negative = value.is_negative();
    let tiny = value.top() < 1 - largest;
    let unit = value.top().max(1 - largest) - fraction;
    let (whole, rest) = value.in_units(unit);
    let away = match rounding {
        Rounding::NearestEven => rest == 3 || rest == 2 && whole & 1 == 1,
        Rounding::TowardZero => false,
        Rounding::Up => rest != 0 && !negative,
        Rounding::Down => rest != 0 && negative,
    };
    let result = Exact::new(negative, whole + u64::from(away), unit);
    let field_bits = 64 - (2 * largest as u64 + 1).leading_zeros() as i64;
    let sign = u64::from(negative) << (fraction + field_bits);
    let mut flags = Flags::DOUBLE_INEXACT.when(rest != 0);
    if result.is_zero() {
        return (sign, flags | Flags::DOUBLE_UNDERFLOW);
    }
    if result.top() > largest {
        let infinity = (2 * largest as u64 + 1) << fraction;
        let stays = match rounding {
            Rounding::NearestEven => false,
            Rounding::TowardZero => true,
            Rounding::Up => negative,
            Rounding::Down => !negative,
        };
        let flags = Flags::DOUBLE_OVERFLOW | Flags::DOUBLE_INEXACT;
        return (sign | (infinity - u64::from(stays)), flags);
    }
    flags |= Flags::DOUBLE_UNDERFLOW.when(tiny && rest != 0);
    let (significand, _) = result.in_units(unit);
    let magnitude = if result.top() < 1 - largest {
        significand
    } else {
        let (significand, _) = result.in_units(result.top() - fraction);
        ((result.top() + largest) as u64) << fraction | significand & ((1 << fraction) - 1)
    };
    (sign | magnitude, flags)
}

fn is_nan(x: u64) -> bool {
    x & !SIGN > INFINITY
}

fn is_infinite(x: u64) -> bool {
    x & !SIGN == INFINITY
}

fn is_zero(x: u64) -> bool {
    x >> 52 & 0x7ff == 0
}

fn operand_flags(operands: &[u64]) -> Flags {
    operands.iter().fold(Flags::NONE, |flags, &x| {
        flags
            | Flags::DOUBLE_NAN.when(is_nan(x))
            | Flags::DOUBLE_INVALID.when(is_nan(x) && x >> 51 & 1 == 0)
            | Flags::DOUBLE_DENORMAL.when(is_zero(x) && x << 12 != 0)
    })
}

/// a * b + t by the rules. `a + b` is `a * 1 + b`, and `product_alone` omits t.
fn model(a: u64, b: u64, t: u64, product_alone: bool, rounding: Rounding) -> (u64, Flags) {
    let invalid = (NAN, Flags::DOUBLE_INVALID);
    let operands = if product_alone { vec![a, b] } else { vec![a, b, t] };
    let zero_by_infinity = is_zero(a) && is_infinite(b) || is_infinite(a) && is_zero(b);
    if zero_by_infinity {
        return invalid;
    }
    if operands.iter().any(|&x| is_nan(x)) {
        return (NAN, Flags::NONE);
    }
    let product_sign = (a ^ b) & SIGN;
    if is_infinite(a) || is_infinite(b) {
        let product = product_sign | INFINITY;
        let cancels = !product_alone && is_infinite(t) && t != product;
        return if cancels { invalid } else { (product, Flags::NONE) };
    }
    let product = exact(a).times(&exact(b));
    if product_alone {
        return if product.is_zero() {
            (product_sign, Flags::NONE)
        } else {
            rounded(&product, rounding, 52, 1023)
        };
    }
    if is_infinite(t) {
        return (t, Flags::NONE);
    }
    let sum = product.plus(&exact(t));
    if sum.is_zero() {
        let both_negative_zero = product.is_zero() && product_sign != 0 && t & SIGN != 0;
        let both_positive_zero = product.is_zero() && product_sign == 0 && t & SIGN == 0;
        let negative = both_negative_zero || !both_positive_zero && rounding == Rounding::Down;
        return (if negative { SIGN } else { 0 }, Flags::NONE);
    }
    rounded(&sum, rounding, 52, 1023)
}

fn check(a: u64, b: u64, t: u64, mode: Rounding) {
    const ONE: u64 = 0x3ff0_0000_0000_0000;
    let with =
        |(value, flags): (u64, Flags), operands: &[u64]| (value, flags | operand_flags(operands));
    let inputs = format!("{a:016x} {b:016x} {t:016x} {mode:?}");
    let not_nan_sign = |value: u64| if value == NAN { value } else { value ^ SIGN };
    let negate = |(value, flags)| (not_nan_sign(value), flags);
    let all = [a, b, t];
    assert_eq!(
        double::dfa(a, b, mode),
        with(model(a, ONE, b, false, mode), &[a, b]),
        "dfa {inputs}"
    );
    assert_eq!(
        double::dfs(a, b, mode),
        with(model(a, ONE, b ^ SIGN, false, mode), &[a, b]),
        "dfs {inputs}"
    );
    assert_eq!(double::dfm(a, b, mode), with(model(a, b, 0, true, mode), &[a, b]), "dfm {inputs}");
    let plus = with(model(a, b, t, false, mode), &all);
    assert_eq!(double::dfma(a, b, t, mode), plus, "dfma {inputs}");
    assert_eq!(double::dfnma(a, b, t, mode), negate(plus), "dfnma {inputs}");
    let minus = with(model(a, b, t ^ SIGN, false, mode), &all);
    assert_eq!(double::dfms(a, b, t, mode), minus, "dfms {inputs}");
    assert_eq!(double::dfnms(a, b, t, mode), negate(minus), "dfnms {inputs}");
}

fn edges() -> Vec<u64> {
    let positive = [
        0,
        1,
        0x000f_ffff_ffff_ffff,
        0x0010_0000_0000_0000,
        0x0010_0000_0000_0001,
        0x001f_ffff_ffff_ffff,
        0x3ca0_0000_0000_0000,
        0x3ca0_0000_0000_0001,
        0x3fe0_0000_0000_0000,
        0x3fef_ffff_ffff_ffff,
        0x3ff0_0000_0000_0000,
        0x3ff0_0000_0000_0001,
        0x4340_0000_0000_0000,
        0x7fe0_0000_0000_0000,
        0x7fef_ffff_ffff_ffff,
        INFINITY,
        SIGNALLING,
        NAN,
        0x1ff8_0000_0000_0000,
        0x2000_0000_0000_0001,
    ];
    positive.into_iter().flat_map(|x| [x, x | SIGN]).collect()
}

#[test]
fn edges_by_edges() {
    let edges = edges();
    for &a in &edges {
        for &b in &edges {
            for &t in &edges {
                for mode in MODES {
                    check(a, b, t, mode);
                }
            }
        }
    }
}

fn random_operands(random: &mut Random) -> [u64; 3] {
    let [a, b, c] = [random.bits(), random.bits(), random.bits()];
    let moderate = |x: u64| x & 0x801f_ffff_ffff_ffff | 0x3fe0_0000_0000_0000;
    // Sums and products of numbers of few digits are often exact.
    let short = |x: u64| moderate(x) & 0xffff_ffc0_0000_0000;
    match random.below(6) {
        0 => [a, b, c],
        1 => [moderate(a), moderate(b), moderate(c)],
        2 => [a, a ^ SIGN ^ b & 0xff, a ^ SIGN ^ c & 0x3f_ffff_ffff_ffff],
        3 => {
            let (product, _) = double::dfm(a, b, Rounding::TowardZero);
            [a, b, (product ^ SIGN).wrapping_add(c % 5).wrapping_sub(2)]
        }
        4 => [short(a), short(b), short(c)],
        // Products near the smallest numbers.
        _ => [
            a & 0x800f_ffff_ffff_ffff | (0x1f0 + (c & 0x1f)) << 52,
            moderate(b) ^ 0x2000_0000_0000_0000,
            c,
        ],
    }
}

#[test]
fn random_operands_in_every_mode() {
    let mut random = Random::new("double");
    for round in 0..rounds(RANDOM_OPERANDS) {
        let [a, b, t] = random_operands(&mut random);
        check(a, b, t, MODES[round as usize % 4]);
    }
}

/// Provenance: the host's IEEE arithmetic, for operands and results that are not denormal.
#[test]
fn nearest_even_is_the_hosts() {
    let mut random = Random::new("host");
    let plain = |x: u64| (0x001..0x7ff).contains(&(x >> 52 & 0x7ff));
    for _ in 0..rounds(RANDOM_OPERANDS) {
        let [a, b, t] = random_operands(&mut random);
        if !(plain(a) && plain(b) && plain(t)) {
            continue;
        }
        let [x, y, z] = [a, b, t].map(f64::from_bits);
        let mode = Rounding::NearestEven;
        assert_eq!(double::dfa(a, b, mode).0, (x + y).to_bits());
        assert_eq!(double::dfs(a, b, mode).0, (x - y).to_bits());
        assert_eq!(double::dfm(a, b, mode).0, (x * y).to_bits());
        assert_eq!(double::dfma(a, b, t, mode).0, x.mul_add(y, z).to_bits());
        assert_eq!(double::frds(a, mode).0, (x as f32).to_bits());
    }
}

#[test]
fn conversions_between_the_precisions() {
    let mut random = Random::new("fesd frds");
    let singles =
        [0u32, 0x8000_0000, 0x0080_0000, 0x3f80_0000, 0x7f7f_ffff, 0x7f80_0000, 0xff80_0000];
    for x in singles.into_iter().chain((0..rounds(25_000)).map(|_| random.bits() as u32)) {
        let value = f32::from_bits(x);
        let (expected, flags) = if value.is_nan() {
            let signalling = Flags::DOUBLE_INVALID.when(x >> 22 & 1 == 0);
            (NAN, Flags::DOUBLE_NAN | signalling)
        } else if value.is_subnormal() {
            (u64::from(x >> 31) << 63, Flags::DOUBLE_DENORMAL)
        } else {
            (f64::from(value).to_bits(), Flags::NONE)
        };
        assert_eq!(double::fesd(x), (expected, flags), "fesd {x:08x}");
    }
    let near_singles = (0..rounds(100_000)).map(|_| {
        let x = random.bits();
        x & 0x800f_ffff_ffff_ffff & !(u64::from(x >> 20 & 3 == 0) * 0x1fff_ffff)
            | (0x360 + (x >> 52) % 0x130) << 52
    });
    for x in edges().into_iter().chain(near_singles) {
        for mode in MODES {
            let (expected, flags) = if is_nan(x) {
                (0x7fc0_0000, Flags::NONE)
            } else if is_infinite(x) || is_zero(x) {
                let magnitude = if is_zero(x) { 0 } else { 0x7f80_0000 };
                (x >> 63 << 31 | magnitude, Flags::NONE)
            } else {
                rounded(&exact(x), mode, 23, 127)
            };
            let expected = (expected as u32, flags | operand_flags(&[x]));
            assert_eq!(double::frds(x, mode), expected, "frds {x:016x} {mode:?}");
        }
    }
}

#[test]
fn compares_and_classes_of_the_extension() {
    let mask = |condition| if condition { u64::MAX } else { 0 };
    let value = |x: u64| if is_zero(x) { 0.0 } else { f64::from_bits(x) };
    for a in edges() {
        for b in edges() {
            let flags = operand_flags(&[a, b]);
            let (x, y) = (value(a), value(b));
            assert_eq!(double::dfceq(a, b), (mask(x == y), flags));
            assert_eq!(double::dfcgt(a, b), (mask(x > y), flags));
            assert_eq!(double::dfcmeq(a, b), (mask(x.abs() == y.abs()), flags));
            assert_eq!(double::dfcmgt(a, b), (mask(x.abs() > y.abs()), flags));
        }
        let x = f64::from_bits(a);
        let classes = [
            x.is_subnormal() && x < 0.0,
            x.is_subnormal() && x > 0.0,
            a == SIGN,
            a == 0,
            x == f64::NEG_INFINITY,
            x == f64::INFINITY,
            x.is_nan(),
        ];
        for (bit, holds) in classes.into_iter().enumerate() {
            assert_eq!(double::dftsv(a, 1 << bit), mask(holds), "{a:016x} {bit}");
        }
        assert_eq!(double::dftsv(a, 0), 0);
    }
}

/// Provenance: the architecture's table of bits.
#[test]
fn the_status_register_keeps_its_bits_only() {
    let all = Fpscr::from_words([u32::MAX; 4]);
    assert_eq!(all.words(), [0x0f07, 0x3f07, 0x3f07, 0x0f07]);
    let modes = Fpscr::from_words([0x0600, 0, 0, 0]);
    assert_eq!((modes.rounding(0), modes.rounding(1)), (Rounding::TowardZero, Rounding::Up));
    let modes = Fpscr::from_words([0x0300, 0, 0, 0]);
    assert_eq!((modes.rounding(0), modes.rounding(1)), (Rounding::NearestEven, Rounding::Down));
    let mut raised = Fpscr::default();
    raised.raise_single([Flags::OVERFLOW, Flags::NONE, Flags::UNDERFLOW, Flags::DIFFERENT]);
    raised.raise_double([Flags::DOUBLE_NAN, Flags::DOUBLE_INEXACT]);
    raised.raise_divide_by_zero([true, false, false, true]);
    assert_eq!(raised.words(), [4, 0x200, 0x802, 0x901]);
}
