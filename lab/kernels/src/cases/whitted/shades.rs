//! The kernels that take out the shadow rays of which it is known whether the ground blocks them.

use std::array;

use crate::catalogue::sensible;
use crate::prelude::*;
use rand::RngCore as _;
use twins::shades::{BLOCKS, Ray, Shades};

/// The kernels in this file.
pub fn kernels() -> Vec<Kernel> {
    vec![
        Kernel::of::<Extent>([sensible("all there", Objects::List(4, 8))]),
        Kernel::of::<Known>([sensible("all there", Objects::List(4, 8))]),
    ]
}

/// The address of the ground's object, and that of the background.
const GROUND: u32 = 0x1230;
const BACKGROUND: u32 = 0x4560;

/// Shadow rays above a field.
#[derive(Debug)]
struct Rays {
    rays: Vec<Ray>,
    shades: Shades,
}

impl Rays {
    /// Some rays are absent, and some start beside the field.
    fn sensible(count: usize, random: &mut ChaCha8Rng) -> Self {
        let step = random.random_range(0.1..30.0);
        let lines = f64::from(random.random_range(20..200_u32));
        let slant = random.random_range(0.0..1.0);
        let start = random.random_range(0.0..1.0) * lines;
        let fall = random.random_range(0.01..2.0) * step;
        let shades = Shades {
            line: [1.0 / step, start, 0.0, lines].map(from_f64),
            place: [0.0, start, -1.0 / step, lines].map(from_f64),
            lane: [slant, lines * slant, fall, random.random_range(0.0..100.0)].map(from_f64),
        };
        let middle: [f64; 2] =
            [(); 2].map(|()| (random.random_range(0.1..0.9) * lines - start) * step);
        let mut ray = || {
            let mut away = || random.random_range(-12.0..12.0) * step;
            let [x, z] = [middle[0] + away(), -middle[1] + away()];
            let origin = [x, random.random_range(-90.0..90.0) * step, z].map(from_f64);
            let t = if random.random_range(0..8) == 0 { -1.0 } else { 1e18 };
            (origin, from_f64(t), BACKGROUND)
        };
        Self { rays: (0..16 * count).map(|_| ray()).collect(), shades }
    }

    fn any(count: usize, random: &mut ChaCha8Rng) -> Self {
        let mut found = Self::sensible(count, random);
        let mut number = || random.next_u32();
        let Shades { line, place, lane } = &mut found.shades;
        for numbers in [line, place, lane] {
            *numbers = [(); 4].map(|()| number());
        }
        for (origin, ..) in &mut found.rays {
            *origin = [(); 3].map(|()| number());
        }
        found
    }

    /// The packets, and the numbers with each of them in all lanes.
    fn put(&self, bench: &mut Bench) -> [Place; 2] {
        let single = |bits: u32| F32::from_bytes(bits.to_be_bytes());
        let packets = self.rays.chunks(16).map(|rays| {
            let mut packet = RayPacket::new_zeroed();
            let origin = |axis: usize| array::from_fn(|lane| single(rays[lane].0[axis]));
            packet.origin_x = origin(0);
            packet.origin_y = origin(1);
            packet.origin_z = origin(2);
            packet.t = array::from_fn(|lane| single(rays[lane].1));
            packet.object = array::from_fn(|lane| rays[lane].2.into());
            packet
        });
        let packets: Vec<RayPacket> = packets.collect();
        let Shades { line, place, lane } = self.shades;
        let numbers = [line, place, lane].concat();
        let numbers: Vec<[U32; 4]> = numbers.into_iter().map(|it| [it.into(); 4]).collect();
        [put(bench, &packets), put(bench, &numbers)]
    }
}

/// Rays of which it is asked where they start.
#[derive(Debug)]
pub struct Extent(Rays);

impl Description for Extent {
    const KERNEL: &'static str = "cuts_extent_r16";
    const ROUNDS: [usize; 2] = [40, 40];
    const LENGTHS: &'static [usize] = &[1, 2, 3, 8];
    type Placed = Place;
    type Found = [u32; 4];

    fn sensible(count: usize, random: &mut ChaCha8Rng) -> Self {
        Self(Rays::sensible(count, random))
    }

    fn any(count: usize, random: &mut ChaCha8Rng) -> Self {
        Self(Rays::any(count, random))
    }

    fn place(&self, bench: &mut Bench) -> (Place, Vec<u32>) {
        let [rays, shades] = self.0.put(bench);
        let out = bench.junk::<[U32; 4]>();
        let packets = self.0.rays.len() as u32 / 16;
        (out, vec![rays.address, packets, shades.address, out.address])
    }

    fn found(&self, bench: &Bench, out: &Place, _: u32) -> Self::Found {
        bench.read::<[U32; 4]>(*out).map(U32::get)
    }

    fn twin(&self, _: &Place) -> Self::Found {
        self.0.shades.extent(&self.0.rays)
    }
}

/// Rays and the blocks of cells where they start.
#[derive(Debug)]
pub struct Known {
    rays: Rays,
    blocks: Vec<[u32; 4]>,
    /// The level, the first line, the first lane, and the length from line to line.
    first: [u32; 4],
}

impl Known {
    fn blocks(random: &mut ChaCha8Rng, spread: f64) -> Vec<[u32; 4]> {
        let block = |_| {
            let low = random.random_range(-spread..spread);
            let high = low + random.random_range(0.0..spread);
            // Some are without an end.
            let reach = random.random_range(0..=300_u32).min(255);
            [random.next_u32(), random.next_u32(), from_f64(low), from_f64(high) & !255 | reach]
        };
        (0..BLOCKS * BLOCKS).map(block).collect()
    }
}

impl Description for Known {
    const KERNEL: &'static str = "cuts_shades_r16";
    const ROUNDS: [usize; 2] = [40, 40];
    const LENGTHS: &'static [usize] = &[1, 2, 3, 8];
    type Placed = Place;
    /// The t and the object of each ray, and whether any is left.
    type Found = (Vec<(u32, u32)>, bool);

    fn sensible(count: usize, random: &mut ChaCha8Rng) -> Self {
        let rays = Rays::sensible(count, random);
        let blocks = Self::blocks(random, 2000.0);
        let length = from_f64(random.random_range(1.0..1000.0));
        let first = [random.random_range(0..6), 8 * random.random_range(0..4), 0, length];
        Self { rays, blocks, first }
    }

    fn any(count: usize, random: &mut ChaCha8Rng) -> Self {
        let rays = Rays::any(count, random);
        let blocks = (0..BLOCKS * BLOCKS).map(|_| [(); 4].map(|()| random.next_u32())).collect();
        Self {
            rays,
            blocks,
            first: [random.random_range(0..6), random.next_u32(), 8, random.next_u32()],
        }
    }

    fn place(&self, bench: &mut Bench) -> (Place, Vec<u32>) {
        let [rays, shades] = self.rays.put(bench);
        let quads = |all: &[[u32; 4]]| -> Vec<[U32; 4]> {
            all.iter().map(|words| words.map(U32::new)).collect()
        };
        let blocks = put(bench, &quads(&self.blocks)).address;
        let first = put(bench, &quads(&[self.first])).address;
        let packets = self.rays.rays.len() as u32 / 16;
        (rays, vec![rays.address, packets, shades.address, blocks, first, GROUND])
    }

    fn found(&self, bench: &Bench, rays: &Place, returned: u32) -> Self::Found {
        let packets: Vec<RayPacket> = bench.read_all(*rays);
        let rays = packets.iter().flat_map(|packet| {
            let ts = packet.t.map(|t| u32::from_be_bytes(t.to_bytes()));
            ts.into_iter().zip(packet.object.map(U32::get))
        });
        (rays.collect(), returned != 0)
    }

    fn twin(&self, _: &Place) -> Self::Found {
        let Rays { rays, shades } = &self.rays;
        let rays = rays.iter().map(|ray| shades.shaded(*ray, &self.blocks, self.first, GROUND));
        let rays: Vec<(u32, u32)> = rays.collect();
        let is_left = rays.iter().any(|(t, _)| t >> 31 == 0);
        (rays, is_left)
    }

    fn part(&self, (rays, _): &Self::Found) -> [usize; 2] {
        let known = rays.iter().filter(|(t, object)| t >> 31 == 1 && *object == GROUND);
        [known.count(), rays.len()]
    }

    const SHARES: [std::ops::Range<f64>; 2] = [0.02..0.9, 0.0..1.0];
}
