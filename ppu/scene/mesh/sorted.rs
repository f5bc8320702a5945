//! A mesh whose leaf blocks are made of its triangles in the order of codes, by SPUs or in the same
//! way by this program ([`pack`](super::pack)): for meshes whose triangles are new in each frame.
//! Spheres and cones that move ([`moving`](super::moving)) are treated as triangles here.
//!
//! A code has the bits of a triangle's centroid in turn, so triangles with near codes are near
//! each other. Chunks of triangles are sorted first. Then the codes are divided into ranges, about
//! as large as chunks, and the triangles of a range are sorted again and packed into blocks. Blocks
//! above these are made by the surface area heuristic.
//!
//! Invariant: a range has at most [`BUILD_CHUNK`] triangles and [`MOST_IN_UNIT`] blocks, whatever
//! the codes are.

use protocol::layout::{
    BUILD_CHUNK, BUILD_FEWEST, BUILD_PACK, BUILD_PACK_OBJECTS, BuildBounds, BuildTriangle,
    BuildUnit, MESH_MATERIALS, SIDES_BOTH, SIDES_SMOOTH,
};
use scenes::{Material, Mesh};
use zerocopy::FromZeros as _;
use zerocopy::big_endian::U32;

use super::moved::{Line, MovedVertices, memory};
use super::tree::{Bounds, Kind, Piece, Tree};
use super::write::{above, coordinate, without_boxes};
use super::{MeshBlocks, NumberWidth, Numbers, has_area, in_range};

/// The most triangles: a range has a part of each chunk, and SPUs have space for 256 parts.
pub(super) const MOST_TRIANGLES: usize = 256 * BUILD_CHUNK as usize;
/// Chunks, unless they would be smaller or larger than they may be: enough for six SPUs to be done
/// at about the same time.
const CHUNKS: u32 = 96;
const SMALLEST_CHUNK: u32 = 256;
/// About the most triangles of a range.
const LARGEST_RANGE: u32 = 2048;
/// The largest distance of the sorted triangles of a chunk whose codes are looked at for ranges.
const LARGEST_STEP: u32 = 32;
/// The fewest triangles of a block, unless those after it have other sides.
const FEWEST: u32 = 17;
/// How many blocks of a range may have fewer: one of each kind of sides.
const SMALLER: u32 = 4;
/// The most blocks of a unit.
const MOST_IN_UNIT: u32 = 255;

/// How codes are made: see [`protocol::layout::Build`].
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Grid {
    pub low: [u32; 3],
    pub scale: f32,
    pub shift: u32,
}

impl Grid {
    /// The grid of corners within these bounds.
    pub(super) fn new(Bounds { low, high }: Bounds) -> Self {
        let largest = low.abs().max(high.abs()).max_element();
        // Three whole numbers below 2^27 can be added.
        let exponent = 26 - libm::ilogbf(largest.max(f32::MIN_POSITIVE));
        let scale = libm::ldexpf(1.0, exponent.min(127));
        let sums = [low, high].map(|corner| corner.to_array().map(|it| 3 * whole(it, scale)));
        let extent = (0..3).map(|axis| sums[1][axis] - sums[0][axis]).max().unwrap_or_default();
        let bits = u32::BITS - extent.leading_zeros();
        Self { low: sums[0].map(|it| it as u32), scale, shift: bits.saturating_sub(10) }
    }

    /// The code of a triangle with these corners, without its sides.
    pub fn code(&self, corners: [[f32; 3]; 3]) -> u32 {
        let mut code = 0;
        for axis in 0..3 {
            let sum: i32 = corners.iter().map(|corner| whole(corner[axis], self.scale)).sum();
            let cell = (sum as u32).wrapping_sub(self.low[axis]) >> self.shift;
            for bit in 0..10 {
                code |= (cell >> bit & 1) << (3 * bit + 2 - axis);
            }
        }
        // Its place among the Gray codes.
        for bits in [1, 2, 4, 8, 16] {
            code ^= code >> bits;
        }
        code
    }
}

fn whole(number: f32, scale: f32) -> i32 {
    (coordinate(number).get() * scale) as i32
}

/// The kind of shapes that are sorted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Sorted {
    Triangles,
    /// Spheres and cones. Their records are in place of the vertices.
    Objects,
}

/// The triangles and vertices of such a mesh.
#[derive(Debug)]
pub struct SortedMesh {
    pub(super) what: Sorted,
    pub(super) vertices: MovedVertices,
    pub(super) triangles: Vec<Line<BuildTriangle>>,
    pub(super) count: u32,
    pub(super) grid: Grid,
}

impl SortedMesh {
    /// A number that no other vertices of this process have.
    pub(crate) fn version(&self) -> u64 {
        self.vertices.version()
    }

    pub(crate) fn vertices(&self) -> &MovedVertices {
        &self.vertices
    }

    /// The address of the first triangle.
    pub(crate) fn address(&self) -> u64 {
        self.triangles.as_ptr().expose_provenance() as u64
    }

    pub(crate) fn count(&self) -> u32 {
        self.count
    }

    pub(crate) fn grid(&self) -> Grid {
        self.grid
    }

    /// The most blocks, with those above the leaves.
    pub(crate) fn most_blocks(&self) -> u32 {
        2 * self.what.most_leaves(self.count)
    }

    /// The task by which SPUs pack them.
    pub(crate) fn pack_task(&self) -> u32 {
        match self.what {
            Sorted::Triangles => BUILD_PACK,
            Sorted::Objects => BUILD_PACK_OBJECTS,
        }
    }

    pub(super) fn triangles(&self) -> impl Iterator<Item = BuildTriangle> {
        self.triangles.iter().flat_map(|line| line.0).take(self.count as usize)
    }

    /// Moves the vertices; `false` if one has a normal that it had not or no longer has.
    pub(crate) fn move_to(&mut self, mesh: &Mesh, blocks: &MeshBlocks) -> bool {
        if mesh.positions.len() != blocks.vertices {
            return false;
        }
        let Some(bounds) = self.vertices.write(mesh, &blocks.flat) else { return false };
        self.grid = Grid::new(bounds);
        true
    }
}

impl MeshBlocks {
    /// The blocks of a mesh before they are made in the order of codes, and the triangles that they
    /// are made of; `None` if they can't be: there are too many triangles or materials, or
    /// there are textures or colours of vertices, or something is wrong with the mesh.
    pub(in crate::scene) fn to_sort(
        mesh: &Mesh,
        materials: &[Material],
        Numbers { firsts, minimum }: Numbers<'_>,
    ) -> Option<(Self, SortedMesh)> {
        let count = mesh.triangles.len();
        let is_textured = !mesh.texture_coordinates.is_empty()
            && mesh.materials.iter().any(|&it| materials[it as usize].texture.is_some());
        if is_textured
            || !mesh.colours.is_empty()
            || minimum != NumberWidth::Byte
            || count > MOST_TRIANGLES
            || mesh.positions.len() > MovedVertices::MOST
            || !mesh.positions.iter().all(in_range)
            || !(0..count).any(|triangle| has_area(mesh, triangle))
        {
            return None;
        }
        let mut numbers = vec![None; materials.len()];
        let mut used = Vec::new();
        let mut triangles = memory(count.div_ceil(8));
        for start in (0..count).step_by(8) {
            let mut records = [BuildTriangle::new_zeroed(); 8];
            for (record, triangle) in records.iter_mut().zip(start..count) {
                let ([a, b, c], material) = (mesh.triangles[triangle], mesh.materials[triangle]);
                let first = firsts[material as usize];
                let number = *numbers[first as usize].get_or_insert_with(|| {
                    used.push(first);
                    used.len() as u32 - 1
                });
                let is_smooth = mesh.corner_normals(triangle).is_some();
                let is_both = mesh.two_sided || materials[material as usize].transmittance > 0.0;
                let sides =
                    if is_both { SIDES_BOTH } else { 0 } | if is_smooth { SIDES_SMOOTH } else { 0 };
                *record = BuildTriangle {
                    code: U32::ZERO,
                    first: (number << 24 | a).into(),
                    second: (sides | b).into(),
                    third: c.into(),
                };
            }
            triangles.push(Line(records));
        }
        if used.len() > MESH_MATERIALS as usize {
            return None;
        }
        let count = count as u32;
        let mut sorted = SortedMesh {
            what: Sorted::Triangles,
            vertices: MovedVertices::default(),
            triangles,
            count,
            grid: Grid::default(),
        };
        let blocks = Self::unmade(mesh, used, sorted.most_blocks());
        sorted.move_to(mesh, &blocks).then_some((blocks, sorted))
    }
}

impl Sorted {
    /// The maximum number of leaf blocks of `count` shapes. Their numbers begin with this one:
    /// smaller ones are left for the blocks above.
    pub(super) fn most_leaves(self, count: u32) -> u32 {
        let Division { chunk, step, in_range } = self.division(count);
        let chunks = count.div_ceil(chunk);
        let last = count - (chunks - 1) * chunk;
        let samples = (chunks - 1) * chunk.div_ceil(step) + last.div_ceil(step);
        count / self.fewest() + SMALLER * samples.div_ceil(in_range)
    }

    fn division(self, count: u32) -> Division {
        let chunk = count.div_ceil(CHUNKS).clamp(SMALLEST_CHUNK, BUILD_CHUNK);
        let range = chunk.min(LARGEST_RANGE);
        let most = BUILD_CHUNK.min((MOST_IN_UNIT - SMALLER) * self.fewest());
        // A range has as many as its samples stand for, and up to `step` more of each chunk.
        let step = (most - range) / count.div_ceil(chunk);
        let step = step.clamp(1, LARGEST_STEP);
        Division { chunk, step, in_range: range / step }
    }

    /// How many a block has at least, unless those after it are of another kind.
    fn fewest(self) -> u32 {
        match self {
            Self::Triangles => FEWEST,
            Self::Objects => BUILD_FEWEST,
        }
    }
}

/// How triangles are divided.
struct Division {
    /// Triangles of a chunk.
    chunk: u32,
    /// The distance of the triangles of a chunk that are samples.
    step: u32,
    /// Samples of a range.
    in_range: u32,
}

impl SortedMesh {
    /// The units that sort the chunks of triangles.
    pub(crate) fn chunks(&self) -> Vec<BuildUnit> {
        let triangles = self.count;
        let size = self.what.division(triangles).chunk;
        let unit = |first| BuildUnit {
            first: U32::new(first),
            triangles: size.min(triangles - first).into(),
            ..BuildUnit::new_zeroed()
        };
        (0..triangles).step_by(size as usize).map(unit).collect()
    }

    /// The units that pack ranges of triangles, and the words that list the parts of sorted chunks
    /// that are in each. `code` is that of a triangle in the sorted chunks.
    pub(crate) fn ranges(&self, code: impl Fn(u32) -> u32) -> (Vec<BuildUnit>, Vec<U32>) {
        let triangles = self.count;
        let Division { chunk, step, in_range } = self.what.division(triangles);
        // Triangles with equal codes stay in their order, so no two are equal.
        let key = |at: u32| u64::from(code(at)) << 32 | u64::from(at);
        let starts = (0..triangles).step_by(chunk as usize);
        let chunk_end = |start: u32| triangles.min(start + chunk);
        let in_chunk = |start| (start..chunk_end(start)).step_by(step as usize).map(key);
        let mut samples: Vec<u64> = starts.clone().flat_map(in_chunk).collect();
        samples.sort_unstable();
        // Of each chunk, where the range begins, and the last sample before its end.
        let mut from: Vec<u32> = starts.clone().collect();
        let mut last: Vec<Option<u32>> = vec![None; from.len()];
        let (mut units, mut words): (Vec<BuildUnit>, Vec<U32>) = Default::default();
        let mut block = self.what.most_leaves(triangles);
        for (number, range) in samples.chunks(in_range as usize).enumerate() {
            let end = samples.get((number + 1) * in_range as usize);
            for &sample in range {
                let at = sample as u32;
                last[(at / chunk) as usize] = Some(at);
            }
            let first_word = words.len();
            let mut count = 0;
            for ((start, from), last) in starts.clone().zip(&mut from).zip(&last) {
                let to = match (end, *last) {
                    (None, _) => chunk_end(start),
                    (Some(_), None) => start,
                    (Some(&end), Some(last)) => {
                        // The next sample is in the next range or later.
                        let (mut low, mut high) = (last + 1, chunk_end(start).min(last + step));
                        while low < high {
                            let middle = low.midpoint(high);
                            if key(middle) < end { low = middle + 1 } else { high = middle }
                        }
                        low
                    }
                };
                while *from < to {
                    let length = (to - *from).min(255);
                    words.push((length << 24 | *from).into());
                    *from += length;
                    count += length;
                }
            }
            words.resize(words.len().next_multiple_of(4), U32::ZERO);
            let most = count / self.what.fewest() + SMALLER;
            units.push(BuildUnit {
                first: block.into(),
                count: most.into(),
                source: (first_word as u32).into(),
                source_count: ((words.len() - first_word) as u32).into(),
                triangles: count.into(),
                ..BuildUnit::new_zeroed()
            });
            block += most;
        }
        (units, words)
    }
}

impl Sorted {
    /// Makes the blocks above leaf blocks, which are in the order of codes and whose numbers are
    /// the pieces' indices, and calls `store` with the number and the bytes of each. A program that
    /// makes no leaf blocks gets one block that has no boxes.
    pub(super) fn join(self, leaves: Vec<Piece>, mut store: impl FnMut(usize, &[u8])) {
        if leaves.is_empty() {
            return store(0, &without_boxes().0);
        }
        let nothing = Mesh::default();
        let count = leaves.len();
        let mut tree = Tree::new(&nothing, leaves, NumberWidth::Byte);
        let root = match self {
            Self::Triangles => tree.grow(Kind::Blocks, 0..count),
            // They need blocks for so few that the PPU's time counts more than the rays' tests.
            Self::Objects => tree.grow_in_order(0..count),
        };
        above(&tree, root, store);
    }
}

impl SortedMesh {
    /// [`Sorted::join`] for leaf blocks that SPUs have made.
    pub(crate) fn join_made(&self, bounds: &[BuildBounds], store: impl FnMut(usize, &[u8])) {
        let made = bounds.iter().zip(0..).filter(|(bounds, _)| bounds.unused.get() == 0);
        let pieces = made.map(|(bounds, index)| Piece { bounds: bounds.into(), index });
        self.what.join(pieces.collect(), store);
    }
}
