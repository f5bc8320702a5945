//! Feeds a [`Pipeline`] from the interpreter.

use crate::interp::{Observer, Spu};
use spu_isa::timing::{AccountDelta, Issue, Pipeline, State};
use spu_isa::{Class, Instruction, LIMIT_MASK, Op};

/// Times what an [`Spu`] runs.
///
/// Where a branch went shows when the next instruction comes, so the last one's outcome is missing
/// until then.
#[derive(Clone, Debug, Default)]
pub struct Timer {
    /// What it drives.
    pub pipeline: Pipeline,
    /// The instruction that issued last, and its address.
    previous: Option<(u32, Instruction)>,
}

impl Timer {
    /// A timer that goes on from the state of `pipeline`.
    #[must_use]
    pub const fn new(pipeline: Pipeline) -> Self {
        Self {
            pipeline,
            previous: None,
        }
    }
}

/// Everything in a timer that bears on the future, wherever its clock stands.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(crate) struct TimerState {
    pipeline: State,
    pub previous: (u32, Instruction),
}

/// Learns of each instruction as it is timed. The unit type records nothing, and costs nothing.
pub(crate) trait Recorder {
    /// The instruction at `pc` has issued.
    #[inline]
    fn issued(&mut self, pc: u32, instruction: Instruction, issue: &Issue, pipeline: &Pipeline) {
        let _ = (pc, instruction, issue, pipeline);
    }

    /// It is known where the instruction that issued last went, which is a branch or a stop.
    #[inline]
    fn branched(&mut self, pipeline: &Pipeline) {
        let _ = pipeline;
    }
}

impl Recorder for () {}

impl Timer {
    /// [`before_instruction`](Observer::before_instruction), written down by `recorder`.
    // Of itself the compiler does not inline it into all loops that time SPUs.
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

    /// Whether the instruction at `pc` is a channel instruction that had to wait and is run again:
    /// it has issued already.
    #[inline]
    pub(crate) fn waits_at(&self, pc: u32) -> bool {
        let channel = |i: Instruction| i.op.row().class == Class::Spr;
        self.previous
            .is_some_and(|(previous, instruction)| previous == pc && channel(instruction))
    }

    /// Issues the next instruction of the executed stream, which stands at `pc`. What a hint by a
    /// register says is told by [`hint_target`](Self::hint_target).
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
                self.pipeline
                    .branched(previous, (!straight_on).then_some(pc));
            }
            if class == Class::Br {
                recorder.branched(&self.pipeline);
            }
        }
        self.previous = Some((pc, instruction));
        let issue = self.pipeline.issue(pc, instruction);
        recorder.issued(pc, instruction, &issue, &self.pipeline);
    }

    /// Tells what the hint says that issued last; the SPU's registers are those of its issue.
    #[inline]
    pub(crate) fn hint_target(&mut self, spu: &Spu, hint: Instruction) {
        let target = spu.register(hint.ra).preferred();
        self.pipeline.hint_target(target);
    }

    /// The state as it is; `None` before the first instruction.
    pub(crate) fn state(&self) -> Option<TimerState> {
        let previous = self.previous?;
        Some(TimerState {
            pipeline: self.pipeline.state(),
            previous,
        })
    }

    /// Goes on from `state`, which a timer of the same rules had, as though `delta` had issued
    /// in between.
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
