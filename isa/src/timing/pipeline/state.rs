//! A pipeline's state apart from the cycle in which it came about.

use super::super::account::AccountDelta;
use super::super::fetch::InlineBuffer;
use super::super::hint::{Hint, Prediction};
use super::Pipeline;
use crate::instructions::Class;

/// What decides when the instructions behind a branch issue, in cycles from the first in which the
/// next one can. Two equal phases go on alike.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(in super::super) struct Phase {
    /// The registers that cannot be read in that cycle, in their order, and when they can.
    pending: Box<[(u8, u64)]>,
    partner: Option<u32>,
    float_unit_taken: bool,
    memory_done: u64,
    channel_free: u64,
    hint: Option<Hint>,
    inline_buffer: Option<InlineBuffer>,
}

/// Everything in a pipeline that bears on the future, wherever its clock stands: from two equal
/// states on, the same stream takes the same cycles for the same causes.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct State {
    phase: Phase,
    /// The class of what writes each pending register.
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
            inline_buffer: self
                .rules
                .inline_prefetch
                .then(|| self.inline_buffer.relative(floor)),
        }
    }

    /// The state as it is.
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

    /// Goes on from `state`, which a pipeline of the same rules had, as though `delta` had
    /// issued in between.
    pub fn resume(&mut self, state: &State, delta: &AccountDelta) {
        let phase = &state.phase;
        self.account.pass(delta);
        self.clock += delta.cycles();
        self.issued += delta.instructions;
        self.partner = phase.partner;
        let floor = self.floor();
        self.ready.fill(0);
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
