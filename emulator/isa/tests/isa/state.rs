//! A pipeline that continues from another's state must behave as that one does.

use proptest::prelude::*;
use spu_isa::timing::{Account, AccountDelta, Cause, Issue, Pipeline, Rules};
use spu_isa::{Instruction, Op};

use super::sequences::{hint, i};

/// An event in a pipeline.
#[derive(Clone, Copy, Debug)]
enum Event {
    /// An instruction issues at the next address.
    Issue(Instruction),
    /// The last instruction went to this address.
    Branched(Option<u32>),
    /// The last instruction, a hint, has this target.
    Target(u32),
    /// Nothing issues for this many cycles.
    Stall(u64),
}

fn instruction() -> impl Strategy<Value = Instruction> {
    let ops = [
        "a", "shl", "shufb", "fa", "fi", "fma", "dfa", "mpy", "lqd", "stqd", "lnop", "nop", "br",
        "brnz", "bi", "rdch", "wrch", "sync", "dsync", "cntb", "cflts", "stop",
    ];
    let register = 0_u8..12;
    let plain = (prop::sample::select(ops.to_vec()), prop::array::uniform4(register))
        .prop_map(|(op, [rt, ra, rb, rc])| i(op, rt, &[ra, rb, rc]));
    let near = prop::sample::select(vec!["hbr", "hbrr"]);
    let hinting = (near, 1_i16..16, 0_i32..16)
        .prop_map(|(op, distance, target)| hint(op, 4 * distance, 4 * target));
    prop_oneof![6 => plain, 1 => hinting]
}

fn event() -> impl Strategy<Value = Event> {
    let address = || (0_u32..64).prop_map(|word| 4 * word);
    prop_oneof![
        12 => instruction().prop_map(Event::Issue),
        2 => prop::option::of(address()).prop_map(Event::Branched),
        1 => address().prop_map(Event::Target),
        1 => prop_oneof![1_u64..40, Just(100_000)].prop_map(Event::Stall),
    ]
}

fn rules() -> impl Strategy<Value = Rules> {
    let switches = prop::array::uniform5(any::<bool>());
    (switches, 1_u64..14).prop_map(|(switches, channel_interval)| Rules {
        hints: switches[0],
        float_conflict: switches[1],
        false_targets: switches[2],
        inline_prefetch: switches[3],
        double_extension: switches[4],
        channel_interval,
        ..Rules::default()
    })
}

/// A pipeline, and the address at which it continues.
#[derive(Clone)]
struct Stream(Pipeline, u32);

impl Stream {
    fn apply(&mut self, event: Event) -> Option<Issue> {
        let Self(pipeline, pc) = self;
        match event {
            Event::Issue(instruction) => {
                let issue = pipeline.issue(*pc, instruction);
                *pc = (*pc + 4) % 256;
                return Some(issue);
            }
            Event::Branched(target) => {
                pipeline.branched(pc.wrapping_sub(4) % 256, target);
                *pc = target.unwrap_or(*pc);
            }
            Event::Target(target) => pipeline.hint_target(target),
            Event::Stall(cycles) => {
                pipeline.stall_until(pipeline.clock() + cycles, Cause::Channel);
            }
        }
        None
    }
}

/// An issue relative to the cycle before `clock`, because the second of a pair issues in that
/// cycle.
fn seen_from(issue: Issue, clock: u64) -> Issue {
    Issue { cycle: issue.cycle + 1 - clock, ready_cycle: issue.ready_cycle - issue.cycle, ..issue }
}

/// Instructions, dual cycles, all cycles.
fn sums(account: &Account) -> [u64; 3] {
    [account.instructions(), account.dual(), account.cycles()]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn from_a_state_the_same_stream_takes_the_same_cycles(
        rules in rules(),
        before in prop::collection::vec(event(), 1..60),
        later in prop::collection::vec(event(), 1..60),
    ) {
        let mut first = Stream(Pipeline::new(rules), 0);
        for event in before {
            first.apply(event);
        }
        // The other pipeline is at another clock, has its own account, and has registers to wait
        // for.
        let mut other = Stream(Pipeline::new(rules), first.1);
        other.0.issue(0, Instruction { op: Op::Dfm, ..i("dfm", 5, &[1, 2]) });
        let delta = AccountDelta { instructions: 1 << 40, ..AccountDelta::default() };
        other.0.resume(&first.0.state(), &delta);
        prop_assert_eq!(other.0.state(), first.0.state());
        prop_assert_eq!(other.0.account().cycles(), other.0.clock());
        let (clock, other_clock) = (first.0.clock(), other.0.clock());
        let (account, other_account) = (first.0.account().clone(), other.0.account().clone());
        for event in later {
            let issues = (first.apply(event), other.apply(event));
            let first_seen = issues.0.map(|issue| seen_from(issue, clock));
            prop_assert_eq!(first_seen, issues.1.map(|issue| seen_from(issue, other_clock)));
            prop_assert_eq!(other.0.state(), first.0.state());
        }
        let stalls = first.0.account().stalls().since(account.stalls());
        prop_assert_eq!(other.0.account().stalls().since(other_account.stalls()), stalls);
        let passed = |now: &Account, then: &Account| {
            let (now, then) = (sums(now), sums(then));
            [0, 1, 2].map(|at| now[at] - then[at])
        };
        prop_assert_eq!(
            passed(other.0.account(), &other_account),
            passed(first.0.account(), &account)
        );
    }
}

/// The result of a channel instruction is there when the state is taken; then the instruction
/// stalls, so that it is not there again.
#[test]
fn a_stall_behind_a_state_has_its_cause() {
    let mut first = Pipeline::default();
    first.issue(0, i("rdch", 7, &[0]));
    first.branched(0, Some(64));
    let mut other = Pipeline::default();
    other.resume(&first.state(), &AccountDelta::default());
    for pipeline in [&mut first, &mut other] {
        pipeline.stall_until(pipeline.clock() + 1, Cause::Channel);
    }
    assert_eq!(other.state(), first.state());
}
