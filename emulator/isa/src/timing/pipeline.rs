//! The issue rules: in program order, two pipes, pairs by address.
//!
//! Invariant: after every call, the account's cycles add up to the clock.

mod state;

use super::account::{Account, Cause};
use super::fetch::InlineBuffer;
use super::hint::{Hint, Prediction, reserves_prefetch};
use super::rules::{DOUBLE_INTERVAL, FLOAT_CONFLICT_DISTANCE, REFETCH_CYCLES, Rules};
use crate::address::LIMIT_MASK;
use crate::instructions::{Class, Instruction, Op, Pipe, Target};

pub use state::State;

/// How an instruction issued.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Issue {
    /// The cycle, counted from 0.
    pub cycle: u64,
    /// The pipe.
    pub pipe: Pipe,
    /// Whether it issued as the second of a pair.
    pub dual: bool,
    /// Whether it would have, if it had been ready.
    pub missed_dual: bool,
    /// The cause of its longest wait, if it waited.
    pub waited: Option<Cause>,
    /// Cycles in which nothing issued because of it. With a cause, 0 means that it only missed its
    /// partner.
    pub waited_cycles: u64,
    /// The register that it waited for, if [`waited`](Self::waited) is an operand.
    pub waited_register: Option<u8>,
    /// The first cycle in which a reader of its result can issue. For a hint, the first cycle in
    /// which the hint works.
    pub ready_cycle: u64,
}

/// The pipelines of one SPU.
#[derive(Clone, Debug)]
pub struct Pipeline {
    rules: Rules,
    /// The first cycle that has no entry in the account yet.
    clock: u64,
    issued: u64,
    /// Address of the instruction that may still pair with the one issued in the last cycle.
    partner: Option<u32>,
    /// The first cycle in which each register can be read, and the class of the instruction that
    /// writes it.
    ready: [u64; 128],
    producer: [Class; 128],
    /// The cycle in which the last FP7 instruction occupies the unit that FP6 needs.
    float_unit_taken: Option<u64>,
    /// When all loads, stores and channel instructions so far are complete.
    memory_done: u64,
    /// The first cycle in which a channel instruction may issue.
    channel_free: u64,
    /// The target of the channel instruction that issued last, as long as no other instruction has
    /// issued.
    channel_result: Option<u8>,
    hint: Option<Hint>,
    prediction: Prediction,
    inline_buffer: InlineBuffer,
    account: Account,
}

/// The progress of an instruction towards its issue cycle.
struct Wait {
    cycle: u64,
    longest: u64,
    cause: Option<Cause>,
}

impl Default for Pipeline {
    fn default() -> Self {
        Self::new(Rules::default())
    }
}

impl Pipeline {
    /// Pipelines at cycle 0 in which all registers are ready.
    #[must_use]
    pub fn new(rules: Rules) -> Self {
        Self {
            rules,
            clock: 0,
            issued: 0,
            partner: None,
            ready: [0; 128],
            producer: [Class::Nop; 128],
            float_unit_taken: None,
            memory_done: 0,
            channel_free: 0,
            channel_result: None,
            hint: None,
            prediction: Prediction::NotTaken,
            inline_buffer: InlineBuffer::default(),
            account: Account::default(),
        }
    }

    /// Number of cycles so far. It is the first cycle in which the next instruction can issue,
    /// unless that one pairs with the last.
    #[inline]
    #[must_use]
    pub const fn clock(&self) -> u64 {
        self.clock
    }

    /// The account of the cycles.
    #[inline]
    #[must_use]
    pub const fn account(&self) -> &Account {
        &self.account
    }

    /// Issues the next instruction of the executed stream, which is at `pc`.
    pub fn issue(&mut self, pc: u32, instruction: Instruction) -> Issue {
        let class = instruction.op.row().class;
        let pipe = class.pipe();
        let may_join = pipe == Pipe::Odd && self.partner == Some(pc);
        let start = self.clock - u64::from(may_join);
        let mut wait = Wait { cycle: start, longest: 0, cause: None };

        if self.rules.inline_prefetch {
            let there = self.inline_buffer.available(start);
            self.hold(&mut wait, there, Cause::Fetch);
        }
        if class == Class::Spr {
            self.hold(&mut wait, self.channel_free, Cause::Channel);
        }
        let mut waited_register = None;
        if let Some((register, ready)) = self.last_operand(instruction)
            && ready > wait.cycle
        {
            waited_register = Some(register);
            let producer = self.producer[usize::from(register)];
            self.hold(&mut wait, ready, Cause::Operand(producer));
        }
        self.prediction = Prediction::NotTaken;
        match class {
            Class::Fp6
                if self.rules.float_conflict && self.float_unit_taken == Some(wait.cycle) =>
            {
                let free = wait.cycle + 1;
                self.hold(&mut wait, free, Cause::FloatConflict);
            }
            Class::Br if matches!(instruction.op, Op::Sync | Op::Dsync) => {
                self.hold(&mut wait, self.memory_done, Cause::Synchronise);
            }
            Class::Br if self.rules.hints => {
                if let Some(hint) = self.hint
                    && let Some((prediction, ready)) = hint.for_branch(pc, self.issued)
                {
                    self.prediction = prediction;
                    self.hold(&mut wait, ready, Cause::HintWait);
                }
            }
            _ => {}
        }

        let cycle = wait.cycle;
        let dual = may_join && cycle == start;
        let waited_cycles = cycle.saturating_sub(self.clock);
        if dual {
            self.account.join();
        } else {
            self.account.add_single();
            self.clock = cycle + 1;
        }
        let ready_cycle = cycle + self.rules.latency(class);
        self.take_effect(pc, instruction, class, cycle, ready_cycle);
        self.issued += 1;
        Issue {
            cycle,
            pipe,
            dual,
            missed_dual: may_join && !dual,
            waited: wait.cause,
            waited_cycles,
            waited_register: waited_register
                .filter(|_| matches!(wait.cause, Some(Cause::Operand(_)))),
            ready_cycle,
        }
    }

    /// Records the target of the branch at `pc`, which issued last. `None` means that it was not
    /// taken. An interrupt or a restart is reported in the same way: nothing predicted it, so it
    /// costs a miss.
    pub fn branched(&mut self, pc: u32, target: Option<u32>) {
        let right = match self.prediction {
            Prediction::NotTaken => target.is_none(),
            Prediction::To(predicted) => target == Some(predicted),
            Prediction::Right => target.is_some(),
        };
        self.prediction = Prediction::NotTaken;
        if right && target.is_none() {
            return;
        }
        let continues = target.unwrap_or(pc.wrapping_add(4) & LIMIT_MASK);
        self.inline_buffer.redirected(continues);
        if !right {
            self.stall(self.clock + self.rules.miss_cycles, Cause::BranchMiss);
        }
    }

    /// Sets the target of the `hbr` that issued last, which is a register's value. Without this
    /// call the hint is assumed to be correct.
    pub fn hint_target(&mut self, target: u32) {
        if let Some(hint) = &mut self.hint
            && hint.is_number(self.issued.wrapping_sub(1))
        {
            hint.set_target(target);
        }
    }

    /// Lets nothing issue before `cycle`, because of an event outside the pipelines. If a channel
    /// instruction issued last, the event held it up: its result is ready as though it had issued
    /// in the cycle before `cycle`.
    pub fn stall_until(&mut self, cycle: u64, cause: Cause) {
        if cycle <= self.clock {
            return;
        }
        let done = cycle - 1 + self.rules.latency(Class::Spr);
        if let Some(register) = self.channel_result.take() {
            self.ready[usize::from(register)] = done;
            self.memory_done = self.memory_done.max(done);
        }
        self.stall(cycle, cause);
    }

    /// The source register that is ready last, and when it is ready.
    #[inline]
    fn last_operand(&self, i: Instruction) -> Option<(u8, u64)> {
        if reserves_prefetch(i) {
            return None;
        }
        let fields = i.op.row().reads.iter();
        let registers = fields.map(|&field| i.register(field) & 127);
        let times = registers.map(|register| (register, self.ready[usize::from(register)]));
        times.max_by_key(|&(_, ready)| ready)
    }

    /// Delays an instruction's issue to `until`. The cycles in which nothing else issues are
    /// charged to `cause`.
    #[inline]
    fn hold(&mut self, wait: &mut Wait, until: u64, cause: Cause) {
        if until <= wait.cycle {
            return;
        }
        // The cycle that it could have shared with its partner is not empty.
        let empty = until.saturating_sub(wait.cycle.max(self.clock));
        if empty > 0 {
            self.account.add_wait(cause, empty);
        }
        if wait.cause.is_none() || empty > wait.longest {
            wait.longest = empty;
            wait.cause = Some(cause);
        }
        wait.cycle = until;
    }

    fn stall(&mut self, until: u64, cause: Cause) {
        self.account.add_wait(cause, until - self.clock);
        self.clock = until;
        self.partner = None;
    }

    /// The effect of the instruction on later ones.
    #[inline]
    fn take_effect(&mut self, pc: u32, i: Instruction, class: Class, cycle: u64, ready: u64) {
        let row = i.op.row();
        self.channel_result = None;
        let register = usize::from(i.rt & 127);
        let written = row.target == Target::Rt;
        if written {
            self.ready[register] = ready;
            self.producer[register] = class;
        } else if row.target == Target::False && self.rules.false_targets {
            // A `nop` has no latency of its own. Its false target is treated as written by an FX2.
            let ready = ready.max(cycle + self.rules.latency(Class::Fx2));
            // The value is still that of the last real write, which may arrive later.
            if ready > self.ready[register] {
                self.ready[register] = ready;
                self.producer[register] = class;
            }
        }
        let blocks = class == Class::Fpd && !self.rules.double_extension;
        let leads = class.pipe() == Pipe::Even && pc & 4 == 0;
        self.partner = leads.then_some(pc.wrapping_add(4));
        if self.rules.inline_prefetch {
            let fetches = class == Class::Hb && !reserves_prefetch(i);
            self.inline_buffer.issued(cycle, class == Class::Ls || fetches);
        }
        match class {
            Class::Fpd if blocks => self.stall(cycle + DOUBLE_INTERVAL, Cause::DoubleStall),
            Class::Fp7 => self.float_unit_taken = Some(cycle + FLOAT_CONFLICT_DISTANCE),
            Class::Ls => self.memory_done = self.memory_done.max(ready),
            Class::Spr => {
                self.memory_done = self.memory_done.max(ready);
                self.channel_free = cycle + self.rules.channel_interval;
                self.channel_result = written.then_some(i.rt & 127);
            }
            Class::Hb if self.rules.hints => {
                if let Some(hint) = Hint::new(pc, i, ready, self.issued) {
                    self.hint = Some(hint);
                }
            }
            Class::Br if i.op == Op::Sync => {
                self.stall(self.clock + REFETCH_CYCLES, Cause::Synchronise);
            }
            _ => {}
        }
    }
}
