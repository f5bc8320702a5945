//! The kernels that make packets.

use twins::load_rays::{Queued, load_ray};
use twins::primary_rays::{Ray, View, primary_ray};
use twins::ray_setup::Basis;
use twins::sample_rays::{Pixel, sample_ray};

use super::call::{ANYTHING, packets};
use crate::cases::eye::call::put_places;
use crate::cases::eye::error::camera;
use crate::eye_records;
use crate::prelude::*;
use protocol::layout::QueuedRay;

/// The first column and row whose pixel numbers are not exact in single precision.
const PIXELS_END: u32 = 1 << 23;

/// Packets whose top left pixels are at `corners`. The sum of each packet is a tile's row after
/// that of the one before.
#[derive(Clone, Debug)]
pub struct PrimaryRays {
    /// The view that all of them share.
    pub view: View,
    /// The columns and rows.
    pub corners: Vec<[u32; 2]>,
    /// The address of the first packet's sum.
    pub pixels: u32,
}

impl Description for PrimaryRays {
    const KERNEL: &'static str = "primary_rays_r16";
    const ROUNDS: [usize; 2] = [20, 1000];
    type Placed = Vec<Place>;
    type Found = Vec<[Ray; 16]>;

    fn sensible(count: usize, random: &mut ChaCha8Rng) -> Self {
        let view = View {
            basis: camera(random),
            background: random.random(),
            width: random.random_range(1..8192),
            height: random.random_range(1..8192),
        };
        let corners =
            (0..count).map(|_| [0; 2].map(|_: u32| random.random_range(0..2048) * 4)).collect();
        Self { view, corners, pixels: random.random() }
    }

    fn any(_: usize, random: &mut ChaCha8Rng) -> Self {
        let corner = [0; 2].map(|_: u32| random.random_range(0..PIXELS_END - 4));
        Self { view: any_bits(random), corners: vec![corner], pixels: random.random() }
    }

    fn place(&self, bench: &mut Bench) -> (Vec<Place>, Vec<u32>) {
        let View { basis, background, width, height } = self.view;
        let basis = put(bench, &[eye_records::basis(&basis)]);
        let packets: Vec<Place> = self.corners.iter().map(|_| bench.junk::<RayPacket>()).collect();
        let places = put_places(bench, &packets, |number| {
            let [x, y] = self.corners[number];
            [self.sum_of(number), x, y]
        });
        let count = self.corners.len() as u32;
        let (width, height) = (width as u32, height as u32);
        (packets, vec![places.address, count, basis.address, background, width, height])
    }

    fn found(&self, bench: &Bench, placed: &Vec<Place>, _: u32) -> Self::Found {
        placed.iter().map(|packet| lanes(&bench.read::<RayPacket>(*packet))).collect()
    }

    fn twin(&self, _: &Vec<Place>) -> Self::Found {
        let packet = |(number, corner): (usize, &[u32; 2])| {
            let corner = corner.map(|at| at as i32);
            std::array::from_fn(|lane| primary_ray(&self.view, self.sum_of(number), corner, lane))
        };
        self.corners.iter().enumerate().map(packet).collect()
    }
}

impl PrimaryRays {
    /// The address of the sum of a packet's top left pixel.
    fn sum_of(&self, packet: usize) -> u32 {
        self.pixels.wrapping_add(packet as u32 * 1024)
    }
}

/// Packets of four pixels, each of which has `across` squared samples.
#[derive(Clone, Debug)]
pub struct SampleRays {
    /// The camera.
    pub basis: Basis,
    /// The address of the background's record.
    pub background: u32,
    /// The pixels.
    pub pixels: Vec<Pixel>,
    /// The samples of a pixel from side to side: 2 or 4.
    pub across: u32,
}

impl Description for SampleRays {
    const KERNEL: &'static str = "sample_rays_r16";
    const ROUNDS: [usize; 2] = [20, 1000];
    type Placed = Place;
    type Found = Vec<[Ray; 16]>;

    fn sensible(count: usize, random: &mut ChaCha8Rng) -> Self {
        let mut pixel = || Pixel {
            sum: random.random(),
            x: random.random_range(-1..8192),
            y: random.random_range(0..8192),
        };
        let pixels = (0..4 * count).map(|_| pixel()).collect();
        let (basis, background) = (camera(random), random.random());
        Self { basis, background, pixels, across: if random.random() { 2 } else { 4 } }
    }

    fn any(count: usize, random: &mut ChaCha8Rng) -> Self {
        let pixels = (0..4 * count).map(|_| any_bits(random)).collect();
        Self { basis: any_bits(random), pixels, ..Self::sensible(count, random) }
    }

    fn place(&self, bench: &mut Bench) -> (Place, Vec<u32>) {
        let count = self.pixels.len() / 4;
        let packets = put(bench, &vec![RayPacket::new_zeroed(); count]);
        let basis = put(bench, &[eye_records::basis(&self.basis)]);
        let places = self.pixels.iter().map(|pixel| layout::Place {
            packet: ANYTHING.into(),
            pixels: pixel.sum.into(),
            x: (pixel.x as u32).into(),
            y: (pixel.y as u32).into(),
        });
        let places = put(bench, &places.collect::<Vec<_>>()).address;
        let samples = self.across * self.across;
        let (count, background) = (count as u32, self.background);
        (packets, vec![places, count, basis.address, background, samples, packets.address])
    }

    fn found(&self, bench: &Bench, placed: &Place, _: u32) -> Self::Found {
        packets(bench, *placed)
    }

    fn twin(&self, _: &Place) -> Self::Found {
        let Self { basis, background, across, .. } = self;
        let packet = |pixels: &[Pixel]| {
            let ray = |lane| sample_ray(basis, *background, pixels[lane / 4], *across, lane);
            std::array::from_fn(ray)
        };
        self.pixels.chunks(4).map(packet).collect()
    }
}

/// Packets of the first `count` rays in the queue's memory.
#[derive(Clone, Debug)]
pub struct LoadRays {
    /// A whole number of packets.
    pub queue: Vec<Queued>,
    /// The number of rays that are there.
    pub count: usize,
    /// The address of the background's record.
    pub background: u32,
    /// The sum that nobody reads.
    pub dummy: u32,
}

impl Description for LoadRays {
    const KERNEL: &'static str = "load_rays_r16";
    const ROUNDS: [usize; 2] = [1, 0];
    type Placed = Place;
    type Found = Vec<[Ray; 16]>;

    fn lengths() -> impl Iterator<Item = usize> {
        (1..=65).chain([127, 128, 129, 500])
    }

    /// Rays of any bits, which are copied whatever they are.
    fn sensible(count: usize, random: &mut ChaCha8Rng) -> Self {
        let queue = (0..count.next_multiple_of(16)).map(|_| any_bits(random)).collect();
        Self { queue, count, background: random.random(), dummy: random.random() }
    }

    fn any(count: usize, random: &mut ChaCha8Rng) -> Self {
        Self::sensible(count, random)
    }

    fn place(&self, bench: &mut Bench) -> (Place, Vec<u32>) {
        let queue = self.queue.iter().map(|queued| QueuedRay {
            origin: queued.origin.map(single),
            weight: single(queued.weight),
            direction: queued.direction.map(single),
            pixel: queued.pixel.into(),
        });
        let queue = put(bench, &queue.collect::<Vec<_>>());
        let packets = put(bench, &vec![RayPacket::new_zeroed(); self.queue.len() / 16]);
        let (count, to) = (self.count as u32, packets.address);
        (packets, vec![queue.address, count, to, self.background, self.dummy])
    }

    fn found(&self, bench: &Bench, placed: &Place, _: u32) -> Self::Found {
        packets(bench, *placed)
    }

    fn twin(&self, _: &Place) -> Self::Found {
        let load =
            |at: usize| load_ray(&self.queue[at], at < self.count, self.background, self.dummy);
        let packet = |first| std::array::from_fn(|lane| load(first + lane));
        (0..self.queue.len()).step_by(16).map(packet).collect()
    }
}
