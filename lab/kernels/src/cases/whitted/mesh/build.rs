//! The kernels that refit a leaf block.

use twins::build::{leaf, list};
use twins::mesh_prepare::{HEADER, LEAF, NODE, WORDS};

use super::block::block;
use crate::prelude::*;
use protocol::layout::SIDES_SMOOTH;

/// Words for the intermediate results of `build_leaf`.
const MEMORY: usize = 4704 / 4;

/// A leaf block whose vertices are new.
#[derive(Clone, Debug)]
pub struct Leaf {
    /// Its words.
    pub block: [u32; WORDS],
}

impl Leaf {
    /// The most usual block: sixteen runs of five triangles, nearly.
    #[must_use]
    pub fn full() -> Self {
        let mut block = [0; WORDS];
        let [nodes, triangles, vertices] = [5, 78, 60];
        block[..HEADER].copy_from_slice(&[0, 0, LEAF, 2, nodes, triangles, vertices, SIDES_SMOOTH]);
        for node in 0..4 {
            let child = |node: usize, lane: usize| HEADER + NODE * node + 24 + lane;
            block[child(0, node)] = 4 * (HEADER + NODE * (1 + node)) as u32;
            for lane in 0..4 {
                let first = 5 * (4 * node + lane) as u32;
                block[child(1 + node, lane)] = 4 * first + ((triangles - first).min(5) << 16);
            }
        }
        Self { block }
    }

    /// Gives the vertices other bits. The fourth word of each is its normal.
    fn with_vertices(mut self, mut bits: impl FnMut() -> u32) -> Self {
        let [nodes, vertices] = [4, 6].map(|word| self.block[word] as usize);
        self.block[HEADER + NODE * nodes..][..4 * vertices].fill_with(&mut bits);
        self
    }
}

impl Description for Leaf {
    const KERNEL: &'static str = "build_leaf";
    const ROUNDS: [usize; 2] = [200, 2000];
    /// Lowest nodes.
    const LENGTHS: &'static [usize] = &[1, 2, 3, 4];
    type Placed = [Place; 2];
    /// The block, and its bounds.
    type Found = ([u32; WORDS], [u32; 8]);

    fn sensible(lowest: usize, random: &mut ChaCha8Rng) -> Self {
        let half = magnitude(1e-3..1e3, random);
        let (mut words, _) = block(LEAF, lowest, in_cube(100.0, random), half, random);
        words[7] = if random.random() { SIDES_SMOOTH } else { 0 };
        let leaf = Self { block: words };
        leaf.with_vertices(|| (random.random_range(-half..half) as f32).to_bits())
    }

    /// Vertices may have any bits, also those of numbers beyond the boxes that are not there.
    fn any(lowest: usize, random: &mut ChaCha8Rng) -> Self {
        Self::sensible(lowest, random).with_vertices(|| any_bits(random))
    }

    fn place(&self, bench: &mut Bench) -> ([Place; 2], Vec<u32>) {
        let block = put(bench, &self.block.map(U32::new));
        let bounds = bench.junk::<[U32; 8]>();
        let memory = bench.junk::<[U32; MEMORY]>();
        ([block, bounds], vec![block.address, bounds.address, memory.address])
    }

    fn found(&self, bench: &Bench, &[block, bounds]: &[Place; 2], _: u32) -> Self::Found {
        let (block, bounds): ([U32; WORDS], [U32; 8]) = (bench.read(block), bench.read(bounds));
        (block.map(U32::get), bounds.map(U32::get))
    }

    fn twin(&self, _: &[Place; 2]) -> Self::Found {
        let mut block = self.block;
        let bounds = leaf(&mut block);
        (block, bounds)
    }
}

/// Runs of vertices for a list.
#[derive(Clone, Debug)]
pub struct Sources {
    /// The runs, in fours.
    pub sources: Vec<[u32; 4]>,
    /// Low word of the address of the vertices.
    pub low: u32,
    /// How many these are.
    pub vertices: u32,
    /// How many of them the runs have.
    pub count: u32,
}

impl Description for Sources {
    const KERNEL: &'static str = "build_list";
    const ROUNDS: [usize; 2] = [20, 1000];
    const SHARES: [std::ops::Range<f64>; 2] = [1.0..f64::INFINITY, 0.1..0.9];
    type Placed = Place;
    /// The list, if all vertices exist.
    type Found = Option<Vec<[u32; 2]>>;

    fn sensible(quads: usize, random: &mut ChaCha8Rng) -> Self {
        let vertices = random.random_range(300..1 << 24);
        let mut count = 0;
        let mut run = || {
            let length = random.random_range(0..256);
            count += length;
            length << 24 | random.random_range(0..=vertices - length)
        };
        let sources = (0..quads).map(|_| [(); 4].map(|()| run())).collect();
        Self { sources, low: random.random::<u32>() & !127, vertices, count }
    }

    /// One run, or a number of vertices, may be anything.
    fn any(quads: usize, random: &mut ChaCha8Rng) -> Self {
        let mut inputs = Self::sensible(quads, random);
        match random.random_range(0..4) {
            0 => inputs.vertices = random.random(),
            1 => inputs.count ^= 1 << random.random_range(0..32),
            2 => {
                let run = &mut inputs.sources[random.random_range(0..quads)];
                run[random.random_range(0..4)] = random.random();
            }
            _ => {}
        }
        inputs
    }

    fn place(&self, bench: &mut Bench) -> (Place, Vec<u32>) {
        let Self { low, vertices, count, .. } = *self;
        let sources: Vec<_> = self.sources.iter().map(|four| four.map(U32::new)).collect();
        let sources = put(bench, &sources).address;
        let list = put(bench, &vec![[U32::ZERO; 2]; 4 * self.sources.len()]);
        let quads = self.sources.len() as u32;
        (list, vec![sources, quads, list.address, low, vertices, count])
    }

    fn found(&self, bench: &Bench, list: &Place, damaged: u32) -> Self::Found {
        let elements: Vec<[U32; 2]> = bench.read_all(*list);
        (damaged == 0).then(|| elements.into_iter().map(|it| it.map(U32::get)).collect())
    }

    fn twin(&self, _: &Place) -> Self::Found {
        list(&self.sources, self.low, self.vertices, self.count)
    }

    fn part(&self, found: &Self::Found) -> [usize; 2] {
        [usize::from(found.is_some()), 1]
    }
}
