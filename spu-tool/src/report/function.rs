//! What is found out about one function.

use spu_isa::timing::{Account, HintDistance, Loop, Schedule};
use spu_scheduler::code::Function;

/// The analysis of a function.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FunctionReport {
    /// Which.
    pub function: Function,
    /// Its code from start to end, no branch being taken.
    pub schedule: Schedule,
    /// Its hints whose branches stand behind them.
    pub hints: Vec<HintDistance>,
    /// Its loops.
    pub loops: Vec<Loop>,
}

/// Cycles that were lost, in a line: `12 operand of LS, 6 double-precision stall`.
pub(super) fn waits(account: &Account) -> String {
    let waits = account.waits();
    let text = waits
        .iter()
        .map(|(cause, cycles)| format!("{cycles} {cause}"));
    text.collect::<Vec<_>>().join(", ")
}
