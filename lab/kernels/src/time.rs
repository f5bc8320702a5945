//! The simulated time of a call.
//!
//! The call starts with idle pipelines, every register ready and the code in the buffer. It ends
//! when the instruction at the return address could issue. It includes the return, with a branch
//! miss if there is no hint for it, but not the caller's branch.

use serde::Serialize;
use spu_emulator::interp::{Observer, Spu};
use spu_emulator::timer::Timer;
use spu_isa::{Class, Instruction, Pipe};

use crate::bench::RETURN_ADDRESS;

/// The cycles of a call and the instructions that issued in them.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Time {
    /// Cycles.
    pub cycles: u64,
    /// Instructions of the even pipe except `nop`.
    pub even: u64,
    /// Instructions of the odd pipe except `lnop`.
    pub odd: u64,
    /// Cycles in which both pipes issued, except `nop` and `lnop`.
    pub dual: u64,
}

impl Time {
    /// The share of all cycles in which the even pipe issued useful work.
    #[must_use]
    pub fn even_share(&self) -> f64 {
        self.even as f64 / self.cycles as f64
    }

    /// The same for the odd pipe.
    #[must_use]
    pub fn odd_share(&self) -> f64 {
        self.odd as f64 / self.cycles as f64
    }

    /// The share of all cycles in which both pipes did.
    #[must_use]
    pub fn dual_share(&self) -> f64 {
        self.dual as f64 / self.cycles as f64
    }

    /// The additional cost of a longer call.
    #[must_use]
    pub fn up_to(&self, longer: &Self) -> Self {
        Self {
            cycles: longer.cycles.saturating_sub(self.cycles),
            even: longer.even.saturating_sub(self.even),
            odd: longer.odd.saturating_sub(self.odd),
            dual: longer.dual.saturating_sub(self.dual),
        }
    }
}

/// Counts a call.
#[derive(Default)]
pub(crate) struct Watch {
    timer: Timer,
    time: Time,
    /// Whether the previous instruction was useful work.
    works: bool,
}

impl Watch {
    pub fn time(&self) -> Time {
        self.time
    }
}

impl Observer for Watch {
    fn before_instruction(&mut self, spu: &Spu, instruction: Instruction) {
        let pairs = self.timer.pipeline.account().dual();
        self.timer.before_instruction(spu, instruction);
        if spu.pc() == RETURN_ADDRESS {
            // The `stop` at the return address issued in a cycle of its own.
            self.time.cycles = self.timer.pipeline.clock() - 1;
            return;
        }
        let joined = self.timer.pipeline.account().dual() > pairs;
        let class = instruction.op.row().class;
        let works = !matches!(class, Class::Nop | Class::Lnop);
        match class.pipe() {
            Pipe::Even => self.time.even += u64::from(works),
            Pipe::Odd => self.time.odd += u64::from(works),
        }
        self.time.dual += u64::from(joined && works && self.works);
        self.works = works;
    }
}
