//! Calls the kernels that intersect candidates with the inputs of their twins.

use twins::primary_rays::Ray as WholeRay;
use twins::sphere_ray::Ray;
use twins::triangle;

use super::error::SCALES;
use super::shape::Shape;
use super::triangle::TriangleObject;
use crate::bench;
use crate::cases::flat::triangles;
use crate::prelude::*;
use protocol::layout::{Candidate, Shear};

/// The packet of these rays. `anything` fills the fields that no intersector reads.
#[must_use]
pub fn packet(rays: &[Ray; 16], anything: u32) -> RayPacket {
    rows(&rays.map(|Ray { origin, direction, t, object }| WholeRay {
        origin,
        direction,
        t,
        object,
        weight: anything,
        pixel: anything,
    }))
}

/// The packets of these rays.
#[must_use]
pub fn packets(packets: &[[Ray; 16]], anything: u32) -> Vec<RayPacket> {
    packets.iter().map(|rays| packet(rays, anything)).collect()
}

/// All fields of these packets.
#[must_use]
pub fn whole(packets: &[RayPacket]) -> Vec<[WholeRay; 16]> {
    packets.iter().map(lanes).collect()
}

/// The rays of a packet.
#[must_use]
pub fn rays(packet: &RayPacket) -> [Ray; 16] {
    lanes(packet).map(|WholeRay { origin, direction, t, object, .. }| Ray {
        origin,
        direction,
        t,
        object,
    })
}

/// The inputs of a kernel in local store.
pub struct Placed {
    /// The packets, one after the other.
    pub packets: bench::Place,
    /// Their shears in the same order, for triangles.
    pub shears: Option<bench::Place>,
    /// The addresses of the objects' records.
    pub objects: Vec<u32>,
    /// The address of the candidates.
    pub candidates: u32,
}

/// Puts packets, objects and candidates into local store. Each candidate is an object and a
/// packet, given by number.
pub fn place<S: Shape>(
    bench: &mut Bench,
    packets: &[RayPacket],
    objects: &[S],
    list: &[[usize; 2]],
    anything: u32,
) -> Placed {
    let placed = put(bench, packets);
    let shears = S::SHEARED.then(|| shear(bench, placed, packets.len()));
    let records: Vec<S::Record> = objects.iter().map(|object| object.record(anything)).collect();
    let records = put(bench, &records);
    let objects: Vec<u32> =
        (0..objects.len()).map(|number| address::<S::Record>(records, number)).collect();
    let candidate = |&[object, packet]: &[usize; 2]| Candidate {
        object: objects[object].into(),
        packet: address::<RayPacket>(placed, packet).into(),
        bound: anything.into(),
        shear: shears.map_or(U32::new(anything), |shears| address::<Shear>(shears, packet).into()),
    };
    let candidates: Vec<Candidate> = list.iter().map(candidate).collect();
    let candidates = put(bench, &candidates).address;
    Placed { packets: placed, shears, objects, candidates }
}

/// Makes the shears of this number of packets.
pub fn shear(bench: &mut Bench, packets: bench::Place, count: usize) -> bench::Place {
    let (shears, arguments) = put_shears(bench, packets, count);
    bench.call(Sheared::KERNEL, &arguments);
    shears
}

fn put_shears(bench: &mut Bench, packets: bench::Place, count: usize) -> (bench::Place, Vec<u32>) {
    let shears = bench.place(&vec![0x55; size_of::<Shear>() * count]);
    (shears, vec![packets.address, count as u32, shears.address])
}

/// Packets whose shears are made.
#[derive(Clone, Debug)]
pub struct Sheared {
    /// The packets.
    pub packets: Vec<[Ray; 16]>,
    /// Fills the fields that have no meaning here.
    pub anything: u32,
}

impl Description for Sheared {
    const KERNEL: &'static str = "shear_packets_r16";
    const ROUNDS: [usize; 2] = [50, 350];
    const LENGTHS: &'static [usize] = &[0, 1, 2, 3, 7, 16, 24];
    type Placed = bench::Place;
    type Found = Vec<[triangle::Shear; 16]>;

    fn sensible(count: usize, random: &mut ChaCha8Rng) -> Self {
        let packets = (0..count).map(|_| TriangleObject::around(random, 1.0).1).collect();
        Self { packets, anything: random.random() }
    }

    fn any(count: usize, random: &mut ChaCha8Rng) -> Self {
        let packets = (0..count).map(|_| any_bits(random)).collect();
        Self { packets, anything: random.random() }
    }

    fn place(&self, bench: &mut Bench) -> (bench::Place, Vec<u32>) {
        let packets = packets(&self.packets, self.anything);
        let placed = put(bench, &packets);
        put_shears(bench, placed, packets.len())
    }

    fn found(&self, bench: &Bench, shears: &bench::Place, _: u32) -> Self::Found {
        bench.read_all(*shears).iter().map(triangles::shears).collect()
    }

    fn twin(&self, _: &bench::Place) -> Self::Found {
        let of = |ray: Ray| triangle::shear(ray.origin, ray.direction);
        self.packets.iter().map(|rays| rays.map(of)).collect()
    }
}

/// Calls the shape's kernel on candidates. Returns the packets after the call, and the objects'
/// addresses.
pub fn pairs<S: Shape>(
    bench: &mut Bench,
    packets: &[RayPacket],
    objects: &[S],
    list: &[[usize; 2]],
    anything: u32,
) -> (Vec<RayPacket>, Vec<u32>) {
    bench.reset();
    let placed = place(bench, packets, objects, list, anything);
    bench.call(S::KERNEL, &[placed.candidates, list.len() as u32]);
    (bench.read_all(placed.packets), placed.objects)
}

/// Packets and objects, and candidates of both by their numbers.
#[derive(Clone, Debug)]
pub struct Pairs<S> {
    /// The packets.
    pub packets: Vec<[Ray; 16]>,
    /// The objects.
    pub objects: Vec<S>,
    /// An object and a packet.
    pub list: Vec<[usize; 2]>,
    /// Fills the fields that have no meaning here.
    pub anything: u32,
}

impl<S: Shape> Description for Pairs<S> {
    const KERNEL: &'static str = S::KERNEL;
    const ROUNDS: [usize; 2] = [60, 1000];
    const LENGTHS: &'static [usize] = LENGTHS_FROM_0;
    const SHARES: [Range<f64>; 2] = [1.0 / 32.0..0.9, ANY_SHARE];
    type Placed = Placed;
    /// All fields of the packets, of which only the hits may change.
    type Found = Vec<[WholeRay; 16]>;

    /// Rays around objects of each scale, some with limits before or after their hits.
    fn sensible(count: usize, random: &mut ChaCha8Rng) -> Self {
        let (mut objects, mut packets) = (Vec::new(), Vec::new());
        for scale in SCALES.into_iter().chain(SCALES) {
            let (object, mut rays) = S::around(random, scale);
            for ray in rays.iter_mut().step_by(2) {
                if let Some(t) = object.truth(ray).t {
                    ray.t = from_f64(t * random.random_range(0.5..1.5));
                }
            }
            objects.push(object);
            packets.push(rays);
        }
        let mut candidate = || {
            let object = random.random_range(0..objects.len());
            // Most objects with the packet that is aimed at them.
            let own = random.random_ratio(3, 4);
            [object, if own { object } else { random.random_range(0..packets.len()) }]
        };
        let list = (0..count).map(|_| candidate()).collect();
        Self { packets, objects, list, anything: random.random() }
    }

    fn any(count: usize, random: &mut ChaCha8Rng) -> Self {
        Self {
            packets: vec![any_bits(random), any_bits(random)],
            objects: (0..4).map(|_| S::junk(random)).collect(),
            list: (0..count).map(|pair| [pair % 4, pair / 4 % 2]).collect(),
            anything: random.random(),
        }
    }

    fn place(&self, bench: &mut Bench) -> (Placed, Vec<u32>) {
        let Self { packets, objects, list, anything } = self;
        let placed = place(bench, &self::packets(packets, *anything), objects, list, *anything);
        let arguments = vec![placed.candidates, list.len() as u32];
        (placed, arguments)
    }

    fn found(&self, bench: &Bench, placed: &Placed, _: u32) -> Self::Found {
        whole(&bench.read_all(placed.packets))
    }

    fn twin(&self, placed: &Placed) -> Self::Found {
        let mut packets = self.packets.clone();
        for &[object, packet] in &self.list {
            for ray in &mut packets[packet] {
                *ray = self.objects[object].twin(*ray, placed.objects[object]);
            }
        }
        whole(&self::packets(&packets, self.anything))
    }

    /// How many rays of the listed packets hit something.
    fn part(&self, found: &Self::Found) -> [usize; 2] {
        let before = whole(&packets(&self.packets, self.anything));
        let listed = |packet: &usize| self.list.iter().any(|pair| pair[1] == *packet);
        let listed: Vec<usize> = (0..found.len()).filter(listed).collect();
        let rays = listed.iter().flat_map(|&packet| before[packet].iter().zip(&found[packet]));
        [rays.filter(|(before, after)| before != after).count(), 16 * listed.len()]
    }
}
