//! Memoised timing: the effect of a block on the pipelines is computed once for each state in
//! which they enter the block.
//!
//! At a block's entry the pipelines are, apart from their clock, in one of very few states. So
//! states are numbered, and the effect of a block on a state is a transition: the state after the
//! block, and the cycles with their causes. A transition is computed by issuing the block
//! instruction by instruction, which remains the definition. After that the block takes only a
//! look-up and a count. The account and the profile are the transitions times their counts, added
//! up on demand.
//!
//! The cycles of a block do not depend on the values that it computes. The outcome of its branch
//! is known when the next block begins, so a transition starts with the outcome of the previous
//! block. Only a hint by register depends on a value. Such a hint ends its block, and its target
//! is added after the block.
//!
//! Invariant: a transition's block is the code that the interpreter had decoded when
//! [`Spu::code_changes`] had the transition's value.

mod transition;

use std::sync::Arc;

use crate::interp::{Block, Spu};
use crate::local_store::LocalStore;
use crate::profile::Recording;
use crate::timer::{Timer, TimerState};
use rustc_hash::FxHashMap;
use spu_isa::timing::{AccountDelta, Rules};
use transition::Transition;

/// The largest number of states, and of transitions. Programs have some hundreds, but a program
/// that keeps writing new code would have an unlimited number.
const CAPACITY: usize = 1 << 14;
/// The largest number of blocks that are kept for one address and one state.
const VERSIONS: usize = 4;

/// The number of a state.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) struct StateId(u32);

/// The number of a transition.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct TransitionId(u32);

#[derive(Debug)]
struct StoredState {
    state: Arc<TimerState>,
    /// The transitions from this state so far, with the addresses of their blocks. There are as
    /// many as the branches that end in this state have targets.
    ways: Vec<(u32, TransitionId)>,
}

/// The results that have been computed so far.
///
/// The tables are bounded, so a guest whose keys collide slows only itself down. They need no hash
/// function that resists such keys.
#[derive(Debug, Default)]
pub(super) struct Memo {
    rules: Rules,
    states: Vec<StoredState>,
    numbers: FxHashMap<Arc<TimerState>, StateId>,
    blocks: FxHashMap<u32, Vec<Arc<Block>>>,
    transitions: Vec<Transition>,
    /// States after a hint by register, by the state before the target was known and the target.
    hinted: FxHashMap<(StateId, u32), StateId>,
    /// Transitions that were taken since the last [`bring_up_to`](Self::bring_up_to).
    taken: Vec<TransitionId>,
}

impl Memo {
    pub fn new(rules: Rules) -> Self {
        Self { rules, ..Self::default() }
    }

    /// Whether the table can't hold another state and another transition.
    #[inline]
    pub fn is_full(&self) -> bool {
        self.states.len().max(self.transitions.len()) + 2 > CAPACITY
    }

    /// Forgets everything. All transitions must have been added to a timer.
    pub fn forget(&mut self) {
        debug_assert!(self.taken.is_empty());
        *self = Self::new(self.rules);
    }

    /// The number of a state.
    pub fn number(&mut self, state: TimerState) -> StateId {
        if let Some(&number) = self.numbers.get(&state) {
            return number;
        }
        let number = StateId(self.states.len() as u32);
        let state = Arc::new(state);
        self.numbers.insert(Arc::clone(&state), number);
        self.states.push(StoredState { state, ways: Vec::new() });
        number
    }

    /// The state with this number.
    pub fn state(&self, number: StateId) -> &TimerState {
        &self.states[number.0 as usize].state
    }

    /// A transition.
    #[inline]
    pub fn transition(&self, at: TransitionId) -> &Transition {
        &self.transitions[at.0 as usize]
    }

    /// The transition from `from` by the block at `pc`, of which `ran` instructions have run.
    /// `None` if this machine has no such instruction as the one there.
    #[inline]
    pub fn find(
        &mut self,
        from: StateId,
        (pc, ran): (u32, u32),
        spu: &mut Spu,
        local_store: &LocalStore,
    ) -> Option<TransitionId> {
        let code_changes = spu.code_changes();
        let ways = self.states[from.0 as usize].ways.iter();
        for &(address, at) in ways {
            if address == pc && self.transitions[at.0 as usize].code_changes == code_changes {
                return Some(at);
            }
        }
        self.find_after_code_change(from, pc, spu)
            .or_else(|| self.make(from, (pc, ran), spu, local_store))
    }

    /// A transition whose block must be compared again, because code was rewritten since the last
    /// comparison.
    #[cold]
    fn find_after_code_change(
        &mut self,
        from: StateId,
        pc: u32,
        spu: &mut Spu,
    ) -> Option<TransitionId> {
        for &(address, at) in &self.states[from.0 as usize].ways {
            let transition = &mut self.transitions[at.0 as usize];
            if address == pc && spu.has_decoded(transition.block()) {
                transition.code_changes = spu.code_changes();
                return Some(at);
            }
        }
        None
    }

    #[cold]
    fn make(
        &mut self,
        from: StateId,
        (pc, ran): (u32, u32),
        spu: &mut Spu,
        local_store: &LocalStore,
    ) -> Option<TransitionId> {
        let block = spu.block(pc, ran, local_store)?;
        let block = self.shared(block);
        let start = Arc::clone(&self.states[from.0 as usize].state);
        let (mut transition, end) = Transition::new(&start, block, self.rules);
        transition.to = self.number(end);
        transition.code_changes = spu.code_changes();
        let at = TransitionId(self.transitions.len() as u32);
        self.transitions.push(transition);
        let ways = &mut self.states[from.0 as usize].ways;
        let here = |&(address, _): &(u32, TransitionId)| address == pc;
        if ways.iter().filter(|way| here(way)).count() == VERSIONS
            && let Some(oldest) = ways.iter().position(here)
        {
            ways.remove(oldest);
        }
        ways.push((pc, at));
        Some(at)
    }

    /// The shared copy of this block.
    fn shared(&mut self, block: Block) -> Arc<Block> {
        let blocks = self.blocks.entry(block.start).or_default();
        if let Some(known) = blocks.iter().find(|known| ***known == block) {
            return Arc::clone(known);
        }
        let block = Arc::new(block);
        // If code keeps changing, its old blocks are not worth keeping.
        blocks.truncate(VERSIONS);
        blocks.push(Arc::clone(&block));
        block
    }

    /// Takes a transition. Returns the state after it.
    #[inline]
    pub fn take(&mut self, at: TransitionId) -> StateId {
        let transition = &mut self.transitions[at.0 as usize];
        if transition.count == 0 {
            self.taken.push(at);
        }
        transition.count += 1;
        transition.to
    }

    /// Takes back the transition that was taken last.
    pub fn undo(&mut self, at: TransitionId) {
        self.transitions[at.0 as usize].count -= 1;
    }

    /// The state after the hint by register that ends `state`, with the hint's target.
    pub fn hinted(&mut self, state: StateId, target: u32) -> StateId {
        if let Some(&known) = self.hinted.get(&(state, target)) {
            return known;
        }
        let after = transition::hinted(self.state(state), target, self.rules);
        let after = self.number(after);
        self.hinted.insert((state, target), after);
        after
    }

    /// Brings the timer and the recording to `state`, through all transitions that were taken.
    pub fn bring_up_to(
        &mut self,
        state: StateId,
        timer: &mut Timer,
        mut recording: Option<&mut Recording>,
    ) {
        let mut delta = AccountDelta::default();
        for at in self.taken.drain(..) {
            let transition = &mut self.transitions[at.0 as usize];
            let count = std::mem::take(&mut transition.count);
            transition.add_to(count, &mut delta);
            if let Some(recording) = &mut recording {
                transition.charge(count, recording);
            }
        }
        let state = &self.states[state.0 as usize].state;
        timer.resume(state, &delta);
        if let Some(recording) = recording {
            recording.catch_up(state.previous, &timer.pipeline);
        }
    }
}
