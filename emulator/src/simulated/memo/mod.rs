//! Memoised timing: what the pipelines do with a block is worked out once for each state in which
//! they come to it.
//!
//! At a block's entry the pipelines, apart from their clock, are in one of very few states. So
//! states have numbers, and what a block does to a state is a transition: the state behind it, and
//! the cycles with their causes. It is worked out by issuing the block instruction by instruction,
//! which stays the definition. From then on the block takes a look-up and a count; the account and
//! the profile are counts times transitions, added up when somebody asks for them.
//!
//! The cycles of a block do not depend on what it computes: where it goes is known when the next
//! one begins, so a transition starts with the outcome of the block before. Only a hint by a
//! register depends on a value; such a hint ends its block, and its target is told behind it.
//!
//! Invariant: a transition's block is what the interpreter had decoded when
//! [`Spu::rewritings`] was the transition's.

mod hasher;
mod transition;

use std::collections::HashMap;
use std::sync::Arc;

use crate::interp::{Block, Spu};
use crate::local_store::LocalStore;
use crate::profile::Recording;
use crate::timer::{Timer, TimerState};
use hasher::Mixing;
use spu_isa::timing::{AccountDelta, Rules};
use transition::Transition;

/// States and transitions that are kept at most, each. Programs have some hundreds; one that
/// writes new code for ever would have any number.
const ROOM: usize = 1 << 14;
/// Blocks that are kept at one address behind one state.
const VERSIONS: usize = 4;

/// A state's number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) struct StateId(u32);

/// A transition's number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct TransitionId(u32);

#[derive(Debug)]
struct KnownState {
    state: Arc<TimerState>,
    /// Where it has gone on from here: addresses and transitions. The number of them is that of
    /// the branches that end in this state.
    ways: Vec<(u32, TransitionId)>,
}

/// What was worked out so far.
#[derive(Debug, Default)]
pub(super) struct Memo {
    rules: Rules,
    states: Vec<KnownState>,
    numbers: HashMap<Arc<TimerState>, StateId, Mixing>,
    /// By their addresses.
    blocks: HashMap<u32, Vec<Arc<Block>>, Mixing>,
    transitions: Vec<Transition>,
    /// States behind a hint, by the state before its target was told and the target.
    hinted: HashMap<(StateId, u32), StateId, Mixing>,
    /// Transitions that have happened since the last [`settle`](Self::settle).
    happened: Vec<TransitionId>,
}

impl Memo {
    pub fn new(rules: Rules) -> Self {
        Self {
            rules,
            ..Self::default()
        }
    }

    /// Whether there is no room for another state and another transition.
    #[inline]
    pub fn is_full(&self) -> bool {
        self.states.len().max(self.transitions.len()) + 2 > ROOM
    }

    /// Forgets everything. Nothing may have happened that is not settled.
    pub fn forget(&mut self) {
        debug_assert!(self.happened.is_empty());
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
        self.states.push(KnownState {
            state,
            ways: Vec::new(),
        });
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

    /// The transition from `from` by the block at the program counter; `None` if there is none,
    /// because no instruction of this machine stands there.
    #[inline]
    pub fn find(
        &mut self,
        from: StateId,
        spu: &mut Spu,
        local_store: &LocalStore,
    ) -> Option<TransitionId> {
        let (pc, rewritings) = (spu.pc(), spu.rewritings());
        let ways = self.states[from.0 as usize].ways.iter();
        for &(address, at) in ways {
            if address == pc && self.transitions[at.0 as usize].rewritings == rewritings {
                return Some(at);
            }
        }
        self.find_unproven(from, spu)
            .or_else(|| self.make(from, spu, local_store))
    }

    /// One whose block has to be compared, because some block was rewritten since it was last.
    #[cold]
    fn find_unproven(&mut self, from: StateId, spu: &mut Spu) -> Option<TransitionId> {
        let pc = spu.pc();
        for &(address, at) in &self.states[from.0 as usize].ways {
            let transition = &mut self.transitions[at.0 as usize];
            if address == pc && spu.has_decoded(transition.block()) {
                transition.rewritings = spu.rewritings();
                return Some(at);
            }
        }
        None
    }

    #[cold]
    fn make(
        &mut self,
        from: StateId,
        spu: &mut Spu,
        local_store: &LocalStore,
    ) -> Option<TransitionId> {
        let block = spu.block(local_store)?;
        let pc = block.start;
        let block = self.shared(block);
        let start = Arc::clone(&self.states[from.0 as usize].state);
        let (mut transition, end) = Transition::new(&start, block, self.rules);
        transition.to = self.number(end);
        transition.rewritings = spu.rewritings();
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

    /// The block that is kept of those that are like this one.
    fn shared(&mut self, block: Block) -> Arc<Block> {
        let blocks = self.blocks.entry(block.start).or_default();
        if let Some(known) = blocks.iter().find(|known| ***known == block) {
            return Arc::clone(known);
        }
        let block = Arc::new(block);
        // Code that is ever new is not looked for.
        blocks.truncate(VERSIONS);
        blocks.push(Arc::clone(&block));
        block
    }

    /// The transition happens; gives the state behind it.
    #[inline]
    pub fn happen(&mut self, at: TransitionId) -> StateId {
        let transition = &mut self.transitions[at.0 as usize];
        if transition.count == 0 {
            self.happened.push(at);
        }
        transition.count += 1;
        transition.to
    }

    /// The transition that happened last has not happened.
    pub fn undo(&mut self, at: TransitionId) {
        self.transitions[at.0 as usize].count -= 1;
    }

    /// The state behind the hint that ends `state`, told its target.
    pub fn hinted(&mut self, state: StateId, target: u32) -> StateId {
        if let Some(&known) = self.hinted.get(&(state, target)) {
            return known;
        }
        let told = transition::hinted(self.state(state), target, self.rules);
        let told = self.number(told);
        self.hinted.insert((state, target), told);
        told
    }

    /// Brings the timer and the recording to `state`, through all that happened.
    pub fn settle(
        &mut self,
        state: StateId,
        timer: &mut Timer,
        mut recording: Option<&mut Recording>,
    ) {
        let mut delta = AccountDelta::default();
        for at in self.happened.drain(..) {
            let transition = &mut self.transitions[at.0 as usize];
            let count = std::mem::take(&mut transition.count);
            transition.pass(count, &mut delta);
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
