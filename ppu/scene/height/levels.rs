//! The levels of a height field: each has half of the samples in a row that the one before has.

use std::ops::Range;

use glam::DVec3;
use protocol::layout::HEIGHT_LEVELS;
use scenes::{HeightField, HeightRegion};
use zerocopy::big_endian::U32;

use crate::scene::colour::Colour;

/// The largest part of a colour, as light or as its square root.
const FULL: f64 = 65535.0;
/// A level with no more samples in a row than this, and no more rows, is the last one.
const LAST: usize = 9;

/// A height, and the light of a colour times `FULL`.
type Sample = [u16; 4];

/// How colours are kept: as light while levels are made, and in 16 bits as SPUs get them.
#[derive(Debug)]
pub(super) struct Packing {
    /// The light of each part of a colour.
    light: [u16; 256],
    /// Light in five and in six bits.
    fives: Vec<u8>,
    sixes: Vec<u8>,
}

impl Packing {
    pub fn new(colour: Colour) -> Self {
        let packed = |most: f64| {
            let part = move |part: u16| {
                let part = f64::from(part) / FULL;
                let part = if colour == Colour::Srgb { part.sqrt() } else { part };
                (most * part).round() as u8
            };
            (0..=u16::MAX).map(part).collect()
        };
        let light = std::array::from_fn(|byte| {
            let light = colour.light(DVec3::splat(byte as f64 / 255.0)).x;
            (FULL * light).round() as u16
        });
        Self { light, fives: packed(31.0), sixes: packed(63.0) }
    }

    pub fn packed(&self, [height, red, green, blue]: Sample) -> U32 {
        let part = |table: &[u8], part: u16| u32::from(table[usize::from(part)]);
        let (red, blue) = (part(&self.fives, red), part(&self.fives, blue));
        let green = part(&self.sixes, green);
        U32::new(u32::from(height) << 16 | red << 11 | green << 5 | blue)
    }
}

/// All levels. The first one's samples are the field's own. The last one has no blocks: the one
/// before it fades to it, and itself needs the range of heights there.
#[derive(Clone, Debug)]
pub(super) struct Levels(pub Vec<Grid>);

/// A level.
#[derive(Clone, Debug)]
pub(super) struct Grid {
    /// Samples of a row, and rows.
    pub size: [usize; 2],
    /// `None` in the first level.
    samples: Option<Vec<Sample>>,
}

impl Grid {
    /// The level that has the field's samples.
    fn of(field: &HeightField) -> Self {
        Self { size: field.size().map(|side| side as usize), samples: None }
    }

    /// A sample, or the nearest one at the edge.
    pub fn at(&self, field: &HeightField, packing: &Packing, column: usize, row: usize) -> Sample {
        let [columns, rows] = self.size;
        let (column, row) = (column.min(columns - 1), row.min(rows - 1));
        match &self.samples {
            Some(samples) => samples[row * columns + column],
            None => {
                let (column, row) = (column as i64, row as i64);
                let light = |byte: u8| packing.light[usize::from(byte)];
                let [red, green, blue] = field.colour(column, row).map(light);
                [field.sample(column, row), red, green, blue]
            }
        }
    }

    /// A sample of the next level: a mean around one, by the weights 1, 2, 1 across and down.
    fn mean(&self, field: &HeightField, packing: &Packing, column: usize, row: usize) -> Sample {
        let [columns, rows] = self.size;
        let (x, z) = ((2 * column).min(columns - 1), (2 * row).min(rows - 1));
        let mut sums = [8_u32; 4];
        for (down, of_row) in [(z.saturating_sub(1), 1), (z, 2), (z + 1, 1)] {
            for (across, of_column) in [(x.saturating_sub(1), 1), (x, 2), (x + 1, 1)] {
                for (sum, part) in sums.iter_mut().zip(self.at(field, packing, across, down)) {
                    *sum += of_row * of_column * u32::from(part);
                }
            }
        }
        sums.map(|sum| (sum >> 4) as u16)
    }

    /// The region of the next level that depends on one of this level.
    pub fn changed_in(&self, region: &HeightRegion, next: &Self) -> HeightRegion {
        let half = |range: &Range<u32>| range.start.saturating_sub(1) / 2..range.end / 2 + 2;
        let HeightRegion { columns, rows } = region;
        HeightRegion { columns: half(columns), rows: half(rows) }
            .within(next.size.map(|side| side as u32))
    }
}

impl Levels {
    pub fn new(field: &HeightField, packing: &Packing) -> Self {
        let mut levels = Self(vec![Grid::of(field)]);
        let half = |samples: usize| (samples - 1).div_ceil(2) + 1;
        // Two more follow the last one that has blocks.
        let mut more = None;
        while more != Some(0) {
            let of = &levels.0[levels.0.len() - 1];
            let is_last = of.size.iter().all(|side| *side <= LAST)
                || levels.0.len() == HEIGHT_LEVELS as usize;
            more = more.map(|more: u32| more - 1).or(is_last.then_some(1));
            let size = of.size.map(half);
            levels.0.push(Grid { size, samples: Some(vec![[0; 4]; size[0] * size[1]]) });
        }
        let [columns, rows] = field.size();
        levels.update(field, packing, &HeightRegion { columns: 0..columns, rows: 0..rows });
        levels
    }

    /// Makes those samples anew that depend on a region of the field.
    pub fn update(&mut self, field: &HeightField, packing: &Packing, region: &HeightRegion) {
        let mut region = region.within(field.size());
        for number in 1..self.0.len() {
            let (before, from) = self.0.split_at_mut(number);
            let (of, next) = (&before[number - 1], &mut from[0]);
            region = of.changed_in(&region, next);
            let columns = next.size[0];
            for row in region.rows.clone() {
                for column in region.columns.clone() {
                    let (column, row) = (column as usize, row as usize);
                    let mean = of.mean(field, packing, column, row);
                    if let Some(samples) = &mut next.samples {
                        samples[row * columns + column] = mean;
                    }
                }
            }
        }
    }
}
