//! Blocks of meshes as `mesh_prepare` gets them.

use crate::prelude::*;
use twins::mesh_prepare::{
    CONES, HEADER, INNER, Known, LEAF, MAGIC, NO_BOX, NODE, SPHERES, WORDS, object, prepare,
};

/// The number of the blocks.
const NUMBER: u32 = 5;
/// How many blocks the mesh has.
const BLOCKS: u32 = 1000;
/// How many materials.
const MATERIALS: u32 = 9;

/// A block of this kind, with this number of lowest nodes, 1 to 11, of which each has one
/// child or more. All boxes are within a cube of half this size around a point, the root's.
#[must_use]
pub fn block(
    kind: u32,
    lowest: usize,
    point: [f64; 3],
    half: f64,
    random: &mut ChaCha8Rng,
) -> ([u32; WORDS], Known) {
    let middle = match lowest {
        0..=4 => 0,
        _ => lowest.div_ceil(4),
    };
    let levels = 1 + usize::from(lowest > 1) + usize::from(middle > 0);
    let upper = usize::from(lowest > 1) + middle;
    let nodes = upper + lowest;
    let first = HEADER + NODE * nodes;
    let space = WORDS - first;
    let lanes: Vec<usize> = (0..lowest).map(|_| random.random_range(1..=4)).collect();
    let children: usize = lanes.iter().sum();
    let [records, vertices] = match (kind, object(kind)) {
        (INNER, _) => [0, 0],
        (_, Some(size)) => [children.min(space / size), 0],
        _ => {
            let vertices = random.random_range(1..=space / 8);
            [(space - 4 * vertices).min(random.random_range(1..=100)), vertices]
        }
    };
    let mut words = [0; WORDS];
    let header =
        [MAGIC, NUMBER, kind, levels as u32, nodes as u32, records as u32, vertices as u32, 0];
    words[..HEADER].copy_from_slice(&header);
    let corner = |corner: [f64; 3], way: f64| corner.map(|c| from_f64(c + way));
    let mut below = 1;
    let mut number = 0;
    for node in 0..nodes {
        let at = HEADER + NODE * node;
        let lanes = match node.checked_sub(upper) {
            Some(low) => lanes[low],
            None if node == 0 && middle > 0 => middle,
            None => (nodes - below).min(4),
        };
        for lane in 0..4 {
            let [low, high] = if lane >= lanes {
                [[NO_BOX; 3], [NO_BOX | 1 << 31; 3]]
            } else if node == 0 {
                [corner(point, -half), corner(point, half)]
            } else {
                let size = random.random_range(0.0..0.2) * half;
                let away = in_cube(half - size, random);
                let middle: [f64; 3] = std::array::from_fn(|axis| point[axis] + away[axis]);
                [corner(middle, -size), corner(middle, size)]
            };
            for axis in 0..3 {
                words[at + 4 * axis + lane] = low[axis];
                words[at + 12 + 4 * axis + lane] = high[axis];
            }
            if lane < lanes {
                words[at + 24 + lane] = if node < upper {
                    below += 1;
                    4 * (HEADER + NODE * (below - 1)) as u32
                } else {
                    match (kind, object(kind)) {
                        (INNER, _) => random.random_range(NUMBER + 1..BLOCKS),
                        (_, Some(size)) => {
                            number = (number + 1) % records;
                            4 * (first + size * number) as u32
                        }
                        _ => {
                            let length = random.random_range(1..=8.min(records));
                            let start = random.random_range(0..=records - length);
                            4 * start as u32 + ((length as u32) << 16)
                        }
                    }
                };
            }
        }
    }
    match (kind, object(kind)) {
        (_, Some(size)) => {
            for record in words[first..first + size * records].chunks_mut(size) {
                record.fill_with(|| random.random::<u32>() & 0x3fff_ffff);
                record[10] = random.random_range(0..MATERIALS);
            }
        }
        (LEAF, _) => {
            for vertex in &mut words[first..first + 4 * vertices] {
                *vertex = random.random::<u32>() & 0xbfff_ffff;
            }
            let faces = first + 4 * vertices;
            for face in &mut words[faces..faces + records] {
                let [a, b, c] = [(); 3].map(|()| random.random_range(0..vertices) as u8);
                *face = u32::from_be_bytes([a, b, c, random.random_range(0..MATERIALS) as u8]);
            }
        }
        _ => {}
    }
    let known = Known {
        number: NUMBER,
        eye: in_cube(10.0, random).map(from_f64),
        blocks: BLOCKS,
        materials: MATERIALS,
        sides: 0x6000_0000,
    };
    (words, known)
}

/// A block that has arrived.
#[derive(Clone, Debug)]
pub struct Prepare {
    /// Its words.
    pub block: [u32; WORDS],
    /// Its expected properties.
    pub known: Known,
}

impl Description for Prepare {
    const KERNEL: &'static str = "mesh_prepare";
    const ROUNDS: [usize; 2] = [55, 3000];
    /// Lowest nodes, as many as leave space for something in a block.
    const LENGTHS: &'static [usize] = &[1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11];
    /// Sensible blocks are whole.
    const SHARES: [Range<f64>; 2] = [1.0..f64::INFINITY, 0.03..0.6];
    type Placed = Place;
    /// The block as it is afterwards, if it is not damaged.
    type Found = Option<[u32; WORDS]>;

    fn sensible(lowest: usize, random: &mut ChaCha8Rng) -> Self {
        let kind = [INNER, LEAF, SPHERES, CONES][random.random_range(0..4)];
        let half = magnitude(1e-3..1e3, random);
        let (block, known) = block(kind, lowest, in_cube(100.0, random), half, random);
        Self { block, known }
    }

    /// One word of the header or of the nodes is another one, often a bit, often a small number; or
    /// nothing but random bits follow the header.
    fn any(lowest: usize, random: &mut ChaCha8Rng) -> Self {
        let Self { block: mut words, known } = Self::sensible(lowest, random);
        if random.random_ratio(1, 3) {
            words[HEADER..].fill_with(|| random.random());
            return Self { block: words, known };
        }
        let nodes = words[4] as usize;
        let at = match random.random_range(0..4) {
            0 => random.random_range(0..HEADER),
            1 => random.random_range(0..WORDS),
            _ => HEADER + NODE * random.random_range(0..nodes) + 24 + random.random_range(0..4),
        };
        words[at] = match random.random_range(0..4) {
            0 => words[at] ^ 1 << random.random_range(0..32),
            1 => words[at].wrapping_add(random.random_range(0..20)).wrapping_sub(10),
            2 => random.random_range(0..20),
            _ => random.random(),
        };
        Self { block: words, known }
    }

    fn place(&self, bench: &mut Bench) -> (Place, Vec<u32>) {
        let Known { number, eye: [x, y, z], blocks, materials, sides } = self.known;
        let place = put(bench, &self.block.map(U32::new));
        let eye = put(bench, &[x, y, z, u32::MAX].map(U32::new)).address;
        (place, vec![place.address, number, eye, blocks, materials, sides])
    }

    fn found(&self, bench: &Bench, placed: &Place, damaged: u32) -> Self::Found {
        let words: [U32; WORDS] = bench.read(*placed);
        (damaged == 0).then(|| words.map(U32::get))
    }

    fn twin(&self, _: &Place) -> Self::Found {
        let mut block = self.block;
        prepare(&mut block, &self.known).then_some(block)
    }

    fn part(&self, found: &Self::Found) -> [usize; 2] {
        [usize::from(found.is_some()), 1]
    }
}
