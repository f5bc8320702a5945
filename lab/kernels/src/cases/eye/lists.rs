//! The kernels that turn masks of a tile's packets into lists, and lists into masks.

use twins::lists::{list_pairs, list_places, mask_pairs};

use super::call::put;
use crate::eye_records;
use crate::prelude::*;
use protocol::layout::{Packet, Pair};

/// The packets of a tile: four groups of sixteen, each with a mask.
const TILE: usize = 64;
const GROUP: usize = 16;

/// No packet, all packets, each one alone, and all but each one, by number.
fn masks(number: usize) -> [u32; 4] {
    let Some(packet) = number.checked_sub(2) else { return [0xffff * number as u32; 4] };
    let all_but = if packet < TILE { 0 } else { 0xffff };
    let packet = packet % TILE;
    std::array::from_fn(|group| {
        let alone = if packet / GROUP == group { 1 << (packet % GROUP) } else { 0 };
        alone ^ all_but
    })
}

fn any_masks(random: &mut ChaCha8Rng) -> [u32; 4] {
    [(); 4].map(|()| random.random_range(0..0x1_0000))
}

/// The records of a list of places, or of pairs, which begins in `buffer` and ends at `end`.
fn records<const WORDS: usize>(bench: &Bench, buffer: Place, end: u32) -> Vec<[u32; WORDS]> {
    let records = bench.read_list::<[U32; 4]>(buffer, end).into_iter();
    records.map(|record| std::array::from_fn(|word| record[word].get())).collect()
}

/// The packets of a tile by their places, the masks that select some, and a word or place that
/// goes into each record of the list.
#[derive(Clone, Debug)]
pub struct ListPlaces {
    /// The masks.
    pub named: [u32; 4],
    /// The places.
    pub places: [[u32; 4]; TILE],
    /// The place of the tile.
    pub origin: [u32; 4],
}

fn put_tile(bench: &mut Bench, named: [u32; 4], places: &[[u32; 4]]) -> [Place; 3] {
    let group: Vec<_> = places.iter().map(|place| place.map(U32::new)).collect();
    let group = put(bench, &group);
    let masks = put(bench, &[named.map(U32::new)]);
    let buffer = bench.place(&[0; size_of::<layout::Place>() * (TILE + 1)]);
    [masks, group, buffer]
}

impl Description for ListPlaces {
    const KERNEL: &'static str = "list_places_p64";
    const ROUNDS: [usize; 2] = [1, 200];
    type Placed = Place;
    type Found = Vec<[u32; 4]>;

    fn lengths() -> impl Iterator<Item = usize> {
        0..2 + 2 * TILE
    }

    fn sensible(number: usize, random: &mut ChaCha8Rng) -> Self {
        Self { named: masks(number), ..Self::any(0, random) }
    }

    fn any(_: usize, random: &mut ChaCha8Rng) -> Self {
        let places = [(); TILE].map(|()| random.random());
        Self { named: any_masks(random), places, origin: random.random() }
    }

    fn place(&self, bench: &mut Bench) -> (Place, Vec<u32>) {
        let [masks, group, buffer] = put_tile(bench, self.named, &self.places);
        let origin = put(bench, &self.origin.map(U32::new));
        (buffer, vec![masks.address, group.address, origin.address, buffer.address])
    }

    fn found(&self, bench: &Bench, buffer: &Place, end: u32) -> Self::Found {
        records(bench, *buffer, end)
    }

    fn twin(&self, _: &Place) -> Self::Found {
        list_places(self.named, &self.places, self.origin)
    }
}

/// The same for pairs with an object.
#[derive(Clone, Debug)]
pub struct ListPairs {
    /// The masks.
    pub named: [u32; 4],
    /// The places.
    pub places: [[u32; 4]; TILE],
    /// The object.
    pub object: u32,
}

impl Description for ListPairs {
    const KERNEL: &'static str = "list_pairs_p64";
    const ROUNDS: [usize; 2] = ListPlaces::ROUNDS;
    type Placed = Place;
    type Found = Vec<[u32; 2]>;

    fn lengths() -> impl Iterator<Item = usize> {
        ListPlaces::lengths()
    }

    fn sensible(number: usize, random: &mut ChaCha8Rng) -> Self {
        Self { named: masks(number), ..Self::any(0, random) }
    }

    fn any(_: usize, random: &mut ChaCha8Rng) -> Self {
        let places = [(); TILE].map(|()| random.random());
        Self { named: any_masks(random), places, object: random.random() }
    }

    fn place(&self, bench: &mut Bench) -> (Place, Vec<u32>) {
        let [masks, group, buffer] = put_tile(bench, self.named, &self.places);
        (buffer, vec![masks.address, group.address, self.object, buffer.address])
    }

    fn found(&self, bench: &Bench, buffer: &Place, end: u32) -> Self::Found {
        records(bench, *buffer, end)
    }

    fn twin(&self, _: &Place) -> Self::Found {
        list_pairs(self.named, &self.places, self.object)
    }
}

/// Pairs of packets of a tile, by the packets' numbers.
#[derive(Clone, Debug)]
pub struct MaskPairs {
    /// The numbers.
    pub numbers: Vec<usize>,
    /// The address of the first packet.
    pub first: u32,
    /// Fills the pairs' objects.
    pub object: u32,
}

impl Description for MaskPairs {
    const KERNEL: &'static str = "mask_pairs_p64";
    /// For each packet alone, too.
    const ROUNDS: [usize; 2] = [2 * TILE, TILE];
    const LENGTHS: &'static [usize] = LENGTHS_FROM_0;
    type Placed = ();
    type Found = [u32; 4];

    fn sensible(count: usize, random: &mut ChaCha8Rng) -> Self {
        let numbers = (0..count).map(|_| random.random_range(0..TILE)).collect();
        Self { numbers, first: 16 * random.random_range(0..0x2000), object: random.random() }
    }

    /// One packet several times.
    fn any(_: usize, random: &mut ChaCha8Rng) -> Self {
        let numbers = vec![random.random_range(0..TILE); random.random_range(1..40)];
        Self { numbers, ..Self::sensible(0, random) }
    }

    fn place(&self, bench: &mut Bench) -> ((), Vec<u32>) {
        let pair = |number: &usize| {
            let packet = self.first + (number * size_of::<Packet>()) as u32;
            eye_records::pair(self.object, packet)
        };
        let pairs: Vec<Pair> = self.numbers.iter().map(pair).collect();
        let pairs = put(bench, &pairs).address;
        ((), vec![pairs, self.numbers.len() as u32, self.first])
    }

    fn found(&self, bench: &Bench, (): &(), _: u32) -> [u32; 4] {
        bench.returned_vector()
    }

    fn twin(&self, (): &()) -> [u32; 4] {
        mask_pairs(&self.numbers)
    }
}
