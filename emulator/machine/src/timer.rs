//! Drives a [`Pipeline`] with the instructions that the interpreter runs.

use crate::interp::{Observer, Spu};
use spu_isa::timing::{AccountDelta, Issue, Pipeline, State};
use spu_isa::{Class, Instruction, LIMIT_MASK, Op};

/// Times the instructions that an [`Spu`] runs.
///
/// The outcome of a branch is known only when the next instruction comes. Until then the pipeline
/// lacks the outcome of the last instruction.
#[derive(Clone, Debug, Default)]
pub struct Timer {
    /// The pipeline model that the timer drives.
    pub pipeline: Pipeline,
    /// The instruction that issued last, with its address.
    previous: Option<(u32, Instruction)>,
}

impl Timer {
    /// A timer that continues from the state of `pipeline`.
    #[must_use]
    pub const fn new(pipeline: Pipeline) -> Self {
        Self { pipeline, previous: None }
    }
}

/// The part of a timer's state on which its future depends, independent of its clock.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(crate) struct TimerState {
    pipeline: State,
    pub previous: (u32, Instruction),
}

/// Receives each instruction as it is timed. The unit type records nothing and costs nothing.
pub(crate) trait Recorder {
    /// The instruction at `pc` has issued.
    #[inline]
    fn issued(&mut self, pc: u32, instruction: Instruction, issue: &Issue, pipeline: &Pipeline) {
        let _ = (pc, instruction, issue, pipeline);
    }

    /// The last instruction is a branch or a stop, and its successor is now known.
    #[inline]
    fn branched(&mut self, pipeline: &Pipeline) {
        let _ = pipeline;
    }
}

impl Recorder for () {}

impl Timer {
    /// [`before_instruction`](Observer::before_instruction), with a recorder.
    // Without the attribute, the compiler does not inline this into all loops that time SPUs.
    #[inline(always)]
    pub(crate) fn record<R: Recorder>(
        &mut self,
        spu: &Spu,
        instruction: Instruction,
        recorder: &mut R,
    ) {
        let pc = spu.pc();
        if self.waits_at(pc) {
            return;
        }
        self.issue(pc, instruction, recorder);
        if instruction.op == Op::Hbr {
            self.hint_target(spu, instruction);
        }
    }

    /// Whether the instruction at `pc` is a channel instruction that had to wait and is now run
    /// again. It has issued already.
    #[inline]
    pub(crate) fn waits_at(&self, pc: u32) -> bool {
        let channel = |i: Instruction| i.op.row().class == Class::Spr;
        self.previous.is_some_and(|(previous, instruction)| previous == pc && channel(instruction))
    }

    /// Issues the next executed instruction, which is at `pc`. If it is a hint by register,
    /// [`hint_target`](Self::hint_target) must follow.
    #[inline(always)]
    pub(crate) fn issue<R: Recorder>(
        &mut self,
        pc: u32,
        instruction: Instruction,
        recorder: &mut R,
    ) {
        if let Some((previous, last)) = self.previous {
            let class = last.op.row().class;
            let straight_on = pc == previous.wrapping_add(4) & LIMIT_MASK;
            if class == Class::Br || !straight_on {
                self.pipeline.branched(previous, (!straight_on).then_some(pc));
            }
            if class == Class::Br {
                recorder.branched(&self.pipeline);
            }
        }
        self.previous = Some((pc, instruction));
        let issue = self.pipeline.issue(pc, instruction);
        recorder.issued(pc, instruction, &issue, &self.pipeline);
    }

    /// Passes on the target of the hint that issued last. The SPU's registers must be those at its
    /// issue.
    #[inline]
    pub(crate) fn hint_target(&mut self, spu: &Spu, hint: Instruction) {
        let target = spu.register(hint.ra).preferred();
        self.pipeline.hint_target(target);
    }

    /// The current state, or `None` before the first instruction.
    pub(crate) fn state(&self) -> Option<TimerState> {
        let previous = self.previous?;
        Some(TimerState { pipeline: self.pipeline.state(), previous })
    }

    /// Continues from `state`, as though the instructions of `delta` had issued in between. The
    /// state must come from a timer with the same rules.
    pub(crate) fn resume(&mut self, state: &TimerState, delta: &AccountDelta) {
        self.previous = Some(state.previous);
        self.pipeline.resume(&state.pipeline, delta);
    }
}

impl Observer for Timer {
    #[inline]
    fn before_instruction(&mut self, spu: &Spu, instruction: Instruction) {
        self.record(spu, instruction, &mut ());
    }
}
