//! Units: compiled traces, and how they are compiled.

use std::sync::Arc;

use crate::compiler::CodeCache;
use crate::float_mode::FloatMode;
use crate::trace::Trace;

/// The most units. On x86-64, each takes some 6 KiB in addition to its code.
pub(crate) const MAX_UNITS: usize = 2048;

/// How much effort the compiler puts into a unit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Tier {
    /// Registers are allocated in a single pass, so that code is soon compiled. Such a unit reports
    /// [`Exit::Hot`](crate::Exit::Hot) when it has been entered often.
    Baseline,
    /// Registers are allocated so that few values are spilled. This takes more than twice as long.
    Optimized,
}

/// The tables of `frest` and `frsqest`. Each entry has base and step at their positions in an
/// estimate word.
#[derive(Clone, Copy, Debug)]
pub struct Estimates {
    /// Indexed by bits 9 to 13 of the operand.
    pub reciprocal: &'static [u32; 32],
    /// Indexed by bits 8 to 13 of the operand.
    pub reciprocal_root: &'static [u32; 64],
}

/// A compiled trace.
pub struct Unit {
    pub(crate) number: u32,
    pub(crate) trace: Trace,
    pub(crate) mode: FloatMode,
    pub(crate) tier: Tier,
    /// Whether it may fail less often in another mode.
    pub(crate) has_fallback: bool,
    pub(crate) entry: *const u8,
    pub(crate) code: Arc<CodeCache>,
}

// SAFETY: the pointer leads to code, which is never changed.
unsafe impl Send for Unit {}
// SAFETY: as above.
unsafe impl Sync for Unit {}

impl Unit {
    /// The unit's number, counted from 0.
    #[must_use]
    pub fn number(&self) -> u32 {
        self.number
    }

    /// The trace that it was compiled from.
    #[must_use]
    pub fn trace(&self) -> &Trace {
        &self.trace
    }

    /// The address of its first instruction.
    #[must_use]
    pub fn start(&self) -> u32 {
        self.trace.start()
    }

    /// How it computes floating-point arithmetic.
    #[must_use]
    pub fn mode(&self) -> FloatMode {
        self.mode
    }

    /// How much effort went into its code.
    #[must_use]
    pub fn tier(&self) -> Tier {
        self.tier
    }

    /// Whether it contains instructions to which the [`FloatMode`] makes a difference.
    #[must_use]
    pub fn has_fallback(&self) -> bool {
        self.has_fallback
    }

    pub(crate) fn entry(&self) -> *const u8 {
        self.entry
    }

    pub(crate) fn code_owner(&self) -> &Arc<CodeCache> {
        &self.code
    }
}

/// The work of units besides their instructions.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct UnitOptions {
    /// Whether [`Cpu::log`](crate::Cpu::log) records which instructions have run.
    pub logs: bool,
    /// Whether units leave accesses to [watched](crate::Storage::watched) quadwords to the
    /// interpreter.
    pub watches: bool,
}
