//! The samples of all levels of a height field as SPUs get them, and the range of heights of each
//! block.

use std::ops::Range;

use protocol::layout::{HEIGHT_COLUMNS, HEIGHT_ROWS};
use scenes::{HeightField, HeightRegion};
use zerocopy::big_endian::U32;
use zerocopy::{FromBytes, FromZeros as _, Immutable, IntoBytes};

use super::levels::{Levels, Packing};
use super::shades::Shades;

/// Samples in front of a row in memory, which are not its own.
const BEFORE: usize = 4;
/// All of those beside the squares of a row's blocks.
const BESIDE: usize = 8;
/// Rows beside those of a level's blocks: one in front, and two more after them.
const ROWS_BESIDE: usize = 3;

/// Four samples: a quadword, as a DMA transfer needs it.
#[derive(Clone, Copy, Debug, PartialEq, FromBytes, IntoBytes, Immutable)]
#[repr(C, align(16))]
pub(super) struct Four(pub [U32; 4]);

/// The samples of all levels.
#[derive(Clone, Debug, PartialEq)]
pub struct HeightSamples {
    pub(super) levels: Vec<Level>,
    memory: Vec<Four>,
    /// Where the ground lies in its own shadow.
    pub(super) shades: Option<Shades>,
}

/// A level.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Level {
    /// Squares across and down.
    pub squares: [u32; 2],
    /// Columns and rows of blocks. There is an even number of rows.
    pub blocks: [u32; 2],
    /// The offset of its samples in bytes.
    pub offset: u32,
    /// Bytes from one row to the next.
    pub stride: u32,
}

/// The sizes of a block in squares.
const BLOCK: [usize; 2] = [HEIGHT_COLUMNS as usize, HEIGHT_ROWS as usize];

impl Level {
    /// Rows of samples in memory.
    fn height(&self) -> usize {
        self.blocks[1] as usize * BLOCK[1] + ROWS_BESIDE
    }

    /// Where a block's range of heights is: in which quadword and which of its words. They are
    /// after the samples, each row in whole quadwords.
    fn range_at(&self, column: usize, row: usize) -> [usize; 2] {
        let start = self.offset as usize + self.height() * self.stride as usize;
        let width = (self.blocks[0] as usize).div_ceil(4);
        [start / size_of::<Four>() + row * width + column / 4, column % 4]
    }

    /// The columns or rows of blocks that have samples of a region, or those of the next level
    /// there.
    fn changed(&self, side: usize, own: &Range<u32>, next: &Range<u32>) -> Range<u32> {
        let (size, half) = (BLOCK[side] as u32, BLOCK[side] as u32 / 2);
        let count = self.blocks[side];
        let start = (own.start / size).min(next.start / half).saturating_sub(1);
        let is_last = own.end == self.squares[side] + 1;
        let end = (own.end / size).max(next.end / half) + 1;
        start..if is_last { count } else { end.min(count) }
    }
}

/// Where a row or column in memory of `count` words or rows has a range of its `samples`: `before`
/// copies of the first one are in front of them, and the rest are copies of the last one.
fn copies(range: &Range<u32>, samples: usize, before: usize, count: usize) -> Range<usize> {
    let start = range.start as usize;
    let end = range.end as usize;
    let start = if start == 0 { 0 } else { start + before };
    start..if end == samples { count } else { end + before }
}

/// The places of the samples around a number of squares.
fn square([columns, rows]: [usize; 2]) -> impl Iterator<Item = [usize; 2]> {
    (0..=rows).flat_map(move |down| (0..=columns).map(move |across| [across, down]))
}

impl HeightSamples {
    /// Packs all levels.
    pub(super) fn new(field: &HeightField, levels: &Levels, packing: &Packing) -> Self {
        let mut samples = Self { levels: Vec::new(), memory: Vec::new(), shades: None };
        for grid in &levels.0[..levels.0.len() - 1] {
            let [columns, rows] = grid.size;
            let across = (columns - 1).div_ceil(BLOCK[0]);
            let down = (rows - 1).div_ceil(2 * BLOCK[1]) * 2;
            let width = BLOCK[0] * across + BESIDE;
            samples.levels.push(Level {
                squares: [columns as u32 - 1, rows as u32 - 1],
                blocks: [across as u32, down as u32],
                offset: size_of_val(&*samples.memory) as u32,
                stride: (width * size_of::<U32>()) as u32,
            });
            let fours = width / 4 * (BLOCK[1] * down + ROWS_BESIDE) + across.div_ceil(4) * down;
            samples.memory.resize(samples.memory.len() + fours, Four::new_zeroed());
        }
        let [columns, rows] = field.size();
        let all = HeightRegion { columns: 0..columns, rows: 0..rows };
        samples.update(field, levels, packing, &all);
        samples.within_4_gb()
    }

    /// Packs a region of the field anew, and what depends on it in all levels. `levels` are up to
    /// date.
    pub(super) fn update(
        &mut self,
        field: &HeightField,
        levels: &Levels,
        packing: &Packing,
        region: &HeightRegion,
    ) {
        let mut region = region.within(field.size());
        for (level, grids) in self.levels.iter_mut().zip(levels.0.windows(2)) {
            let [grid, next] = [&grids[0], &grids[1]];
            let of_next = grid.changed_in(&region, next);
            let at = |column, row| grid.at(field, packing, column, row);
            let width = level.stride as usize / size_of::<U32>();
            let words = copies(&region.columns, grid.size[0], BEFORE, width);
            for row in copies(&region.rows, grid.size[1], 1, level.height()) {
                let start = level.offset as usize / size_of::<Four>() + row * width / 4;
                for word in words.clone() {
                    let sample = at(word.saturating_sub(BEFORE), row.saturating_sub(1));
                    self.memory[start + word / 4].0[word % 4] = packing.packed(sample);
                }
            }
            for row in level.changed(1, &region.rows, &of_next.rows) {
                for column in level.changed(0, &region.columns, &of_next.columns) {
                    let [x, z] = [column as usize * BLOCK[0], row as usize * BLOCK[1]];
                    let own = square(BLOCK).map(|[across, down]| at(x + across, z + down));
                    let other = square(BLOCK.map(|side| side / 2)).map(|[across, down]| {
                        next.at(field, packing, x / 2 + across, z / 2 + down)
                    });
                    let heights = own.chain(other).map(|[height, ..]| height);
                    let range =
                        heights.fold([u16::MAX, 0], |[low, high], it| [low.min(it), high.max(it)]);
                    let [four, word] = level.range_at(column as usize, row as usize);
                    let [low, high] = range.map(u32::from);
                    self.memory[four].0[word] = U32::new(high << 16 | low);
                }
            }
            region = of_next;
        }
    }

    /// The minimum and the maximum height of a block and of the next level there.
    pub(super) fn range(&self, level: &Level, column: u32, row: u32) -> [u16; 2] {
        let [four, word] = level.range_at(column as usize, row as usize);
        let range = self.memory[four].0[word].get();
        [range as u16, (range >> 16) as u16]
    }

    /// The number of levels that blocks have.
    pub(super) fn count(&self) -> usize {
        self.levels.len() - 1
    }

    /// The bytes of all levels.
    #[cfg(test)]
    pub fn bytes(&self) -> usize {
        size_of_val(&*self.memory) + self.shades.as_ref().map_or(0, Shades::bytes)
    }

    pub(super) fn address(&self) -> u64 {
        self.memory.as_ptr().expose_provenance() as u64
    }

    /// The same samples where they don't cross a multiple of 4 GB, as the elements of a DMA list
    /// may not.
    fn within_4_gb(mut self) -> Self {
        let mut others = Vec::new();
        loop {
            let start = self.address();
            let end = start + size_of_val(&*self.memory) as u64 - 1;
            if start >> 32 == end >> 32 {
                return self;
            }
            // The memory that crosses it is kept until there is other memory.
            let mut other = vec![Four::new_zeroed(); self.memory.len()];
            other.copy_from_slice(&self.memory);
            others.push(std::mem::replace(&mut self.memory, other));
        }
    }
}
