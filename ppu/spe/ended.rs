//! How SPU programs end.

use std::fmt;

/// How an SPU program ended.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// The program exited with this code.
    Exit(i32),
    /// The program stopped with a code that has no defined meaning.
    Signal(u32),
    /// The SPU could not continue; a description of the bits in `SPU_Status`.
    Fault(&'static str),
    /// The MFC raised an exception; a description, and the kernel's event word.
    Dma(&'static str, i32),
    /// Any other reason of libspe2: stop reason and result.
    Library(u32, i32),
}

/// How and where a run ended.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Ended {
    /// How the run ended.
    pub outcome: Outcome,
    /// The local-store address of the next instruction.
    pub npc: u32,
    /// The instruction word before it. It caused the stop, unless the stop was imprecise.
    pub instruction: u32,
}

impl fmt::Display for Ended {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.outcome {
            Outcome::Exit(code) => write!(f, "exited with code {code}")?,
            Outcome::Signal(code) => write!(f, "stopped with the unknown code {code:#06x}")?,
            Outcome::Fault(what) => write!(f, "stopped: {what}")?,
            Outcome::Dma(what, word) => write!(f, "stopped: {what} (event {word:#06x})")?,
            Outcome::Library(reason, result) => {
                write!(f, "stopped: libspe2's stop reason {reason}, result {result}")?;
            }
        }
        let pc = self.npc.wrapping_sub(4);
        write!(f, " at {pc:#07x}, instruction {:#010x}", self.instruction)
    }
}
