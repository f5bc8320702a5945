//! The numbers of the pipeline model, and switches for rules that no source documents.
//!
//! Latencies and pipes are columns of the instruction table ([`Class::latency`], [`Class::pipe`]).
//! Each number here states its source and its certainty. `docs/timing.md` has the same as a table.

use crate::instructions::Class;

/// Cycles from a double-precision instruction to the next instruction of any kind: its issue
/// cycle, and six cycles in which nothing issues. Source: IBM SDK tutorial. Firm.
pub const DOUBLE_INTERVAL: u64 = 7;

/// Latency of double precision on machines with [`Rules::double_extension`], where it is also
/// pipelined and can pair. Source: GCC. Firm.
pub const DOUBLE_EXTENSION_LATENCY: u64 = 9;

/// Cycles after an FP7 instruction issues in which it occupies the unit that FP6 needs at its
/// issue. Source: GCC's reservations. IBM's simulator counts such stalls. Fair.
pub const FLOAT_CONFLICT_DISTANCE: u64 = 1;

/// Extra cycles after a mispredicted branch. Source: IBM SDK tutorial (18 to 19), ISSCC
/// description (18). Firm within that one cycle.
pub const MISS_CYCLES: u64 = 18;

/// Minimum number of instructions between a hint and its branch for the hint to be seen at all.
/// Source: GCC, which calls it a requirement of the hardware. Fair.
pub const HINT_MINIMUM_INSTRUCTIONS: u64 = 8;

/// Cycles from a hint until its branch can use it. Source: a loop of a hint and its branch takes 17
/// cycles on a PlayStation 3, at most 17.8. IBM's SDK tutorial gives the class a latency of 15, and
/// so do practitioners (11 to fetch the target's line, and four pairs). Firm within one cycle.
pub const HINT_CYCLES: u64 = Class::Hb.latency() as u64;

/// Cycles that `sync` adds for fetching again: at least the cost of any flush. Inferred.
pub const REFETCH_CYCLES: u64 = MISS_CYCLES;

/// Size in bytes of a line, which one instruction fetch brings. Source: IBM SDK tutorial. Firm.
pub const LINE_BYTES: u32 = 128;

/// Number of lines in the inline prefetch buffer. Recalled from the handbook, not verified. Open.
pub const INLINE_LINES: u32 = 2;

/// Cycles from the request for a line to its first instruction's issue. The same as for a hint,
/// which fetches a line too. Inferred. Open.
pub const LINE_CYCLES: u64 = HINT_CYCLES;

/// The model's assumptions where sources disagree or are silent.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Deserialize), serde(default, deny_unknown_fields))]
pub struct Rules {
    /// Extra cycles after a mispredicted branch: [`MISS_CYCLES`] by default. Some sources give 19.
    pub miss_cycles: u64,
    /// Cycles from a hint until its branch can use it: [`HINT_CYCLES`] by default. The console's
    /// is 16 to 17.
    pub hint_cycles: u64,
    /// Whether branch hints work. Without them a branch costs one cycle if it is not taken, and a
    /// miss if it is. On by default.
    pub hints: bool,
    /// Whether an FP6 instruction waits for the unit that an FP7 instruction occupies. On by
    /// default.
    pub float_conflict: bool,
    /// Whether a register that is encoded as a target but never written delays its readers. The
    /// architecture allows this. Off by default.
    pub false_targets: bool,
    /// Minimum number of cycles between the issues of two channel instructions. 1 by default,
    /// which is no rule. A DMA command's five or six channel writes were measured at about 13
    /// cycles, with its queueing.
    pub channel_interval: u64,
    /// Whether straight-line code waits for its lines while loads and stores occupy the local
    /// store's port. Off by default, because the buffer's depth is not known.
    pub inline_prefetch: bool,
    /// Whether double precision is pipelined, as on the PowerXCell 8i. Off on the Cell.
    pub double_extension: bool,
}

impl Default for Rules {
    fn default() -> Self {
        Self {
            miss_cycles: MISS_CYCLES,
            hint_cycles: HINT_CYCLES,
            hints: true,
            float_conflict: true,
            false_targets: false,
            channel_interval: 1,
            inline_prefetch: false,
            double_extension: false,
        }
    }
}

impl Rules {
    /// Cycles from an instruction's issue until its result can be used.
    #[must_use]
    pub fn latency(&self, class: Class) -> u64 {
        match class {
            Class::Fpd if self.double_extension => DOUBLE_EXTENSION_LATENCY,
            Class::Hb => self.hint_cycles,
            _ => u64::from(class.latency()),
        }
    }
}
