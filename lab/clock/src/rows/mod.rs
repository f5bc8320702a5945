//! The table of rows: what each measures, and what others measured on a console.

mod interconnect;
mod memory;
mod pipelines;
mod ppe;

use crate::order::{Benchmark, Measured, Order};
use crate::results::Value;
use crate::spes::{ClockError, Mapped, OWN_BYTES, Place, Ppe, run};
use crate::{CYCLES_PER_TICK, GIGAHERTZ};

/// The number of SPEs that PS3 Linux has.
const ALL: usize = 6;
const LINE: f64 = 128.0;

/// How certain a console's figure is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Certainty {
    /// The source's program was run in the emulator, and its printed figure compared.
    Ran,
    /// The figure, and the code that made it, were read.
    Read,
}

impl Certainty {
    /// Its name in the document.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Ran => "ran",
            Self::Read => "read",
        }
    }
}

/// What others measured on a console.
#[derive(Clone, Copy, Debug)]
pub struct Console {
    /// The figure, in the row's unit.
    pub value: f64,
    /// Who measured it, and how it became this figure.
    pub source: &'static str,
    /// How certain it is.
    pub certainty: Certainty,
    /// The largest relative error that the model may have.
    pub band: f64,
}

/// A figure of the clock.
pub struct Row {
    /// Its name on the command line and in files.
    pub name: String,
    /// What it measures.
    pub what: String,
    /// The unit.
    pub unit: &'static str,
    /// What others measured on a console, if anyone did.
    pub console: Option<Console>,
    measure: Box<dyn Fn() -> Result<f64, ClockError>>,
}

impl Row {
    fn new(
        name: impl Into<String>,
        what: impl Into<String>,
        unit: &'static str,
        console: Option<Console>,
        measure: impl Fn() -> Result<f64, ClockError> + 'static,
    ) -> Self {
        Self { name: name.into(), what: what.into(), unit, console, measure: Box::new(measure) }
    }

    /// Measures it on this machine.
    ///
    /// # Errors
    ///
    /// Fails if libspe2 does, or if an SPU doesn't end as it should.
    pub fn measure(&self) -> Result<Value, ClockError> {
        Ok(Value { row: self.name.clone(), value: (self.measure)()? })
    }
}

/// The figure of a source whose program was run in the emulator too.
const fn ran(value: f64, source: &'static str, band: f64) -> Option<Console> {
    Some(Console { value, source, certainty: Certainty::Ran, band })
}

/// A figure that was only read.
const fn read(value: f64, source: &'static str, band: f64) -> Option<Console> {
    Some(Console { value, source, certainty: Certainty::Read, band })
}

/// All rows: first those that have a console's figure.
#[must_use]
pub fn all() -> Vec<Row> {
    let mut rows = pipelines::rows();
    rows.extend(memory::rows());
    rows.extend(interconnect::rows());
    rows.extend(ppe::rows());
    rows.sort_by_key(|row| row.console.is_none());
    rows
}

/// The rows with these names; all of them if there are none.
///
/// # Errors
///
/// There is no row of a name.
pub fn named(names: &[String]) -> Result<Vec<Row>, ClockError> {
    let rows = all();
    for name in names {
        if !rows.iter().any(|row| row.name == *name) {
            let known: Vec<&str> = rows.iter().map(|row| row.name.as_str()).collect();
            return Err(ClockError::Row { name: name.clone(), known: known.join(", ") });
        }
    }
    let wanted = |row: &Row| names.is_empty() || names.contains(&row.name);
    Ok(rows.into_iter().filter(wanted).collect())
}

/// Cycles of the SPU that took longest.
fn cycles(measured: &[Measured]) -> f64 {
    let ticks = measured.iter().map(|spu| spu.ticks).max().unwrap_or(0);
    f64::from(ticks) * CYCLES_PER_TICK
}

/// Cycles of a pass of a benchmark that one SPU runs alone.
fn alone(order: Order) -> Result<f64, ClockError> {
    let measured = run(1, Mapped::Nothing, Ppe::Waits, |place, number| Order {
        ea: place.memory(number),
        ..order
    })?;
    Ok(cycles(&measured) / f64::from(order.passes))
}

/// Commands of one size in a loop.
#[derive(Clone, Copy)]
struct Stream {
    opcode: u32,
    size: u32,
    depth: u32,
    passes: u32,
}

impl Stream {
    fn order(self, ea: u64) -> Order {
        // One place for each command, unless the transfers would leave the own memory.
        let mask = (OWN_BYTES - 1) & !(self.size.max(128) - 1);
        Order {
            opcode: self.opcode,
            size: self.size,
            depth: self.depth,
            ea,
            mask,
            ..Order::new(Benchmark::Stream, self.passes)
        }
    }

    /// GB/s of all SPEs together. `ea` returns the effective address for an SPE's commands.
    fn rate(
        self,
        spes: usize,
        mapped: Mapped,
        ea: impl Fn(&Place, usize) -> Option<u64>,
    ) -> Result<f64, ClockError> {
        let idle = Order::new(Benchmark::HintedLoop, 1);
        let measured = run(spes, mapped, Ppe::Waits, |place, number| {
            ea(place, number).map_or(idle, |ea| Order {
                // Only buffers of another local store.
                mask: match mapped {
                    Mapped::Stores | Mapped::Signals => 0,
                    Mapped::Nothing => self.order(ea).mask,
                },
                ..self.order(ea)
            })
        })?;
        // The sum of the flows' own rates, because they begin one after the other.
        let bytes = f64::from(self.passes) * f64::from(self.size);
        let flows = measured.iter().filter(|spu| spu.ticks > 1000);
        let rate = |spu: &Measured| bytes * GIGAHERTZ / (f64::from(spu.ticks) * CYCLES_PER_TICK);
        Ok(flows.map(rate).sum())
    }

    /// Cycles from a command until it is complete, of commands that are waited for one by one.
    fn latency(self, spes: usize) -> Result<f64, ClockError> {
        let of = |benchmark| {
            let measured = run(spes, Mapped::Nothing, Ppe::Waits, |place, number| Order {
                benchmark,
                mask: 0,
                ..self.order(place.memory(number))
            })?;
            Ok::<f64, ClockError>(cycles(&measured) / f64::from(self.passes))
        };
        Ok(of(Benchmark::Stream)? - of(Benchmark::StreamWithoutCommand)?)
    }
}
