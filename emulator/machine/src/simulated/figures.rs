//! The latencies and rates of simulated time, each with its source and certainty.

use super::time::Tenths;
use crate::engine::Engine;
use spu_isa::timing::Rules;

/// The timing parameters of a machine. The default is the console. With the feature `timing-file`,
/// `Timing::read` reads those of another machine from a file.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(
    feature = "timing-file",
    derive(serde::Deserialize),
    serde(default, deny_unknown_fields)
)]
pub struct Timing {
    /// Rules of the SPUs' pipelines. In a file the table is `pipelines`.
    #[cfg_attr(feature = "timing-file", serde(rename = "pipelines"))]
    pub rules: Rules,
    /// Latencies and rates of transfers.
    pub memory: MemoryFigures,
    /// Costs of the PPE's actions.
    pub ppe: PpeFigures,
}

/// One number of a [`Timing`].
#[derive(Clone, Copy, Debug)]
#[cfg_attr(not(feature = "timing-file"), allow(dead_code, reason = "only files have tables"))]
pub(super) struct Figure {
    /// The table of a file that has it.
    pub table: &'static str,
    /// Its name in reports. In a file the name is without `_tenths`.
    pub name: &'static str,
    pub value: u64,
    /// Its minimum.
    pub min: u64,
}

impl Timing {
    /// All numbers by name, for reports. Times are in cycles, or in tenths of cycles where the name
    /// ends so.
    pub fn named(&self) -> impl Iterator<Item = (&'static str, u64)> {
        self.figures().map(|figure| (figure.name, figure.value))
    }

    pub(super) fn figures(&self) -> impl Iterator<Item = Figure> {
        let Self { rules, memory, ppe } = self;
        [
            ("memory", "port_line_tenths", memory.port_line.0, 1),
            ("memory", "get_line_tenths", memory.get_line.0, 1),
            ("memory", "put_line_tenths", memory.put_line.0, 1),
            ("memory", "ring_line_tenths", memory.ring_line.0, 1),
            ("memory", "command_cycles", memory.command_cycles, 0),
            ("memory", "get_latency", memory.get_latency, 0),
            ("memory", "put_latency", memory.put_latency, 0),
            ("memory", "local_store_latency", memory.local_store_latency, 0),
            ("memory", "outstanding_lines", memory.outstanding_lines, 1),
            ("memory", "list_element_cycles", memory.list_element_cycles, 0),
            ("memory", "put_line_conflict_cycles", memory.put_line_conflict_cycles, 0),
            ("memory", "atomic_latency", memory.atomic_latency, 0),
            ("memory", "putllc_lost_latency", memory.putllc_lost_latency, 0),
            ("memory", "getllar_line_cycles", memory.getllar_line_cycles, 0),
            ("memory", "atomic_write_line_cycles", memory.atomic_write_line_cycles, 0),
            ("pipelines", "miss_cycles", rules.miss_cycles, 0),
            ("pipelines", "hint_cycles", rules.hint_cycles, 1),
            ("pipelines", "channel_interval", rules.channel_interval, 1),
            ("ppe", "call_cycles", ppe.call_cycles, 0),
            ("ppe", "run_cycles", ppe.run_cycles, 0),
            ("ppe", "wake_cycles", ppe.wake_cycles, 0),
        ]
        .into_iter()
        .map(|(table, name, value, min)| Figure { table, name, value, min })
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

/// The records of a machine in simulated time, and its method of counting cycles.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct SimulationOptions {
    /// Whether the SPUs keep a [profile](super::Simulation::profile).
    pub profile: bool,
    /// Whether the SPEs keep a [timeline](super::Simulation::timeline).
    pub timeline: bool,
    /// Whether uses of local store that race with the SPU's own DMA commands are
    /// [reported](super::Simulation::on_race).
    pub races: bool,
    /// How the SPUs' cycles are counted.
    pub method: Method,
    /// The engine that runs their instructions. Where cycles are counted by instruction, that is
    /// the interpreter.
    pub engine: Engine,
}

/// The latencies and rates of DMA.
///
/// Where a doc comment is marked *measured*, the figure is that of a PlayStation 3;
/// `docs/timing.md` compares them all with the console. In a file the times of lines may have one
/// decimal, as in `get_line = 17.0`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(
    feature = "timing-file",
    derive(serde::Deserialize),
    serde(default, deny_unknown_fields)
)]
pub struct MemoryFigures {
    /// Time for which a line of 128 bytes occupies an SPE's port in its direction. Measured between
    /// local stores: 23.6 GB/s. Firm.
    pub port_line: Tenths,
    /// Time for which a line that is read occupies main memory. Measured: 22.8 GB/s with the share
    /// of the console's own system, 24.2 without it. Fair.
    pub get_line: Tenths,
    /// The same for a line that is written. Measured: 22.1 GB/s and 23.5. Fair.
    pub put_line: Tenths,
    /// Time for which a line between local stores occupies the four rings, taken as one resource.
    /// Fitted: six flows between three pairs had 21.6 cycles a line each. Lines of main memory and
    /// distances on the rings do not count, because no measurement separates them. Fair for six
    /// flows, open otherwise.
    pub ring_line: Tenths,
    /// Cycles from the write of the command channel to the first request on the bus. Source:
    /// Kistler, Perrone and Petrini (2006) give under 4 ns (13 cycles) for issuing a command. IBM's
    /// lecture gives about 20 for all its channel writes, of which the pipeline counts six. Fair.
    pub command_cycles: u64,
    /// Cycles from a line's time in main memory until it has arrived in the local store. With
    /// `command_cycles` and `get_line`, one line takes 310 cycles. Kistler, Perrone and Petrini
    /// (2006) have under 100 ns (319 cycles), but of transfers inside the chip. Open: no
    /// measurement of an unloaded `get` was found.
    pub get_latency: u64,
    /// The same for a line to main memory. Measured with six SPUs: a `put` of 32 bytes is complete
    /// about 330 cycles after its command. Fair.
    pub put_latency: u64,
    /// The same between two local stores. Estimate: no measurement was found.
    pub local_store_latency: u64,
    /// The largest number of lines that one SPU has in flight, at min 1. Source: IBM's lecture
    /// gives over 100 outstanding requests for the interconnect. Divided among eight SPEs, they
    /// would be 16 each. Inferred.
    pub outstanding_lines: u64,
    /// Cycles that each element of a list adds. Estimate: no measurement was found.
    pub list_element_cycles: u64,
    /// Cycles for which a `put` to main memory keeps the `put` of another SPE from the same line.
    /// Measured with six SPUs: 200 a put. Only the first and the last line of a transfer can be
    /// kept so. Firm for six SPUs.
    pub put_line_conflict_cycles: u64,
    /// Cycles from an atomic command until its status can be read. Fitted, with the next three, to
    /// three loops of six SPUs and one of two, measured. The model does not keep apart lines that
    /// the own atomic unit, another one or main memory has. Fair under contention, open otherwise.
    pub atomic_latency: u64,
    /// The same for a `putllc` that has lost its reservation.
    pub putllc_lost_latency: u64,
    /// Cycles for which `getllar` keeps other atomic commands from its line.
    pub getllar_line_cycles: u64,
    /// Cycles for which an atomic command that writes its line keeps other atomic commands from it.
    /// Measured with six SPUs: 193 a `putlluc`. A `putllc` that has lost keeps none. Firm.
    pub atomic_write_line_cycles: u64,
}

impl MemoryFigures {
    /// The console's values.
    pub const CONSOLE: Self = Self {
        port_line: Tenths(173),
        get_line: Tenths(170),
        put_line: Tenths(174),
        ring_line: Tenths(36),
        command_cycles: 13,
        get_latency: 280,
        put_latency: 300,
        local_store_latency: 200,
        outstanding_lines: 16,
        list_element_cycles: 16,
        put_line_conflict_cycles: 200,
        atomic_latency: 255,
        putllc_lost_latency: 20,
        getllar_line_cycles: 64,
        atomic_write_line_cycles: 195,
    };

    /// Cycles from a command until its data can arrive in another local store. One SPU can't
    /// affect another one's loads sooner.
    #[must_use]
    pub const fn local_store_delay(&self) -> u64 {
        self.command_cycles + self.port_line.0 / Tenths::PER_CYCLE + self.local_store_latency
    }
}

impl Default for MemoryFigures {
    fn default() -> Self {
        Self::CONSOLE
    }
}

/// The costs of the PPE's actions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(
    feature = "timing-file",
    derive(serde::Deserialize),
    serde(default, deny_unknown_fields)
)]
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
    pub const CONSOLE: Self = Self { call_cycles: 1_600, run_cycles: 32_000, wake_cycles: 9_600 };
}

impl Default for PpeFigures {
    fn default() -> Self {
        Self::CONSOLE
    }
}
