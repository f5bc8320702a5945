//! Compares the functions for four ordinary lanes with the full functions: the words must be
//! equal, and there must be no flags. Also tests instructions that have both ordinary lanes and
//! others.

use crate::instructions::machine::{Script, instruction, put};
use crate::prelude::*;
use spu_emulator::float::single::{self, Lanes};
use spu_emulator::float::{convert, ordinary};
use std::array::from_fn;

const SIGN: u32 = 0x8000_0000;
const QUADS: u32 = 500_000;

type Operands = [[u32; 4]; 3];

struct Case {
    name: &'static str,
    op: Op,
    ordinary: fn(Operands) -> Option<[u32; 4]>,
    full: fn(Operands) -> Lanes<4>,
}

/// A case by the name that an instruction and its functions share.
macro_rules! case {
    ($op:ident $name:ident $full:expr, $($operand:ident)* $(; $other:pat)?) => {
        Case {
            name: stringify!($name),
            op: Op::$op,
            ordinary: |[$($operand,)* $($other)?]| ordinary::$name($($operand),*),
            full: |[$($operand,)* $($other)?]| $full($($operand),*),
        }
    };
}

const CASES: [Case; 7] = [
    case!(Fa fa single::fa_lanes, a b; _),
    case!(Fs fs single::fs_lanes, a b; _),
    case!(Fm fm single::fm_lanes, a b; _),
    case!(Fma fma single::fma_lanes, a b c),
    case!(Fms fms single::fms_lanes, a b c),
    case!(Fnms fnms single::fnms_lanes, a b c),
    case!(Fi fi interpolated, a b; _),
];

fn interpolated(a: [u32; 4], b: [u32; 4]) -> Lanes<4> {
    let lanes: [_; 4] = from_fn(|n| estimate::fi_flagged(a[n], b[n]));
    (lanes.map(|lane| lane.0), lanes.map(|lane| lane.1))
}

/// Whether there was a result. If there was, it must be correct.
fn has_correct_result(case: &Case, operands: Operands) -> bool {
    let result = (case.ordinary)(operands);
    if let Some(words) = result {
        let expected = (case.full)(operands);
        assert_eq!(
            (words, [Flags::NONE; 4]),
            expected,
            "{} {operands:08x?}: {words:08x?}, expected {:08x?}",
            case.name,
            expected.0
        );
    }
    result.is_some()
}

/// Words at the limits of what is ordinary, and some between.
fn borders() -> Vec<u32> {
    let exponents = [0, 1, 2, 24, 103, 126, 127, 128, 150, 151, 180, 253, 254, 255];
    let fractions = [0, 1, 0x40_0000, 0x7f_fffe, 0x7f_ffff];
    let positive = exponents
        .into_iter()
        .flat_map(|exponent| fractions.map(|fraction| exponent << 23 | fraction));
    positive.flat_map(|x| [x, x | SIGN]).collect()
}

#[test]
fn borders_by_borders() {
    let borders = borders();
    for case in &CASES {
        let mut results = 0;
        for &a in &borders {
            for &b in &borders {
                for c in borders.chunks_exact(4) {
                    let c = from_fn(|n| c[n]);
                    results += u32::from(has_correct_result(case, [[a; 4], [b; 4], c]));
                    results += u32::from(has_correct_result(case, [c, [b; 4], [a; 4]]));
                }
            }
        }
        assert!(results > 100_000, "{}: {results}", case.name);
    }
}

/// Exponents near `centre`, with any fraction and sign.
fn near(bits: u32, centre: u32) -> u32 {
    let exponent = (centre + (bits >> 23 & 7)).clamp(4, 258) - 4;
    bits & 0x807f_ffff | exponent << 23
}

/// Words with few fraction bits: their products and sums are singles.
fn short(bits: u32) -> u32 {
    near(bits & 0x83f0_0000, 127)
}

fn lane(random: &mut Random, kind: u64) -> [u32; 3] {
    let bits = random.bits();
    let [a, b, c] = [bits as u32, (bits >> 32) as u32, random.bits() as u32];
    match kind {
        0 => [near(a, 127), near(b, 127), near(c, 127)],
        1 => [short(a), short(b), short(c)],
        // The third operand is the product, or a few units from it.
        2 => {
            let (a, b) = (near(a, 127), near(b, 127));
            let product = single::fm(a, b);
            [a, b, (product ^ c & SIGN).wrapping_add(c & 3).wrapping_sub(1)]
        }
        // Terms so far apart that the sum in 53 bits is rounded to a single, or almost to one.
        3 => [near(a, 127), short(b), near(c, 127 + 20 + (a & 63))],
        4 => [short(a), near(b, 127), short(c) - ((20 + (a & 63)) << 23)],
        // Results at both ends of the range.
        5 => [near(a, 254 - (c & 127)), near(b, 127 + (c & 127)), near(c, 254)],
        6 => [near(a, c & 127), near(b, 127 - (c & 127)), near(c, 1)],
        // Cancellation to zero or nearly zero, anywhere in the range.
        7 => {
            let a = near(a, 1 + (b & 255).min(253));
            [a, a ^ SIGN ^ c & 3, c]
        }
        8 => [near(a, 127), 0, 0],
        _ => [a, b, c],
    }
}

#[test]
fn random_quads() {
    for case in &CASES {
        let quads = rounds(QUADS);
        let mut random = Random::new(case.name);
        let mut results = [0; 10];
        let borders = borders();
        for round in 0..quads {
            let kind = random.below(10);
            let lanes: [_; 4] = from_fn(|_| lane(&mut random, kind));
            let mut operands = from_fn(|operand| lanes.map(|lane| lane[operand]));
            results[kind as usize] += u32::from(has_correct_result(case, operands));
            if round % 4 == 0 {
                let border = borders[random.below(borders.len() as u64) as usize];
                operands[random.below(3) as usize][random.below(4) as usize] = border;
                has_correct_result(case, operands);
            }
        }
        // All cases of the kinds without special values must have a result.
        if case.name != "fi" {
            let share = f64::from(results[0] + results[1] + results[8]) * 10.0 / 3.0;
            let share = share / f64::from(quads);
            assert!(share > 0.98, "{}: {share}, {results:?}", case.name);
        }
    }
}

/// An operand or a result that is not ordinary, in any lane, must never give a result.
#[test]
fn one_special_lane_is_enough() {
    const ONE: u32 = 0x3f80_0000;
    let special = [1, 0x007f_ffff, 0x7f80_0000, 0x7fff_ffff];
    for case in &CASES[..6] {
        assert!(has_correct_result(case, [[ONE; 4]; 3]), "{}", case.name);
        let operands = if case.name.len() > 2 { 3 } else { 2 };
        for operand in 0..operands {
            for lane in 0..4 {
                for word in special.into_iter().flat_map(|x| [x, x | SIGN]) {
                    let mut words = [[ONE; 4]; 3];
                    words[operand][lane] = word;
                    assert!(!has_correct_result(case, words), "{} {words:08x?}", case.name);
                }
            }
        }
    }
    for lane in 0..4 {
        let mut a = [ONE; 4];
        a[lane] = 0x7f00_0000;
        assert_eq!(ordinary::fm(a, a), None, "overflow");
        assert_eq!(ordinary::fa(a, a), None, "2^128 is not IEEE's");
        a[lane] = 0x0080_0000;
        assert_eq!(ordinary::fm(a, a), None, "underflow");
        assert_eq!(ordinary::fma(a, a, [0; 4]), None, "underflow");
        let mut b = [ONE; 4];
        b[lane] = 0x0080_0001;
        assert_eq!(ordinary::fs(a, b), None, "underflow");
    }
}

#[test]
fn zeros_are_positive() {
    let zeros = [0, SIGN, 0, SIGN];
    let others = [0, 0, SIGN, SIGN];
    let ones = [0x3f80_0000; 4];
    assert_eq!(ordinary::fa(zeros, others), Some([0; 4]));
    assert_eq!(ordinary::fs(zeros, others), Some([0; 4]));
    assert_eq!(ordinary::fm(zeros, others), Some([0; 4]));
    assert_eq!(ordinary::fm(zeros, ones), Some([0; 4]));
    assert_eq!(ordinary::fma(zeros, ones, others), Some([0; 4]));
    assert_eq!(ordinary::fms(zeros, ones, others), Some([0; 4]));
    assert_eq!(ordinary::fnms(ones, ones, ones), Some([0; 4]));
}

#[test]
fn conversions() {
    let mut random = Random::new("ordinary conversions");
    for scale in -173..=173 {
        for round in 0..5_000 {
            let shift = random.below(32) as u32;
            let x: [u32; 4] = match round {
                0 => [0, 1, u32::MAX, SIGN],
                _ => from_fn(|_| random.bits() as u32 >> shift),
            };
            let check = |name, result: Option<_>, full: fn(u32, i32) -> (u32, Flags)| {
                let full = x.map(|x| full(x, scale));
                if let Some(words) = result {
                    let expected = (full.map(|lane| lane.0), full.map(|lane| lane.1));
                    assert_eq!((words, [Flags::NONE; 4]), expected, "{name} {x:08x?} {scale}");
                }
                assert_eq!(result.is_some(), (-90..=126).contains(&scale));
            };
            check("csflt", ordinary::csflt(x, scale), convert::csflt_flagged);
            check("cuflt", ordinary::cuflt(x, scale), convert::cuflt_flagged);
        }
    }
}

/// rt and FPSCR after one instruction with these sources. The FPSCR was 0 before.
fn run(op: Op, immediate: i32, sources: Operands) -> ([u32; 4], [u32; 4]) {
    let local_store = LocalStore::new();
    put(&local_store, 0, instruction(op, immediate));
    let mut spu = Spu::new();
    for (number, words) in (4..).zip(sources) {
        spu.set_register(number, Quad(words));
    }
    let stopped = spu.step(&local_store, &mut Script::default());
    assert_eq!(stopped, None);
    (spu.register(3).0, spu.fpscr.words())
}

fn expected((words, flags): Lanes<4>) -> ([u32; 4], [u32; 4]) {
    let mut fpscr = Fpscr::default();
    fpscr.raise_single(flags);
    (words, fpscr.words())
}

#[test]
fn instructions_mix_ordinary_and_special_lanes() {
    let mut random = Random::new("mixed lanes");
    for case in &CASES {
        for round in 0..200 {
            let lanes: [_; 4] = from_fn(|_| {
                let kind = if round % 2 == 0 { 0 } else { random.below(10) };
                lane(&mut random, kind)
            });
            let operands = from_fn(|operand| lanes.map(|lane| lane[operand]));
            assert_eq!(run(case.op, 0, operands), expected((case.full)(operands)), "{}", case.name);
        }
    }
    for round in 0..400 {
        let a = from_fn(|_| random.bits() as u32 & ((1 << 31 >> (round % 24)) - 1));
        let scale = round % 128;
        let lanes = a.map(|a| convert::csflt_flagged(a, scale));
        let full = (lanes.map(|lane| lane.0), lanes.map(|lane| lane.1));
        assert_eq!(run(Op::Csflt, scale, [a; 3]), expected(full));
        let zero = 1 << (round % 4);
        let a = from_fn(|n| if zero >> n & 1 == 1 { a[n] & 0x7f_ffff } else { a[n] });
        let mut fpscr = Fpscr::default();
        fpscr.raise_divide_by_zero(a.map(estimate::divides_by_zero));
        let estimated = (a.map(estimate::frest), fpscr.words());
        assert_eq!(run(Op::Frest, 0, [a; 3]), estimated);
    }
}
