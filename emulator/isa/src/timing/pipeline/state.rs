//! A pipeline's state, relative to its current cycle.

use super::super::account::AccountDelta;
use super::super::fetch::InlineBuffer;
use super::super::hint::{Hint, Prediction};
use super::Pipeline;
use crate::instructions::Class;

/// The part of the state that determines when the instructions after a branch issue, relative to
/// the first cycle in which the next one can. Equal phases behave equally.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(in super::super) struct Phase {
    /// The registers that cannot be read in that cycle, in ascending order, and when they can be.
    pending: Box<[(u8, u64)]>,
    partner: Option<u32>,
    float_unit_taken: bool,
    memory_done: u64,
    channel_free: u64,
    hint: Option<Hint>,
    inline_buffer: Option<InlineBuffer>,
}

/// The part of a pipeline's state on which its future depends, independent of its clock. From
/// equal states, the same stream takes the same cycles for the same causes.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct State {
    phase: Phase,
    /// The class of the instruction that writes each pending register.
    producers: Box<[Class]>,
    channel_result: Option<u8>,
    prediction: Prediction,
}

impl Pipeline {
    /// The first cycle in which the next instruction can issue.
    fn floor(&self) -> u64 {
        self.clock - u64::from(self.partner.is_some())
    }

    pub(in super::super) fn phase(&self) -> Phase {
        let floor = self.floor();
        let pending = (0..).zip(self.ready);
        Phase {
            pending: pending
                .filter(|&(_, ready)| ready > floor)
                .map(|(register, ready)| (register, ready - floor))
                .collect(),
            partner: self.partner,
            float_unit_taken: self.float_unit_taken == Some(self.clock),
            memory_done: self.memory_done.saturating_sub(floor),
            channel_free: self.channel_free.saturating_sub(floor),
            hint: self.hint.map(|hint| hint.relative(floor, self.issued)),
            inline_buffer: self.rules.inline_prefetch.then(|| self.inline_buffer.relative(floor)),
        }
    }

    /// The current state.
    #[must_use]
    pub fn state(&self) -> State {
        let phase = self.phase();
        let producer = |&(register, _): &(u8, u64)| self.producer[usize::from(register)];
        State {
            producers: phase.pending.iter().map(producer).collect(),
            phase,
            channel_result: self.channel_result,
            prediction: self.prediction,
        }
    }

    /// Continues from `state`, as though the instructions of `delta` had issued in between. The
    /// state must come from a pipeline with the same rules.
    pub fn resume(&mut self, state: &State, delta: &AccountDelta) {
        let phase = &state.phase;
        self.account.apply(delta);
        self.clock += delta.cycles();
        self.issued += delta.instructions;
        self.partner = phase.partner;
        let floor = self.floor();
        self.ready.fill(0);
        // It may not be pending now, but a stall of its instruction would make it so.
        if let Some(register) = state.channel_result {
            self.producer[usize::from(register)] = Class::Spr;
        }
        for (&(register, ready), &producer) in phase.pending.iter().zip(&state.producers) {
            self.ready[usize::from(register)] = floor + ready;
            self.producer[usize::from(register)] = producer;
        }
        self.float_unit_taken = phase.float_unit_taken.then_some(self.clock);
        self.memory_done = floor + phase.memory_done;
        self.channel_free = floor + phase.channel_free;
        self.hint = phase.hint.map(|hint| hint.at(floor, self.issued));
        if let Some(buffer) = &phase.inline_buffer {
            self.inline_buffer = buffer.at(floor);
        }
        self.channel_result = state.channel_result;
        self.prediction = state.prediction;
    }
}
