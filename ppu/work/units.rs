//! Splits a frame into work units, so that all SPUs finish at the same time.
//!
//! Invariant: the units have every given tile exactly once, and each unit has 1 to [`UNIT_TILES`].

use std::cmp::Reverse;

use zerocopy::big_endian::U32;
use zerocopy::{FromZeros as _, IntoBytes as _};

use super::policy::Split;
use super::tiles::{TileSet, tile_count};
use crate::framebuffer::Geometry;
use protocol::layout::{MAX_SPUS, TILE_FLAGS, TILE_KEPT, UNIT_TILES, UnitCost, WorkUnit};

/// The number of units for each SPU if the tiles' costs are unknown, without the small ones at the
/// end. It is low enough for the time to take a unit to be negligible, and high enough for a unit
/// of expensive tiles not to outlast all others.
const UNITS_AN_SPU: u32 = 48;

/// The smallest number of units for each SPU that go upwards. With fewer of them, SPUs would idle
/// at the end.
const STRIPS_AN_SPU: u32 = 4;

/// The most tiles of a unit that goes upwards. Cuts begin at the eye with each unit, so that
/// shorter ones take longer.
const STRIP_TILES: usize = 8;

/// An SPU's share of the remaining work is divided by this to get the largest cost of the next
/// unit, so the last units are small. With a lower number SPUs would idle at the end; with a
/// higher one they would wait for the counter.
const PARTS_OF_A_SHARE: u64 = 2;

/// The same for numbers of tiles, if their costs are unknown.
const PARTS_OF_UNKNOWN_COST: usize = 4;

/// An SPU's share of the frame is divided by this to get the cost below which a unit need not be
/// made smaller: then SPUs wait less for each other at the end than they would for the counter.
const PARTS_OF_THE_WHOLE: u64 = 40;

/// The work units of a frame. Its buffers are reused for the next.
#[derive(Default)]
pub struct Units {
    lines: Vec<WorkUnit>,
    /// The tiles in descending order of their costs.
    by_cost: Vec<u32>,
    /// The tiles in the order of the units.
    order: Vec<u32>,
    slices: [U32; MAX_SPUS as usize + 1],
}

impl Units {
    /// Splits `tiles`, whose numbers are ascending, into units for `spus` SPUs. `costs` has the
    /// last cost of each tile of the picture; slices don't use it.
    pub fn split(&mut self, tiles: &[u32], spus: u32, split: Split, costs: Option<&[u32]>) {
        self.lines.clear();
        let spus = spus.max(1);
        match (split, costs) {
            (Split::Slices, _) => return self.split_slices(tiles, spus),
            (Split::Units, None) => self.split_runs(tiles, spus),
            (Split::Units, Some(costs)) => self.split_by_cost(tiles, u64::from(spus), costs),
        }
        self.slices = [U32::new(self.lines.len() as u32); MAX_SPUS as usize + 1];
    }

    /// The units.
    #[must_use]
    pub fn lines(&self) -> &[WorkUnit] {
        &self.lines
    }

    /// The units' bytes.
    #[must_use]
    pub fn bytes(&self) -> &[u8] {
        self.lines.as_bytes()
    }

    /// The index of the first unit of each SPU's slice. All further entries are the last slice's
    /// end.
    #[must_use]
    pub fn slices(&self) -> [U32; MAX_SPUS as usize + 1] {
        self.slices
    }

    /// Makes units of tiles of which each is above the one before, of a picture with `across` tiles
    /// in a row. Cuts go on from tile to tile in a unit, so units are long. Those with the largest
    /// cost come first, or those at the bottom if costs are unknown, since the sky costs little.
    pub fn split_upwards(&mut self, tiles: &[u32], across: u32, spus: u32, costs: Option<&[u32]>) {
        self.lines.clear();
        self.order.clear();
        self.order.extend_from_slice(tiles);
        self.order.sort_unstable_by_key(|&tile| (tile % across, Reverse(tile)));
        let share = tiles.len().div_ceil((STRIPS_AN_SPU * spus.max(1)) as usize);
        let length = share.clamp(1, STRIP_TILES);
        let order = std::mem::take(&mut self.order);
        for column in order.chunk_by(|one, other| one % across == other % across) {
            let length = column.len().div_ceil(column.len().div_ceil(length));
            column.chunks(length).for_each(|unit| self.push(unit));
        }
        self.order = order;
        let row = |tile: &U32| u64::from(tile.get() / across);
        let cost = |tile: &U32| match costs {
            Some(costs) => u64::from(costs.get(tile.get() as usize).copied().unwrap_or(0)),
            None => row(tile),
        };
        self.lines.sort_unstable_by_key(|unit| {
            let tiles = &unit.tiles[..unit.count.get() as usize];
            Reverse(tiles.iter().map(cost).sum::<u64>())
        });
        self.slices = [U32::new(self.lines.len() as u32); MAX_SPUS as usize + 1];
    }

    /// Makes units of consecutive tiles. The units get smaller towards the end.
    fn split_runs(&mut self, tiles: &[u32], spus: u32) {
        let length = run_length(tiles.len(), spus);
        let mut rest = tiles;
        while !rest.is_empty() {
            let share = rest.len() / (PARTS_OF_UNKNOWN_COST * spus as usize);
            let (unit, following) = rest.split_at(share.clamp(1, length));
            self.push(unit);
            rest = following;
        }
    }

    /// Gives each SPU the same number of consecutive tiles, as in the paper.
    fn split_slices(&mut self, tiles: &[u32], spus: u32) {
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

    fn split_by_cost(&mut self, tiles: &[u32], spus: u64, costs: &[u32]) {
        let cost = |tile: u32| u64::from(costs.get(tile as usize).copied().unwrap_or(0).max(1));
        self.by_cost.clear();
        self.by_cost.extend_from_slice(tiles);
        self.by_cost.sort_unstable_by_key(|&tile| (Reverse(cost(tile)), tile));
        let mut left: u64 = tiles.iter().map(|&tile| cost(tile)).sum();
        let minimum = left / (PARTS_OF_THE_WHOLE * spus);
        let expensive =
            self.by_cost.partition_point(|&tile| 2 * cost(tile) * tiles.len() as u64 >= left);
        self.order.clear();
        // While an SPU traces an expensive tile, the others have as much left to do. Tiles that
        // cost little make them wait less for each other than cheap tiles at the end for main
        // memory.
        let (mut after, mut needed) = (0, 0);
        for &tile in self.by_cost[..expensive].iter().rev() {
            if cost(tile) > minimum {
                needed = needed.max(((spus - 1) * cost(tile)).saturating_sub(after));
            }
            after += cost(tile);
        }
        let missing = self.by_cost[expensive..].iter().rev().scan(needed, |needed, &tile| {
            let missing = *needed;
            *needed = missing.saturating_sub(cost(tile));
            Some(missing)
        });
        let last = missing.take_while(|&missing| missing > 0).count();
        let last = last.max(CHEAP_AT_THE_END * spus as usize);
        self.order.extend(spread(&self.by_cost, expensive, last));

        let order = std::mem::take(&mut self.order);
        let mut rest = order.as_slice();
        while let Some((&first, others)) = rest.split_first() {
            let share = (left / (PARTS_OF_A_SHARE * spus)).max(minimum);
            let mut taken = cost(first);
            let others = others.iter().take(UNIT_TILES as usize - 1);
            let more = others.take_while(|&&tile| {
                let fits = taken + cost(tile) <= share;
                taken += if fits { cost(tile) } else { 0 };
                fits
            });
            let (unit, following) = rest.split_at(1 + more.count());
            self.push(unit);
            left -= taken;
            rest = following;
        }
        self.order = order;
    }

    /// Marks the units' tiles that are in a set with a flag.
    pub fn mark(&mut self, tiles: &TileSet, flag: u32) {
        for unit in &mut self.lines {
            let count = unit.count.get() as usize;
            for tile in unit.tiles.iter_mut().take(count) {
                if tiles.contains(tile.get() & !TILE_FLAGS) {
                    *tile |= flag;
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

/// The minimum number of cheap tiles at the end, for each SPU.
const CHEAP_AT_THE_END: usize = 4;

/// Spreads cheap tiles evenly between the first `expensive` ones, and keeps the `last` for the end.
/// Tiles that are only filled wait for main memory when many come together. At the end, though,
/// they are the smallest pieces of work, with which all SPUs finish at nearly the same time.
fn spread(by_cost: &[u32], expensive: usize, last: usize) -> impl Iterator<Item = u32> {
    let (expensive, cheap) = by_cost.split_at(expensive);
    let (between, last) = cheap.split_at(cheap.len().saturating_sub(last));
    let run = |number: usize| between.len() * number / expensive.len();
    let mixed = expensive.iter().enumerate().flat_map(move |(number, tile)| {
        std::iter::once(tile).chain(&between[run(number)..run(number + 1)])
    });
    // Without expensive tiles, the others follow one another.
    let alone = if expensive.is_empty() { between } else { &[] };
    mixed.chain(alone).chain(last).copied()
}

fn run_length(tiles: usize, spus: u32) -> usize {
    tiles.div_ceil((UNITS_AN_SPU * spus) as usize).clamp(1, UNIT_TILES as usize)
}

/// A tile that may be kept counts for this part of its cost at least, since a change may reach it.
const PART_OF_KEPT: u32 = 8;

/// The time that each tile of a picture took, in decrementer ticks.
#[derive(Default)]
pub struct TileCosts {
    geometry: Option<Geometry>,
    /// When it was last traced as a whole.
    whole: Vec<u32>,
    /// In the last frame that had it, in which it may have been kept.
    last: Vec<u32>,
    expected: Vec<u32>,
}

impl TileCosts {
    /// The costs to be expected of a picture's tiles, if they are known. Of the tiles `in_part`
    /// those are traced that a change reaches: mostly the same as in the last frame.
    pub fn of(&mut self, geometry: Geometry, in_part: &TileSet) -> Option<&[u32]> {
        let Self { whole, last, expected, .. } = self;
        expected.clear();
        expected.extend((0..).zip(whole).zip(last).map(|((tile, whole), last)| {
            match in_part.contains(tile) {
                true => (*last).max(*whole / PART_OF_KEPT),
                false => *whole,
            }
        }));
        (self.geometry == Some(geometry)).then_some(&self.expected)
    }

    /// Records the costs of a frame's units.
    pub fn learn(&mut self, geometry: Geometry, units: &[WorkUnit], costs: &[UnitCost]) {
        if self.geometry != Some(geometry) {
            self.geometry = Some(geometry);
            for ticks in [&mut self.whole, &mut self.last] {
                ticks.clear();
                ticks.resize(tile_count(geometry) as usize, 0);
            }
        }
        for (tile, cost) in tiles_and_costs(units, costs) {
            let (tile, ticks) = (tile as usize, cost & !TILE_FLAGS);
            let (Some(whole), Some(last)) = (self.whole.get_mut(tile), self.last.get_mut(tile))
            else {
                continue;
            };
            *last = ticks;
            if cost & TILE_KEPT == 0 {
                *whole = ticks;
            }
        }
    }
}

/// The tiles of the units that SPUs have finished, each with its cost.
pub(super) fn tiles_and_costs<'a>(
    units: &'a [WorkUnit],
    costs: &'a [UnitCost],
) -> impl Iterator<Item = (u32, u32)> + 'a {
    let measured = units.iter().zip(costs).filter(|(unit, cost)| unit.count == cost.count);
    measured.flat_map(|(unit, cost)| {
        let tiles = unit.tiles.iter().take(unit.count.get() as usize);
        let tiles = tiles.map(|tile| tile.get() & !TILE_FLAGS);
        tiles.zip(cost.ticks.iter().map(|ticks| ticks.get()))
    })
}

#[cfg(test)]
mod tests;
