//! The analysis of one function.

use spu_isa::timing::{Account, HintDistance, Loop, Schedule};
use spu_scheduler::code::Function;

/// The analysis of a function.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FunctionReport {
    /// The function.
    pub function: Function,
    /// Its code from start to end, with no branch taken.
    pub schedule: Schedule,
    /// The hints whose branches come after them.
    pub hints: Vec<HintDistance>,
    /// Its loops.
    pub loops: Vec<Loop>,
}

/// The lost cycles in one line: `12 operand of LS, 6 double-precision stall`.
pub(super) fn waits(account: &Account) -> String {
    let waits = account.waits();
    let text = waits.iter().map(|(cause, cycles)| format!("{cycles} {cause}"));
    text.collect::<Vec<_>>().join(", ")
}
