//! `list_places_p64`, `list_pairs_p64` and `mask_pairs_p64`.

use kernels::bench::{Bench, random};
use kernels::cases::eye::call::put;
use kernels::eye_records;
use protocol::layout::{Packet, Pair, Place};
use rand::Rng as _;
use rand_chacha::ChaCha8Rng;
use twins::lists::{list_pairs, list_places, mask_pairs};
use zerocopy::FromZeros as _;
use zerocopy::big_endian::U32;

use super::COUNTS;

/// The packets of a tile: four groups of sixteen, each with a mask.
const TILE: usize = 64;
const GROUP: usize = 16;

/// No packet, all packets, each one alone, all but each one, and random ones.
fn masks(random: &mut ChaCha8Rng) -> Vec<[u32; 4]> {
    let mut masks = vec![[0; 4], [0xffff; 4]];
    for packet in 0..TILE {
        let alone: [u32; 4] = std::array::from_fn(|group| {
            let own = packet / GROUP == group;
            if own { 1 << (packet % GROUP) } else { 0 }
        });
        masks.extend([alone, alone.map(|mask| mask ^ 0xffff)]);
    }
    masks.extend((0..200).map(|_| std::array::from_fn(|_| random.random_range(0..0x1_0000))));
    masks
}

fn record([packet, pixels, x, y]: [u32; 4]) -> Place {
    Place { packet: packet.into(), pixels: pixels.into(), x: x.into(), y: y.into() }
}

fn words(place: &Place) -> [u32; 4] {
    [place.packet, place.pixels, place.x, place.y].map(U32::get)
}

#[test]
fn listed_places_equal_the_twins() {
    let mut random = random();
    let mut bench = Bench::new();
    for named in masks(&mut random) {
        let places: [[u32; 4]; TILE] = std::array::from_fn(|_| random.random());
        let origin: [u32; 4] = random.random();
        bench.reset();
        let group = put(&mut bench, &places.map(record));
        let first = put(&mut bench, &[record(origin)]);
        let room = put(&mut bench, &[Place::new_zeroed(); TILE + 1]);
        let masks = put(&mut bench, &named.map(U32::new));
        let arguments = [masks.address, group.address, first.address, room.address];
        let end = bench.call("list_places_p64", &arguments).value;
        let found: [Place; TILE + 1] = bench.read(room);

        let expected = list_places(named, &places, origin);
        let bytes = (expected.len() * size_of::<Place>()) as u32;
        assert_eq!(end, room.address + bytes, "masks {named:x?}");
        for (found, expected) in found.iter().zip(&expected) {
            assert_eq!(words(found), *expected, "masks {named:x?}");
        }
    }
}

#[test]
fn listed_pairs_equal_the_twins() {
    let mut random = random();
    let mut bench = Bench::new();
    for named in masks(&mut random) {
        let places: [[u32; 4]; TILE] = std::array::from_fn(|_| random.random());
        let object = random.random();
        bench.reset();
        let group = put(&mut bench, &places.map(record));
        let room = put(&mut bench, &[Pair::new_zeroed(); TILE + 1]);
        let masks = put(&mut bench, &named.map(U32::new));
        let arguments = [masks.address, group.address, object, room.address];
        let end = bench.call("list_pairs_p64", &arguments).value;
        let found: [Pair; TILE + 1] = bench.read(room);

        let expected = list_pairs(named, &places, object);
        let bytes = (expected.len() * size_of::<Pair>()) as u32;
        assert_eq!(end, room.address + bytes, "masks {named:x?}");
        for (found, expected) in found.iter().zip(&expected) {
            let found = [found.object.get(), found.packet.get()];
            assert_eq!(found, *expected, "masks {named:x?}");
        }
    }
}

#[test]
fn masks_of_pairs_equal_the_twins() {
    let mut random = random();
    let mut bench = Bench::new();
    for round in 0..3 * TILE {
        for count in COUNTS.into_iter().chain([0]) {
            // Each packet alone, and then random sets of them.
            let numbers: Vec<usize> = (0..count)
                .map(|_| if round < TILE { round } else { random.random_range(0..TILE) })
                .collect();
            let first = 16 * random.random_range(0..0x2000);
            let pairs: Vec<Pair> = numbers
                .iter()
                .map(|number| {
                    let packet = first + (number * size_of::<Packet>()) as u32;
                    eye_records::pair(random.random(), packet)
                })
                .collect();
            bench.reset();
            let pairs = put(&mut bench, &pairs);
            bench.call("mask_pairs_p64", &[pairs.address, count as u32, first]);
            let found = bench.returned_vector();
            assert_eq!(found, mask_pairs(&numbers), "{numbers:?}");
        }
    }
}
