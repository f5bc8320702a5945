//! `filter_spheres_r16`, `cull_spheres_p64`, `frustum_spheres` and `hidden_pairs_r16`.

use kernels::bench::{Bench, random};
use kernels::cases::eye::call::{address, list, list_room, put, put_packets, put_places};
use kernels::cases::eye::error;
use kernels::cases::sphere_ray::unit;
use kernels::eye_records::{self, Vectors};
use kernels::single::{bits, single};
use protocol::layout::{Frustum, Packet, Pair, Sphere};
use rand::Rng as _;
use rand_chacha::ChaCha8Rng;
use spu_emulator::float::single::from_f64;
use twins::cull::{is_hidden, may_enter, reaches_into};
use twins::isect_pairs::Hit;
use twins::{FARTHEST, Single};
use zerocopy::FromZeros as _;
use zerocopy::big_endian::U32;

use super::COUNTS;

/// The kind of inputs.
#[derive(Clone, Copy)]
enum Inputs {
    /// Directions close to -z, and spheres around them with limits of which about half are
    /// exceeded.
    Sensible,
    /// Random bits.
    Any,
}

impl Inputs {
    fn directions(self, random: &mut ChaCha8Rng) -> Vectors {
        std::array::from_fn(|_| match self {
            Self::Sensible => {
                let [x, y] = [(); 2].map(|()| random.random_range(-0.3..0.3));
                unit([x, y, -1.0]).map(from_f64)
            }
            Self::Any => random.random(),
        })
    }

    fn packet(self, random: &mut ChaCha8Rng) -> Packet {
        eye_records::packet(&self.directions(random), &error::NO_HITS)
    }

    fn sphere(self, random: &mut ChaCha8Rng) -> Sphere {
        let mut sphere = Sphere::new_zeroed();
        match self {
            Self::Sensible => {
                let distance: f64 = random.random_range(5.0..50.0);
                let [x, y] = [(); 2].map(|()| random.random_range(-0.4..0.4) * distance);
                let sine: f64 = random.random_range(0.02..0.3);
                sphere.centre = [x, y, -distance].map(|value| single(from_f64(value)));
                let limit = distance * (1.0 - sine * sine).sqrt();
                sphere.ray_limit = single(from_f64(limit));
                sphere.packet_limit = single(from_f64(limit * random.random_range(0.98..1.0)));
                sphere.reach = single(from_f64(distance * sine));
            }
            Self::Any => {
                sphere.centre = random.random::<[Single; 3]>().map(single);
                sphere.ray_limit = single(random.random());
                sphere.packet_limit = single(random.random());
                sphere.reach = single(random.random());
            }
        }
        sphere
    }

    fn spheres(self, random: &mut ChaCha8Rng, count: usize) -> Vec<Sphere> {
        (0..count).map(|_| self.sphere(random)).collect()
    }
}

fn objects_and_packets(pairs: &[Pair]) -> Vec<[u32; 2]> {
    pairs.iter().map(|pair| [pair.object.get(), pair.packet.get()]).collect()
}

/// Checks `filter_spheres_r16`, and returns how many pairs passed.
fn check_filter(bench: &mut Bench, packets: &[Packet], spheres: &[Sphere]) -> usize {
    bench.reset();
    let addresses = put_packets(bench, packets);
    let places = put_places(bench, &addresses, |_| [1, 2, 3]);
    let records = put(bench, spheres);
    let room = list_room(bench, packets.len() * spheres.len());
    let arguments = [
        places.address,
        packets.len() as u32,
        records.address,
        spheres.len() as u32 / 4,
        room.address,
    ];
    let end = bench.call("filter_spheres_r16", &arguments).value;
    let found = objects_and_packets(&list(bench, room, end));

    let mut expected = Vec::new();
    for (packet, place) in packets.iter().zip(&addresses) {
        let rays = eye_records::directions(packet);
        for (number, sphere) in spheres.iter().enumerate() {
            let (centre, limit) = (sphere.centre.map(bits), bits(sphere.ray_limit));
            if rays.iter().any(|ray| may_enter(*ray, centre, limit)) {
                expected.push([address::<Sphere>(records, number), place.address]);
            }
        }
    }
    assert_eq!(found, expected, "{packets:x?}, {spheres:x?}");
    found.len()
}

#[test]
fn filtered_spheres_equal_the_twins() {
    let mut random = random();
    let mut bench = Bench::new();
    for inputs in [Inputs::Sensible, Inputs::Any] {
        let (mut passed, mut tried) = (0, 0);
        for round in 0..40 {
            for packets in [1, 2, 3, 7] {
                let fours = [1, 2, 3, 4, 10][round % 5];
                let packets: Vec<Packet> =
                    (0..packets).map(|_| inputs.packet(&mut random)).collect();
                let spheres = inputs.spheres(&mut random, 4 * fours);
                passed += check_filter(&mut bench, &packets, &spheres);
                tried += packets.len() * spheres.len();
            }
        }
        assert!(passed * 10 > tried && passed < tried, "{passed} of {tried}");
    }
}

#[test]
fn one_ray_of_sixteen_is_enough_for_the_filter() {
    let mut bench = Bench::new();
    let mut sphere = Sphere::new_zeroed();
    sphere.centre = [0.0, 0.0, -5.0].map(|value| single(from_f64(value)));
    sphere.ray_limit = single(from_f64(4.9));
    let [along, away] = [[0.0, 0.0, -1.0], [0.0, 1.0, 0.0]].map(|ray| ray.map(from_f64));
    for lane in 0..16 {
        let mut rays = [away; 16];
        rays[lane] = along;
        let packet = eye_records::packet(&rays, &error::NO_HITS);
        assert_eq!(check_filter(&mut bench, &[packet], &[sphere; 4]), 4);
    }
    let packet = eye_records::packet(&[away; 16], &error::NO_HITS);
    assert_eq!(check_filter(&mut bench, &[packet], &[sphere; 4]), 0);
}

/// Checks `cull_spheres_p64`, and returns how many packets it selected.
fn check_cull(
    bench: &mut Bench,
    middles: &[Vectors; 4],
    spheres: &[Sphere],
    order: &[usize],
) -> u32 {
    bench.reset();
    let packets = middles.each_ref().map(|group| eye_records::packet(group, &error::NO_HITS));
    let packets = put(bench, &packets);
    let records = put(bench, spheres);
    let entries: Vec<Pair> = order
        .iter()
        .map(|number| eye_records::pair(address::<Sphere>(records, *number), 0xdead_beef))
        .collect();
    let entries = put(bench, &entries);
    let masks = put(bench, &vec![[U32::new(0x5555_5555); 4]; order.len()]);
    let arguments = [packets.address, entries.address, order.len() as u32, masks.address];
    bench.call("cull_spheres_p64", &arguments);
    let masks: Vec<[U32; 4]> = bench.read_all(masks);
    let mut named = 0;
    for (number, masks) in order.iter().zip(masks) {
        let sphere = &spheres[*number];
        let (centre, limit) = (sphere.centre.map(bits), bits(sphere.packet_limit));
        for (middles, found) in middles.iter().zip(masks) {
            let expected = middles
                .iter()
                .fold(0, |mask, middle| mask << 1 | u32::from(may_enter(*middle, centre, limit)));
            assert_eq!(found.get(), expected, "{middles:x?}, {sphere:x?}");
            named += expected.count_ones();
        }
    }
    named
}

#[test]
fn culled_spheres_equal_the_twins() {
    let mut random = random();
    let mut bench = Bench::new();
    for inputs in [Inputs::Sensible, Inputs::Any] {
        let (mut named, mut tried) = (0, 0);
        for _ in 0..20 {
            for count in COUNTS {
                let middles = std::array::from_fn(|_| inputs.directions(&mut random));
                let spheres = inputs.spheres(&mut random, 20);
                let order: Vec<usize> = (0..count).map(|_| random.random_range(0..20)).collect();
                named += check_cull(&mut bench, &middles, &spheres, &order);
                tried += 64 * count as u32;
            }
        }
        assert!(named * 20 > tried && named < tried, "{named} of {tried}");
    }
}

/// Checks `frustum_spheres`, and returns how many spheres passed.
fn check_frustum(bench: &mut Bench, normals: &[[Single; 3]; 4], spheres: &[Sphere]) -> usize {
    bench.reset();
    let [normal_x, normal_y, normal_z] =
        [0, 1, 2].map(|axis| normals.map(|normal| single(normal[axis])));
    let frustum = Frustum { normal_x, normal_y, normal_z };
    let frustum = put(bench, &[frustum]);
    let records = put(bench, spheres);
    let room = list_room(bench, spheres.len());
    let arguments = [frustum.address, records.address, spheres.len() as u32, room.address];
    let end = bench.call("frustum_spheres", &arguments).value;
    let found: Vec<u32> = list(bench, room, end).iter().map(|entry| entry.object.get()).collect();
    let expected: Vec<u32> = (0..spheres.len())
        .filter(|number| {
            let sphere = &spheres[*number];
            reaches_into(normals, sphere.centre.map(bits), bits(sphere.reach))
        })
        .map(|number| address::<Sphere>(records, number))
        .collect();
    assert_eq!(found, expected, "{normals:x?}, {spheres:x?}");
    found.len()
}

#[test]
fn spheres_in_a_frustum_equal_the_twins() {
    let mut random = random();
    let mut bench = Bench::new();
    for inputs in [Inputs::Sensible, Inputs::Any] {
        let (mut passed, mut tried) = (0, 0);
        for _ in 0..40 {
            for count in COUNTS.into_iter().chain([0]) {
                let slope = random.random_range(0.05..0.3);
                let normals = match inputs {
                    Inputs::Sensible => [[1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0]]
                        .map(|[x, y]| unit([x, y, -slope]).map(from_f64)),
                    Inputs::Any => random.random(),
                };
                let spheres = inputs.spheres(&mut random, count);
                passed += check_frustum(&mut bench, &normals, &spheres);
                tried += count;
            }
        }
        assert!(passed * 20 > tried && passed < tried, "{passed} of {tried}");
    }
}

/// Checks `hidden_pairs_r16` on pairs of a sphere at each distance of `near` and the packet with
/// the same index. Returns how many pairs stayed.
fn check_hidden(bench: &mut Bench, packets: &[Packet], near: &[Single]) -> usize {
    bench.reset();
    let addresses = put_packets(bench, packets);
    let spheres: Vec<Sphere> =
        near.iter().map(|near| Sphere { near: single(*near), ..Sphere::new_zeroed() }).collect();
    let spheres = put(bench, &spheres);
    let pairs: Vec<Pair> = addresses
        .iter()
        .enumerate()
        .map(|(number, packet)| {
            eye_records::pair(address::<Sphere>(spheres, number), packet.address)
        })
        .collect();
    let room = put(bench, &pairs);
    let arguments = [room.address, packets.len() as u32];
    let end = bench.call("hidden_pairs_r16", &arguments).value;
    let found = objects_and_packets(&list(bench, room, end));
    let visible = (0..packets.len()).filter(|&number| {
        let t = eye_records::hits(&packets[number]).map(|hit| hit.t);
        !is_hidden(&t, near[number])
    });
    let expected: Vec<Pair> = visible.map(|number| pairs[number]).collect();
    assert_eq!(found, objects_and_packets(&expected), "near {near:x?}");
    found.len()
}

#[test]
fn hidden_pairs_equal_the_twins() {
    let mut random = random();
    let mut bench = Bench::new();
    let (mut stayed, mut tried) = (0, 0);
    for round in 0..60 {
        let any_bits = round % 3 == 0;
        for count in COUNTS.into_iter().chain([0]) {
            let packets: Vec<Packet> = (0..count)
                .map(|_| {
                    let farthest = random.random_range(1.0..4.0);
                    let hits = std::array::from_fn(|_| Hit {
                        t: if any_bits {
                            random.random()
                        } else {
                            from_f64(random.random_range(0.0..farthest))
                        },
                        object: random.random(),
                    });
                    eye_records::packet(&[[0; 3]; 16], &hits)
                })
                .collect();
            let near: Vec<Single> = (0..count)
                .map(|_| {
                    if any_bits { random.random() } else { from_f64(random.random_range(1.0..3.0)) }
                })
                .collect();
            stayed += check_hidden(&mut bench, &packets, &near);
            tried += count;
        }
    }
    assert!(stayed * 4 > tried && stayed * 10 < tried * 9, "{stayed} of {tried}");
}

#[test]
fn one_ray_of_sixteen_is_enough_to_be_seen() {
    let mut bench = Bench::new();
    let near = from_f64(2.0);
    let mut stays = |lane: usize, t| {
        let mut hits = error::NO_HITS.map(|hit| Hit { t: near, ..hit });
        hits[lane].t = t;
        let packet = eye_records::packet(&[[0; 3]; 16], &hits);
        check_hidden(&mut bench, &[packet], &[near]) == 1
    };
    for lane in 0..16 {
        assert!(stays(lane, near + 1) && stays(lane, FARTHEST));
        // The largest possible distance. Such a ray can't hit any part of the sphere.
        assert!(!stays(lane, near - 1) && !stays(lane, near));
    }
}
