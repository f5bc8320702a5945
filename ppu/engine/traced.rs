//! The work units of the last frame, for those who look into it.

use protocol::layout::{TILE_FLAGS, TILE_HAS_PATHS, UnitCost};
use zerocopy::big_endian::U32;

use super::Engine;

/// The work units that the SPUs traced in a frame.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TracedUnits {
    /// The units in the order of their numbers: each unit's tiles as they were traced.
    pub units: Vec<Vec<TracedTile>>,
    /// The effective address to which an SPU sends the first unit's costs.
    pub costs: u64,
    /// The distance in bytes to the next unit's costs.
    pub distance: u64,
}

/// A tile that was traced.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TracedTile {
    /// The tile's number, line by line from the top left.
    pub number: u32,
    /// The ticks of the decrementer that it took.
    pub ticks: u32,
    /// Whether the SPUs had a record of what its rays had crossed before, and traced only those
    /// that a change had reached.
    pub had_paths: bool,
}

impl Engine {
    /// The work units of the last frame, with what each tile took; `None` after an SPU was lost.
    #[must_use]
    pub fn traced_units(&self) -> Option<TracedUnits> {
        let records = self.records.as_ref()?;
        let units = self.plan.units().lines().iter().zip(&self.costs);
        let units = units.map(|(unit, cost)| {
            let tiles = unit.tiles.iter().zip(&cost.ticks);
            let tiles = tiles.take(unit.count.get() as usize);
            let tile = |(tile, ticks): (&U32, &U32)| TracedTile {
                number: tile.get() & !TILE_FLAGS,
                ticks: ticks.get() & !TILE_FLAGS,
                had_paths: tile.get() & TILE_HAS_PATHS != 0,
            };
            tiles.map(tile).collect()
        });
        Some(TracedUnits {
            units: units.collect(),
            costs: records.addresses().costs,
            distance: size_of::<UnitCost>() as u64,
        })
    }
}
