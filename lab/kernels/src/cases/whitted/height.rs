//! The kernel that makes triangles of a height field's samples.

use protocol::layout::{HeightLevel, Heights};
use rand::{Rng as _, SeedableRng as _};
use rand_chacha::ChaCha8Rng;
use spu_emulator::float::single::from_f64;
use twins::height::{Field, block};
use twins::mesh_prepare::WORDS;
use zerocopy::FromZeros as _;
use zerocopy::big_endian::{F32, U32};

use crate::bench::{Bench, Place};
use crate::cases::eye::call::put;
use crate::catalogue::{Case, Kernel, Objects};
use crate::description::Description;

/// Words of the kernel's scratch.
const SCRATCH: usize = 604;

/// The kernels in this file.
pub const KERNELS: &[Kernel] = &[Kernel {
    rays: 1,
    cases: &[Case {
        name: "block",
        objects: Objects::Fixed(1),
        place: |bench, _| {
            HeightBlock::sensible(1, &mut ChaCha8Rng::seed_from_u64(1)).place(bench).1
        },
    }],
    ..Kernel::of::<HeightBlock>()
}];

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
