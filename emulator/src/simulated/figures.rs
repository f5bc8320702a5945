//! The latencies and rates of simulated time, each with its source and certainty.

use crate::engine::Engine;
use spu_isa::timing::Rules;

/// The timing parameters of a machine. The default is the console.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Timing {
    /// Rules of the SPUs' pipelines.
    pub rules: Rules,
    /// Latencies and rates of transfers.
    pub memory: MemoryFigures,
    /// Costs of the PPE's actions.
    pub ppe: PpeFigures,
}

impl Timing {
    /// All numbers by name, for reports. Times are in cycles.
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

/// How a clock counts the cycles of its SPU's instructions. All methods give the same result.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Method {
    /// The effect of a block on the pipelines is computed once for each state and remembered.
    #[default]
    Memoised,
    /// Each instruction issues in the pipeline model. This is the definition.
    ByInstruction,
    /// Memoised timing, compared with the definition. At the first
    /// [difference](super::Simulation::difference) the SPE ends its run as though it had been
    /// asked to stop.
    Checked,
}

/// What a machine in simulated time records, and how it counts cycles.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Keep {
    /// Whether the SPUs keep a [profile](super::Simulation::profile).
    pub profile: bool,
    /// How the SPUs' cycles are counted.
    pub method: Method,
    /// What runs their instructions. Where cycles are counted by instruction, that is the
    /// interpreter.
    pub engine: Engine,
}

/// The latencies and rates of DMA.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MemoryFigures {
    /// Cycles for which a line occupies an SPU's port, or main memory, at least 1. On the console
    /// 128 bytes move at 16 bytes per cycle of the bus, which has half the core's clock, so at
    /// 25.5 GB/s. Source: 25.6 GB/s at 3.2 GHz, for main memory in IBM's lecture at MIT, for the
    /// port in measurements of Kistler, Perrone and Petrini (2006). Firm.
    pub line_cycles: u64,
    /// Cycles from the write of the command channel to the first request on the bus. Source: the
    /// same measurements give under 4 ns (13 cycles) for issuing a command. IBM's lecture gives
    /// about 20 for all its channel writes, of which the pipeline counts six. Fair.
    pub command_cycles: u64,
    /// Cycles from a line's time on the bus until it has arrived, to or from main memory. With
    /// `command_cycles` and `line_cycles`, one line takes 309 cycles on the console. Kistler,
    /// Perrone and Petrini (2006) measured under 100 ns, which is 319 cycles. Fair.
    pub memory_latency: u64,
    /// The same between two local stores. Estimate: only main memory's latency was found.
    pub local_store_latency: u64,
    /// The largest number of lines that one SPU has in flight, at least 1. Source: IBM's lecture
    /// gives over 100 outstanding requests for the interconnect. Divided among eight SPEs, they
    /// would be 16 each. Inferred.
    pub outstanding_lines: usize,
    /// Cycles that each element of a list adds. Estimate: no measurement was found.
    pub list_element_cycles: u64,
    /// Cycles from an atomic command until its status can be read: the time of one line from main
    /// memory. Inferred from `memory_latency`.
    pub atomic_cycles: u64,
    /// Cycles for which an atomic command blocks other atomic commands on its line. Estimate: the
    /// line moves from one SPU to the other in the time of a transfer between local stores.
    pub atomic_line_cycles: u64,
}

impl MemoryFigures {
    /// The console's values.
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

    /// Cycles from a command until its data can arrive in another local store. One SPU can't
    /// affect another one's loads sooner.
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

/// The costs of the PPE's actions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PpeFigures {
    /// Cycles of a call that accesses an SPE. On the console half a microsecond: a system call and
    /// an access to the SPE's registers. Estimate.
    pub call_cycles: u64,
    /// Cycles from the call that runs an SPE until the SPU's first instruction. On the console ten
    /// microseconds: the kernel loads the context onto an SPE. Estimate.
    pub run_cycles: u64,
    /// Cycles from an SPE's action until the PPE thread that sleeps on it continues. On the
    /// console three microseconds: an interrupt and the kernel's scheduler. Estimate.
    pub wake_cycles: u64,
}

impl PpeFigures {
    /// The console's values.
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
