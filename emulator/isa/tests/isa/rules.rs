//! Each rule of the pipeline model, on sequences whose cycles were derived by hand.
//!
//! Provenance of every expectation: `model`, which means that the rules in `docs/timing.md` were
//! applied on paper. The derivation is in a comment. Nothing here was measured on the console.

use spu_isa::timing::{Cause, Pipeline, Rules};
use spu_isa::{Class, Instruction, Pipe};

use super::sequences::{cycles, cycles_by, cycles_from, feed, i};

#[test]
fn an_even_and_an_odd_instruction_of_a_group_issue_together() {
    // a | lqd in one aligned doubleword.
    let issues = feed(&mut Pipeline::default(), 0x100, &[i("a", 3, &[4, 5]), i("lqd", 6, &[7])]);
    assert_eq!(issues.iter().map(|i| i.cycle).collect::<Vec<_>>(), [0, 0]);
    assert_eq!(issues[0].pipe, Pipe::Even);
    assert_eq!(issues[1].pipe, Pipe::Odd);
    assert!(!issues[0].dual && issues[1].dual);
}

#[test]
fn the_same_two_across_a_group_border_do_not() {
    // The first is at 4 mod 8, so it is alone in its group.
    assert_eq!(cycles_from(0x104, &[i("a", 3, &[4, 5]), i("lqd", 6, &[7])]), [0, 1]);
}

#[test]
fn odd_before_even_and_twice_the_same_pipe_do_not_pair() {
    let even = i("a", 3, &[4, 5]);
    let odd = i("lqd", 6, &[7]);
    assert_eq!(cycles(&[odd, even]), [0, 1]);
    assert_eq!(cycles(&[even, even]), [0, 1]);
    assert_eq!(cycles(&[odd, odd]), [0, 1]);
    // In the wrong order the four take four cycles, in the right one two.
    assert_eq!(cycles(&[odd, even, odd, even]), [0, 1, 2, 3]);
    assert_eq!(cycles(&[even, odd, even, odd]), [0, 0, 1, 1]);
}

#[test]
fn nop_and_lnop_pair_like_others() {
    assert_eq!(cycles(&[i("nop", 127, &[]), i("lqd", 6, &[7])]), [0, 0]);
    assert_eq!(cycles(&[i("a", 3, &[4, 5]), i("lnop", 0, &[])]), [0, 0]);
}

#[test]
fn a_group_that_was_split_does_not_pair_with_the_next() {
    // [a | lqd needs a] splits: lqd waits until 2. The next group is a pair and issues in cycle 3.
    let code = [i("a", 3, &[4, 5]), i("lqd", 6, &[3]), i("a", 8, &[9, 10]), i("lqd", 11, &[12])];
    assert_eq!(cycles(&code), [0, 2, 3, 3]);
}

#[test]
fn a_dependence_within_a_group_costs_the_pair_and_the_whole_latency() {
    let mut pipeline = Pipeline::default();
    let issues = feed(&mut pipeline, 0, &[i("a", 3, &[4, 5]), i("shufb", 6, &[3, 3, 7])]);
    assert_eq!(issues[1].cycle, 2);
    assert!(issues[1].missed_dual);
    assert_eq!(issues[1].waited, Some(Cause::Operand(Class::Fx2)));
    assert_eq!(issues[1].waited_register, Some(3));
    // Cycle 1 is empty. Cycle 0 has the `a`.
    assert_eq!(issues[1].waited_cycles, 1);
    assert_eq!(pipeline.account().single(), 2);
}

#[test]
fn a_pair_lost_by_a_cycle_is_no_stall() {
    // The lqd's operand is ready at 2. The a issues alone at 1, and the lqd follows at 2 without
    // an empty cycle.
    let code = [
        i("il", 3, &[]),     // 0
        i("lnop", 0, &[]),   // 0
        i("a", 8, &[9, 10]), // 1
        i("lqd", 6, &[3]),   // 2
    ];
    let mut pipeline = Pipeline::default();
    let issues = feed(&mut pipeline, 0, &code);
    assert_eq!(issues[3].cycle, 2);
    assert!(issues[3].missed_dual);
    assert_eq!(issues[3].waited_cycles, 0);
    assert_eq!(issues[3].waited, Some(Cause::Operand(Class::Fx2)));
    assert_eq!(pipeline.account().stalled(), 0);
}

/// The cycle of an `ai` that reads what `producer` wrote to $3.
fn reader_after(producer: Instruction) -> u64 {
    cycles(&[producer, i("ai", 60, &[3])])[1]
}

#[test]
fn latencies_by_class() {
    // The latency of each class, from IBM's tutorial, GCC and binutils.
    for (mnemonic, latency) in [
        ("a", 2),
        ("selb", 2),
        ("fcgt", 2),
        ("clz", 2),
        ("shl", 4),
        ("rotmi", 4),
        ("avgb", 4),
        ("cntb", 4),
        ("fa", 6),
        ("fma", 6),
        ("mpy", 7),
        ("csflt", 7),
        ("fi", 7),
        ("dfa", 13),
        ("fesd", 13),
        ("fscrrd", 13),
        ("shufb", 4),
        ("rotqby", 4),
        ("frest", 4),
        ("orx", 4),
        ("fsmbi", 4),
        ("lqd", 6),
        ("lqr", 6),
        ("brsl", 4),
        ("rdch", 6),
        ("rchcnt", 6),
        ("mfspr", 6),
    ] {
        let producer = i(mnemonic, 3, &[70, 71, 72]);
        assert_eq!(reader_after(producer), latency, "{mnemonic}");
    }
}

#[test]
fn load_use_waits_six_cycles_and_names_the_load() {
    let mut pipeline = Pipeline::default();
    let issues = feed(&mut pipeline, 0, &[i("lqd", 3, &[4]), i("a", 5, &[3, 3])]);
    assert_eq!(issues[0].ready_cycle, 6);
    assert_eq!(issues[1].cycle, 6);
    // Cycles 1 to 5 are empty.
    assert_eq!(issues[1].waited_cycles, 5);
    assert_eq!(pipeline.account().waited(Cause::Operand(Class::Ls)), 5);
}

#[test]
fn a_load_after_a_store_waits_for_nothing() {
    // Both are odd, so they issue one a cycle.
    assert_eq!(cycles(&[i("stqd", 3, &[4]), i("lqd", 5, &[4])]), [0, 1]);
}

#[test]
fn stores_branches_and_accumulating_forms_read_their_target_field() {
    let load = i("lqd", 3, &[4]);
    for reader in [
        i("stqd", 3, &[9]),
        i("stqx", 3, &[9, 10]),
        i("brz", 3, &[]),
        i("binz", 3, &[9]),
        i("wrch", 3, &[21]),
        i("addx", 3, &[9, 10]),
        i("mpyhha", 3, &[9, 10]),
        i("iohl", 3, &[]),
        i("dfma", 3, &[9, 10]),
        i("hbr", 0, &[3]),
    ] {
        assert_eq!(cycles(&[load, reader]), [0, 6], "{:?}", reader.op);
    }
}

#[test]
fn a_channel_number_is_no_register() {
    // rdch $5,$ch3 after a load of $3.
    assert_eq!(cycles(&[i("lqd", 3, &[4]), i("rdch", 5, &[3])]), [0, 1]);
}

#[test]
fn three_sources_count_and_the_last_one_decides() {
    // $3 is ready at 0+6, $4 at 1+4, $5 at 2+2: the fma issues at 6 because of $3.
    let code = [
        i("lqd", 3, &[70]),
        i("shufb", 4, &[71, 72, 73]),
        i("a", 5, &[74, 75]),
        i("fma", 6, &[3, 4, 5]),
    ];
    let issues = feed(&mut Pipeline::default(), 0, &code);
    assert_eq!(issues[3].cycle, 6);
    assert_eq!(issues[3].waited_register, Some(3));
}

#[test]
fn the_youngest_write_wins_without_a_wait() {
    // mpy would make $3 ready at 7. The il at 1 overwrites it, so its reader issues at 3.
    let code = [i("mpy", 3, &[4, 5]), i("il", 3, &[]), i("ai", 6, &[3])];
    assert_eq!(cycles(&code), [0, 1, 3]);
}

#[test]
fn double_precision_blocks_six_cycles_and_pairs_with_nothing() {
    // (DP, odd) in a group: the odd one issues at 7. The next DP issues at 8 because it depends on
    // nothing, the one after it at 15.
    let code = [i("dfa", 3, &[4, 5]), i("lqd", 6, &[7]), i("dfa", 8, &[9, 10]), i("il", 11, &[])];
    assert_eq!(cycles(&code), [0, 7, 8, 15]);
    // (even, DP): the DP issues a cycle later.
    assert_eq!(cycles(&[i("il", 3, &[]), i("dfa", 4, &[5, 6])]), [0, 1]);
    // The result is ready at 13, and 7 of these cycles are the block.
    let mut pipeline = Pipeline::default();
    let issues = feed(&mut pipeline, 0, &[i("dfa", 3, &[4, 5]), i("dfa", 6, &[3, 3])]);
    assert_eq!(issues[1].cycle, 13);
    assert_eq!(pipeline.account().waited(Cause::DoubleStall), 6 + 6);
    assert_eq!(pipeline.account().waited(Cause::Operand(Class::Fpd)), 6);
}

#[test]
fn the_double_extension_pipelines_double_precision() {
    let rules = Rules { double_extension: true, ..Rules::default() };
    let code = [
        i("dfa", 3, &[4, 5]),  // 0
        i("lqd", 6, &[7]),     // 0, paired
        i("dfa", 8, &[9, 10]), // 1
        i("a", 11, &[3, 3]),   // 9
    ];
    assert_eq!(cycles_by(rules, &code), [0, 0, 1, 9]);
}

#[test]
fn fp6_right_behind_fp7_waits_a_cycle() {
    let fp7 = i("mpy", 3, &[4, 5]);
    let fp6 = i("fa", 6, &[7, 8]);
    let other = i("a", 9, &[10, 11]);
    assert_eq!(cycles(&[fp7, fp6]), [0, 2]);
    assert_eq!(cycles(&[fp7, other, fp6]), [0, 1, 2]);
    assert_eq!(cycles(&[fp6, fp7]), [0, 1]);
    assert_eq!(cycles(&[fp7, fp7]), [0, 1]);
    assert_eq!(cycles(&[fp6, fp6]), [0, 1]);
    let mut pipeline = Pipeline::default();
    let issues = feed(&mut pipeline, 0, &[fp7, fp6]);
    assert_eq!(issues[1].waited, Some(Cause::FloatConflict));
    assert_eq!(pipeline.account().waited(Cause::FloatConflict), 1);
    let rules = Rules { float_conflict: false, ..Rules::default() };
    assert_eq!(cycles_by(rules, &[fp7, fp6]), [0, 1]);
}

#[test]
fn false_targets_delay_readers_only_if_asked() {
    let code = [i("fscrwr", 3, &[4]), i("a", 5, &[3, 3])];
    assert_eq!(cycles(&code), [0, 1]);
    let rules = Rules { false_targets: true, ..Rules::default() };
    // fscrwr is FP7, a halt is FX2, and a nop counts as FX2.
    assert_eq!(cycles_by(rules, &code), [0, 7]);
    let halt = [i("heqi", 3, &[4]), i("a", 5, &[3, 3])];
    assert_eq!(cycles_by(rules, &halt), [0, 2]);
    let nop = [i("nop", 3, &[]), i("a", 5, &[3, 3])];
    assert_eq!(cycles_by(rules, &nop), [0, 2]);
    // A real write that is pending still counts: the load's 6, not the nop's 1 + 2.
    let load = [i("lqd", 3, &[4]), i("nop", 3, &[]), i("a", 5, &[3, 3])];
    assert_eq!(cycles_by(rules, &load), [0, 1, 6]);
}

#[test]
fn dsync_waits_for_memory_and_sync_fetches_again() {
    // The load is complete at 6.
    let load = i("lqd", 3, &[4]);
    assert_eq!(cycles(&[load, i("dsync", 0, &[]), i("il", 5, &[])]), [0, 6, 7]);
    // Then the line is fetched again: 6 + 1 + 18.
    assert_eq!(cycles(&[load, i("sync", 0, &[]), i("il", 5, &[])]), [0, 6, 25]);
    // dsync does not wait for arithmetic.
    assert_eq!(cycles(&[i("fm", 3, &[4, 4]), i("dsync", 0, &[])]), [0, 0]);
    // It waits for stores and channel instructions.
    assert_eq!(cycles(&[i("stqd", 3, &[4]), i("dsync", 0, &[])]), [0, 6]);
    assert_eq!(cycles(&[i("wrch", 3, &[21]), i("dsync", 0, &[])]), [0, 6]);
}

#[test]
fn channel_instructions_keep_their_interval() {
    let code = vec![i("wrch", 3, &[21]); 3];
    assert_eq!(cycles(&code), [0, 1, 2]);
    let rules = Rules { channel_interval: 2, ..Rules::default() };
    assert_eq!(cycles_by(rules, &code), [0, 2, 4]);
}

#[test]
fn a_stall_from_outside_holds_issue_and_the_channel_instruction() {
    let mut pipeline = Pipeline::default();
    pipeline.issue(0, i("rdch", 3, &[24]));
    pipeline.stall_until(100, Cause::Channel);
    assert_eq!(pipeline.clock(), 100);
    // The next instruction issues at 100. The data is ready as if the rdch had issued at 99: 99 +
    // 6.
    assert_eq!(pipeline.issue(4, i("il", 5, &[])).cycle, 100);
    assert_eq!(pipeline.issue(8, i("a", 6, &[3, 3])).cycle, 105);
    assert_eq!(pipeline.account().waited(Cause::Channel), 99);
    // A stall that ends in the past has no effect.
    pipeline.stall_until(50, Cause::Dma);
    assert_eq!(pipeline.clock(), 106);
    assert_eq!(pipeline.account().waited(Cause::Dma), 0);
    // A stall after another instruction does not delay the rdch's result: $9 is ready after its
    // own 6.
    let start = pipeline.issue(0x20, i("rdch", 9, &[24])).cycle;
    pipeline.issue(0x24, i("il", 5, &[]));
    pipeline.stall_until(start + 4, Cause::Dma);
    let reader = pipeline.issue(0x28, i("a", 6, &[9, 9]));
    assert_eq!(reader.cycle, start + 6);
    // Nothing pairs across a stall.
    pipeline.issue(0x10, i("il", 7, &[]));
    pipeline.stall_until(200, Cause::Dma);
    let odd = pipeline.issue(0x14, i("lqd", 8, &[9]));
    assert_eq!((odd.cycle, odd.dual), (200, false));
}

#[test]
fn loads_in_every_cycle_starve_straight_line_code() {
    let rules = Rules { inline_prefetch: true, ..Rules::default() };
    let loads = |count| vec![i("lqd", 3, &[4]); count];
    // 64 instructions are buffered and the port is never free. The 65th requests its line in cycle
    // 64, and the line arrives 16 cycles later.
    let cycles = cycles_by(rules, &loads(65));
    assert_eq!(cycles[63], 63);
    assert_eq!(cycles[64], 80);
    // Once there is space for a line, one free cycle is enough: in cycle 41, for the line at 56.
    let mut code = loads(41);
    code.push(i("il", 5, &[]));
    code.extend(loads(40));
    let cycles = cycles_by(rules, &code);
    assert_eq!(cycles.last(), Some(&81));
    // In the first word of a group it pairs with the next load, and the port is not free.
    code.remove(0);
    let cycles = cycles_by(rules, &code);
    assert_eq!(cycles[40..42], [40, 40]);
    assert_eq!(cycles.last(), Some(&(79 + 16)));
    // With the rule off there is no such stall.
    assert_eq!(cycles_by(Rules::default(), &loads(65))[64], 64);
    // A branch to the ninth instruction of a line leaves 64 - 8 instructions: the 57th requests
    // its line in cycle 19 + 56.
    let mut pipeline = Pipeline::new(rules);
    feed(&mut pipeline, 0, &loads(20));
    let branch = pipeline.issue(80, i("br", 0, &[])).cycle;
    pipeline.branched(80, Some(0x120));
    let issues = feed(&mut pipeline, 0x120, &loads(57));
    assert_eq!(issues[55].cycle, branch + 19 + 55);
    assert_eq!(issues[56].cycle, branch + 19 + 56 + 16);
    assert_eq!(issues[56].waited, Some(Cause::Fetch));
}

#[test]
fn a_published_style_schedule() {
    // One step of a reciprocal, laid out in pairs:
    //   lqd $3 0 | (odd first: alone)   lqd at 4 mod 8 follows
    let code = [
        i("il", 10, &[]),           // 0e
        i("lqd", 3, &[80]),         // 0o  $3 at 6
        i("ilhu", 11, &[]),         // 1e
        i("lqd", 4, &[80]),         // 1o  $4 at 7
        i("nop", 127, &[]),         // 2e
        i("frest", 5, &[3]),        // 6o  waits for $3; $5 at 10
        i("fi", 6, &[3, 5]),        // 10e $6 at 17
        i("shufb", 7, &[3, 4, 10]), // 10o pairs; $7 at 14
        i("fnms", 8, &[6, 3, 11]),  // 17e $8 at 23
        i("stqd", 7, &[80]),        // 17o
        i("fma", 9, &[8, 6, 6]),    // 23e $9 at 29
        i("stqd", 9, &[80]),        // 29o
    ];
    let mut pipeline = Pipeline::default();
    let issues = feed(&mut pipeline, 0, &code);
    let cycles: Vec<u64> = issues.iter().map(|issue| issue.cycle).collect();
    assert_eq!(cycles, [0, 0, 1, 1, 2, 6, 10, 10, 17, 17, 23, 29]);
    let account = pipeline.account();
    // Issuing cycles are 0 1 2 6 10 17 23 29, and four of them are dual. 22 of 30 cycles are
    // empty.
    assert_eq!((account.dual(), account.single()), (4, 4));
    assert_eq!(account.cycles(), 30);
    // Empty: 3-5 for the load, 7-9 for frest, 11-16 for fi, 18-22 and 24-28 for FP6.
    assert_eq!(account.waited(Cause::Operand(Class::Ls)), 3);
    assert_eq!(account.waited(Cause::Operand(Class::Shuf)), 3);
    assert_eq!(account.waited(Cause::Operand(Class::Fp7)), 6);
    assert_eq!(account.waited(Cause::Operand(Class::Fp6)), 10);
}
