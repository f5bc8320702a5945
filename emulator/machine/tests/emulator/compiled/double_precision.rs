//! Tests compiled double precision, on ordinary doubles and on edge cases.

use super::operations::{compare_all, instruction, word};
use super::units::State;
use crate::prelude::*;
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;
use spu_emulator::edges::DOUBLES;

const OPERATIONS: [Op; 9] =
    [Op::Dfa, Op::Dfs, Op::Dfm, Op::Dfma, Op::Dfms, Op::Dfnms, Op::Dfnma, Op::Fesd, Op::Frds];

/// A double near one, with few bits or many, so that sums and products are exact or not.
fn ordinary(rng: &mut ChaCha8Rng) -> u64 {
    let exponent = rng.random_range(1003..1043u64) << 52;
    let fraction = rng.random::<u64>() >> 12;
    let kept = [0, !0 << 49, !0 << 26, !0][rng.random_range(0..4)];
    rng.random::<u64>() >> 63 << 63 | exponent | fraction & kept
}

fn edge(rng: &mut ChaCha8Rng) -> u64 {
    let edge = DOUBLES[rng.random_range(0..DOUBLES.len())];
    let flipped = [0, 1, 1 << 52][rng.random_range(0..3)];
    (edge ^ flipped) | rng.random::<u64>() >> 63 << 63
}

/// A state whose registers hold doubles made by `double`, and an FPSCR that rounds to nearest and
/// may have flags already.
fn state(rng: &mut ChaCha8Rng, double: fn(&mut ChaCha8Rng) -> u64) -> State {
    let registers = std::array::from_fn(|_| {
        let [a, b] = [double(rng), double(rng)];
        Quad([(a >> 32) as u32, a as u32, (b >> 32) as u32, b as u32])
    });
    let flags = [0, 0x800, 0x3f07][rng.random_range(0..3)];
    State {
        registers,
        fpscr: [0, flags, flags & rng.random::<u32>(), 0],
        local_store: LocalStore::new(),
    }
}

fn states(rng: &mut ChaCha8Rng, count: usize, double: fn(&mut ChaCha8Rng) -> u64) -> Vec<State> {
    (0..count).map(|_| state(rng, double)).collect()
}

fn one_of(rng: &mut ChaCha8Rng, all: &[Op]) -> Op {
    all[rng.random_range(0..all.len())]
}

#[test]
fn ordinary_doubles_do_not_fail() {
    let mut rng = ChaCha8Rng::seed_from_u64(11);
    let states = states(&mut rng, 30, ordinary);
    // The words of doubles are not ordinary singles, and chains of products leave the range.
    let operations = &OPERATIONS[..7];
    let failures = compare_all(&mut rng, 60, &states, |rng| {
        let ops = [one_of(rng, operations), one_of(rng, operations)];
        ops.map(|op| instruction(rng, op)).into_iter().collect()
    });
    assert_eq!(failures, [[0; 2]; 4]);
}

#[test]
fn edges_of_doubles() {
    let mut rng = ChaCha8Rng::seed_from_u64(12);
    let states = states(&mut rng, 40, edge);
    for op in OPERATIONS {
        let failures = compare_all(&mut rng, rounds(10) as usize, &states, |rng| {
            Some(vec![instruction(rng, op)?])
        });
        assert!(failures.iter().all(|&[host, wasm]| host > 0 && wasm == 0), "{op:?}");
    }
}

#[test]
fn both_precisions_in_turn() {
    let mut rng = ChaCha8Rng::seed_from_u64(13);
    let mixed = |rng: &mut ChaCha8Rng| match rng.random_range(0..8) {
        0 => edge(rng),
        1..4 => ordinary(rng),
        _ => u64::from(word(rng, 2)) << 32 | u64::from(word(rng, 2)),
    };
    let states = states(&mut rng, 20, mixed);
    let others = [
        Op::Fa,
        Op::Fm,
        Op::Fma,
        Op::Fi,
        Op::Csflt,
        Op::Cflts,
        Op::Selb,
        Op::Fcgt,
        Op::Stqd,
        Op::Lqd,
        Op::Ai,
    ];
    compare_all(&mut rng, rounds(40) as usize, &states, |rng| {
        let length = rng.random_range(3..12);
        (0..length)
            .map(|_| {
                let op = match rng.random() {
                    true => one_of(rng, &OPERATIONS),
                    false => one_of(rng, &others),
                };
                (0..20).find_map(|_| instruction(rng, op))
            })
            .collect()
    });
}

/// Units compute in one rounding mode only, and fail in the others.
#[test]
fn other_rounding_modes_are_interpreted() {
    let mut rng = ChaCha8Rng::seed_from_u64(14);
    let mut states = states(&mut rng, 15, ordinary);
    for (state, mode) in states.iter_mut().zip(1..) {
        state.fpscr[0] = mode << 8;
    }
    let failures = compare_all(&mut rng, 40, &states, |rng| {
        let op = one_of(rng, &OPERATIONS);
        let made = (0..100).find_map(|_| instruction(rng, op));
        Some(vec![made.expect("one of many is valid")])
    });
    assert_eq!(failures, [[40 * 15, 0]; 4]);
}
