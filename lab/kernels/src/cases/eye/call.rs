//! Puts records and lists into local store for kernels, and reads lists.

use zerocopy::Immutable;

use crate::bench;
use crate::prelude::*;
use protocol::layout::{Packet, Pair, Place};

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

/// A buffer for a list of pairs, and for one more pair that may be written after it.
pub fn list_buffer(bench: &mut Bench, pairs: usize) -> bench::Place {
    put(bench, &vec![Pair::new_zeroed(); pairs + 1])
}
