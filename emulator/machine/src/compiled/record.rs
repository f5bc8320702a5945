//! Recording of traces: the paths that an SPU takes from hot addresses.

use std::collections::HashSet;

use spu_isa::{Instruction, Machine};
use spu_jit::{Cpu, MAX_STEPS, Step, Trace, can_compile};

use crate::channel::Channels;
use crate::interp::Spu;
use crate::local_store::LocalStore;
use crate::stop::Stopped;

/// The instruction in `word`, if a trace can contain it.
fn compilable(word: u32) -> Option<Instruction> {
    Instruction::decode(word).filter(|i| i.op.row().machine == Machine::Every && can_compile(*i))
}

/// Records the path that an SPU takes, up to the end of its trace.
#[derive(Default)]
pub(super) struct Recorder {
    steps: Vec<Step>,
    seen: HashSet<u32>,
}

impl Recorder {
    /// Whether the trace can continue at `pc`. It ends when it has [`MAX_STEPS`] instructions, or
    /// returns to an address that it contains, or reaches one where a unit starts.
    pub fn can_extend(&self, cpu: &Cpu, pc: u32) -> bool {
        self.steps.len() < MAX_STEPS && !self.seen.contains(&pc) && !cpu.has_unit(pc)
    }

    /// Adds the instruction `word` at `pc`, after which the SPU went to `next`. Returns `false` if
    /// the trace ends before it.
    pub fn add(&mut self, cpu: &Cpu, pc: u32, word: u32, next: u32) -> bool {
        let Some(instruction) = compilable(word).filter(|_| self.can_extend(cpu, pc)) else {
            return false;
        };
        self.seen.insert(pc);
        self.steps.push(Step { pc, word, instruction, next });
        true
    }

    /// The recorded trace, if it isn't empty and can be compiled.
    pub fn trace(self) -> Option<Trace> {
        Trace::new(self.steps).map(Trace::unrolled)
    }
}

/// Interprets and records from the SPU's program counter to the end of the trace. Returns a stop
/// if one happened, and the trace if it can be compiled.
pub(super) fn record<C: Channels>(
    cpu: &Cpu,
    spu: &mut Spu,
    local_store: &LocalStore,
    channels: &mut C,
) -> (Option<Stopped>, Option<Trace>) {
    let mut recorder = Recorder::default();
    let mut stopped = None;
    while stopped.is_none() && !spu.interrupts_enabled() && recorder.can_extend(cpu, spu.pc()) {
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
