//! The kernels that intersect pairs of a sphere and a packet of primary rays, one for each
//! formulation.

use twins::isect_pairs::{Hit, isect_pair};

use super::call::{address, put, put_packets};
use super::formulation::{Seen, around_a_sphere};
use crate::cases::formulation::ForTheEye;
use crate::eye_records;
use crate::eye_records::Hits;
use crate::prelude::*;
use protocol::layout::{Packet, Pair, Sphere};

/// Where the packets and the spheres are.
#[derive(Debug)]
pub struct Placed {
    /// The packets.
    pub packets: Vec<Place>,
    /// The spheres, one after the other.
    pub spheres: Place,
}

/// Puts pairs of a sphere and a packet, both given by number, into local store.
pub fn place(
    bench: &mut Bench,
    packets: &[Packet],
    spheres: &[Sphere],
    pairs: &[[usize; 2]],
) -> (Placed, Vec<u32>) {
    let packets = put_packets(bench, packets);
    let spheres = put(bench, spheres);
    let pair = |&[sphere, packet]: &[usize; 2]| {
        eye_records::pair(address::<Sphere>(spheres, sphere), packets[packet].address)
    };
    let list: Vec<Pair> = pairs.iter().map(pair).collect();
    let arguments = vec![put(bench, &list).address, pairs.len() as u32];
    (Placed { packets, spheres }, arguments)
}

/// Packets and spheres, and pairs of both.
#[derive(Clone, Debug)]
pub struct Pairs<F: ForTheEye> {
    /// The directions and hits of the packets.
    pub packets: Vec<(Vectors, Hits)>,
    /// The spheres.
    pub spheres: Vec<F::Sphere>,
    /// A sphere and a packet.
    pub pairs: Vec<[usize; 2]>,
}

impl<F: ForTheEye<Sphere: Seen>> Pairs<F> {
    /// Calls the kernel, which must find what its twin finds. Returns the hits, with the numbers
    /// of spheres as objects, or `None` for hits that stayed as they were.
    pub fn hits(&self, bench: &mut Bench) -> Vec<[Option<usize>; 16]> {
        let (placed, found) = self.check_placed(bench);
        let number = |hit: Hit| {
            let numbers = 0..self.spheres.len();
            numbers.into_iter().find(|n| address::<Sphere>(placed.spheres, *n) == hit.object)
        };
        found.iter().map(|(_, hits)| hits.map(number)).collect()
    }
}

impl<F: ForTheEye<Sphere: Seen>> Description for Pairs<F> {
    const KERNEL: &'static str = F::EYE;
    const ROUNDS: [usize; 2] = [130, 1000];
    const LENGTHS: &'static [usize] = LENGTHS_FROM_0;
    const SHARES: [Range<f64>; 2] = [0.1..0.9, ANY_SHARE];
    type Placed = Placed;
    /// The packets, of which only the hits may change.
    type Found = Vec<(Vectors, Hits)>;

    /// Packets that are aimed at spheres, and pairs in runs of one packet, mostly with its sphere.
    fn sensible(count: usize, random: &mut ChaCha8Rng) -> Self {
        let before = Hit { t: from_f64(random.random_range(1.0..400.0)), object: 7 };
        let (mut packets, mut spheres) = (Vec::new(), Vec::new());
        for _ in 0..4 {
            let (rays, sphere) = around_a_sphere::<F>(random);
            packets.push((rays, [before; 16]));
            spheres.push(sphere);
        }
        let mut packet = 0;
        let mut pair = || {
            if random.random_ratio(1, 2) {
                packet = random.random_range(0..4);
            }
            [if random.random_ratio(3, 4) { packet } else { random.random_range(0..4) }, packet]
        };
        let pairs = (0..count).map(|_| pair()).collect();
        Self { packets, spheres, pairs }
    }

    fn any(count: usize, random: &mut ChaCha8Rng) -> Self {
        Self {
            packets: (0..2).map(|_| (random.random(), any_bits(random))).collect(),
            spheres: (0..4).map(|_| any_bits(random)).collect(),
            pairs: (0..count).map(|pair| [pair % 4, pair / 4 % 2]).collect(),
        }
    }

    fn place(&self, bench: &mut Bench) -> (Placed, Vec<u32>) {
        let packets = self.packets.iter().map(|(rays, hits)| eye_records::packet(rays, hits));
        let spheres: Vec<Sphere> = self.spheres.iter().map(Seen::record).collect();
        place(bench, &packets.collect::<Vec<_>>(), &spheres, &self.pairs)
    }

    fn found(&self, bench: &Bench, placed: &Placed, _: u32) -> Self::Found {
        let packets = placed.packets.iter().map(|packet| bench.read(*packet));
        packets
            .map(|packet| (eye_records::directions(&packet), eye_records::hits(&packet)))
            .collect()
    }

    fn twin(&self, placed: &Placed) -> Self::Found {
        let mut packets = self.packets.clone();
        for &[sphere, packet] in &self.pairs {
            let (rays, hits) = &mut packets[packet];
            let object = address::<Sphere>(placed.spheres, sphere);
            for (direction, hit) in rays.iter().zip(hits) {
                *hit = isect_pair::<F>(*direction, &self.spheres[sphere], object, *hit);
            }
        }
        packets
    }

    /// How many rays of the paired packets hit something.
    fn part(&self, found: &Self::Found) -> [usize; 2] {
        let paired = |packet: &usize| self.pairs.iter().any(|pair| pair[1] == *packet);
        let paired: Vec<usize> = (0..found.len()).filter(paired).collect();
        let hits = |packet: &usize| {
            let hits = found[*packet].1.iter().zip(&self.packets[*packet].1);
            hits.filter(|(after, before)| after != before).count()
        };
        [paired.iter().map(hits).sum(), 16 * paired.len()]
    }
}
