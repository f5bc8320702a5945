//! Feeds a [`Pipeline`] from the interpreter.

use crate::interp::{Observer, Spu};
use spu_isa::timing::{Issue, Pipeline};
use spu_isa::{Class, Instruction, LIMIT_MASK, Op};

/// Times what an [`Spu`] runs.
///
/// Where a branch went shows when the next instruction comes, so the last one's outcome is missing
/// until then.
#[derive(Clone, Debug, Default)]
pub struct Timer {
    /// What it drives.
    pub pipeline: Pipeline,
    previous: Option<(u32, Class)>,
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
        if let Some((previous, class)) = self.previous {
            // A channel instruction that had to wait is run again: it has issued already.
            if previous == pc && class == Class::Spr {
                return;
            }
            let straight_on = pc == previous.wrapping_add(4) & LIMIT_MASK;
            if class == Class::Br || !straight_on {
                self.pipeline
                    .branched(previous, (!straight_on).then_some(pc));
            }
            if class == Class::Br {
                recorder.branched(&self.pipeline);
            }
        }
        let class = instruction.op.row().class;
        self.previous = Some((pc, class));
        let issue = self.pipeline.issue(pc, instruction);
        recorder.issued(pc, instruction, &issue, &self.pipeline);
        if instruction.op == Op::Hbr {
            let target = spu.register(instruction.ra).preferred();
            self.pipeline.hint_target(target);
        }
    }
}

impl Observer for Timer {
    #[inline]
    fn before_instruction(&mut self, spu: &Spu, instruction: Instruction) {
        self.record(spu, instruction, &mut ());
    }
}
