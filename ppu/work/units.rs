//! Cutting a frame into work units, so that all SPUs are done at the same time.
//!
//! Invariant: a cut has every tile that it is given exactly once, 1 to [`UNIT_TILES`] of them a
//! unit.

use std::cmp::Reverse;

use zerocopy::big_endian::U32;
use zerocopy::{FromZeros as _, IntoBytes as _};

use super::policy::Split;
use super::tiles::{TileSet, tile_count};
use crate::framebuffer::Geometry;
use protocol::layout::{MAX_SPUS, TILE_BLANK, UNIT_TILES, UnitCost, WorkUnit};

/// Units an SPU where nothing is known of the tiles' costs, not counting the small ones at the
/// end: few enough that taking one costs nothing.
const UNITS_AN_SPU: u32 = 24;

/// A unit is at most one in this many parts of an SPU's share of what is left: so the last ones
/// are small. Fewer would leave SPUs idle at the end, more would have them wait for the counter.
const PARTS_OF_A_SHARE: u64 = 2;

/// The same in tiles, where their costs are not known.
const PARTS_OF_UNKNOWN_COST: usize = 4;

/// No unit need be smaller than one in this many parts of an SPU's share of the frame: what SPUs
/// then wait for each other at the end is less than what they would wait for the counter.
const PARTS_OF_THE_WHOLE: u64 = 40;

/// The work units of a frame; its buffers serve for the next.
#[derive(Default)]
pub struct Units {
    lines: Vec<WorkUnit>,
    /// Tiles, the dearest first, and in the order of the units.
    falling: Vec<u32>,
    order: Vec<u32>,
    slices: [U32; MAX_SPUS as usize + 1],
}

impl Units {
    /// Cuts `tiles`, whose numbers rise, into units for `spus` SPUs. `costs` has what each tile of
    /// the picture took the last time; slices make no use of it.
    pub fn cut(&mut self, tiles: &[u32], spus: u32, split: Split, costs: Option<&[u32]>) {
        self.lines.clear();
        let spus = spus.max(1);
        match (split, costs) {
            (Split::Slices, _) => return self.cut_slices(tiles, spus),
            (Split::Units, None) => self.cut_runs(tiles, spus),
            (Split::Units, Some(costs)) => self.cut_by_cost(tiles, u64::from(spus), costs),
        }
        self.slices = [U32::new(self.lines.len() as u32); MAX_SPUS as usize + 1];
    }

    /// The units.
    #[must_use]
    pub fn lines(&self) -> &[WorkUnit] {
        &self.lines
    }

    /// The units as they lie in memory.
    #[must_use]
    pub fn bytes(&self) -> &[u8] {
        self.lines.as_bytes()
    }

    /// First unit of each SPU's slice; all further entries are the end of the last.
    #[must_use]
    pub fn slices(&self) -> [U32; MAX_SPUS as usize + 1] {
        self.slices
    }

    /// In the order of the tiles; towards the end of all tiles the runs get shorter.
    fn cut_runs(&mut self, tiles: &[u32], spus: u32) {
        let length = run_length(tiles.len(), spus);
        let mut rest = tiles;
        while !rest.is_empty() {
            let share = rest.len() / (PARTS_OF_UNKNOWN_COST * spus as usize);
            let (unit, behind) = rest.split_at(share.clamp(1, length));
            self.push(unit);
            rest = behind;
        }
    }

    /// As in the paper: as many tiles for each SPU, one behind the other.
    fn cut_slices(&mut self, tiles: &[u32], spus: u32) {
        let length = run_length(tiles.len(), spus);
        let start = |number: usize| tiles.len() * number / spus as usize;
        for number in 0..=MAX_SPUS as usize {
            self.slices[number] = U32::new(self.lines.len() as u32);
            if number < spus as usize {
                let slice = &tiles[start(number)..start(number + 1)];
                slice.chunks(length).for_each(|unit| self.push(unit));
            }
        }
    }

    fn cut_by_cost(&mut self, tiles: &[u32], spus: u64, costs: &[u32]) {
        let cost = |tile: u32| u64::from(costs.get(tile as usize).copied().unwrap_or(0).max(1));
        self.falling.clear();
        self.falling.extend_from_slice(tiles);
        self.falling
            .sort_unstable_by_key(|&tile| (Reverse(cost(tile)), tile));
        let mut left: u64 = tiles.iter().map(|&tile| cost(tile)).sum();
        let least = left / (PARTS_OF_THE_WHOLE * spus);
        let dear = self
            .falling
            .partition_point(|&tile| 2 * cost(tile) * tiles.len() as u64 >= left);
        self.order.clear();
        self.order
            .extend(spread(&self.falling, dear, spus as usize));

        let order = std::mem::take(&mut self.order);
        let mut rest = order.as_slice();
        while let Some((&first, others)) = rest.split_first() {
            let share = (left / (PARTS_OF_A_SHARE * spus)).max(least);
            let mut taken = cost(first);
            let room = others.iter().take(UNIT_TILES as usize - 1);
            let more = room.take_while(|&&tile| {
                let fits = taken + cost(tile) <= share;
                taken += if fits { cost(tile) } else { 0 };
                fits
            });
            let (unit, behind) = rest.split_at(1 + more.count());
            self.push(unit);
            left -= taken;
            rest = behind;
        }
        self.order = order;
    }

    /// Marks those of the tiles that show nothing but the background.
    pub fn mark_blank(&mut self, blank: &TileSet) {
        for unit in &mut self.lines {
            let count = unit.count.get() as usize;
            for tile in unit.tiles.iter_mut().take(count) {
                if blank.contains(tile.get()) {
                    *tile |= TILE_BLANK;
                }
            }
        }
    }

    fn push(&mut self, tiles: &[u32]) {
        let mut unit = WorkUnit::new_zeroed();
        unit.count = (tiles.len() as u32).into();
        for (to, &tile) in unit.tiles.iter_mut().zip(tiles) {
            *to = tile.into();
        }
        self.lines.push(unit);
    }
}

/// Cheap tiles that come last, for each SPU.
const CHEAP_AT_THE_END: usize = 4;

/// The first `dear` of the tiles, with the others evenly between them, but for a few at the end:
/// tiles that are only filled wait for main memory when many come together, but they are the
/// smallest that there is to even out when the SPUs finish.
fn spread(falling: &[u32], dear: usize, spus: usize) -> impl Iterator<Item = u32> {
    let (dear, cheap) = falling.split_at(dear);
    let between = cheap.len().saturating_sub(CHEAP_AT_THE_END * spus);
    let (between, last) = cheap.split_at(between);
    let run = |number: usize| between.len() * number / dear.len();
    let mixed = dear.iter().enumerate().flat_map(move |(number, tile)| {
        std::iter::once(tile).chain(&between[run(number)..run(number + 1)])
    });
    // Without a dear tile, there is nothing to come between.
    let alone = if dear.is_empty() { between } else { &[] };
    mixed.chain(alone).chain(last).copied()
}

fn run_length(tiles: usize, spus: u32) -> usize {
    tiles
        .div_ceil((UNITS_AN_SPU * spus) as usize)
        .clamp(1, UNIT_TILES as usize)
}

/// What each tile of a picture took the last time it was traced, in decrementer ticks.
#[derive(Default)]
pub struct TileCosts {
    geometry: Option<Geometry>,
    ticks: Vec<u32>,
}

impl TileCosts {
    /// The costs of a picture's tiles, if they are known.
    #[must_use]
    pub fn of(&self, geometry: Geometry) -> Option<&[u32]> {
        (self.geometry == Some(geometry)).then_some(&self.ticks)
    }

    /// Takes over what the units of a frame have cost.
    pub fn learn(&mut self, geometry: Geometry, units: &[WorkUnit], costs: &[UnitCost]) {
        if self.geometry != Some(geometry) {
            self.geometry = Some(geometry);
            self.ticks.clear();
            self.ticks.resize(tile_count(geometry) as usize, 0);
        }
        for (tile, cost) in tiles_and_costs(units, costs) {
            if let Some(known) = self.ticks.get_mut(tile as usize) {
                *known = cost & !TILE_BLANK;
            }
        }
    }
}

/// The tiles of the units that were answered, each with its cost.
pub(super) fn tiles_and_costs<'a>(
    units: &'a [WorkUnit],
    costs: &'a [UnitCost],
) -> impl Iterator<Item = (u32, u32)> + 'a {
    let answered = units
        .iter()
        .zip(costs)
        .filter(|(unit, cost)| unit.count == cost.count);
    answered.flat_map(|(unit, cost)| {
        let tiles = unit.tiles.iter().take(unit.count.get() as usize);
        let tiles = tiles.map(|tile| tile.get() & !TILE_BLANK);
        tiles.zip(cost.ticks.iter().map(|ticks| ticks.get()))
    })
}

#[cfg(test)]
mod tests;
