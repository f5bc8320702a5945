//! Finds the instructions that the host's singles can't compute, and loads of what was just stored.

use std::collections::HashSet;

use spu_isa::{Class, Instruction, Op};
use spu_jit::{Steps, Trace};

use crate::channel::NoChannels;
use crate::float::fpscr::Fpscr;
use crate::interp::{Quad, Spu};
use crate::local_store::LocalStore;

const EXPONENT: u32 = 0x7f80_0000;
const FRACTION: u32 = 0x007f_ffff;

/// A copy of an SPU that replays a trace to find its special instructions.
pub(super) struct Specials {
    spu: Spu,
    local_store: LocalStore,
}

/// Whether a lane holds bits that IEEE reads as a different number, or as no number.
fn is_special(quad: Quad) -> bool {
    quad.0.iter().any(|word| match word & EXPONENT {
        0 => word & FRACTION != 0,
        exponent => exponent == EXPONENT,
    })
}

impl Specials {
    pub fn new() -> Self {
        Self { spu: Spu::new(), local_store: LocalStore::new() }
    }

    /// Replays a trace from the SPU's program counter on, and returns the instructions that
    /// singles can't compute, and loads of quadwords that the trace has stored. The replay ends
    /// where the SPU leaves the trace. The SPU itself is unchanged.
    pub fn find(&mut self, trace: &Trace, spu: &Spu, local_store: &LocalStore) -> Steps {
        // The quadwords that the replay has loaded or stored. They are copied when it needs them,
        // because copying all of local store would take longer than the replay.
        let mut copied = HashSet::new();
        let mut stored = HashSet::new();
        self.spu.registers = spu.registers;
        self.spu.set_pc(spu.pc());
        let mut specials = Steps::NONE;
        let steps = trace.steps();
        let start = steps.iter().position(|step| step.pc == spu.pc());
        for step in steps.iter().skip(start.unwrap_or(steps.len())) {
            let access = self.spu.access(step.instruction);
            let mut overlaps = false;
            if let Some(access) = access {
                overlaps = !access.is_store && stored.contains(&access.address);
                stored.extend(access.is_store.then_some(access.address));
            }
            let address = access.map(|access| access.address);
            for address in address.into_iter().chain([step.pc & !15]) {
                if copied.insert(address) {
                    let quadword = local_store.load_quadword(address);
                    self.local_store.store_quadword(address, quadword);
                }
            }
            let special = self.is_special(step.instruction);
            self.spu.fpscr = Fpscr::default();
            let stopped = self.spu.step(&self.local_store, &mut NoChannels);
            let is_single = step.instruction.op.row().class != Class::Fpd;
            let raised = self.spu.fpscr.words() != [0; 4];
            if special || overlaps || is_single && raised {
                // In all iterations, if the trace is an unrolled loop.
                let same = (0..steps.len()).filter(|&other| steps[other].pc == step.pc);
                same.for_each(|number| specials.add(number));
            }
            if stopped.is_some() || self.spu.pc() != step.next {
                break;
            }
        }
        specials
    }

    /// Whether the instruction has an operand that singles can't represent. Estimates always count
    /// as special, because they are hardly slower in doubles.
    fn is_special(&self, instruction: Instruction) -> bool {
        use Op::{Fa, Fi, Fm, Fma, Fms, Fnms, Frest, Frsqest, Fs};
        let mut read = instruction.op.row().reads.iter();
        match instruction.op {
            Frest | Frsqest | Fi => true,
            Fa | Fs | Fm | Fma | Fms | Fnms => {
                read.any(|&field| is_special(self.spu.register(instruction.register(field))))
            }
            _ => false,
        }
    }
}
