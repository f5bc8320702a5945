//! The kernels that pack spheres and cones into leaf blocks.

use twins::mesh_prepare::{CONE, CONES, HEADER, NODE, OBJECT, WORDS};
use twins::objects::{Packed, boxes, pack};
use twins::sort::Triangle;

use super::sort::{any_triangle, put_triangles};
use crate::prelude::*;
use protocol::layout::{BUILD_CONE, BUILD_MOST};

/// Elements after the last one that are looked at, and those of a list.
const MORE: usize = BUILD_MOST as usize;

/// Sorted objects that become a block.
#[derive(Clone, Debug)]
pub struct PackObjects {
    objects: Vec<Triangle>,
    low: u32,
    quads: u32,
    number: u32,
}

impl PackObjects {
    /// Spheres in their order.
    #[must_use]
    pub fn spheres(count: usize) -> Self {
        let objects = (0..count as u32).map(|at| [at, 3 * at, 3 * at, 3 * at]).collect();
        Self { objects, low: 0, quads: 1 << 24, number: 0 }
    }
}

impl Description for PackObjects {
    const KERNEL: &'static str = "objects_pack";
    const ROUNDS: [usize; 2] = [100, 1000];
    const LENGTHS: &'static [usize] = &[1, 2, 4, 5, 9, 10, 11, 15, 16, 17, 30];
    const SHARES: [Range<f64>; 2] = [1.0..f64::INFINITY, 0.2..0.95];
    type Placed = [Place; 2];
    /// What is packed, with the list; `None` if a record does not exist.
    type Found = Option<(Packed, Vec<[u32; 2]>)>;

    fn sensible(count: usize, random: &mut ChaCha8Rng) -> Self {
        let mut cone = if random.random() { BUILD_CONE } else { 0 };
        let objects = (0..count).map(|_| {
            if random.random_ratio(1, 50) {
                cone ^= BUILD_CONE;
            }
            let first = random.random_range(0..1 << 23);
            [random.random::<u32>() >> 2, first, cone | first, first]
        });
        let objects = objects.collect();
        let low = random.random::<u32>() & !127;
        Self { objects, low, quads: 1 << 24, number: random.random_range(0..1 << 24) }
    }

    /// Objects, and the number of quadwords, may be anything.
    fn any(count: usize, random: &mut ChaCha8Rng) -> Self {
        let mut inputs = Self::sensible(count, random);
        match random.random_range(0..3) {
            0 => inputs.quads = random.random_range(0..1 << 24),
            1 => inputs.objects.fill_with(|| any_triangle(random)),
            _ => {}
        }
        inputs
    }

    fn place(&self, bench: &mut Bench) -> ([Place; 2], Vec<u32>) {
        let with_more = [&self.objects[..], &[[0; 4]; MORE]].concat();
        let objects = put_triangles(bench, &with_more).address;
        let block = bench.junk::<[U32; WORDS]>();
        let list = put(bench, &[[U32::ZERO; 2]; MORE]);
        let Self { low, quads, number, .. } = *self;
        let count = self.objects.len() as u32;
        let arguments = vec![objects, count, block.address, list.address, low, quads, number];
        ([block, list], arguments)
    }

    fn found(&self, bench: &Bench, &[block, list]: &[Place; 2], objects: u32) -> Self::Found {
        let block = bench.read::<[U32; WORDS]>(block).map(U32::get);
        let list = bench.read::<[[U32; 2]; MORE]>(list).map(|it| it.map(U32::get));
        let list = list[..objects as usize].to_vec();
        let records = list.iter().map(|it| it[1].wrapping_sub(self.low) >> 4).collect();
        let bytes = list.first().map_or(0, |it| it[0]);
        (objects > 0).then_some((Packed { block, records, bytes }, list))
    }

    fn twin(&self, _: &[Place; 2]) -> Self::Found {
        let packed = pack(&self.objects, self.number, self.quads)?;
        let element = |first: &u32| [packed.bytes, (first << 4).wrapping_add(self.low)];
        let list = packed.records.iter().map(element).collect();
        Some((packed, list))
    }

    fn part(&self, found: &Self::Found) -> [usize; 2] {
        [usize::from(found.is_some()), 1]
    }
}

/// A block of spheres or cones that has its records.
#[derive(Clone, Debug)]
pub struct BoxObjects {
    block: [u32; WORDS],
}

impl BoxObjects {
    /// As many objects, all records of which are 0.
    #[must_use]
    pub fn of(count: usize, cone: u32) -> Self {
        let objects = vec![[0, 0, cone, 0]; count];
        let block = pack(&objects, 0, 1 << 24).map(|packed| packed.block);
        Self { block: block.unwrap_or([0; WORDS]) }
    }

    /// The words of the records.
    fn records(&mut self) -> std::slice::ChunksMut<'_, u32> {
        let size = if self.block[2] == CONES { CONE } else { OBJECT };
        let first = HEADER + NODE * self.block[4] as usize;
        let end = first + size * self.block[5] as usize;
        self.block[first..end].chunks_mut(size)
    }
}

impl Description for BoxObjects {
    const KERNEL: &'static str = "objects_boxes";
    const ROUNDS: [usize; 2] = [100, 1000];
    const LENGTHS: &'static [usize] = &[1, 2, 3, 4, 5, 8, 9, 12, 13, 16];
    type Placed = [Place; 2];
    /// The block, and its bounds.
    type Found = ([u32; WORDS], [u32; 8]);

    fn sensible(count: usize, random: &mut ChaCha8Rng) -> Self {
        let mut inputs = Self::of(count, if random.random() { BUILD_CONE } else { 0 });
        for record in inputs.records() {
            let mut number = |range: Range<f32>| random.random_range(range).to_bits();
            record.fill_with(|| number(-5.0..5.0));
            let axis = any_direction(random).map(|it| (it as f32).to_bits());
            record[4..7].copy_from_slice(&axis);
        }
        inputs
    }

    fn any(count: usize, random: &mut ChaCha8Rng) -> Self {
        let mut inputs = Self::sensible(count, random);
        inputs.records().for_each(|record| record.fill_with(|| any_bits(random)));
        inputs
    }

    fn place(&self, bench: &mut Bench) -> ([Place; 2], Vec<u32>) {
        let block = put(bench, &self.block.map(U32::new));
        let bounds = bench.junk::<[U32; 8]>();
        let memory = bench.junk::<[U32; 32]>();
        ([block, bounds], vec![block.address, bounds.address, memory.address])
    }

    fn found(&self, bench: &Bench, &[block, bounds]: &[Place; 2], _: u32) -> Self::Found {
        let (block, bounds): ([U32; WORDS], [U32; 8]) = (bench.read(block), bench.read(bounds));
        (block.map(U32::get), bounds.map(U32::get))
    }

    fn twin(&self, _: &[Place; 2]) -> Self::Found {
        let mut block = self.block;
        let bounds = boxes(&mut block);
        (block, bounds)
    }
}
