//! The kernels for the sums of pixels.

use rand::seq::SliceRandom as _;
use twins::accumulate::{Share, accumulate};
use twins::bounce::CHAIN_STEP;
use twins::pack::pack;

use super::light::{ANYTHING, NO_RAY, whole};
use super::{LENGTHS, records};
use crate::eye_records::pixel_shuffle;
use crate::prelude::*;
use protocol::layout::TILE_WIDTH;
use twins::primary_rays::Ray as WholeRay;

/// A colour by its channels.
type Colour = [Single; 3];

fn put_sums(bench: &mut Bench, sums: &[Colour]) -> Place {
    let quads: Vec<_> = sums.iter().map(|&[x, y, z]| [x, y, z, ANYTHING].map(single)).collect();
    put(bench, &quads)
}

/// Packets of shares that are added to sums.
#[derive(Clone, Debug)]
pub struct Shares {
    /// The packets.
    pub packets: Vec<[Share; 16]>,
    /// The sums.
    pub sums: Vec<Colour>,
}

impl Shares {
    /// Any two shares may belong to the same of these pixels.
    pub fn of(pixels: usize, packets: usize, random: &mut ChaCha8Rng) -> Self {
        let colour =
            |random: &mut ChaCha8Rng| [(); 3].map(|()| from_f64(random.random_range(0.0..1.0)));
        let mut share = || Share {
            pixel: random.random_range(0..pixels),
            weight: from_f64(random.random_range(0.0..1.0)),
            lit: colour(random),
        };
        let packets = (0..packets).map(|_| [(); 16].map(|()| share())).collect();
        Self { packets, sums: (0..pixels).map(|_| colour(random)).collect() }
    }
}

impl Description for Shares {
    const KERNEL: &'static str = "accumulate_r16";
    const ROUNDS: [usize; 2] = [100, 1000];
    const LENGTHS: &'static [usize] = LENGTHS;
    type Placed = Place;
    type Found = Vec<Colour>;

    fn sensible(count: usize, random: &mut ChaCha8Rng) -> Self {
        Self::of([1, 2, 3, 16, 100][random.random_range(0..5)], count, random)
    }

    fn any(count: usize, random: &mut ChaCha8Rng) -> Self {
        let mut shares = Self::of(20, count, random);
        random.fill(shares.sums.as_flattened_mut());
        for share in shares.packets.as_flattened_mut() {
            (share.weight, share.lit) = random.random();
        }
        shares
    }

    fn place(&self, bench: &mut Bench) -> (Place, Vec<u32>) {
        let sums = put_sums(bench, &self.sums);
        let rays = |shares: &[Share; 16]| {
            // Rays of one pixel may come after any number of others.
            rows::<_, _, 16>(&std::array::from_fn(|lane| WholeRay {
                weight: shares[lane].weight,
                pixel: address::<[F32; 4]>(sums, shares[lane].pixel) + lane as u32 * CHAIN_STEP,
                ..whole(NO_RAY, ANYTHING)
            }))
        };
        let rays: Vec<RayPacket> = self.packets.iter().map(rays).collect();
        let rays = put(bench, &rays).address;
        let lit = |shares: &[Share; 16]| records::lit_surfaces(&shares.map(|share| share.lit));
        let surfaces: Vec<_> = self.packets.iter().map(lit).collect();
        let surfaces = put(bench, &surfaces).address;
        (sums, vec![rays, surfaces, self.packets.len() as u32])
    }

    fn found(&self, bench: &Bench, sums: &Place, _: u32) -> Vec<Colour> {
        let quads: Vec<[F32; 4]> = bench.read_all(*sums);
        quads.into_iter().map(|[x, y, z, _]| [x, y, z].map(bits)).collect()
    }

    fn twin(&self, _: &Place) -> Vec<Colour> {
        let mut sums = self.sums.clone();
        for shares in self.packets.as_flattened().as_chunks().0 {
            accumulate(shares, &mut sums);
        }
        sums
    }
}

/// Rows of sums, all of the same length, which is a multiple of four.
#[derive(Clone, Debug)]
pub struct Rows {
    /// The rows.
    pub rows: Vec<Vec<Colour>>,
    /// By how many bits each channel is shifted in a pixel's word.
    pub shifts: [u32; 3],
}

impl Rows {
    /// The rows and their lengths that belong to this number.
    fn of(number: usize, random: &mut ChaCha8Rng, value: fn(&mut ChaCha8Rng) -> Single) -> Self {
        let (rows, groups) = (1 + number / 16, 1 + number % 16);
        let mut row = || (0..4 * groups).map(|_| [(); 3].map(|()| value(random))).collect();
        let rows = (0..rows).map(|_| row()).collect();
        let mut shifts = [0, 8, 16, 24];
        shifts.shuffle(random);
        Self { rows, shifts: [shifts[0], shifts[1], shifts[2]] }
    }
}

impl Description for Rows {
    const KERNEL: &'static str = "pack_sums";
    const ROUNDS: [usize; 2] = [1, 256];
    type Placed = Place;
    type Found = Vec<u32>;

    /// Up to sixteen rows of up to sixteen groups of four.
    fn lengths() -> impl Iterator<Item = usize> {
        0..256
    }

    fn sensible(number: usize, random: &mut ChaCha8Rng) -> Self {
        Self::of(number, random, |random| from_f64(random.random_range(-0.25..1.25)))
    }

    fn any(number: usize, random: &mut ChaCha8Rng) -> Self {
        Self::of(number, random, |random| random.random())
    }

    fn place(&self, bench: &mut Bench) -> (Place, Vec<u32>) {
        let mut sums = Vec::new();
        for row in &self.rows {
            assert!(row.len() <= TILE_WIDTH as usize, "a row of {} pixels", row.len());
            sums.extend(row);
            sums.resize(sums.len() + TILE_WIDTH as usize - row.len(), [ANYTHING; 3]);
        }
        let sums = put_sums(bench, &sums).address;
        let row_bytes = 4 * self.rows[0].len();
        let pixels = bench.place(&vec![0x55; row_bytes * self.rows.len()]);
        let shuffle = put(bench, &[pixel_shuffle(self.shifts)]).address;
        let count = self.rows.len() as u32;
        (pixels, vec![sums, pixels.address, count, row_bytes as u32, shuffle])
    }

    fn found(&self, bench: &Bench, pixels: &Place, _: u32) -> Vec<u32> {
        bench.read_all::<U32>(*pixels).into_iter().map(U32::get).collect()
    }

    fn twin(&self, _: &Place) -> Vec<u32> {
        self.rows.iter().flatten().map(|&sum| pack(sum, self.shifts)).collect()
    }
}
