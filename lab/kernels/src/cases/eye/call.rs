//! Calls the kernels for primary rays with the inputs of their twins.

use twins::Single;
use twins::isect_pairs::Hit;
use twins::sphere_ray::BareSphere;
use twins::{ray_setup, shade_depth};
use zerocopy::big_endian::U32;
use zerocopy::{FromZeros as _, Immutable, IntoBytes};

use crate::bench::{self, Bench};
use crate::eye_records::{self, Hits, Vectors};
use crate::single::single;
use protocol::layout::{Colours, Packet, Pair, Place, Sphere};

/// Bytes between rows of the pixels that [`pack`] writes. This is more than the width of a packet.
pub const PITCH: usize = 48;

/// Puts records into local store, one after the other.
pub fn put<T: IntoBytes + Immutable>(bench: &mut Bench, records: &[T]) -> bench::Place {
    bench.place(records.as_bytes())
}

/// The address of a record in an array.
#[must_use]
pub fn address<T>(array: bench::Place, number: usize) -> u32 {
    array.address + (number * size_of::<T>()) as u32
}

/// Puts packets into local store, each between guards.
pub fn put_packets(bench: &mut Bench, packets: &[Packet]) -> Vec<bench::Place> {
    let each = packets.iter().map(|packet| bench.place(packet.as_bytes()));
    each.collect()
}

/// Puts the places of these packets into local store. `fill` sets the other fields.
pub fn put_places(
    bench: &mut Bench,
    packets: &[bench::Place],
    fill: impl Fn(usize) -> [u32; 3],
) -> bench::Place {
    let place = |(number, packet): (usize, &bench::Place)| {
        let [pixels, x, y] = fill(number).map(U32::new);
        Place { packet: packet.address.into(), pixels, x, y }
    };
    let places: Vec<Place> = packets.iter().enumerate().map(place).collect();
    put(bench, &places)
}

/// Room for a list of pairs, and for one more pair that may be written after it.
pub fn list_room(bench: &mut Bench, pairs: usize) -> bench::Place {
    put(bench, &vec![Pair::new_zeroed(); pairs + 1])
}

/// The pairs of a list that begins in `room` and ends at the address that a kernel returned.
///
/// # Panics
///
/// Panics if the address is not a possible end of such a list.
#[must_use]
pub fn list(bench: &Bench, room: bench::Place, end: u32) -> Vec<Pair> {
    let mut pairs: Vec<Pair> = bench.read_all(room);
    let count = (0..=pairs.len()).find(|number| address::<Pair>(room, *number) == end);
    pairs.truncate(count.unwrap_or_else(|| panic!("no list ends at {end:#x}")));
    pairs
}

/// `ray_setup_r16`: returns the packets whose top left pixels are at `pixels`.
pub fn ray_setup(
    bench: &mut Bench,
    basis: &ray_setup::Basis,
    pixels: &[[u32; 2]],
    background: u32,
) -> Vec<Packet> {
    bench.reset();
    let basis = put(bench, &[eye_records::basis(basis)]);
    let packets: Vec<bench::Place> = pixels.iter().map(|_| bench.junk::<Packet>()).collect();
    let places = put_places(bench, &packets, |number| {
        let [x, y] = pixels[number];
        [0, x, y]
    });
    let count = pixels.len() as u32;
    bench.call("ray_setup_r16", &[basis.address, places.address, count, background]);
    packets.iter().map(|packet| bench.read(*packet)).collect()
}

/// Calls `isect_pairs_r16`, or the kernel of another formulation, on pairs of a sphere and a
/// packet, both given by number. Returns the packets and the addresses of the spheres' records,
/// which identify the objects.
pub fn isect_pairs(
    bench: &mut Bench,
    kernel: &str,
    packets: &[Packet],
    spheres: &[Sphere],
    pairs: &[[usize; 2]],
) -> (Vec<Packet>, Vec<u32>) {
    bench.reset();
    let packets = put_packets(bench, packets);
    let records = put(bench, spheres);
    let objects: Vec<u32> =
        (0..spheres.len()).map(|number| address::<Sphere>(records, number)).collect();
    let list: Vec<_> = pairs
        .iter()
        .map(|&[sphere, packet]| eye_records::pair(objects[sphere], packets[packet].address))
        .collect();
    let list = put(bench, &list);
    bench.call(kernel, &[list.address, pairs.len() as u32]);
    let packets = packets.iter().map(|packet| bench.read(*packet));
    (packets.collect(), objects)
}

/// Calls `shade_depth_r16` on packets whose hits have indices into `colours` as objects. The first
/// colour is the background's. Returns the colours, and the number of rays in each lane that hit
/// something.
pub fn shade_depth(
    bench: &mut Bench,
    hits: &[Hits],
    colours: &[[Single; 3]],
    depth: shade_depth::Depth,
) -> (Vec<Vectors>, [u32; 4]) {
    bench.reset();
    let nothing = eye_records::sphere(&BareSphere { centre: [0; 3], radius_squared: 0 });
    let records: Vec<Sphere> = colours
        .iter()
        .map(|colour| Sphere {
            colour: colour.map(single),
            // Any value, because it has no effect on the colour.
            distance: single(u32::MAX),
            ..nothing
        })
        .collect();
    let records = put(bench, &records);
    let packets: Vec<Packet> = hits
        .iter()
        .map(|hits| {
            let hits = hits
                .map(|hit| Hit { object: address::<Sphere>(records, hit.object as usize), ..hit });
            eye_records::packet(&[[0; 3]; 16], &hits)
        })
        .collect();
    let packets = put_packets(bench, &packets);
    let places = put_places(bench, &packets, |_| [0; 3]);
    let depth = put(bench, &[eye_records::depth(depth)]);
    let shaded = bench.place(&vec![0x55; size_of::<Colours>() * hits.len()]);
    let count = hits.len() as u32;
    let arguments = [places.address, count, depth.address, shaded.address, records.address];
    bench.call("shade_depth_r16", &arguments);
    let shaded: Vec<Colours> = bench.read_all(shaded);
    let shaded = shaded.iter().map(eye_records::colour_vectors).collect();
    (shaded, bench.returned_vector())
}

/// `pack_r16`: returns the words of packets with these colours.
///
/// # Panics
///
/// Panics if the kernel writes a byte outside the pixels.
pub fn pack(bench: &mut Bench, colours: &[Vectors], shifts: [u32; 3]) -> Vec<[u32; 16]> {
    const JUNK: u8 = 0x55;
    bench.reset();
    let records: Vec<Colours> = colours.iter().map(eye_records::colours).collect();
    let records = put(bench, &records);
    let shuffle = put(bench, &[eye_records::pixel_shuffle(shifts)]);
    let rows: Vec<bench::Place> = colours.iter().map(|_| bench.place(&[JUNK; 4 * PITCH])).collect();
    let places = put_places(bench, &rows, |number| [rows[number].address, 0, 0]);
    let count = colours.len() as u32;
    let arguments = [places.address, count, records.address, shuffle.address, PITCH as u32];
    bench.call("pack_r16", &arguments);
    let words = |rows: &bench::Place| {
        let rows: [[u8; PITCH]; 4] = bench.read(*rows);
        let beside = rows.iter().flat_map(|row| &row[16..]);
        assert!(beside.into_iter().all(|byte| *byte == JUNK), "pack_r16 wrote beside the pixels");
        std::array::from_fn(|lane| {
            let first = lane % 4 * 4;
            let bytes = &rows[lane / 4][first..first + 4];
            u32::from_be_bytes(bytes.try_into().expect("four bytes"))
        })
    };
    rows.iter().map(words).collect()
}
