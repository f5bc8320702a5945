//! Where ground lies in its own shadow, for a light that is infinitely far: what spares shadow rays
//! the search for the triangles that they would meet.
//!
//! The field is cut into strips across the light, the first one at the edge that is nearest to it,
//! as wide as a square, and into narrower lanes along the light. A ray to the light stays in its
//! lane. Heights are those above a plane that rises towards the light as its rays do. So a ray to
//! the light has the same height everywhere, and ground that is higher on its way blocks it. One
//! sweep along each lane away from the light finds two bounds of the highest ground so far. Points
//! below the lower one are dark, and points above the upper one are lit.
//!
//! On the ground itself the upper bound decides little, since the ground may be the highest so far.
//! So a block's upper bound is only that of its cells that are not lit. A cell is lit if, back to a
//! line that is above all ground before it, no square rises as steeply as the light does. Between
//! the two sides of a lane heights are taken for linear, with a margin for the bends of the ground
//! between them.
//!
//! Bounds hold for the triangles of the first level. Coarser levels have less of the same cells.

use glam::DVec3;
use protocol::layout::{SHADE_ENDLESS as ENDLESS, SHADE_LEVELS, SHADE_SIDE_LOG2, SHADES_BESIDE};
use scenes::{HeightField, HeightRegion, MAX_SAMPLES};
use zerocopy::big_endian::{F32, U32};

use super::samples::Four;
use crate::scene::single::single;

/// Cells of a block, along the light and across it.
const SIDE: usize = 1 << SHADE_SIDE_LOG2;
const LEVELS: usize = SHADE_LEVELS as usize;
/// Lanes of a cell, which is a square wide.
const LANES: usize = 4;
/// How far a lane reaches into its neighbours, in squares: more than the SPUs' singles
/// are off.
const OVERLAP: f64 = 1.0 / 64.0;
/// By how much a slope must be less than the light's, as a part of that.
const LESS: f64 = 1.0 / 1024.0;
/// The margin of heights, as a part of the largest: more than the SPUs' singles are off.
const MARGIN: f64 = 1.0 / (1 << 19) as f64;
/// How many lines back the ground is compared with what is above it.
const LINES: usize = 16;

/// A light's direction, as far as its shadows need it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Sun {
    to_light: DVec3,
    /// Whether the light comes along x rather than along z, and whether lines and places of a line
    /// count against the samples' numbers.
    along_x: bool,
    flipped: [bool; 2],
    /// Lines and samples of a line.
    size: [usize; 2],
    /// How far a lane goes aside from line to line, in samples, and how much the plane falls.
    slant: f64,
    fall: f64,
    /// How long a ray is from line to line.
    length: f64,
    /// What is added to places so that those of lanes are above 0.
    shift: f64,
    /// Rows and columns of blocks.
    blocks: [usize; 2],
}

/// A record of the sun as SPUs get it.
#[derive(Clone, Copy, Debug)]
pub(super) struct SunRecord {
    pub rows: u32,
    pub columns: u32,
    pub slant: u32,
    /// How far a ray goes from line to line.
    pub length: F32,
    /// A place's line is the sum of its parts times these, and so is its sample of the line.
    pub line: [F32; 4],
    pub place: [F32; 4],
    /// Its lane is its sample less this part of its line, and more than that by the second; its
    /// height grows by the third with the line, and by the fourth.
    pub lane: [F32; 4],
}

impl Sun {
    /// The sun in a direction, unless that is below the horizon or near the zenith.
    pub fn new(field: &HeightField, to_light: DVec3) -> Option<Self> {
        let along_x = to_light.x.abs() >= to_light.z.abs();
        let [major, minor] =
            if along_x { [to_light.x, to_light.z] } else { [to_light.z, to_light.x] };
        let aside = -minor / major.abs();
        let fall = field.step() * to_light.y / major.abs();
        let [columns, rows] = field.size().map(|side| side as usize);
        let size = if along_x { [columns, rows] } else { [rows, columns] };
        let padded = |side: usize| (side - 1).div_ceil(SIDE << (LEVELS - 1)) << (LEVELS - 1);
        let blocks = size.map(padded);
        let slant = aside.abs();
        let shift = slant * (SIDE * blocks[0]) as f64;
        // Where the sun is near the zenith, singles would lose too much of the plane's heights.
        let steepest = 64.0 * field.step();
        (fall > 0.0 && fall < steepest).then_some(Self {
            to_light,
            along_x,
            flipped: [major > 0.0, aside < 0.0],
            size,
            slant,
            fall,
            length: field.step() / major.abs(),
            shift,
            blocks,
        })
    }

    /// A slant in parts of 65536, not above the exact one.
    fn parts(&self) -> u32 {
        (self.slant * 65536.0).min(65535.0) as u32
    }

    /// Blocks of a level's row, and its rows.
    fn width(&self, level: usize) -> usize {
        (self.blocks[1] >> level) + SHADES_BESIDE as usize
    }

    fn rows(&self, level: usize) -> usize {
        self.blocks[0] >> level
    }

    /// Where a level's blocks begin.
    fn start(&self, level: usize) -> usize {
        (0..level).map(|level| self.width(level) * self.rows(level)).sum()
    }

    /// The place of a block, if it is there. Rows begin where the field does.
    fn index(&self, level: usize, row: usize, column: usize) -> Option<usize> {
        let after = (self.rows(level) - 1 - row) as u64;
        let first = ((u64::from(self.parts()) * after) >> 16) as usize;
        let at = (column + 1).checked_sub(first)?;
        let width = self.width(level);
        (at < width).then(|| self.start(level) + row * width + at)
    }

    /// The record for an eye.
    pub fn record(&self, field: &HeightField, eye: DVec3) -> SunRecord {
        let corner = field.corner - eye;
        let axis = |axis: usize| {
            let is_x = self.along_x == (axis == 0);
            let per = if self.flipped[axis] { -1.0 } else { 1.0 } / field.step();
            let start = -per * if is_x { corner.x } else { corner.z };
            let last = (self.size[axis] - 1) as f64;
            let start = if self.flipped[axis] { last + start } else { start };
            let [x, z] = if is_x { [per, 0.0] } else { [0.0, per] };
            [x, start, z, last].map(single)
        };
        SunRecord {
            rows: self.blocks[0] as u32,
            columns: self.blocks[1] as u32,
            slant: self.parts(),
            length: single(self.length),
            line: axis(0),
            place: axis(1),
            lane: [self.slant, self.shift, self.fall, -corner.y].map(single),
        }
    }
}

/// The cells of all levels. A block is a quadword: a bit for each cell that is lit, and the bounds.
/// The last bits of the upper one are the number of lines before the block where rays that are not
/// dark may be blocked: before these, all ground is below the lower bound.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Shades {
    pub sun: Sun,
    memory: Vec<Four>,
}

/// The parts of a block.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Cells {
    lit: u64,
    low: f32,
    high: f32,
    /// How many lines before the block there are where ground may be high enough.
    reach: u32,
}

impl Cells {
    /// Nothing: cells beside the field.
    const NONE: Self = Self { lit: u64::MAX, low: f32::MAX, high: 0.0, reach: 0 };

    fn of(Four([first, last, low, high]): Four) -> Self {
        let lit = u64::from(first.get()) << 32 | u64::from(last.get());
        let reach = high.get() & ENDLESS;
        let [low, high] = [low.get(), high.get() & !ENDLESS].map(f32::from_bits);
        Self { lit, low, high, reach }
    }

    fn packed(self) -> Four {
        let [first, last] = [self.lit >> 32, self.lit].map(|half| half as u32);
        // Bounds are not below 0, so more bits are a greater number.
        let high = ((self.high.to_bits() + ENDLESS) & !ENDLESS) | self.reach;
        Four([first, last, self.low.to_bits(), high].map(U32::new))
    }
}

/// A cell, as a lane has it.
#[derive(Clone, Copy)]
struct Cell {
    is_lit: bool,
    /// Points below this are dark.
    low: f32,
    /// Points above this are lit.
    high: f32,
    /// The highest ground up to its end.
    highest: f32,
}

/// The bit of a cell.
fn bit(line: usize, lane: usize) -> u64 {
    1 << (63 - (line % SIDE * SIDE + lane % SIDE))
}

/// The ground at a line within a lane.
#[derive(Clone, Copy, Default)]
struct Line {
    /// At the lane's sides.
    sides: [f64; 2],
    /// How much higher and how much lower than in between it may be.
    above: f64,
    below: f64,
    /// Whether the lane is all in the field.
    inside: bool,
}

/// The ground of a lane between two lines.
struct Strip {
    /// Whether it rises towards the light less steeply than that does.
    falls: bool,
    /// Whether what rays leave last does so, and only what they enter first may not.
    ends_falling: bool,
    /// By how much it may be higher than at both lines.
    above: f64,
}

/// A field as lanes see it.
struct Ground<'a> {
    field: &'a HeightField,
    sun: &'a Sun,
}

impl Ground<'_> {
    /// The height of a sample above the plane.
    fn at(&self, line: usize, place: i64) -> f64 {
        let Sun { size, flipped, along_x, fall, .. } = self.sun;
        let place = place.clamp(0, size[1] as i64 - 1);
        let turn = |at: i64, axis: usize| {
            if flipped[axis] { size[axis] as i64 - 1 - at } else { at }
        };
        let [line_at, place] = [turn(line as i64, 0), turn(place, 1)];
        let [column, row] = if *along_x { [line_at, place] } else { [place, line_at] };
        self.field.unit() * f64::from(self.field.sample(column, row)) + fall * line as f64
    }

    /// Where a lane starts at the first line.
    fn start(&self, lane: usize) -> f64 {
        lane as f64 / LANES as f64 - self.sun.shift
    }

    /// The places between which a lane is at a line.
    fn sides(&self, lane: usize, line: usize) -> [f64; 2] {
        let start = self.start(lane) + self.sun.slant * line as f64;
        [start - OVERLAP, start + 1.0 / LANES as f64 + OVERLAP]
    }

    /// How much a sample of a line is above the mean of its neighbours, twice.
    fn bend(&self, line: usize, place: i64) -> f64 {
        2.0 * self.at(line, place) - self.at(line, place - 1) - self.at(line, place + 1)
    }

    fn line(&self, lane: usize, line: usize) -> Line {
        let last = (self.sun.size[1] - 1) as f64;
        let [start, end] = self.sides(lane, line);
        let side = |place: f64| {
            let place = place.clamp(0.0, last);
            let whole = place.floor();
            let [one, other] = [0, 1].map(|step| self.at(line, whole as i64 + step));
            one + (other - one) * (place - whole)
        };
        let mut found = Line {
            sides: [start, end].map(side),
            inside: start >= 0.0 && end <= last,
            ..Line::default()
        };
        for place in start.ceil() as i64..=end.floor() as i64 {
            let bend = self.bend(line, place) * (end - start) / 4.0;
            found.above += bend.max(0.0);
            found.below += (-bend).max(0.0);
        }
        found
    }

    /// The ground of a lane between a line and the next.
    fn strip(&self, lane: usize, line: usize) -> Strip {
        let slant = self.sun.slant;
        let (is_main, limit) = (self.sun.flipped[0] == self.sun.flipped[1], self.sun.fall * LESS);
        let [[start, _], [_, end]] = [line, line + 1].map(|line| self.sides(lane, line));
        let last = self.sun.size[1] as i64 - 2;
        let square = |place: f64| (place.floor() as i64).clamp(0, last);
        let mut strip = Strip { falls: true, ends_falling: true, above: 0.0 };
        for place in square(start)..=square(end) {
            let [a, b] = [0, 1].map(|step| self.at(line, place + step));
            let [c, d] = [0, 1].map(|step| self.at(line + 1, place + step));
            // The slopes away from the light of the triangle that rays leave last, and the other's.
            let [last, first] = if is_main {
                [c - a + slant * (d - c), d - b + slant * (b - a)]
            } else {
                [d - b + slant * (d - c), c - a + slant * (b - a)]
            };
            strip.falls &= first.min(last) >= limit;
            // Rays that come from the square beside it meet only the last one, if it is the main
            // diagonal that parts them.
            let from_beside = !is_main && place > square(start);
            strip.ends_falling &= last >= limit && !(from_beside && first < limit);
            let bend = self.bend(line, place).max(self.bend(line + 1, place)).max(0.0);
            strip.above = strip.above.max(((first - last).max(0.0) + slant * bend) / 4.0);
        }
        strip
    }
}

impl Shades {
    /// Those of a light.
    pub fn new(field: &HeightField, sun: Sun) -> Self {
        let count = sun.start(LEVELS);
        let mut shades = Self { sun, memory: vec![Cells::NONE.packed(); count] };
        let [columns, rows] = field.size();
        shades.update(field, &HeightRegion { columns: 0..columns, rows: 0..rows });
        shades
    }

    /// Sweeps those lanes anew in which a region of the field is.
    pub fn update(&mut self, field: &HeightField, region: &HeightRegion) {
        if region.is_empty() {
            return;
        }
        let sun = self.sun;
        let range = |axis: usize| {
            let range = if sun.along_x == (axis == 0) { &region.columns } else { &region.rows };
            let [start, end] = [f64::from(range.start), f64::from(range.end)];
            let last = sun.size[axis] as f64 - 1.0;
            // Bends are those of the samples beside it.
            let [start, end] =
                if sun.flipped[axis] { [last - end, last - start] } else { [start, end] };
            [start - 2.0, end + 2.0]
        };
        let [lines, places] = [range(0), range(1)];
        let lane = |place: f64, line: f64| (place - sun.slant * line + sun.shift).floor();
        let start = lane(places[0], lines[1]).max(0.0) as usize / SIDE;
        let end = lane(places[1], lines[0]) as usize / SIDE;
        for column in start..=end {
            self.sweep(&Ground { field, sun: &sun }, column);
        }
        for level in 1..LEVELS {
            for column in start >> level..=end >> level {
                for row in 0..sun.rows(level) {
                    self.merge(level, row, column);
                }
            }
        }
    }

    /// Makes a block of the four of the level before.
    fn merge(&mut self, level: usize, row: usize, column: usize) {
        let Some(to) = self.sun.index(level, row, column) else {
            return;
        };
        let mut cells = Cells::NONE;
        for quarter in 0..4 {
            let [down, across] = [quarter / 2, quarter % 2];
            let from = self.sun.index(level - 1, 2 * row + down, 2 * column + across);
            let Some(from) = from else {
                continue;
            };
            let part = Cells::of(self.memory[from]);
            cells.low = cells.low.min(part.low);
            cells.high = cells.high.max(part.high);
            let is_endless = part.reach == ENDLESS;
            let reach = if is_endless { ENDLESS } else { part.reach.div_ceil(2) };
            cells.reach = cells.reach.max(reach);
            for cell in 0..SIDE * SIDE {
                let [line, lane] = [cell / SIDE, cell % SIDE];
                if part.lit & bit(line, lane) == 0 {
                    let half = SIDE / 2;
                    cells.lit &= !bit(down * half + line / 2, across * half + lane / 2);
                }
            }
        }
        self.memory[to] = cells.packed();
    }

    /// Sweeps the lanes of a column of blocks.
    fn sweep(&mut self, ground: &Ground<'_>, column: usize) {
        let sun = self.sun;
        for row in 0..sun.rows(0) {
            if let Some(at) = sun.index(0, row, column) {
                self.memory[at] = Cells::NONE.packed();
            }
        }
        // The highest ground up to the line after each.
        let mut highs = [0.0; MAX_SAMPLES as usize];
        for lane in column * SIDE * LANES..(column + 1) * SIDE * LANES {
            sweep_lane(ground, lane, |line, cell| {
                highs[line] = cell.highest.max(highs[line]);
                self.add(line, lane / LANES, cell);
            });
        }
        for line in 1..highs.len() {
            highs[line] = highs[line].max(highs[line - 1]);
        }
        for row in 0..sun.rows(0) {
            let Some(at) = sun.index(0, row, column) else {
                continue;
            };
            let mut cells = Cells::of(self.memory[at]);
            let first = (row * SIDE).min(sun.size[0]);
            let lower = highs[..first].partition_point(|high| *high < cells.low);
            cells.reach = ((first - lower) as u32 + 2).min(ENDLESS);
            self.memory[at] = cells.packed();
        }
    }

    /// Adds what a lane has found at a line to a cell.
    fn add(&mut self, line: usize, lane: usize, found: Cell) {
        let Some(at) = self.sun.index(0, line / SIDE, lane / SIDE) else {
            return;
        };
        let mut cells = Cells::of(self.memory[at]);
        cells.low = cells.low.min(found.low);
        if !found.is_lit {
            cells.lit &= !bit(line, lane);
            cells.high = cells.high.max(found.high);
        }
        self.memory[at] = cells.packed();
    }

    /// The address of the first block.
    pub fn address(&self) -> u64 {
        self.memory.as_ptr().expose_provenance() as u64
    }

    /// The bytes of all levels.
    #[cfg(test)]
    pub fn bytes(&self) -> usize {
        size_of_val(&*self.memory)
    }
}

/// Sweeps a lane, and hands out each of its cells.
fn sweep_lane(ground: &Ground<'_>, lane: usize, mut add: impl FnMut(usize, Cell)) {
    let sun = ground.sun;
    let [lines, places] = sun.size;
    // The first line after which it is in the field, and the last.
    let from = |place: f64| (place - ground.start(lane)) / sun.slant.max(1e-9);
    let first = (from(-1.0 - OVERLAP).floor() - 1.0).max(0.0) as usize;
    let end = (from(places as f64 + OVERLAP).ceil().max(0.0) as usize + 1).min(lines - 1);
    if first >= end {
        return;
    }
    let margin = MARGIN * (ground.field.unit() * f64::from(u16::MAX) + sun.fall * lines as f64);
    let mut before = ground.line(lane, first);
    let mut highest = before.sides.map(|side| side + before.above);
    let bound = |highest: [f64; 2]| (highest[0].max(highest[1]) + margin) as f32;
    let mut surely = 0.0_f64;
    let mut is_lit = true;
    // The highest ground before each of the last lines, as far as none has risen.
    let mut past = [[0.0; 2]; LINES];
    let mut even = 0;
    for line in first..end {
        let here = ground.line(lane, line + 1);
        let Strip { falls, ends_falling, above } = ground.strip(lane, line);
        past[line % LINES] = highest;
        even = if falls { (even + 1).min(LINES) } else { usize::from(ends_falling) };
        if before.inside {
            surely = surely.max(before.sides[0].min(before.sides[1]) - before.below);
        }
        for side in 0..2 {
            let highest = &mut highest[side];
            *highest = highest.max(here.sides[side] + here.above);
            if !falls {
                let most = here.sides[side].max(before.sides[side]);
                *highest = highest.max(most + here.above.max(before.above) + above);
            }
        }
        let cell = is_lit && falls;
        is_lit = cell
            || (0..even).any(|back| {
                let past = past[(line - back) % LINES];
                (0..2).all(|side| past[side] + margin <= here.sides[side] - here.below)
            });
        before = here;
        let high = bound(highest);
        // If the ground has dipped at most, a point above all ground before it is above this, too.
        let before_it = if falls || ends_falling { bound(past[line % LINES]) } else { high };
        let low = (surely - margin).max(0.0) as f32;
        add(line, Cell { is_lit: cell, low, high: before_it, highest: high });
    }
}

#[cfg(test)]
mod tests;
