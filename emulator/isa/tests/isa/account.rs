//! Properties of every program: each cycle is counted once, issue is in order, the model is
//! deterministic, and no rule makes code faster.

use proptest::prelude::*;
use spu_isa::timing::{Cause, Issue, Pipeline, Rules, find_loops, straight_line};
use spu_isa::{Class, Instruction, Op, Pipe};

/// A step of a stream: a word, and what happens after it.
#[derive(Clone, Copy, Debug)]
enum Step {
    Word(u32),
    Branch(Option<u32>),
    Target(u32),
    Stall(u64, bool),
}

/// Words that are instructions, with an assigned opcode and random fields. They use few registers,
/// so that they depend on each other.
fn word() -> impl Strategy<Value = u32> {
    let rows = Op::rows();
    (0..rows.len(), any::<u32>(), any::<bool>()).prop_map(move |(row, fields, crowded)| {
        let row = &rows[row];
        let opcode = u32::from(row.opcode) << 21;
        let mask = u32::MAX >> row.format.opcode_bits();
        let fields = if crowded { fields & !0x01c3_8f1e } else { fields };
        opcode | fields & mask
    })
}

fn step() -> impl Strategy<Value = Step> {
    prop_oneof![
        20 => word().prop_map(Step::Word),
        1 => proptest::option::of((0u32..0x1_0000).prop_map(|word| word * 4)).prop_map(Step::Branch),
        1 => any::<u32>().prop_map(Step::Target),
        1 => (0u64..100, any::<bool>()).prop_map(|(cycles, dma)| Step::Stall(cycles, dma)),
    ]
}

fn rules() -> impl Strategy<Value = Rules> {
    let numbers = (18u64..20, 15u64..18, 1u64..4);
    let switches = any::<[bool; 5]>();
    (switches, numbers).prop_map(|(on, (miss_cycles, hint_cycles, channel_interval))| Rules {
        miss_cycles,
        hint_cycles,
        hints: on[0],
        float_conflict: on[1],
        false_targets: on[2],
        channel_interval,
        inline_prefetch: on[3],
        double_extension: on[4],
    })
}

fn run(rules: Rules, steps: &[Step]) -> (Pipeline, Vec<(u32, Instruction, Issue)>) {
    let mut pipeline = Pipeline::new(rules);
    let mut issues = Vec::new();
    let mut pc = 0;
    for &step in steps {
        match step {
            Step::Word(word) => {
                let instruction = Instruction::decode(word).unwrap();
                issues.push((pc, instruction, pipeline.issue(pc, instruction)));
                pc = (pc + 4) & 0x3_fffc;
            }
            Step::Branch(target) => {
                pipeline.branched(pc.wrapping_sub(4) & 0x3_fffc, target);
                pc = target.unwrap_or(pc);
            }
            Step::Target(target) => pipeline.hint_target(target),
            Step::Stall(cycles, dma) => {
                let cause = if dma { Cause::Dma } else { Cause::Channel };
                pipeline.stall_until(pipeline.clock() + cycles, cause);
            }
        }
        let account = pipeline.account();
        assert_eq!(account.cycles(), pipeline.clock());
        assert_eq!(account.instructions(), issues.len() as u64);
    }
    (pipeline, issues)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn every_cycle_has_one_cause(rules in rules(), steps in prop::collection::vec(step(), 1..200)) {
        let (pipeline, issues) = run(rules, &steps);
        // The sum over single causes is the same, and each wait was counted under the cause that the
        // issue reports.
        let waits: u64 = Cause::all().map(|cause| pipeline.account().waited(cause)).sum();
        prop_assert_eq!(waits, pipeline.account().stalled());
        for (_, _, issue) in &issues {
            prop_assert!(issue.waited.is_some() || issue.waited_cycles == 0);
        }
    }

    #[test]
    fn issue_is_in_order_and_pairs_are_groups(
        rules in rules(),
        steps in prop::collection::vec(step(), 1..200),
    ) {
        let (_, issues) = run(rules, &steps);
        for pair in issues.windows(2) {
            let [(pc, _, first), (next_pc, _, second)] = pair else { unreachable!() };
            if second.dual {
                prop_assert_eq!(first.cycle, second.cycle);
                prop_assert_eq!((first.pipe, second.pipe), (Pipe::Even, Pipe::Odd));
                prop_assert_eq!((pc % 8, *next_pc), (0, pc + 4));
                prop_assert!(!first.dual);
            } else {
                prop_assert!(second.cycle > first.cycle);
            }
        }
    }

    #[test]
    fn no_operand_is_read_before_it_is_there(
        rules in rules(),
        words in prop::collection::vec(word(), 1..200),
    ) {
        let steps: Vec<_> = words.into_iter().map(Step::Word).collect();
        let (_, issues) = run(rules, &steps);
        // To be independent of the model's own bookkeeping, search backwards for the last writer.
        for (at, (_, reader, issue)) in issues.iter().enumerate() {
            let prefetch = reader.op == Op::Hbr && reader.immediate & 4 != 0;
            for register in reader.reads().iter().filter(|_| !prefetch) {
                let writer = issues[..at].iter().rev().find(|(_, i, _)| i.writes().contains(register));
                if let Some((_, writer, written)) = writer {
                    let class = writer.op.row().class;
                    let latency = match class {
                        Class::Fpd if rules.double_extension => 9,
                        _ => u64::from(class.latency()),
                    };
                    prop_assert!(issue.cycle >= written.cycle + latency);
                }
            }
        }
    }

    #[test]
    fn the_same_stream_gives_the_same_cycles(
        rules in rules(),
        steps in prop::collection::vec(step(), 1..100),
    ) {
        let (one, first) = run(rules, &steps);
        let (other, second) = run(rules, &steps);
        prop_assert_eq!(first, second);
        prop_assert_eq!(one.account(), other.account());
    }

    /// For any words, the analysis ends and its steady states are whole passes.
    #[test]
    fn any_words_are_analysed(rules in rules(), words in prop::collection::vec(any::<u32>(), 0..300)) {
        let code: Vec<_> = (0..).step_by(4).zip(words).collect();
        let schedule = straight_line(&code, rules);
        prop_assert_eq!(schedule.lines.len(), code.len());
        for found in find_loops(&code, rules) {
            if let Some(steady) = &found.steady {
                let instructions = found.instructions as u64 * steady.passes;
                prop_assert_eq!(steady.account.instructions(), instructions);
            }
        }
    }

    /// No schedule is faster than the bound of its loop.
    #[test]
    fn no_loop_beats_its_bound(rules in rules(), words in prop::collection::vec(word(), 1..60)) {
        let start = 0x100;
        let distance = -(words.len() as i32) * 4;
        let back = Instruction::new(Op::Br, [0; 4], distance);
        let words = words.into_iter().chain([back.encode()]);
        let code: Vec<_> = (start..).step_by(4).zip(words).collect();
        for found in find_loops(&code, rules) {
            let Some(steady) = &found.steady else { continue };
            prop_assert!(steady.account.cycles() >= found.bound() * steady.passes);
        }
    }
}
