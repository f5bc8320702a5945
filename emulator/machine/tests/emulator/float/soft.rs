//! Compares double precision with LLVM's soft float in the crate `rustc_apfloat`: values and
//! flags, in the four rounding modes.

use crate::prelude::*;
use rustc_apfloat::ieee::{Double, Single};
use rustc_apfloat::{Float as _, FloatConvert as _, Round, Status, StatusAnd};
use spu_emulator::float::double;
use spu_emulator::float::fpscr::Rounding;

const MODES: [(Rounding, Round); 4] = [
    (Rounding::NearestEven, Round::NearestTiesToEven),
    (Rounding::TowardZero, Round::TowardZero),
    (Rounding::Up, Round::TowardPositive),
    (Rounding::Down, Round::TowardNegative),
];
const SIGN: u64 = 1 << 63;
const DEFAULT_NAN: u64 = 0x7ff8_0000_0000_0000;
const RANDOM_OPERANDS: u32 = 125_000;

/// On the SPU, a denormal operand is a zero with its sign.
fn operand(bits: u64) -> Double {
    let denormal = bits & 0x7ff0_0000_0000_0000 == 0;
    Double::from_bits(u128::from(if denormal { bits & SIGN } else { bits }))
}

fn is_nan(bits: u64) -> bool {
    operand(bits).is_nan()
}

fn is_denormal(bits: u64) -> bool {
    bits & !SIGN != 0 && bits & 0x7ff0_0000_0000_0000 == 0
}

/// The SPU's flags for the soft float's status of a result, and for the operands.
fn flags(status: Status, operands: &[u64]) -> Flags {
    let mut flags = Flags::NONE;
    for (of_soft_float, flag) in [
        (Status::OVERFLOW, Flags::DOUBLE_OVERFLOW),
        (Status::UNDERFLOW, Flags::DOUBLE_UNDERFLOW),
        (Status::INEXACT, Flags::DOUBLE_INEXACT),
        (Status::INVALID_OP, Flags::DOUBLE_INVALID),
    ] {
        flags |= flag.when(status.contains(of_soft_float));
    }
    flags |= Flags::DOUBLE_NAN.when(operands.iter().any(|bits| is_nan(*bits)));
    let signalling = |bits: &u64| is_nan(*bits) && bits & 1 << 51 == 0;
    flags |= Flags::DOUBLE_INVALID.when(operands.iter().any(signalling));
    flags |= Flags::DOUBLE_DENORMAL.when(operands.iter().any(|bits| is_denormal(*bits)));
    flags
}

/// Converts the soft float's result to the SPU's: there is only one NaN, with its own flags.
fn expected(result: StatusAnd<Double>, operands: &[u64]) -> (u64, Flags) {
    let value = if result.value.is_nan() { DEFAULT_NAN } else { result.value.to_bits() as u64 };
    (value, flags(result.status, operands))
}

/// Compares value and flags. Two of the SPU's flags differ from the soft float's, each at one
/// value, and only the exact model can check them. The soft float raises no overflow if a directed
/// rounding stops at the largest number, but IEEE does. It raises no underflow if rounding goes
/// from below to the smallest normal number, but the SPU checks before rounding.
#[track_caller]
fn same(
    found: (u64, Flags),
    expected: (u64, Flags),
    [smallest, largest]: [u64; 2],
    what: impl FnOnce() -> String,
) {
    let magnitude = expected.0 & (largest | smallest);
    let free = Flags::DOUBLE_OVERFLOW.when(magnitude == largest)
        | Flags::DOUBLE_UNDERFLOW.when(magnitude == smallest);
    let agree = found.1 == expected.1 || found.1 == expected.1 | free;
    assert!(found.0 == expected.0 && agree, "{}: {found:x?}, not {expected:x?}", what());
}

/// The smallest normal and the largest finite numbers.
const DOUBLE_ENDS: [u64; 2] = [0x0010_0000_0000_0000, 0x7fef_ffff_ffff_ffff];
const SINGLE_ENDS: [u64; 2] = [0x0080_0000, 0x7f7f_ffff];

/// Operands with any bits, with close exponents, or with few bits set, which lead to
/// cancellation and ties in sums.
fn random_operand(random: &mut Random) -> u64 {
    let (bits, choice) = (random.bits(), random.bits() % 4);
    match choice {
        0 => bits,
        1 => bits & (SIGN | 0x000f_ffff_ffff_ffff) | (1000 + bits % 48) << 52,
        2 => bits & (SIGN | 0x000f_f800_0000_0000) | (1000 + bits % 48) << 52,
        _ => {
            const EDGES: [u64; 10] = [
                0,
                1,
                0x000f_ffff_ffff_ffff,
                0x0010_0000_0000_0000,
                0x0010_0000_0000_0001,
                0x3ff0_0000_0000_0000,
                0x7fef_ffff_ffff_ffff,
                0x7ff0_0000_0000_0000,
                0x7ff0_0000_0000_0001,
                DEFAULT_NAN,
            ];
            EDGES[(bits % 10) as usize] | bits & SIGN
        }
    }
}

#[test]
fn sums_products_and_fused_forms() {
    let mut random = Random::new("soft float");
    for _ in 0..rounds(RANDOM_OPERANDS) {
        let (a, b, t) =
            (random_operand(&mut random), random_operand(&mut random), random_operand(&mut random));
        let (x, y, z) = (operand(a), operand(b), operand(t));
        for (mode, round) in MODES {
            let check = |name, found: (u64, Flags), expected: (u64, Flags)| {
                same(found, expected, DOUBLE_ENDS, || {
                    format!("{name} {a:#018x} {b:#018x} {t:#018x} {mode:?}")
                });
            };
            check("dfa", double::dfa(a, b, mode), expected(x.add_r(y, round), &[a, b]));
            check("dfs", double::dfs(a, b, mode), expected(x.sub_r(y, round), &[a, b]));
            check("dfm", double::dfm(a, b, mode), expected(x.mul_r(y, round), &[a, b]));
            // The soft float accepts a NaN addend to inf * 0 without an exception. On the SPU the
            // product's rule applies.
            if !(is_nan(t) && (x * y).value.is_nan()) {
                let plus = expected(x.mul_add_r(y, z, round), &[a, b, t]);
                let minus = expected(x.mul_add_r(y, -z, round), &[a, b, t]);
                check("dfma", double::dfma(a, b, t, mode), plus);
                check("dfms", double::dfms(a, b, t, mode), minus);
                let negated = |(value, flags)| {
                    (if value == DEFAULT_NAN { value } else { value ^ SIGN }, flags)
                };
                check("dfnms", double::dfnms(a, b, t, mode), negated(minus));
                check("dfnma", double::dfnma(a, b, t, mode), negated(plus));
            }
        }
    }
}

#[test]
fn conversions() {
    let mut random = Random::new("doubles to singles");
    for _ in 0..rounds(RANDOM_OPERANDS) {
        let bits = random_operand(&mut random);
        for (mode, round) in MODES {
            let mut loses_info = false;
            let narrow: StatusAnd<Single> = operand(bits).convert_r(round, &mut loses_info);
            let value = if narrow.value.is_nan() { 0x7fc0_0000 } else { narrow.value.to_bits() };
            let expected = (value as u64, flags(narrow.status, &[bits]));
            let (found, raised) = double::frds(bits, mode);
            same((u64::from(found), raised), expected, SINGLE_ENDS, || {
                format!("frds {bits:#018x} {mode:?}")
            });
        }
        let single = bits as u32;
        if single & 0x7f80_0000 != 0 {
            let mut loses_info = false;
            let wide: StatusAnd<Double> =
                Single::from_bits(u128::from(single)).convert_r(Round::TowardZero, &mut loses_info);
            if !wide.value.is_nan() {
                assert_eq!(
                    u128::from(double::fesd(single).0),
                    wide.value.to_bits(),
                    "{single:#010x}"
                );
            }
        }
    }
}
