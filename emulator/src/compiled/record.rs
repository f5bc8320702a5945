//! Traces: the path that an SPU takes from a place that it has come to often.

use std::collections::HashSet;

use spu_compiler::{Cpu, MOST_STEPS, Step, Trace, can_compile};
use spu_isa::{Instruction, Machine};

use crate::channel::Channels;
use crate::interp::Spu;
use crate::local_store::LocalStore;
use crate::stop::Stopped;

/// The instruction in `word`, if a trace can have it.
fn compilable(word: u32) -> Option<Instruction> {
    Instruction::decode(word).filter(|i| i.op.row().machine == Machine::Every && can_compile(*i))
}

/// The path that an SPU takes, up to where a trace of it ends.
#[derive(Default)]
pub(super) struct Recorder {
    steps: Vec<Step>,
    seen: HashSet<u32>,
}

impl Recorder {
    /// Whether the trace can go on at `pc`: it does not once it is long, or comes round to its
    /// start or another place that it has been to, or to one where a unit starts.
    pub fn goes_on(&self, cpu: &Cpu, pc: u32) -> bool {
        self.steps.len() < MOST_STEPS && !self.seen.contains(&pc) && !cpu.has(pc)
    }

    /// Adds the word at `pc`, behind which the SPU went to `next`; `false` if the trace ends before
    /// it.
    pub fn add(&mut self, cpu: &Cpu, pc: u32, word: u32, next: u32) -> bool {
        let Some(instruction) = compilable(word).filter(|_| self.goes_on(cpu, pc)) else {
            return false;
        };
        self.seen.insert(pc);
        self.steps.push(Step {
            pc,
            word,
            instruction,
            next,
        });
        true
    }

    /// The trace, if it is one to be compiled.
    pub fn trace(self) -> Option<Trace> {
        Trace::new(self.steps)
    }
}

/// Interprets from where the SPU is, as long as a trace goes on. Gives the trace too, if it is one
/// to be compiled.
pub(super) fn record<C: Channels>(
    cpu: &Cpu,
    spu: &mut Spu,
    local_store: &LocalStore,
    channels: &mut C,
) -> (Option<Stopped>, Option<Trace>) {
    let mut recorder = Recorder::default();
    let mut stopped = None;
    while stopped.is_none() && !spu.interrupts_enabled() && recorder.goes_on(cpu, spu.pc()) {
        let pc = spu.pc();
        let word = local_store.load_word(pc);
        if compilable(word).is_none() {
            break;
        }
        stopped = spu.step(local_store, channels);
        if stopped.is_none() {
            recorder.add(cpu, pc, word, spu.pc());
        }
    }
    (stopped, recorder.trace())
}
