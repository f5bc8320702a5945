//! The kernels that cull spheres for primary rays.

use twins::cull::{is_hidden, may_enter, reaches_into};
use twins::isect_pairs::Hit;

use super::call::{address, list_buffer, put, put_packets, put_places};
use super::error::NO_HITS;
use crate::eye_records;
use crate::prelude::*;
use protocol::layout::{Frustum, Packet, Pair, Sphere};

/// Directions close to -z.
fn directions(random: &mut ChaCha8Rng) -> Vectors {
    std::array::from_fn(|_| {
        let [x, y] = [(); 2].map(|()| random.random_range(-0.3..0.3));
        unit([x, y, -1.0]).map(from_f64)
    })
}

/// Spheres around -z with limits of which about half are exceeded by such directions.
fn spheres(count: usize, random: &mut ChaCha8Rng) -> Vec<Sphere> {
    let mut sphere = || {
        let distance: f64 = random.random_range(5.0..50.0);
        let [x, y] = [(); 2].map(|()| random.random_range(-0.4..0.4) * distance);
        let sine: f64 = random.random_range(0.02..0.3);
        let limit = distance * (1.0 - sine * sine).sqrt();
        Sphere {
            centre: [x, y, -distance].map(|value| single(from_f64(value))),
            ray_limit: single(from_f64(limit)),
            packet_limit: single(from_f64(limit * random.random_range(0.98..1.0))),
            reach: single(from_f64(distance * sine)),
            ..Sphere::new_zeroed()
        }
    };
    (0..count).map(|_| sphere()).collect()
}

fn any_spheres(count: usize, random: &mut ChaCha8Rng) -> Vec<Sphere> {
    let mut sphere = || Sphere {
        centre: random.random::<[Single; 3]>().map(single),
        ray_limit: single(random.random()),
        packet_limit: single(random.random()),
        reach: single(random.random()),
        ..Sphere::new_zeroed()
    };
    (0..count).map(|_| sphere()).collect()
}

fn packet(rays: &Vectors) -> Packet {
    eye_records::packet(rays, &NO_HITS)
}

/// The list that a kernel has written: an object and a packet each.
fn objects_and_packets(bench: &Bench, buffer: Place, end: u32) -> Vec<[u32; 2]> {
    bench
        .read_list(buffer, end)
        .iter()
        .map(|pair: &Pair| [pair.object, pair.packet].map(U32::get))
        .collect()
}

/// Packets, each of which is tested with all spheres. There are four spheres or a multiple.
#[derive(Clone, Debug)]
pub struct FilterSpheres {
    /// The directions of the packets' rays.
    pub packets: Vec<Vectors>,
    /// The spheres, of which the centre and the limit for rays count.
    pub spheres: Vec<Sphere>,
}

/// Where the packets, the spheres and the list are.
pub struct Filtered {
    packets: Vec<Place>,
    spheres: Place,
    buffer: Place,
}

impl Description for FilterSpheres {
    const KERNEL: &'static str = "filter_spheres_r16";
    const ROUNDS: [usize; 2] = [40, 160];
    const LENGTHS: &'static [usize] = &[1, 2, 3, 7];
    const SHARES: [Range<f64>; 2] = [0.1..1.0, 0.1..1.0];
    type Placed = Filtered;
    type Found = Vec<[u32; 2]>;

    /// The list of all pairs must fit.
    fn sensible(count: usize, random: &mut ChaCha8Rng) -> Self {
        let packets = (0..count).map(|_| directions(random)).collect();
        let fours = [1, 2, 3, 4, 10][random.random_range(0..5)];
        Self { packets, spheres: spheres(4 * fours, random) }
    }

    fn any(count: usize, random: &mut ChaCha8Rng) -> Self {
        let packets = (0..count).map(|_| random.random()).collect();
        Self { packets, spheres: any_spheres(4 * random.random_range(1..5), random) }
    }

    fn place(&self, bench: &mut Bench) -> (Filtered, Vec<u32>) {
        let packets: Vec<Packet> = self.packets.iter().map(packet).collect();
        let packets = put_packets(bench, &packets);
        let places = put_places(bench, &packets, |_| [1, 2, 3]).address;
        let spheres = put(bench, &self.spheres);
        let buffer = list_buffer(bench, packets.len() * self.spheres.len());
        let [count, fours] = [packets.len(), self.spheres.len() / 4].map(|count| count as u32);
        let arguments = vec![places, count, spheres.address, fours, buffer.address];
        (Filtered { packets, spheres, buffer }, arguments)
    }

    fn found(&self, bench: &Bench, placed: &Filtered, end: u32) -> Self::Found {
        objects_and_packets(bench, placed.buffer, end)
    }

    fn twin(&self, placed: &Filtered) -> Self::Found {
        let mut list = Vec::new();
        for (rays, packet) in self.packets.iter().zip(&placed.packets) {
            for (number, sphere) in self.spheres.iter().enumerate() {
                let (centre, limit) = (sphere.centre.map(bits), bits(sphere.ray_limit));
                if rays.iter().any(|ray| may_enter(*ray, centre, limit)) {
                    list.push([address::<Sphere>(placed.spheres, number), packet.address]);
                }
            }
        }
        list
    }

    fn part(&self, found: &Self::Found) -> [usize; 2] {
        [found.len(), self.packets.len() * self.spheres.len()]
    }
}

/// The directions through the middles of a tile's packets, and a list of spheres.
#[derive(Clone, Debug)]
pub struct CullSpheres {
    /// The directions.
    pub middles: [Vectors; 4],
    /// The spheres, of which the centre and the limit for packets count.
    pub spheres: Vec<Sphere>,
    /// The numbers of the listed spheres.
    pub order: Vec<usize>,
}

impl Description for CullSpheres {
    const KERNEL: &'static str = "cull_spheres_p64";
    const ROUNDS: [usize; 2] = [20, 200];
    const SHARES: [Range<f64>; 2] = [0.05..1.0, 0.05..1.0];
    type Placed = Place;
    /// Four masks of packets for each listed sphere.
    type Found = Vec<[u32; 4]>;

    fn sensible(count: usize, random: &mut ChaCha8Rng) -> Self {
        Self {
            middles: [(); 4].map(|()| directions(random)),
            spheres: spheres(20, random),
            order: (0..count).map(|_| random.random_range(0..20)).collect(),
        }
    }

    fn any(count: usize, random: &mut ChaCha8Rng) -> Self {
        let (middles, spheres) = (random.random(), any_spheres(20, random));
        Self { middles, spheres, ..Self::sensible(count, random) }
    }

    fn place(&self, bench: &mut Bench) -> (Place, Vec<u32>) {
        let packets = put(bench, &self.middles.each_ref().map(packet)).address;
        let spheres = put(bench, &self.spheres);
        let pair =
            |number: &usize| eye_records::pair(address::<Sphere>(spheres, *number), 0xdead_beef);
        let list: Vec<Pair> = self.order.iter().map(pair).collect();
        let list = put(bench, &list).address;
        let masks = put(bench, &vec![[U32::new(0x5555_5555); 4]; self.order.len()]);
        (masks, vec![packets, list, self.order.len() as u32, masks.address])
    }

    fn found(&self, bench: &Bench, placed: &Place, _: u32) -> Self::Found {
        let masks: Vec<[U32; 4]> = bench.read_all(*placed);
        masks.into_iter().map(|masks| masks.map(U32::get)).collect()
    }

    fn twin(&self, _: &Place) -> Self::Found {
        let masks = |number: &usize| {
            let sphere = &self.spheres[*number];
            let (centre, limit) = (sphere.centre.map(bits), bits(sphere.packet_limit));
            self.middles.each_ref().map(|group| {
                let named = group.iter().map(|middle| may_enter(*middle, centre, limit));
                named.fold(0, |mask, named| mask << 1 | u32::from(named))
            })
        };
        self.order.iter().map(masks).collect()
    }

    fn part(&self, found: &Self::Found) -> [usize; 2] {
        let named: u32 = found.as_flattened().iter().map(|mask| mask.count_ones()).sum();
        [named as usize, 64 * found.len()]
    }
}

/// A pyramid by the normals of its sides, and spheres.
#[derive(Clone, Debug)]
pub struct FrustumSpheres {
    /// The normals.
    pub normals: [[Single; 3]; 4],
    /// The spheres, of which the centre and the reach count.
    pub spheres: Vec<Sphere>,
}

impl Description for FrustumSpheres {
    const KERNEL: &'static str = "frustum_spheres";
    const ROUNDS: [usize; 2] = [40, 280];
    const LENGTHS: &'static [usize] = LENGTHS_FROM_0;
    const SHARES: [Range<f64>; 2] = [0.05..1.0, 0.05..1.0];
    type Placed = [Place; 2];
    /// The addresses of the listed spheres.
    type Found = Vec<u32>;

    fn sensible(count: usize, random: &mut ChaCha8Rng) -> Self {
        let slope = random.random_range(0.05..0.3);
        let normals = [[1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0]]
            .map(|[x, y]| unit([x, y, -slope]).map(from_f64));
        Self { normals, spheres: spheres(count, random) }
    }

    fn any(count: usize, random: &mut ChaCha8Rng) -> Self {
        Self { normals: random.random(), spheres: any_spheres(count, random) }
    }

    fn place(&self, bench: &mut Bench) -> ([Place; 2], Vec<u32>) {
        let [normal_x, normal_y, normal_z] =
            [0, 1, 2].map(|axis| self.normals.map(|normal| single(normal[axis])));
        let frustum = put(bench, &[Frustum { normal_x, normal_y, normal_z }]).address;
        let spheres = put(bench, &self.spheres);
        let buffer = list_buffer(bench, self.spheres.len());
        let count = self.spheres.len() as u32;
        ([spheres, buffer], vec![frustum, spheres.address, count, buffer.address])
    }

    fn found(&self, bench: &Bench, [_, buffer]: &[Place; 2], end: u32) -> Vec<u32> {
        bench.read_list(*buffer, end).iter().map(|entry: &Pair| entry.object.get()).collect()
    }

    fn twin(&self, [spheres, _]: &[Place; 2]) -> Vec<u32> {
        let numbered = self.spheres.iter().enumerate().filter(|(_, sphere)| {
            reaches_into(&self.normals, sphere.centre.map(bits), bits(sphere.reach))
        });
        numbered.map(|(number, _)| address::<Sphere>(*spheres, number)).collect()
    }

    fn part(&self, found: &Vec<u32>) -> [usize; 2] {
        [found.len(), self.spheres.len()]
    }
}

/// Packets, each in a pair with a sphere. The list overwrites the pairs.
#[derive(Clone, Debug)]
pub struct HiddenPairs {
    /// The hits of the packets' rays.
    pub packets: Vec<[Hit; 16]>,
    /// The distances of the nearest points of the packets' spheres.
    pub near: Vec<Single>,
}

impl Description for HiddenPairs {
    const KERNEL: &'static str = "hidden_pairs_r16";
    const ROUNDS: [usize; 2] = [40, 200];
    const LENGTHS: &'static [usize] = LENGTHS_FROM_0;
    const SHARES: [Range<f64>; 2] = [0.25..0.9, 0.25..1.0];
    type Placed = (Vec<Pair>, Place);
    type Found = Vec<[u32; 2]>;

    fn sensible(count: usize, random: &mut ChaCha8Rng) -> Self {
        let mut hits = || {
            let farthest = random.random_range(1.0..4.0);
            [(); 16].map(|()| Hit {
                t: from_f64(random.random_range(0.0..farthest)),
                object: random.random(),
            })
        };
        let packets = (0..count).map(|_| hits()).collect();
        let near = (0..count).map(|_| from_f64(random.random_range(1.0..3.0))).collect();
        Self { packets, near }
    }

    fn any(count: usize, random: &mut ChaCha8Rng) -> Self {
        let mut hits = || [(); 16].map(|()| Hit { t: random.random(), object: random.random() });
        let packets = (0..count).map(|_| hits()).collect();
        Self { packets, near: (0..count).map(|_| random.random()).collect() }
    }

    fn place(&self, bench: &mut Bench) -> (Self::Placed, Vec<u32>) {
        let packets = self.packets.iter().map(|hits| eye_records::packet(&[[0; 3]; 16], hits));
        let packets = put_packets(bench, &packets.collect::<Vec<_>>());
        let sphere = |near: &Single| Sphere { near: single(*near), ..Sphere::new_zeroed() };
        let spheres: Vec<Sphere> = self.near.iter().map(sphere).collect();
        let spheres = put(bench, &spheres);
        let numbered = packets.iter().enumerate();
        let pairs: Vec<Pair> = numbered
            .map(|(number, packet)| {
                eye_records::pair(address::<Sphere>(spheres, number), packet.address)
            })
            .collect();
        let buffer = put(bench, &pairs);
        let arguments = vec![buffer.address, pairs.len() as u32];
        ((pairs, buffer), arguments)
    }

    fn found(&self, bench: &Bench, (_, buffer): &Self::Placed, end: u32) -> Self::Found {
        objects_and_packets(bench, *buffer, end)
    }

    fn twin(&self, (pairs, _): &Self::Placed) -> Self::Found {
        let packets = pairs.iter().zip(&self.packets).zip(&self.near);
        let visible =
            packets.filter(|((_, hits), near)| !is_hidden(&hits.map(|hit| hit.t), **near));
        visible.map(|((pair, _), _)| [pair.object, pair.packet].map(U32::get)).collect()
    }

    fn part(&self, found: &Self::Found) -> [usize; 2] {
        [found.len(), self.packets.len()]
    }
}
