//! The blocks of a height field for an eye, and the tree above them.

use std::ops::Range;
use std::sync::Arc;

use glam::{DVec2, DVec3, Vec3};
use protocol::layout::{
    Boxes, HEIGHT_BLOCK, HEIGHT_COLUMNS, HEIGHT_ROWS, HEIGHT_TREE, HeightLevel, Heights,
    MESH_BLOCK, MESH_INNER, MeshHeader, NO_BOX,
};
use scenes::HeightField;
use zerocopy::big_endian::F32;
use zerocopy::{FromBytes as _, FromZeros as _, IntoBytes as _};

use super::samples::{HeightSamples, Level};
use crate::scene::mesh::{Block, block_header};
use crate::scene::single::{single, singles};

/// How far from the eye a level is used, in squares of that level. More have smaller triangles.
pub(crate) const LEVEL_SQUARES: f64 = 160.0;
/// From this part of that distance on, it fades to the next.
const FADES_FROM: f64 = 0.75;
/// The children of a node.
const WIDTH: usize = 4;
/// The nodes at the lowest level of an inner block: as many as are below three others.
const LOWEST: usize = 12;
/// The children of an inner block.
const CHILDREN: usize = WIDTH * LOWEST;
/// Blocks for which there is space from the start, so that a frame of a game allocates none. Near
/// the middle of the largest field there are about as many.
const BLOCKS: usize = 8192;
/// The margin of boxes on each side, as a part of the largest coordinate: more than singles
/// lose when the SPUs compute a vertex in another way.
const MARGIN: f64 = 1.0 / (1 << 20) as f64;

/// A box and the number of its block.
#[derive(Clone, Copy, Debug)]
struct Child {
    low: Vec3,
    high: Vec3,
    number: u32,
}

impl Child {
    const NONE: Self = Self { low: Vec3::INFINITY, high: Vec3::NEG_INFINITY, number: 0 };

    fn with(self, other: &Self) -> Self {
        Self { low: self.low.min(other.low), high: self.high.max(other.high), ..self }
    }
}

/// The inner blocks above the chosen ones: the children of each, those of the lowest ones first. A
/// child that is such a block has its index as its number.
#[derive(Default)]
struct Wrapped {
    children: Vec<Child>,
    blocks: Vec<Range<usize>>,
}

impl Wrapped {
    /// Puts children from an index on under an inner block, if they are `many`.
    fn wrap(&mut self, found: &mut Vec<Child>, start: usize, many: usize) {
        if found.len() - start < many {
            return;
        }
        let around = found[start..].iter().fold(Child::NONE, |around, child| around.with(child));
        let first = self.children.len();
        self.children.extend(found.drain(start..));
        found.push(Child { number: self.blocks.len() as u32, ..around });
        self.blocks.push(first..self.children.len());
    }
}

/// A record, aligned as its DMA transfer needs it.
#[repr(C, align(128))]
struct AlignedRecord(Heights);

/// A height field as it is seen by an eye: what a frame has of it. The engine keeps it for as long
/// as SPUs may read it.
pub(crate) struct HeightView {
    /// The samples that its record names. A view that is not in use keeps none, so that they can be
    /// changed.
    samples: Option<Arc<HeightSamples>>,
    record: Box<AlignedRecord>,
    tree: Vec<Block>,
    /// Buffers.
    found: Vec<Child>,
    wrapped: Wrapped,
    /// The blocks of samples.
    blocks: usize,
    /// Whether the eye is above it.
    pub is_below: bool,
}

impl std::fmt::Debug for HeightView {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        formatter.debug_struct("HeightView").field("blocks", &self.blocks).finish()
    }
}

impl HeightView {
    pub(super) fn new() -> Self {
        Self {
            samples: None,
            record: Box::new(AlignedRecord(Heights::new_zeroed())),
            tree: Vec::with_capacity(BLOCKS / CHILDREN * 4),
            found: Vec::with_capacity(BLOCKS),
            wrapped: Wrapped {
                children: Vec::with_capacity(BLOCKS),
                blocks: Vec::with_capacity(BLOCKS / CHILDREN * 4),
            },
            blocks: 0,
            is_below: false,
        }
    }

    /// The address of the record.
    pub fn address(&self) -> u64 {
        (&raw const *self.record).expose_provenance() as u64
    }

    /// Lets go of the samples, since the view is not in use.
    pub(super) fn rest(&mut self) {
        self.samples = None;
    }

    /// The numbers of the blocks of samples.
    #[cfg(test)]
    pub fn numbers(&self) -> impl Iterator<Item = u32> {
        let all = self.wrapped.children.iter().map(|child| child.number);
        all.filter(|number| *number >= HEIGHT_TREE)
    }

    /// Chooses the blocks for an eye and builds the tree, in coordinates relative to `origin`. The
    /// samples have the shadows of a light, if one is named.
    pub(super) fn look(
        &mut self,
        field: &HeightField,
        samples: &Arc<HeightSamples>,
        eye: DVec3,
        origin: DVec3,
        light: Option<u32>,
    ) {
        let chooser = Chooser::new(field, samples, eye, origin);
        let mut wrapped = std::mem::take(&mut self.wrapped);
        wrapped.children.clear();
        wrapped.blocks.clear();
        self.found.clear();
        self.is_below = chooser.is_below(eye.y - field.ground(eye));
        chooser.choose(samples.count() - 1, [0, 0], &mut self.found, &mut wrapped);
        wrapped.wrap(&mut self.found, 0, 1);
        self.write_tree(&wrapped);
        let of_samples = wrapped.children.iter().filter(|child| child.number >= HEIGHT_TREE);
        self.blocks = of_samples.count();
        self.wrapped = wrapped;
        let mut record = Heights::new_zeroed();
        record.samples = samples.address().into();
        record.tree = (self.tree.as_ptr().expose_provenance() as u64).into();
        record.tree_blocks = (self.tree.len() as u32).into();
        record.levels = (samples.count() as u32).into();
        record.blocks = ((self.tree.len() + self.blocks) as u32).into();
        record.corner = singles(field.corner - eye);
        record.above = single(chooser.above);
        record.step = [field.step(), field.unit(), field.step()].map(single);
        let [columns, rows] = field.size();
        record.last = [f64::from(columns - 1), 0.0, f64::from(rows - 1)].map(single);
        let shades = samples.shades.as_ref().filter(|_| self.is_below);
        if let (Some(light), Some(shades)) = (light, shades) {
            let of_sun = shades.sun.record(field, eye);
            record.shades = shades.address().into();
            record.shades_light = light.into();
            record.shades_rows = of_sun.rows.into();
            record.shades_columns = of_sun.columns.into();
            record.shades_slant = of_sun.slant.into();
            record.shades_length = of_sun.length;
            record.shades_line = of_sun.line;
            record.shades_place = of_sun.place;
            record.shades_lane = of_sun.lane;
        }
        for (number, (to, level)) in record.levels_of.iter_mut().zip(&samples.levels).enumerate() {
            *to = chooser.record(number, level);
        }
        self.record.0 = record;
        self.samples = Some(samples.clone());
    }

    /// Writes the inner blocks. The last one that was wrapped is the root, which comes first: a
    /// child has a greater number than its parent.
    fn write_tree(&mut self, wrapped: &Wrapped) {
        let count = wrapped.blocks.len();
        let number = |index: usize| HEIGHT_TREE + (count - 1 - index) as u32;
        self.tree.resize(count, Block([0; MESH_BLOCK as usize]));
        for (index, (block, own)) in self.tree.iter_mut().rev().zip(&wrapped.blocks).enumerate() {
            let own = wrapped.children[own.clone()].iter();
            let mut children: [Child; CHILDREN] = [Child::NONE; CHILDREN];
            let mut length = 0;
            for (to, from) in children.iter_mut().zip(own) {
                let of_tree = from.number < HEIGHT_TREE;
                *to = Child {
                    number: if of_tree { number(from.number as usize) } else { from.number },
                    ..*from
                };
                length += 1;
            }
            write(block, number(index), &children[..length]);
        }
    }
}

/// Writes an inner block with up to three levels of nodes.
fn write(block: &mut Block, number: u32, children: &[Child]) {
    let lowest = children.len().div_ceil(WIDTH);
    let middle = if lowest > WIDTH { lowest.div_ceil(WIDTH) } else { 0 };
    let levels = 1 + u32::from(lowest > 1) + u32::from(middle > 0);
    let nodes = lowest + middle + usize::from(lowest > 1);
    let mut header = block_header(number, MESH_INNER, levels as usize, nodes);
    header.triangles = 0.into();
    let (to_header, rest) = block.0.split_at_mut(size_of::<MeshHeader>());
    to_header.copy_from_slice(header.as_bytes());
    let Ok((records, _)) = <[Boxes]>::mut_from_prefix_with_elems(rest, nodes) else {
        return;
    };
    let mut level: [Child; LOWEST] = [children[0]; LOWEST];
    let mut count = 0_usize;
    let offset = |node: usize| (size_of::<MeshHeader>() + node * size_of::<Boxes>()) as u32;
    for (index, children) in children.chunks(WIDTH).enumerate() {
        let node = nodes - lowest + index;
        level[index] = Child { number: offset(node), ..put(&mut records[node], children) };
        count += 1;
    }
    while count > 1 {
        let above = count.div_ceil(WIDTH);
        // The level above begins with the root, or after it.
        let first = if above == 1 { 0 } else { 1 };
        for index in 0..above {
            let own = index * WIDTH..count.min((index + 1) * WIDTH);
            let around = put(&mut records[first + index], &level[own]);
            level[index] = Child { number: offset(first + index), ..around };
        }
        count = above;
    }
}

/// Writes a node, and returns the box around it.
fn put(node: &mut Boxes, children: &[Child]) -> Child {
    let none = f32::from_bits(NO_BOX);
    for lane in 0..WIDTH {
        let child = children.get(lane);
        let low = child.map_or(Vec3::splat(none), |child| child.low);
        let high = child.map_or(Vec3::splat(-none), |child| child.high);
        node.lo_x[lane] = low.x.into();
        node.lo_y[lane] = low.y.into();
        node.lo_z[lane] = low.z.into();
        node.hi_x[lane] = high.x.into();
        node.hi_y[lane] = high.y.into();
        node.hi_z[lane] = high.z.into();
        node.child[lane] = child.map_or(0, |child| child.number).into();
    }
    children[1..].iter().fold(children[0], |around, child| around.with(child))
}

/// Chooses blocks for an eye.
struct Chooser<'a> {
    samples: &'a HeightSamples,
    eye: DVec2,
    /// The square of the eye's height above the ground.
    above: f64,
    corner: DVec3,
    /// The first sample's place across the ground, and that of the last.
    ends: [DVec2; 2],
    step: f64,
    unit: f64,
    margin: f64,
}

impl<'a> Chooser<'a> {
    fn new(field: &HeightField, samples: &'a HeightSamples, eye: DVec3, origin: DVec3) -> Self {
        let above = eye.y - field.ground(eye);
        let (low, high) = field.bounds();
        let largest = [low - origin, high - origin, eye - origin]
            .map(|corner| corner.abs().max_element())
            .into_iter()
            .fold(0.0, f64::max);
        let ends = [low, high].map(|corner| DVec2::new(corner.x, corner.z));
        Self {
            samples,
            eye: DVec2::new(eye.x, eye.z),
            above: above * above,
            corner: field.corner - origin,
            ends,
            step: field.step(),
            unit: field.unit(),
            margin: largest * MARGIN,
        }
    }

    /// Whether an eye at this height above the ground is above the field.
    fn is_below(&self, above: f64) -> bool {
        let [start, end] = self.ends;
        above > 0.0 && self.eye.clamp(start, end) == self.eye
    }

    /// The distance up to which a level is used.
    fn range(&self, level: usize) -> f64 {
        LEVEL_SQUARES * self.step * f64::from(1_u32 << level)
    }

    fn record(&self, number: usize, level: &Level) -> HeightLevel {
        let to = self.range(number).powi(2);
        let from = to * FADES_FROM.powi(2);
        // Singles are rounded, and what is that far away must have faded completely.
        let to = to * (1.0 - MARGIN);
        let is_last = number + 1 >= self.samples.count();
        let mut record = HeightLevel::new_zeroed();
        record.offset = level.offset.into();
        record.stride = level.stride.into();
        let [across, down] = level.blocks;
        record.across = across.into();
        record.down = down.into();
        record.fades_from = single(from);
        record.until = single(to);
        record.fade = if is_last { F32::ZERO } else { single((to - from).recip()) };
        let side = self.step * f64::from(1_u32 << number);
        record.up = single(4.0 * side / self.unit);
        record
    }

    /// Chooses the blocks of a square of eight by eight samples of a level, or of the ones in it.
    /// They are put under inner blocks as soon as there are such a number that four times it would
    /// be too many for one.
    fn choose(
        &self,
        level: usize,
        [column, row]: [u32; 2],
        found: &mut Vec<Child>,
        wrapped: &mut Wrapped,
    ) {
        let side = self.step * f64::from(HEIGHT_COLUMNS << level);
        let [start, end] = self.ends;
        let low = start + DVec2::new(f64::from(column), f64::from(row)) * side;
        let high = (low + side).min(end);
        let away = self.eye - self.eye.clamp(low, high);
        let distance = away.length_squared() + self.above;
        if level > 0 && distance < self.range(level - 1).powi(2) {
            let [across, down] = self.samples.levels[level - 1].blocks;
            let start = found.len();
            for below in 0..4 {
                let [column, row] = [2 * column + (below & 1), 2 * row + (below >> 1)];
                if column < across && row < down / 2 {
                    self.choose(level - 1, [column, row], found, wrapped);
                }
            }
            wrapped.wrap(found, start, CHILDREN / 4 + 1);
            return;
        }
        let of_level = &self.samples.levels[level];
        for half in 0..2 {
            let row = 2 * row + half;
            if row * HEIGHT_ROWS < of_level.squares[1] {
                found.push(self.block(level, of_level, [column, row]));
            }
        }
    }

    fn block(&self, level: usize, of_level: &Level, [column, row]: [u32; 2]) -> Child {
        let [low, high] = self.samples.range(of_level, column, row);
        let side = self.step * f64::from(1_u32 << level);
        let last = self.ends[1] - self.ends[0];
        let corner = |columns: u32, rows: u32, height: u16, way: f64| {
            let x = (f64::from(columns) * side).min(last.x);
            let z = (f64::from(rows) * side).min(last.y);
            let place = self.corner + DVec3::new(x, f64::from(height) * self.unit, z);
            (place + way * self.margin).as_vec3()
        };
        let [columns, rows] = [HEIGHT_COLUMNS, HEIGHT_ROWS];
        Child {
            low: corner(column * columns, row * rows, low, -1.0),
            high: corner((column + 1) * columns, (row + 1) * rows, high, 1.0),
            number: HEIGHT_BLOCK | (level as u32) << 19 | row << 9 | column,
        }
    }
}
