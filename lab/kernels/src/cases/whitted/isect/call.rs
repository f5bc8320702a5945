//! Calls the kernels that intersect candidates with the inputs of their twins.

use twins::sphere_ray::Ray;
use zerocopy::FromZeros as _;
use zerocopy::big_endian::U32;

use super::shape::Shape;
use crate::bench::{self, Bench};
use crate::cases::eye::call::{address, put};
use crate::single::{bits, single};
use protocol::layout::{Candidate, RayPacket, Shear};

/// The packet of these rays. `anything` fills the fields that no intersector reads.
#[must_use]
pub fn packet(rays: &[Ray; 16], anything: u32) -> RayPacket {
    let mut packet = RayPacket::new_zeroed();
    for (lane, ray) in rays.iter().enumerate() {
        [packet.origin_x[lane], packet.origin_y[lane], packet.origin_z[lane]] =
            ray.origin.map(single);
        [packet.direction_x[lane], packet.direction_y[lane], packet.direction_z[lane]] =
            ray.direction.map(single);
        packet.t[lane] = single(ray.t);
        packet.object[lane] = ray.object.into();
        packet.weight[lane] = single(anything);
        packet.pixel[lane] = anything.into();
    }
    packet
}

/// The rays of a packet.
#[must_use]
pub fn rays(packet: &RayPacket) -> [Ray; 16] {
    let origins = [packet.origin_x, packet.origin_y, packet.origin_z];
    let directions = [packet.direction_x, packet.direction_y, packet.direction_z];
    std::array::from_fn(|lane| Ray {
        origin: origins.map(|axis| bits(axis[lane])),
        direction: directions.map(|axis| bits(axis[lane])),
        t: bits(packet.t[lane]),
        object: packet.object[lane].get(),
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
    let shears = S::SHEARED.then(|| {
        let shears = bench.place(&vec![0x55; size_of::<Shear>() * packets.len()]);
        let count = packets.len() as u32;
        bench.call("shear_packets_r16", &[placed.address, count, shears.address]);
        shears
    });
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
