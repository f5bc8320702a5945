//! The kernels that make, shade and pack packets of primary rays.

use rand::seq::SliceRandom as _;
use twins::isect_pairs::Hit;
use twins::pack;
use twins::ray_setup::{self, Basis};
use twins::shade_depth::{Depth, shade_depth};
use twins::sphere_ray::BareSphere;

use super::call::{address, put, put_packets, put_places};
use super::error;
use crate::eye_records;
use crate::eye_records::Hits;
use crate::prelude::*;
use protocol::layout::{Colours, Packet, Sphere};

/// The first column and row whose pixel numbers are not exact in single precision.
const PIXELS_END: u32 = 1 << 23;
/// Bytes between rows of the pixels that are written. This is more than the width of a packet.
pub const PITCH: usize = 48;
/// Fills the bytes beside pixels.
const BESIDE: u8 = 0x55;

/// A camera, and the top left pixels of packets.
#[derive(Clone, Debug)]
pub struct RaySetup {
    /// The camera.
    pub basis: Basis,
    /// The pixels.
    pub pixels: Vec<[u32; 2]>,
    /// The object of rays that have hit nothing.
    pub background: u32,
}

impl Description for RaySetup {
    const KERNEL: &'static str = "ray_setup_r16";
    const ROUNDS: [usize; 2] = [20, 1000];
    type Placed = Vec<Place>;
    /// The directions and hits of each packet.
    type Found = Vec<(Vectors, Hits)>;

    fn sensible(count: usize, random: &mut ChaCha8Rng) -> Self {
        let basis = error::camera(random);
        let mut pixel = || [0; 2].map(|_: u32| random.random_range(0..2048) * 4);
        Self { basis, pixels: (0..count).map(|_| pixel()).collect(), background: random.random() }
    }

    fn any(_: usize, random: &mut ChaCha8Rng) -> Self {
        let pixel = [0; 2].map(|_: u32| random.random_range(0..PIXELS_END - 4));
        Self { basis: any_bits(random), pixels: vec![pixel], background: random.random() }
    }

    fn place(&self, bench: &mut Bench) -> (Vec<Place>, Vec<u32>) {
        let basis = put(bench, &[eye_records::basis(&self.basis)]).address;
        let packets: Vec<Place> = self.pixels.iter().map(|_| bench.junk::<Packet>()).collect();
        let places = put_places(bench, &packets, |number| {
            let [x, y] = self.pixels[number];
            [0, x, y]
        });
        let arguments = vec![basis, places.address, packets.len() as u32, self.background];
        (packets, arguments)
    }

    fn found(&self, bench: &Bench, packets: &Vec<Place>, _: u32) -> Self::Found {
        let packets = packets.iter().map(|packet| bench.read(*packet));
        packets
            .map(|packet| (eye_records::directions(&packet), eye_records::hits(&packet)))
            .collect()
    }

    fn twin(&self, _: &Vec<Place>) -> Self::Found {
        let directions = |&[x, y]: &[u32; 2]| {
            std::array::from_fn(|lane| {
                let (x, y) = ((x + lane as u32 % 4) as i32, (y + lane as u32 / 4) as i32);
                ray_setup::ray_setup(&self.basis, x, y)
            })
        };
        let hits = [Hit { t: FARTHEST, object: self.background }; 16];
        self.pixels.iter().map(|pixel| (directions(pixel), hits)).collect()
    }
}

/// Packets whose hits have indices into colours as objects.
#[derive(Clone, Debug)]
pub struct ShadeDepth {
    /// The hits.
    pub hits: Vec<Hits>,
    /// The colours, of which the first is the background's.
    pub colours: Vec<[Single; 3]>,
    /// Where colours fade.
    pub depth: Depth,
}

impl Description for ShadeDepth {
    const KERNEL: &'static str = "shade_depth_r16";
    const ROUNDS: [usize; 2] = [30, 1000];
    type Placed = Place;
    /// The colours, and the number of rays in each lane that hit something.
    type Found = (Vec<Vectors>, [u32; 4]);

    fn sensible(count: usize, random: &mut ChaCha8Rng) -> Self {
        let (depth, colours, first) = error::shaded_hits(random);
        let mut hits = vec![first; count];
        for hit in hits.iter_mut().flatten().filter(|hit| hit.object != 0) {
            hit.object = random.random_range(0..colours.len() as u32);
            hit.t = from_f64(to_f64(hit.t) * random.random_range(0.9..1.1));
        }
        Self { hits, colours, depth }
    }

    fn any(count: usize, random: &mut ChaCha8Rng) -> Self {
        let colours = (0..20).map(|_| random.random()).collect();
        let mut hit = || Hit { t: random.random(), object: random.random_range(0..20) };
        let hits = (0..count).map(|_| [(); 16].map(|()| hit())).collect();
        Self { hits, colours, depth: any_bits(random) }
    }

    fn place(&self, bench: &mut Bench) -> (Place, Vec<u32>) {
        let nothing = eye_records::sphere(&BareSphere { centre: [0; 3], radius_squared: 0 });
        let sphere = |colour: &[Single; 3]| Sphere {
            colour: colour.map(single),
            // Any value, because it has no effect on the colour.
            distance: single(u32::MAX),
            ..nothing
        };
        let records: Vec<Sphere> = self.colours.iter().map(sphere).collect();
        let records = put(bench, &records);
        let packet = |hits: &Hits| {
            let object = |hit: Hit| address::<Sphere>(records, hit.object as usize);
            let hits = hits.map(|hit| Hit { object: object(hit), ..hit });
            eye_records::packet(&[[0; 3]; 16], &hits)
        };
        let packets: Vec<Packet> = self.hits.iter().map(packet).collect();
        let packets = put_packets(bench, &packets);
        let places = put_places(bench, &packets, |_| [0; 3]).address;
        let depth = put(bench, &[eye_records::depth(self.depth)]).address;
        let shaded = bench.place(&vec![0x55; size_of::<Colours>() * packets.len()]);
        let count = packets.len() as u32;
        (shaded, vec![places, count, depth, shaded.address, records.address])
    }

    fn found(&self, bench: &Bench, shaded: &Place, _: u32) -> Self::Found {
        let shaded: Vec<Colours> = bench.read_all(*shaded);
        (shaded.iter().map(eye_records::colour_vectors).collect(), bench.returned_vector())
    }

    fn twin(&self, _: &Place) -> Self::Found {
        let mut counts = [0; 4];
        let mut colours = |hits: &Hits| {
            std::array::from_fn(|lane| {
                let Hit { t, object } = hits[lane];
                counts[lane % 4] += u32::from(object != 0);
                shade_depth(t, self.colours[object as usize], object == 0, self.depth)
            })
        };
        let shaded = self.hits.iter().map(&mut colours).collect();
        (shaded, counts)
    }
}

/// Colours of packets, and the positions of red, green and blue in a pixel.
#[derive(Clone, Debug)]
pub struct Pack {
    /// The colours.
    pub colours: Vec<Vectors>,
    /// The positions.
    pub shifts: [u32; 3],
}

fn any_shifts(random: &mut ChaCha8Rng) -> [u32; 3] {
    let mut shifts = [0, 8, 16, 24];
    shifts.shuffle(random);
    [shifts[0], shifts[1], shifts[2]]
}

impl Description for Pack {
    const KERNEL: &'static str = "pack_r16";
    const ROUNDS: [usize; 2] = [30, 1000];
    type Placed = Vec<Place>;
    /// The pixels of each packet.
    type Found = Vec<[u32; 16]>;

    fn sensible(count: usize, random: &mut ChaCha8Rng) -> Self {
        let mut channel = || from_f64(random.random_range(-0.25..1.25));
        let colours =
            (0..count).map(|_| [[(); 3]; 16].map(|colour| colour.map(|()| channel()))).collect();
        Self { colours, shifts: any_shifts(random) }
    }

    fn any(_: usize, random: &mut ChaCha8Rng) -> Self {
        Self { colours: vec![random.random()], shifts: any_shifts(random) }
    }

    fn place(&self, bench: &mut Bench) -> (Vec<Place>, Vec<u32>) {
        let records: Vec<Colours> = self.colours.iter().map(eye_records::colours).collect();
        let records = put(bench, &records).address;
        let shuffle = put(bench, &[eye_records::pixel_shuffle(self.shifts)]).address;
        let rows: Vec<Place> =
            self.colours.iter().map(|_| bench.place(&[BESIDE; 4 * PITCH])).collect();
        let places = put_places(bench, &rows, |number| [rows[number].address, 0, 0]).address;
        let count = rows.len() as u32;
        (rows, vec![places, count, records, shuffle, PITCH as u32])
    }

    fn found(&self, bench: &Bench, rows: &Vec<Place>, _: u32) -> Self::Found {
        let words = |rows: &Place| {
            let rows: [[u8; PITCH]; 4] = bench.read(*rows);
            let mut beside = rows.iter().flat_map(|row| &row[16..]);
            assert!(beside.all(|byte| *byte == BESIDE), "pack_r16 wrote beside the pixels");
            std::array::from_fn(|lane| {
                let first = lane % 4 * 4;
                let bytes = &rows[lane / 4][first..first + 4];
                u32::from_be_bytes(bytes.try_into().expect("four bytes"))
            })
        };
        rows.iter().map(words).collect()
    }

    fn twin(&self, _: &Vec<Place>) -> Self::Found {
        let pixels = |colours: &Vectors| colours.map(|colour| pack::pack(colour, self.shifts));
        self.colours.iter().map(pixels).collect()
    }
}
