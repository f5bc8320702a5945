//! The rules of branches and their hints. The other rules are in `rules.rs`.
//!
//! Provenance of every expectation: `model`, with the derivation in a comment.

use spu_isa::timing::{Cause, Pipeline, Rules};

use super::sequences::{cycles, feed, hint, i, nops};

#[test]
fn a_compare_gives_its_branch_two_cycles_later() {
    assert_eq!(cycles(&[i("ceq", 3, &[4, 5]), i("brnz", 3, &[])]), [0, 2]);
}

/// The cycle in which the instruction at the branch's target issues. The branch is at 0x40 and
/// issues in cycle 0.
fn after_branch(rules: Rules, taken: bool) -> u64 {
    let mut pipeline = Pipeline::new(rules);
    assert_eq!(pipeline.issue(0x40, i("brz", 3, &[])).cycle, 0);
    pipeline.branched(0x40, taken.then_some(0x100));
    let next = if taken { 0x100 } else { 0x44 };
    pipeline.issue(next, i("il", 4, &[])).cycle
}

#[test]
fn an_unhinted_branch_costs_its_cycle_or_a_miss() {
    let rules = Rules::default();
    assert_eq!(after_branch(rules, false), 1);
    // t + 1 + 18
    assert_eq!(after_branch(rules, true), 19);
    let rules = Rules { miss_cycles: 19, ..rules };
    assert_eq!(after_branch(rules, true), 20);
}

#[test]
fn a_taken_branch_ends_its_group() {
    // nop | br pair in cycle 0. The target is the second word of a group and issues alone.
    let mut pipeline = Pipeline::default();
    feed(&mut pipeline, 0, &[i("nop", 127, &[]), i("br", 0, &[])]);
    assert_eq!(pipeline.account().dual(), 1);
    pipeline.branched(4, Some(0x104));
    assert_eq!(pipeline.issue(0x104, i("lqd", 3, &[4])).cycle, 19);
    // An even instruction at 0x100 and then a jump to 0x104 are not a group either.
    let mut pipeline = Pipeline::default();
    pipeline.issue(0x100, i("il", 3, &[]));
    pipeline.branched(0x100, Some(0x104));
    assert!(!pipeline.issue(0x104, i("lqd", 5, &[4])).dual);
}

/// A hint in cycle 0, `between` nops, and a branch that is taken to 0x800. Returns the cycles of
/// the branch and of the instruction after it.
fn hinted(hinted_target: u32, between: usize, taken: Option<u32>) -> (u64, u64, Pipeline) {
    let mut pipeline = Pipeline::default();
    let branch = 4 + 4 * between as u32;
    pipeline.issue(0, hint("hbra", branch as i16, hinted_target as i32));
    feed(&mut pipeline, 4, &nops(between));
    let issue = pipeline.issue(branch, i("br", 0, &[]));
    pipeline.branched(branch, taken);
    let next = pipeline.issue(taken.unwrap_or(branch + 4), i("il", 3, &[]));
    (issue.cycle, next.cycle, pipeline)
}

#[test]
fn a_far_hint_makes_its_branch_free() {
    // The hint works in cycle 16. The 15 nops bring the branch to cycle 16 anyway.
    let (branch, next, pipeline) = hinted(0x800, 15, Some(0x800));
    assert_eq!((branch, next), (16, 17));
    assert_eq!(pipeline.account().stalled(), 0);
}

#[test]
fn a_near_hint_holds_its_branch() {
    // 8 nops would bring the branch to cycle 9. It waits until 16, and is free then.
    let (branch, next, pipeline) = hinted(0x800, 8, Some(0x800));
    assert_eq!((branch, next), (16, 17));
    assert_eq!(pipeline.account().waited(Cause::HintWait), 7);
}

#[test]
fn a_hint_with_less_than_eight_instructions_is_not_seen() {
    // 7 nops: the branch issues in cycle 8 without waiting, and misses: 8 + 1 + 18.
    let (branch, next, pipeline) = hinted(0x800, 7, Some(0x800));
    assert_eq!((branch, next), (8, 27));
    assert_eq!(pipeline.account().waited(Cause::HintWait), 0);
}

#[test]
fn a_wrong_hint_costs_a_miss() {
    // The branch is not taken, or is taken to another target: 16 + 1 + 18.
    assert_eq!(hinted(0x800, 15, None).1, 35);
    assert_eq!(hinted(0x900, 15, Some(0x800)).1, 35);
}

#[test]
fn the_last_hint_wins() {
    let mut pipeline = Pipeline::default();
    // Two hints for different branches, then 20 nops. The first hint's branch is not predicted.
    pipeline.issue(0, hint("hbra", 0x58, 0x800));
    pipeline.issue(4, hint("hbra", 0x58, 0x900));
    feed(&mut pipeline, 8, &nops(20));
    let branch = pipeline.issue(0x58, i("br", 0, &[])).cycle;
    pipeline.branched(0x58, Some(0x800));
    assert_eq!(pipeline.issue(0x800, i("il", 3, &[])).cycle, branch + 19);
    // The second hint's branch is.
    feed(&mut pipeline, 0x804, &nops(20));
    let branch = pipeline.issue(0x5c, i("br", 0, &[])).cycle;
    pipeline.branched(0x5c, Some(0x900));
    assert_eq!(pipeline.issue(0x900, i("il", 3, &[])).cycle, branch + 1);
}

#[test]
fn a_hint_is_for_its_branch_alone() {
    // The branch at 0x40 is not the hinted one. If it is not taken it is free, and it does not
    // wait.
    let mut pipeline = Pipeline::default();
    pipeline.issue(0x10, hint("hbra", 0x70, 0x800));
    feed(&mut pipeline, 0x14, &nops(11));
    let branch = pipeline.issue(0x40, i("brz", 3, &[])).cycle;
    assert_eq!(branch, 12);
    pipeline.branched(0x40, None);
    assert_eq!(pipeline.issue(0x44, i("il", 4, &[])).cycle, 13);
    // A hinted branch whose outcome was not reported does not affect the next one.
    feed(&mut pipeline, 0x48, &nops(14));
    pipeline.issue(0x80, i("br", 0, &[]));
    let branch = pipeline.issue(0x84, i("brz", 3, &[])).cycle;
    pipeline.branched(0x84, None);
    assert_eq!(pipeline.issue(0x88, i("il", 4, &[])).cycle, branch + 1);
}

#[test]
fn relative_and_register_hints_name_their_targets() {
    for (hint, hinted) in [
        (hint("hbrr", 0x40, 0x300), None),
        (hint("hbr", 0x40, 0), Some(0x400)),
        (hint("hbr", 0x40, 0), None),
    ] {
        let mut pipeline = Pipeline::default();
        pipeline.issue(0x100, hint);
        if let Some(target) = hinted {
            pipeline.hint_target(target);
        }
        feed(&mut pipeline, 0x104, &nops(15));
        let branch = pipeline.issue(0x140, i("br", 0, &[])).cycle;
        pipeline.branched(0x140, Some(0x400));
        assert_eq!(pipeline.issue(0x400, i("il", 3, &[])).cycle, branch + 1);
    }
    // An hbr whose register holds another address causes a miss.
    let mut pipeline = Pipeline::default();
    pipeline.issue(0x100, hint("hbr", 0x40, 0));
    pipeline.hint_target(0x500);
    feed(&mut pipeline, 0x104, &nops(15));
    let branch = pipeline.issue(0x140, i("bi", 0, &[9])).cycle;
    pipeline.branched(0x140, Some(0x400));
    assert_eq!(pipeline.issue(0x400, i("il", 3, &[])).cycle, branch + 19);
}

#[test]
fn a_prefetch_hint_hints_nothing_and_reads_nothing() {
    // hbrp is hbr with its p bit (4). Its ra is 3, which a load is writing.
    let mut prefetch = hint("hbr", 0x44, 4);
    prefetch.ra = 3;
    let mut pipeline = Pipeline::default();
    pipeline.issue(0, hint("hbra", 0x48, 0x800));
    pipeline.issue(4, i("lqd", 3, &[4]));
    assert_eq!(pipeline.issue(8, prefetch).cycle, 2);
    // Its register's value must not become the older hint's target either.
    pipeline.hint_target(0x900);
    feed(&mut pipeline, 0xc, &nops(15));
    let branch = pipeline.issue(0x48, i("br", 0, &[])).cycle;
    pipeline.branched(0x48, Some(0x800));
    assert_eq!(pipeline.issue(0x800, i("il", 3, &[])).cycle, branch + 1);
}

#[test]
fn without_hints_every_taken_branch_misses() {
    let mut pipeline = Pipeline::new(Rules { hints: false, ..Rules::default() });
    pipeline.issue(0, hint("hbra", 0x40, 0x800));
    feed(&mut pipeline, 4, &nops(15));
    let branch = pipeline.issue(0x40, i("br", 0, &[])).cycle;
    assert_eq!(branch, 16);
    pipeline.branched(0x40, Some(0x800));
    assert_eq!(pipeline.issue(0x800, i("il", 3, &[])).cycle, 35);
}
