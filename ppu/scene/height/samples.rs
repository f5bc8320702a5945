//! The samples of all levels of a height field, and the range of heights of each block.

use glam::DVec3;
use protocol::layout::{HEIGHT_COLUMNS, HEIGHT_LEVELS, HEIGHT_ROWS};
use scenes::HeightField;
use zerocopy::big_endian::U32;
use zerocopy::{FromBytes, FromZeros as _, Immutable, IntoBytes};

use crate::scene::colour::Colour;

/// Samples in front of a row in memory, which are not its own.
const BEFORE: usize = 4;
/// All of those beside the squares of a row's blocks.
const BESIDE: usize = 8;
/// Rows beside those of a level's blocks: one in front, and two more after them.
const ROWS_BESIDE: usize = 3;
/// The largest part of a colour, as light or as its square root.
const FULL: f64 = 65535.0;

/// Four samples: a quadword, as a DMA transfer needs it.
#[derive(Clone, Copy, Debug, FromBytes, IntoBytes, Immutable)]
#[repr(C, align(16))]
struct Four([U32; 4]);

/// The samples of all levels.
#[derive(Debug)]
pub struct HeightSamples {
    pub(super) levels: Vec<Level>,
    memory: Vec<Four>,
}

/// A level.
#[derive(Clone, Debug)]
pub(super) struct Level {
    /// Squares across and down.
    pub squares: [u32; 2],
    /// Columns and rows of blocks. There is an even number of rows.
    pub blocks: [u32; 2],
    /// The offset of its samples in bytes.
    pub offset: u32,
    /// Bytes from one row to the next.
    pub stride: u32,
    /// The minimum and the maximum height of each block and of the next level there.
    pub ranges: Vec<[u16; 2]>,
}

/// A level's samples, before they are packed.
struct Grid {
    columns: usize,
    rows: usize,
    heights: Vec<u16>,
    /// Light, times `FULL`.
    colours: Vec<[u16; 3]>,
}

impl Grid {
    fn at(&self, column: usize, row: usize) -> usize {
        row.min(self.rows - 1) * self.columns + column.min(self.columns - 1)
    }

    /// The next level: each sample is a mean around it, by the weights 1, 2, 1 across and down.
    fn halved(&self) -> Self {
        let half = |samples: usize| (samples - 1).div_ceil(2) + 1;
        let (columns, rows) = (half(self.columns), half(self.rows));
        let count = columns * rows;
        let (mut heights, mut colours) = (Vec::with_capacity(count), Vec::with_capacity(count));
        for row in 0..rows {
            for column in 0..columns {
                let mut sums = [8_u32; 4];
                let (x, z) = ((2 * column).min(self.columns - 1), (2 * row).min(self.rows - 1));
                for (down, of_row) in [(z.saturating_sub(1), 1), (z, 2), (z + 1, 1)] {
                    for (across, of_column) in [(x.saturating_sub(1), 1), (x, 2), (x + 1, 1)] {
                        let at = self.at(across, down);
                        let [red, green, blue] = self.colours[at];
                        for (sum, part) in sums.iter_mut().zip([self.heights[at], red, green, blue])
                        {
                            *sum += of_row * of_column * u32::from(part);
                        }
                    }
                }
                let [height, red, green, blue] = sums.map(|sum| (sum >> 4) as u16);
                heights.push(height);
                colours.push([red, green, blue]);
            }
        }
        Self { columns, rows, heights, colours }
    }
}

impl HeightSamples {
    /// All levels of a height field, with its colours as SPUs get those of vertices.
    pub(crate) fn new(field: &HeightField, colour: Colour) -> Self {
        let light: [u16; 256] = std::array::from_fn(|byte| {
            let light = colour.light(DVec3::splat(byte as f64 / 255.0)).x;
            (FULL * light).round() as u16
        });
        let [columns, rows] = field.size();
        let places = (0..i64::from(rows))
            .flat_map(|row| (0..i64::from(columns)).map(move |column| (column, row)));
        let colours = places
            .clone()
            .map(|(column, row)| field.colour(column, row).map(|part| light[usize::from(part)]));
        let mut grid = Grid {
            columns: columns as usize,
            rows: rows as usize,
            heights: places.clone().map(|(column, row)| field.sample(column, row)).collect(),
            colours: colours.collect(),
        };
        let mut samples = Self { levels: Vec::new(), memory: Vec::new() };
        loop {
            let next = grid.halved();
            samples.add(&grid, &next, colour);
            let is_one = grid.columns <= 9 && grid.rows <= 9;
            grid = next;
            if is_one || samples.levels.len() == HEIGHT_LEVELS as usize {
                break;
            }
        }
        // The one that the last level fades to.
        let next = grid.halved();
        samples.add(&grid, &next, colour);
        samples.within_4_gb()
    }

    /// The number of levels that blocks have.
    pub(super) fn count(&self) -> usize {
        self.levels.len() - 1
    }

    /// The minimum and the maximum height of all levels.
    pub(super) fn range(&self) -> [u16; 2] {
        let all = self.levels[0].ranges.iter();
        all.fold([u16::MAX, 0], |[low, high], it| [low.min(it[0]), high.max(it[1])])
    }

    /// The bytes of all levels.
    #[cfg(test)]
    pub fn bytes(&self) -> usize {
        let ranges = self.levels.iter().map(|level| size_of_val(&*level.ranges));
        size_of_val(&*self.memory) + ranges.sum::<usize>()
    }

    pub(super) fn address(&self) -> u64 {
        self.memory.as_ptr().expose_provenance() as u64
    }

    fn add(&mut self, grid: &Grid, next: &Grid, colour: Colour) {
        let [columns, rows] = [HEIGHT_COLUMNS, HEIGHT_ROWS].map(|side| side as usize);
        let across = (grid.columns - 1).div_ceil(columns);
        let down = (grid.rows - 1).div_ceil(2 * rows) * 2;
        let width = columns * across + BESIDE;
        let packed = |part: u16, most: f64| {
            let part = f64::from(part) / FULL;
            let part = if colour == Colour::Srgb { part.sqrt() } else { part };
            (most * part).round() as u32
        };
        let fives: Vec<u8> = (0..=u16::MAX).map(|part| packed(part, 31.0) as u8).collect();
        let sixes: Vec<u8> = (0..=u16::MAX).map(|part| packed(part, 63.0) as u8).collect();
        let offset = size_of_val(&*self.memory) as u32;
        for row in 0..rows * down + ROWS_BESIDE {
            let words = (0..width).map(|column| {
                let at = grid.at(column.saturating_sub(BEFORE), row.saturating_sub(1));
                let [red, green, blue] = grid.colours[at].map(usize::from);
                let colour = [(fives[red], 11), (sixes[green], 5), (fives[blue], 0)];
                let colour = colour.iter().map(|&(part, shift)| u32::from(part) << shift);
                u32::from(grid.heights[at]) << 16 | colour.sum::<u32>()
            });
            let mut words = words.map(U32::new);
            while let Some(first) = words.next() {
                let mut rest = || words.next().unwrap_or_default();
                self.memory.push(Four([first, rest(), rest(), rest()]));
            }
        }
        let range = |(column, row): (usize, usize)| {
            let own = (0..=rows).flat_map(|z| (0..=columns).map(move |x| (x, z)));
            let own = own.map(|(x, z)| grid.heights[grid.at(column * columns + x, row * rows + z)]);
            let other = (0..=rows / 2).flat_map(|z| (0..=columns / 2).map(move |x| (x, z)));
            let other = other.map(|(x, z)| {
                next.heights[next.at((column * columns) / 2 + x, (row * rows) / 2 + z)]
            });
            own.chain(other).fold([u16::MAX, 0], |[low, high], it| [low.min(it), high.max(it)])
        };
        let blocks = (0..down).flat_map(|row| (0..across).map(move |column| (column, row)));
        let ranges: Vec<[u16; 2]> = blocks.map(range).collect();
        // The largest heights, for the SPUs: each row in whole quadwords.
        for row in ranges.chunks(across) {
            for four in row.chunks(4) {
                let word = |at: usize| four.get(at).map_or(0, |range| u32::from(range[1]) << 16);
                self.memory.push(Four([0, 1, 2, 3].map(word).map(U32::new)));
            }
        }
        self.levels.push(Level {
            squares: [grid.columns as u32 - 1, grid.rows as u32 - 1],
            blocks: [across as u32, down as u32],
            offset,
            stride: (width * size_of::<U32>()) as u32,
            ranges,
        });
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
