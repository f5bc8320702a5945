//! Recurrences and steady states of loops, for bodies whose figures were derived by hand.
//!
//! Provenance: `model`.

use spu_isa::timing::{Cause, Loop, Rules, find_loops};
use spu_isa::{Instruction, Op};

const START: u32 = 0x100;

fn i(op: Op, rt: u8, ra: u8, rb: u8) -> Instruction {
    Instruction::new(op, [rt, ra, rb, 0], 0)
}

/// The loop of `body` and a branch back, which is hinted from far ahead.
fn hinted_loop(body: &[Instruction]) -> Loop {
    let branch = START + 4 * body.len() as u32;
    let hint_at = START - 0x40;
    let hint = Instruction {
        branch_distance: (branch - hint_at) as i16,
        immediate: (START - hint_at) as i32,
        ..i(Op::Hbrr, 0, 0, 0)
    };
    let back = Instruction { immediate: START as i32 - branch as i32, ..i(Op::Br, 0, 0, 0) };
    let run_up = std::iter::repeat_n(i(Op::Nop, 127, 0, 0), 15);
    let stream = [hint].into_iter().chain(run_up).chain(body.iter().copied()).chain([back]);
    let code: Vec<_> = (hint_at..).step_by(4).zip(stream.map(Instruction::encode)).collect();
    let mut loops = find_loops(&code, Rules::default());
    assert_eq!(loops.len(), 1);
    loops.remove(0)
}

/// Cycles and passes of the recurrence, and the mean cycles of a pass.
fn recurrence(body: &[Instruction]) -> (Option<(u64, u64)>, f64) {
    let found = hinted_loop(body);
    let chain = found.recurrence.map(|chain| (chain.cycles, chain.passes));
    (chain, found.steady.unwrap().cycles_a_pass())
}

#[test]
fn a_sum_goes_round_in_its_latency() {
    // fa $3,$3,$4: 6 cycles from pass to pass, although each pipe has only one instruction.
    let found = hinted_loop(&[i(Op::Fa, 3, 3, 4)]);
    assert_eq!((found.even, found.odd, found.bound()), (1, 1, 6));
    assert_eq!(found.recurrence.unwrap().registers, [3]);
    let steady = found.steady.unwrap();
    assert_eq!((steady.account.cycles(), steady.passes), (6, 1));
    assert_eq!(steady.account.waited(Cause::BranchMiss), 0);
}

#[test]
fn a_chain_through_several_instructions_adds_up() {
    // $4 -> fa (6) -> $3 -> a (2) -> $4: 8 cycles a pass.
    let body = [i(Op::Fa, 3, 4, 5), i(Op::A, 4, 3, 6)];
    assert_eq!(recurrence(&body), (Some((8, 1)), 8.0));
}

#[test]
fn a_chain_over_two_passes_has_half_its_cycles_a_pass() {
    // $3 -> ori (2) -> $7 -> ori (2) -> $4; $4 -> fa (6) -> $3: 10 cycles in two passes. In
    // program order, a pass waits for the fa of the previous pass (6) and for the ori after it.
    let body = [i(Op::Ori, 7, 3, 0), i(Op::Fa, 3, 4, 4), i(Op::Ori, 4, 7, 0)];
    let (chain, cycles) = recurrence(&body);
    assert_eq!(chain, Some((10, 2)));
    assert!(cycles >= 5.0);
}

#[test]
fn the_longest_of_several_chains_counts() {
    // A pointer (2), a rotate (4) and a product (6), which are independent of each other.
    let body = [i(Op::Ai, 3, 3, 0), i(Op::Rot, 4, 4, 9), i(Op::Fm, 5, 5, 9)];
    let found = hinted_loop(&body);
    let chain = found.recurrence.unwrap();
    assert_eq!((chain.cycles, chain.passes), (6, 1));
    assert_eq!(chain.registers, [5]);
}

#[test]
fn registers_written_before_read_are_not_carried() {
    let (chain, cycles) = recurrence(&[i(Op::Il, 3, 0, 0), i(Op::Fa, 4, 3, 9)]);
    assert_eq!(chain, None);
    // il at 0, fa at 2, br at 3: no pass waits for the result of another.
    assert_eq!(cycles, 4.0);
}

#[test]
fn double_precision_takes_both_pipes() {
    let found = hinted_loop(&[i(Op::Dfa, 3, 4, 5), i(Op::Dfa, 6, 7, 8)]);
    assert_eq!((found.even, found.odd), (14, 15));
    assert_eq!(found.steady.unwrap().account.cycles(), 15);
}

#[test]
fn a_call_backwards_is_no_loop() {
    let call = Instruction { immediate: -8, ..i(Op::Brsl, 0, 0, 0) };
    let code = [(0, 0x4020_0000), (4, 0x4020_0000), (8, call.encode())];
    assert_eq!(find_loops(&code, Rules::default()), []);
}
