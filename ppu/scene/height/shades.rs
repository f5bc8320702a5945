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
/// Lanes of a cell, which is a square wide, and those of a block.
const LANES: usize = 4;
const ACROSS: usize = SIDE * LANES;
/// Samples of a line that a block's lanes are compared with, from the line before it to the next,
/// and one more on each side: lanes go aside by a sample a line at most.
const WIDTH: usize = SIDE + 6;
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

/// The samples of a line, from one on.
struct Row {
    first: i64,
    heights: [f64; WIDTH],
    /// How much each is above the mean of its neighbours, twice.
    bends: [f64; WIDTH],
}

impl Row {
    /// A height or a bend of a place. Lanes reach only those that are there.
    fn of(&self, values: &[f64; WIDTH], place: i64) -> f64 {
        values[(place - self.first) as usize]
    }
}

/// A square between two lines.
#[derive(Clone, Copy, Default)]
struct Square {
    /// Whether it rises towards the light less steeply than that does.
    falls: bool,
    /// Whether what rays leave last does so, and only what they enter first may not. Rays that
    /// come from the square beside it meet only the last one, if it is the main diagonal that
    /// parts them: the second is for these.
    ends_falling: [bool; 2],
    /// By how much it may be higher than at both lines.
    above: f64,
}

/// The ground at a line within a lane.
#[derive(Clone, Copy, Default)]
struct Line {
    /// The samples at or before the lane's sides, and the heights there.
    places: [i64; 2],
    sides: [f64; 2],
    /// How much higher and how much lower than in between it may be.
    above: f64,
    below: f64,
    /// Whether the lane is all in the field.
    inside: bool,
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

    /// The samples of a line that the lanes of a column of blocks reach.
    fn row(&self, column: usize, line: usize) -> Row {
        let before = self.sun.slant * line.saturating_sub(1) as f64;
        let start = self.start(column * ACROSS) + before - OVERLAP;
        let last = (self.sun.size[1] as i64 - 3).max(-1);
        let first = (start.floor() as i64 - 1).clamp(-1, last);
        let heights: [f64; WIDTH] = std::array::from_fn(|at| self.at(line, first + at as i64));
        let mut bends = [0.0; WIDTH];
        for (bend, of) in bends[1..].iter_mut().zip(heights.windows(3)) {
            *bend = 2.0 * of[1] - of[0] - of[2];
        }
        Row { first, heights, bends }
    }

    /// The squares between two lines, from the first sample of the second one on.
    fn squares(&self, [one, two]: [&Row; 2]) -> [Square; WIDTH] {
        let slant = self.sun.slant;
        let (is_main, limit) = (self.sun.flipped[0] == self.sun.flipped[1], self.sun.fall * LESS);
        let mut squares = [Square::default(); WIDTH];
        let beside = (two.first - one.first) as usize;
        let ([above, bends], [below, other_bends]) =
            ([&one.heights[beside..], &one.bends[beside..]], [&two.heights[..], &two.bends]);
        for at in 0..WIDTH - 1 - beside {
            let [a, b, c, d] = [above[at], above[at + 1], below[at], below[at + 1]];
            // The slopes away from the light of the triangle that rays leave last, and the other's.
            let [last, first] = if is_main {
                [c - a + slant * (d - c), d - b + slant * (b - a)]
            } else {
                [d - b + slant * (d - c), c - a + slant * (b - a)]
            };
            let falls = first.min(last) >= limit;
            let bend = bends[at].max(other_bends[at]).max(0.0);
            squares[at] = Square {
                falls,
                ends_falling: [last >= limit, if is_main { last >= limit } else { falls }],
                above: ((first - last).max(0.0) + slant * bend) / 4.0,
            };
        }
        squares
    }

    /// The ground at a line where a lane begins there.
    fn line(&self, start: f64, row: &Row) -> Line {
        let last = self.sun.size[1] as f64 - 1.0;
        let ends = [start - OVERLAP, start + 1.0 / LANES as f64 + OVERLAP];
        let within = ends.map(|end| end.clamp(0.0, last));
        let places = within.map(|end| end as i64);
        let side = |side: usize| {
            let [one, other] = [0, 1].map(|step| row.of(&row.heights, places[side] + step));
            one + (other - one) * (within[side] - places[side] as f64)
        };
        let [start, end] = ends;
        let sample = places[1] as f64;
        // A lane is narrower than a square.
        let bend = if start <= sample && sample <= end {
            row.of(&row.bends, places[1]) * (end - start) / 4.0
        } else {
            0.0
        };
        Line {
            places,
            sides: [0, 1].map(side),
            above: bend.max(0.0),
            below: (-bend).max(0.0),
            inside: start >= 0.0 && end <= last,
        }
    }
}

/// A lane as far as it has been swept.
#[derive(Clone, Copy)]
struct Lane {
    /// Where it starts at the first line.
    start: f64,
    /// The first line after which it is in the field, and the last.
    first: usize,
    end: usize,
    before: Line,
    highest: [f64; 2],
    surely: f64,
    is_lit: bool,
    /// The highest ground before each of the last lines, as far as none has risen.
    past: [[f64; 2]; LINES],
    even: usize,
}

impl Lane {
    fn new(ground: &Ground<'_>, lane: usize) -> Self {
        let [lines, places] = ground.sun.size;
        let start = ground.start(lane);
        let from = |place: f64| (place - start) / ground.sun.slant.max(1e-9);
        Self {
            start,
            first: (from(-1.0 - OVERLAP).floor() - 1.0).max(0.0) as usize,
            end: (from(places as f64 + OVERLAP).ceil().max(0.0) as usize + 1).min(lines - 1),
            before: Line::default(),
            highest: [0.0; 2],
            surely: 0.0,
            is_lit: true,
            past: [[0.0; 2]; LINES],
            even: 0,
        }
    }

    /// Goes on from a line to the next, whose samples are given.
    fn step(
        &mut self,
        ground: &Ground<'_>,
        margin: f64,
        line: usize,
        next: &Row,
        squares: &[Square; WIDTH],
    ) -> Cell {
        let slant = ground.sun.slant;
        let here = ground.line(self.start + slant * (line + 1) as f64, next);
        let before = std::mem::replace(&mut self.before, here);
        let last = ground.sun.size[1] as i64 - 2;
        let [start, end] = [before.places[0], here.places[1]].map(|place| place.min(last));
        let first = (start - next.first) as usize;
        let mut strip = squares[first];
        let mut ends_falling = strip.ends_falling[0];
        for square in &squares[first + 1..=(end - next.first) as usize] {
            strip.falls &= square.falls;
            ends_falling &= square.ends_falling[1];
            strip.above = strip.above.max(square.above);
        }
        let Square { falls, above, .. } = strip;
        let past = self.highest;
        self.past[line % LINES] = past;
        self.even = if falls { (self.even + 1).min(LINES) } else { usize::from(ends_falling) };
        if before.inside {
            self.surely = self.surely.max(before.sides[0].min(before.sides[1]) - before.below);
        }
        for side in 0..2 {
            let highest = &mut self.highest[side];
            *highest = highest.max(here.sides[side] + here.above);
            if !falls {
                let most = here.sides[side].max(before.sides[side]);
                *highest = highest.max(most + here.above.max(before.above) + above);
            }
        }
        let is_lit = self.is_lit && falls;
        // The highest ground only rises, so the earliest of the lines decides.
        self.is_lit = is_lit
            || self.even > 0 && {
                let past = self.past[(line + 1 - self.even) % LINES];
                (0..2).all(|side| past[side] + margin <= here.sides[side] - here.below)
            };
        let bound = |highest: [f64; 2]| (highest[0].max(highest[1]) + margin) as f32;
        let high = bound(self.highest);
        // If the ground has dipped at most, a point above all ground before it is above this, too.
        let before_it = if falls || ends_falling { bound(past) } else { high };
        let low = (self.surely - margin).max(0.0) as f32;
        Cell { is_lit, low, high: before_it, highest: high }
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

    /// Sweeps the lanes of a column of blocks, line by line.
    fn sweep(&mut self, ground: &Ground<'_>, column: usize) {
        let sun = self.sun;
        let margin = ground.field.unit() * f64::from(u16::MAX) + sun.fall * sun.size[0] as f64;
        let margin = MARGIN * margin;
        let mut lanes: [Lane; ACROSS] =
            std::array::from_fn(|lane| Lane::new(ground, column * ACROSS + lane));
        // Lanes begin the earlier and end the earlier, the farther aside they start.
        let [first, end] = [lanes[ACROSS - 1].first, lanes[0].end];
        let mut before = ground.row(column, first);
        // The highest ground up to the line after each.
        let mut highs = [0.0_f32; MAX_SAMPLES as usize];
        let mut highest = 0.0_f32;
        for row in 0..sun.rows(0) {
            let mut cells = Cells::NONE;
            let lines = row * SIDE..(row + 1) * SIDE;
            for (line, high) in lines.clone().zip(&mut highs[lines]) {
                if (first..end).contains(&line) {
                    let next = ground.row(column, line + 1);
                    let squares = ground.squares([&before, &next]);
                    for (number, lane) in lanes.iter_mut().enumerate() {
                        if !(lane.first..lane.end).contains(&line) {
                            continue;
                        }
                        if line == lane.first {
                            let start = lane.start + sun.slant * line as f64;
                            lane.before = ground.line(start, &before);
                            lane.highest = lane.before.sides.map(|side| side + lane.before.above);
                        }
                        let found = lane.step(ground, margin, line, &next, &squares);
                        highest = highest.max(found.highest);
                        cells.low = cells.low.min(found.low);
                        if !found.is_lit {
                            cells.lit &= !bit(line, number / LANES);
                            cells.high = cells.high.max(found.high);
                        }
                    }
                    before = next;
                }
                *high = highest;
            }
            if let Some(at) = sun.index(0, row, column) {
                let first = (row * SIDE).min(sun.size[0]);
                let lower = highs[..first].partition_point(|high| *high < cells.low);
                cells.reach = ((first - lower) as u32 + 2).min(ENDLESS);
                self.memory[at] = cells.packed();
            }
        }
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

#[cfg(test)]
mod tests;
