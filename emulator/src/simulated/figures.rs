//! The figures that simulated time is made of, each with its source and certainty.

use crate::engine::Engine;
use spu_isa::timing::Rules;

/// What is taken for true of a machine's time. The default is the console.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Timing {
    /// Of the SPUs' pipelines.
    pub rules: Rules,
    /// Of transfers.
    pub memory: MemoryFigures,
    /// Of the PPE's part.
    pub ppe: PpeFigures,
}

impl Timing {
    /// Its numbers by name, in cycles where they are times: for reports.
    pub fn named(&self) -> impl Iterator<Item = (&'static str, u64)> {
        let Self { rules, memory, ppe } = self;
        [
            ("line_cycles", memory.line_cycles),
            ("command_cycles", memory.command_cycles),
            ("memory_latency", memory.memory_latency),
            ("local_store_latency", memory.local_store_latency),
            ("outstanding_lines", memory.outstanding_lines as u64),
            ("list_element_cycles", memory.list_element_cycles),
            ("atomic_cycles", memory.atomic_cycles),
            ("atomic_line_cycles", memory.atomic_line_cycles),
            ("branch_miss_cycles", rules.miss_cycles),
            ("ppe_call_cycles", ppe.call_cycles),
            ("ppe_run_cycles", ppe.run_cycles),
            ("ppe_wake_cycles", ppe.wake_cycles),
        ]
        .into_iter()
    }
}

/// How a clock comes to the cycles of its SPU's instructions. Every method comes to the same.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Method {
    /// What a block does to the pipelines is worked out once a state and remembered.
    #[default]
    Memoised,
    /// Each instruction issues in the pipeline model: the definition.
    ByInstruction,
    /// Memoised, with the definition beside it. At the first
    /// [difference](super::Simulation::difference) the SPE ends its run as though it had been
    /// asked to stop.
    Checked,
}

/// What a machine in simulated time keeps, and how it counts.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Keep {
    /// Whether the SPUs keep a [profile](super::Simulation::profile).
    pub profile: bool,
    /// How their cycles are counted.
    pub method: Method,
    /// What runs their instructions. Where cycles are counted by instruction, that is the
    /// interpreter.
    pub engine: Engine,
}

/// How long DMA takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MemoryFigures {
    /// Cycles for which a line takes an SPU's port, or the memory, at least 1. The console: 128
    /// bytes at 16 bytes per cycle of the bus, which has half the core's clock, or 25.5 GB/s.
    /// Source: 25.6 GB/s at 3.2 GHz in IBM's lecture at MIT for the memory, in measurements of
    /// Kistler, Perrone and Petrini (2006) for the port. Firm.
    pub line_cycles: u64,
    /// Cycles from the write of the command channel to the first request on the bus. Source: the
    /// same measurements give under 4 ns (13 cycles) for issuing a command, IBM's lecture about 20
    /// for all its channel writes, of which the pipeline counts six. Fair.
    pub command_cycles: u64,
    /// Cycles from a line's time on the bus until it has arrived, to or from main memory. With
    /// `command_cycles` and `line_cycles`, one line takes 309 cycles on the console: under 100 ns,
    /// 319 cycles, were measured by Kistler, Perrone and Petrini (2006). Fair.
    pub memory_latency: u64,
    /// The same between two local stores. Estimate: no figure was found apart from memory's.
    pub local_store_latency: u64,
    /// Lines that one SPU has under way at most, at least 1. Source: IBM's lecture says over 100
    /// outstanding requests for the interconnect, whose eight SPEs would have 16 each. Inferred.
    pub outstanding_lines: usize,
    /// Cycles that each element of a list adds. Estimate: no figure was found.
    pub list_element_cycles: u64,
    /// Cycles from an atomic command until its status can be read: one line from memory. Inferred
    /// from `memory_latency`.
    pub atomic_cycles: u64,
    /// Cycles for which an atomic command keeps others' atomic commands off its line. Estimate:
    /// the line goes from one SPU to the other in the time of a transfer between local stores.
    pub atomic_line_cycles: u64,
}

impl MemoryFigures {
    /// The console's.
    pub const CONSOLE: Self = Self {
        line_cycles: 16,
        command_cycles: 13,
        memory_latency: 280,
        local_store_latency: 200,
        outstanding_lines: 16,
        list_element_cycles: 16,
        atomic_cycles: 13 + 16 + 280,
        atomic_line_cycles: 200,
    };

    /// Cycles from a command until what it sends to another local store can be there: the shortest
    /// way on which one SPU reaches what another one loads.
    #[must_use]
    pub const fn local_store_delay(&self) -> u64 {
        self.command_cycles + self.line_cycles + self.local_store_latency
    }
}

impl Default for MemoryFigures {
    fn default() -> Self {
        Self::CONSOLE
    }
}

/// What the PPE's part costs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PpeFigures {
    /// Cycles of a call that reaches an SPE; on the console half a microsecond: a system call and
    /// an access to the SPE's registers. Estimate.
    pub call_cycles: u64,
    /// Cycles from the call that runs an SPE until the SPU's first instruction; on the console ten
    /// microseconds: the kernel loads the context onto an SPE. Estimate.
    pub run_cycles: u64,
    /// Cycles from an SPE's act until the PPE thread that slept for it goes on; on the console
    /// three microseconds: an interrupt and the scheduler. Estimate.
    pub wake_cycles: u64,
}

impl PpeFigures {
    /// The console's.
    pub const CONSOLE: Self = Self {
        call_cycles: 1_600,
        run_cycles: 32_000,
        wake_cycles: 9_600,
    };
}

impl Default for PpeFigures {
    fn default() -> Self {
        Self::CONSOLE
    }
}
