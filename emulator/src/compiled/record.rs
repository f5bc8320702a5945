//! Traces: the path that an SPU takes from a place that it has come to often.

use std::collections::HashSet;

use spu_compiler::{Cpu, MOST_STEPS, Step, Trace, can_compile};
use spu_isa::{Instruction, Machine};

use crate::channel::Channels;
use crate::interp::Spu;
use crate::local_store::LocalStore;
use crate::stop::Stopped;

/// Interprets from where the SPU is, at most [`MOST_STEPS`] instructions, until the path comes round to
/// its start or to another place it has been to, or to one where a unit starts, or meets what no
/// unit can have. Gives the path too, if it is one to be compiled.
pub(super) fn record<C: Channels>(
    cpu: &Cpu,
    spu: &mut Spu,
    local_store: &LocalStore,
    channels: &mut C,
) -> (Option<Stopped>, Option<Trace>) {
    let mut steps = Vec::new();
    let mut seen = HashSet::new();
    let mut stopped = None;
    while steps.len() < MOST_STEPS && !spu.interrupts_enabled() && seen.insert(spu.pc()) {
        let pc = spu.pc();
        if cpu.has(pc) {
            break;
        }
        let word = local_store.load_word(pc);
        let compilable = |i: &Instruction| i.op.row().machine == Machine::Every && can_compile(*i);
        let Some(instruction) = Instruction::decode(word).filter(compilable) else {
            break;
        };
        stopped = spu.step(local_store, channels);
        if stopped.is_some() {
            break;
        }
        let next = spu.pc();
        steps.push(Step {
            pc,
            word,
            instruction,
            next,
        });
    }
    (stopped, Trace::new(steps))
}
