//! Feeds a [`Pipeline`] from the interpreter.

use super::pipeline::Pipeline;
use crate::interp::{Observer, Spu};
use crate::isa::{Class, Instruction, Op};
use crate::local_store::LIMIT_MASK;

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

impl Observer for Timer {
    #[inline]
    fn before_instruction(&mut self, spu: &Spu, instruction: Instruction) {
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
        }
        let class = instruction.op.row().class;
        self.previous = Some((pc, class));
        self.pipeline.issue(pc, instruction);
        if instruction.op == Op::Hbr {
            let target = spu.register(instruction.ra).preferred();
            self.pipeline.hint_target(target);
        }
    }
}
