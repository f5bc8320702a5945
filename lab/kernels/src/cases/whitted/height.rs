//! The kernels that make triangles of a height field's samples, and find what is at the vertices
//! of those that were hit.

use crate::catalogue::sensible;
use crate::prelude::*;
use protocol::layout::{
    HEIGHT_BLOCK, HeightLevel, Heights, MESH_HIT, MESH_LEAF_PLACES, MeshLeaf, Patch,
};
use twins::height::{Field, block, corner_normal};
use twins::mesh_prepare::WORDS;

/// Words of the kernel's scratch.
const SCRATCH: usize = 604;

/// The kernels in this file.
pub fn kernels() -> Vec<Kernel> {
    vec![
        Kernel::of::<HeightBlock>([sensible("block", Objects::Fixed(1))]).rays(1),
        Kernel::of::<HeightCorners>([sensible("patches", Objects::List(24, 48))])
            .rays(1)
            .error(normal_error),
    ]
}

/// The largest error of a component of a normal, in ulps of 1.
fn normal_error(bench: &mut Bench, random: &mut ChaCha8Rng) -> f64 {
    let mut worst = 0.0_f64;
    for _ in 0..200 {
        let corners = HeightCorners::sensible(32, random);
        let hits = corners.objects.iter().filter_map(|object| corners.vertices(*object));
        let made = corners.call(bench);
        for (vertices, ([_, normals], _)) in hits.zip(made) {
            for ([.., halves], normal) in vertices.into_iter().zip(normals) {
                let exact = unit(unfolded([halves >> 16, halves]));
                let errors = normal.map(to_f64).into_iter().zip(exact).map(|(x, y)| (x - y).abs());
                worst = errors.fold(worst, f64::max);
            }
        }
    }
    worst * 2_f64.powi(23)
}

/// A direction from its two halves: the octahedron's lower half is folded over its upper one.
fn unfolded(halves: [u32; 2]) -> Vector {
    let [u, v] = halves.map(|half| f64::from(half as i16) / f64::from(i16::MAX));
    let z = 1.0 - u.abs() - v.abs();
    let fold = (-z).max(0.0);
    [u - fold.copysign(u), v - fold.copysign(v), z]
}

/// A block whose samples have arrived.
#[derive(Debug)]
pub struct HeightBlock {
    block: [u32; WORDS],
    field: Field,
    number: u32,
}

impl Description for HeightBlock {
    const KERNEL: &'static str = "height_block";
    const ROUNDS: [usize; 2] = [100, 300];
    const LENGTHS: &'static [usize] = &[1];
    type Placed = Place;
    type Found = [u32; WORDS];

    /// Half of the fields have a block that fades.
    fn sensible(_: usize, random: &mut ChaCha8Rng) -> Self {
        let level = random.random_range(0..10);
        let [row, column] = [random.random_range(0..1024_u32), random.random_range(0..512_u32)];
        let base = random.random_range(0..60000_u32);
        let block = std::array::from_fn(|_| {
            (base + random.random_range(0..3000)) << 16 | random.random_range(0..0x1_0000)
        });
        let step = random.random_range(0.1..30.0);
        let side = step * f64::from(1_u32 << level);
        let at = |index: u32, squares: f64| side * f64::from(index) * squares;
        let mut away = || random.random_range(-40.0..40.0) * side;
        let corner = [away() - at(column, 8.0), away(), away() - at(row, 4.0)];
        let from = (20.0 * side) * (20.0 * side);
        let field = Field {
            corner: corner.map(from_f64),
            above: from_f64(random.random_range(0.0..from)),
            step: [step, random.random_range(0.001..1.0) * step, step].map(from_f64),
            last: [(); 2].map(|()| from_f64(f64::from(random.random_range(8..=4096_u32)))),
            fading: [from, 1.0 / from, random.random_range(1.0..3000.0)].map(from_f64),
        };
        Self { block, field, number: 1 << 23 | level << 19 | row << 9 | column }
    }

    fn any(_: usize, random: &mut ChaCha8Rng) -> Self {
        let mut number = || random.random();
        let field = Field {
            corner: [(); 3].map(|()| number()),
            above: number(),
            step: [(); 3].map(|()| number()),
            last: [(); 2].map(|()| number()),
            fading: [(); 3].map(|()| number()),
        };
        let level = random.random_range(0..10) << 19;
        Self {
            block: std::array::from_fn(|_| random.random()),
            field,
            number: 1 << 23 | level | random.random_range(0..1 << 19),
        }
    }

    fn place(&self, bench: &mut Bench) -> (Place, Vec<u32>) {
        let single = |bits: u32| F32::from_bytes(bits.to_be_bytes());
        let mut record = Heights::new_zeroed();
        let Field { corner, above, step, last, fading } = self.field;
        record.corner = corner.map(single);
        record.above = single(above);
        record.step = step.map(single);
        record.last = [last[0], 0, last[1]].map(single);
        let [fades_from, fade, up] = fading.map(single);
        let level = (self.number >> 19 & 15) as usize;
        record.levels_of[level] = HeightLevel { fades_from, fade, up, ..HeightLevel::new_zeroed() };
        let place = put(bench, &self.block.map(U32::new));
        let field = put(bench, &[record]).address;
        let scratch = put(bench, &[U32::ZERO; SCRATCH]).address;
        (place, vec![place.address, field, self.number, scratch])
    }

    fn found(&self, bench: &Bench, placed: &Place, _: u32) -> Self::Found {
        let words: [U32; WORDS] = bench.read(*placed);
        words.map(U32::get)
    }

    fn twin(&self, _: &Place) -> Self::Found {
        let mut words = self.block;
        block(&mut words, &self.field, self.number);
        words
    }
}

/// The first vertex, face and colour of a block, in words.
const VERTICES: usize = 92;
const FACES: usize = VERTICES + 4 * 60;
const COLOURS: usize = FACES + 64;

/// Hit triangles, and the leaves that are there.
#[derive(Debug)]
pub struct HeightCorners {
    /// The patches' objects.
    objects: Vec<u32>,
    /// Numbers and blocks of the leaves.
    leaves: Vec<(u32, [u32; WORDS])>,
}

impl HeightCorners {
    /// Where a leaf is in the table.
    pub fn place_of(number: u32) -> usize {
        ((number + (number >> 7)) % MESH_LEAF_PLACES) as usize
    }

    /// The leaf of an object.
    fn leaf(&self, object: u32) -> Option<&[u32; WORDS]> {
        let number = (object & !MESH_HIT) >> 7;
        self.leaves.iter().find(|leaf| leaf.0 == number).map(|leaf| &leaf.1)
    }

    /// The vertices of a hit triangle, if its leaf is there: place, colour, the normal's halves.
    fn vertices(&self, object: u32) -> Option<[[u32; 5]; 3]> {
        let block = self.leaf(object)?;
        let [a, b, c, _] = block[FACES + (object & 127) as usize].to_be_bytes();
        Some([a, b, c].map(usize::from).map(|corner| {
            let [x, y, z, halves] = std::array::from_fn(|word| block[VERTICES + 4 * corner + word]);
            [x, y, z, block[COLOURS + corner], halves]
        }))
    }
}

impl Description for HeightCorners {
    const KERNEL: &'static str = "height_corners";
    const ROUNDS: [usize; 2] = [60, 100];
    const LENGTHS: &'static [usize] = LENGTHS_FROM_0;
    type Placed = [Place; 2];
    /// The vertices, their normals and their colours.
    type Found = Vec<([[[u32; 3]; 3]; 2], [u32; 3])>;

    /// Hits in three leaves beside each other, some in one that is not there.
    fn sensible(count: usize, random: &mut ChaCha8Rng) -> Self {
        let first = HEIGHT_BLOCK + random.random_range(0..1 << 22);
        let leaves = [0, 1, 1 << 9].map(|beside| {
            let mut block: [u32; WORDS] = std::array::from_fn(|_| random.random());
            for face in &mut block[FACES..COLOURS] {
                let vertices = [(); 3].map(|()| random.random_range(0..60_u8));
                *face = u32::from_be_bytes([vertices[0], vertices[1], vertices[2], 0]);
            }
            (first + beside, block)
        });
        let object = |_| {
            let number = match random.random_range(0..8) {
                0 => first + 2,
                _ => leaves[random.random_range(0..leaves.len())].0,
            };
            MESH_HIT + (number << 7) + random.random_range(0..64)
        };
        Self { objects: (0..count).map(object).collect(), leaves: leaves.to_vec() }
    }

    /// Any normals and colours are sensible.
    fn any(count: usize, random: &mut ChaCha8Rng) -> Self {
        Self::sensible(count, random)
    }

    fn place(&self, bench: &mut Bench) -> ([Place; 2], Vec<u32>) {
        let mut patches = vec![Patch::new_zeroed(); self.objects.len().next_multiple_of(4)];
        for (patch, object) in patches.iter_mut().zip(&self.objects) {
            patch.triangle[..4].fill((*object).into());
        }
        let patches = put(bench, &patches);
        let fours = self.objects.len().div_ceil(4);
        let colours = put(bench, &vec![[U32::ZERO; 4]; 4 * fours]);
        let mut table = [MeshLeaf::new_zeroed(); MESH_LEAF_PLACES as usize];
        for (number, block) in &self.leaves {
            let vertices = put(bench, &block.map(U32::new)).address + 4 * VERTICES as u32;
            table[Self::place_of(*number)] = MeshLeaf {
                number: (*number).into(),
                vertices: vertices.into(),
                ..MeshLeaf::new_zeroed()
            };
        }
        // Nothing that changes follows the table, which lanes without a leaf read beyond.
        let table = put(bench, &table).address;
        let arguments = vec![patches.address, fours as u32, table, colours.address];
        ([patches, colours], arguments)
    }

    fn found(&self, bench: &Bench, &[patches, colours]: &[Place; 2], _: u32) -> Self::Found {
        let three = |four: &[u32]| [four[0], four[1], four[2]];
        let patches: Vec<Patch> = bench.read_all(patches);
        let colours: Vec<[U32; 4]> = bench.read_all(colours);
        let each = self.objects.iter().zip(patches.into_iter().zip(colours));
        let known = each.filter(|(object, _)| self.leaf(**object).is_some());
        known
            .map(|(_, (patch, [a, b, c, _]))| {
                let words: [U32; size_of::<Patch>() / 4] = zerocopy::transmute!(patch);
                let words = words.map(U32::get);
                let at = |quad: usize| three(&words[4 * quad..]);
                ([[3, 4, 5], [6, 7, 8]].map(|quads| quads.map(at)), [a, b, c].map(U32::get))
            })
            .collect()
    }

    fn twin(&self, _: &[Place; 2]) -> Self::Found {
        let corners = |object: &u32| {
            let vertices = self.vertices(*object)?;
            let places = vertices.map(|[x, y, z, ..]| [x, y, z]);
            let normals = vertices.map(|[.., halves]| corner_normal(halves));
            Some(([places, normals], vertices.map(|[_, _, _, colour, _]| colour)))
        };
        self.objects.iter().filter_map(corners).collect()
    }

    fn part(&self, found: &Self::Found) -> [usize; 2] {
        [found.len(), self.objects.len()]
    }
}
