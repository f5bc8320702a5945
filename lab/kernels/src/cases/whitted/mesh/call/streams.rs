//! Calls the kernels that take rays through blocks one by one, and the one that checks blocks.

use protocol::layout::{Boxes, MeshBound, MeshCandidate, MeshRay, MeshVisit, RayPacket};
use twins::Single;
use twins::mesh_prepare::{Known, WORDS};
use twins::mesh_rays::{self, Visit};
use twins::primary_rays::Ray;
use zerocopy::big_endian::F32;
use zerocopy::{FromZeros as _, IntoBytes as _};

use crate::bench::{Bench, Place};
use crate::cases::eye::call::{address, put};
use crate::cases::whitted::rays;
use crate::single::{bits, single};

use super::{LOWER, Node, TO_UPPER, boxes};

/// The record of the ray with this number.
fn ray_record(ray: &mesh_rays::MeshRay, number: u32) -> MeshRay {
    let plane = |axis: usize| {
        let lower = LOWER[axis] as u32;
        lower + if ray.down[axis] { TO_UPPER as u32 } else { 0 }
    };
    MeshRay {
        planes: (plane(0) | plane(2) << 24).into(),
        inverse: ray.inverse.map(single),
        number: (plane(1) | (127 - number) << 24).into(),
        near_shift: ray.near_shift.map(single),
        t: single(ray.t),
        far_shift: ray.far_shift.map(single),
    }
}

/// The words of the records of rays.
#[must_use]
pub fn ray_words(rays: &[mesh_rays::MeshRay]) -> Vec<[u32; 12]> {
    let records = rays.iter().zip(0..);
    let records = records.map(|(ray, number)| ray_record(ray, number));
    records.map(|record| record_words(&record)).collect()
}

fn record_words(record: &MeshRay) -> [u32; 12] {
    let mut words = record.as_bytes().chunks(4);
    std::array::from_fn(|_| {
        let word = words.next().and_then(|word| word.try_into().ok());
        u32::from_be_bytes(word.unwrap_or_default())
    })
}

/// Calls `mesh_rays_r16`. Returns the words of the records.
pub fn mesh_rays(bench: &mut Bench, packets: &[[Ray; 16]]) -> Vec<[u32; 12]> {
    bench.reset();
    let (records, arguments) = put_for_rays(bench, packets);
    bench.call("mesh_rays_r16", &arguments);
    let records: Vec<MeshRay> = bench.read_all(records);
    records.iter().map(record_words).collect()
}

/// Puts the inputs of `mesh_rays_r16` into local store. Returns the records' buffer and the
/// arguments.
pub fn put_for_rays(bench: &mut Bench, packets: &[[Ray; 16]]) -> (Place, Vec<u32>) {
    let placed: Vec<RayPacket> = packets.iter().map(rays::call::packet).collect();
    let placed = put(bench, &placed);
    let records = put(bench, &vec![MeshRay::new_zeroed(); 16 * packets.len()]);
    let count = packets.len() as u32;
    (records, vec![placed.address, count, records.address])
}

fn put_bits(bench: &mut Bench, bits: u128) -> Place {
    bench.place(&bits.to_be_bytes())
}

/// Calls `mesh_alive_r16`. Returns the bits that are left.
pub fn alive(bench: &mut Bench, packets: &[[Ray; 16]], near: Single, bits: u128) -> u128 {
    bench.reset();
    let (bits, arguments) = put_for_alive(bench, packets, near, bits);
    bench.call("mesh_alive_r16", &arguments);
    u128::from_be_bytes(bench.read(bits))
}

/// Puts the inputs of `mesh_alive_r16` into local store. Returns the place of the bits and the
/// arguments.
pub fn put_for_alive(
    bench: &mut Bench,
    packets: &[[Ray; 16]],
    near: Single,
    bits: u128,
) -> (Place, Vec<u32>) {
    let placed: Vec<RayPacket> = packets.iter().map(rays::call::packet).collect();
    let placed = put(bench, &placed);
    let bits = put_bits(bench, bits);
    let count = packets.len() as u32;
    (bits, vec![placed.address, count, near, bits.address])
}

/// A batch of rays and a block's nodes in local store, for `mesh_filter_rays` and `mesh_few_rays`.
pub struct Batch {
    /// The nodes.
    pub nodes: u32,
    /// The bits, and space for those of other nodes.
    pub bits: u32,
    /// The rays' records.
    pub records: Place,
    /// The packets.
    pub packets: Place,
    /// A buffer for a list of rays.
    pub list: u32,
}

/// Puts packets, their records, nodes and bits into local store. The records have other distances
/// than the packets, as before they are brought up to date.
pub fn put_batch(bench: &mut Bench, packets: &[[Ray; 16]], nodes: &[Node], bits: u128) -> Batch {
    let nodes: Vec<Boxes> = nodes.iter().map(boxes).collect();
    let records: Vec<MeshRay> = packets
        .iter()
        .flatten()
        .zip(0..)
        .map(|(ray, number)| MeshRay {
            t: 0.5.into(),
            ..ray_record(&mesh_rays::mesh_ray(ray), number)
        })
        .collect();
    let placed: Vec<RayPacket> = packets.iter().map(rays::call::packet).collect();
    let mut buffer = bits.to_be_bytes().to_vec();
    buffer.resize(16 * (nodes.len() + 3), 0x55);
    Batch {
        nodes: put(bench, &nodes).address,
        bits: bench.place(&buffer).address,
        records: put(bench, &records),
        packets: put(bench, &placed),
        list: bench.place(&[0x55; 16 * 131]).address,
    }
}

/// Calls `mesh_filter_rays`. Returns the visits, and how many tests it took.
///
/// # Panics
///
/// Panics if the list ends outside its buffer or within an entry.
pub fn filter_rays(
    bench: &mut Bench,
    packets: &[[Ray; 16]],
    nodes: &[Node],
    bits: u128,
) -> (Vec<Visit>, u32) {
    bench.reset();
    let (buffer, arguments) = put_for_filter(bench, packets, nodes, bits);
    let end = bench.call("mesh_filter_rays", &arguments).value;
    let tests = bench.returned_second();
    let visits: Vec<MeshVisit> = bench.read_all(buffer);
    let count = (end - buffer.address) as usize / size_of::<MeshVisit>();
    assert_eq!(end, address::<MeshVisit>(buffer, count), "the end of the list");
    let visit = |visit: &MeshVisit| {
        assert_eq!([visit.reserved.get(), visit.reserved_2.get()], [0; 2]);
        Visit {
            child: visit.child.get(),
            near: single_of(visit.near),
            rays: visit.rays.iter().fold(0, |rays, word| rays << 32 | u128::from(word.get())),
        }
    };
    (visits[..count].iter().map(visit).collect(), tests)
}

fn single_of(value: F32) -> Single {
    bits(value)
}

/// Puts the inputs of `mesh_filter_rays` into local store. Returns the list's buffer and the
/// arguments.
pub fn put_for_filter(
    bench: &mut Bench,
    packets: &[[Ray; 16]],
    nodes: &[Node],
    bits: u128,
) -> (Place, Vec<u32>) {
    let batch = put_batch(bench, packets, nodes, bits);
    let buffer = put(bench, &vec![MeshVisit::new_zeroed(); 4 * nodes.len() + 3]);
    let arguments = vec![
        batch.nodes,
        nodes.len() as u32,
        batch.bits,
        buffer.address,
        batch.records.address,
        batch.packets.address,
        batch.list,
    ];
    (buffer, arguments)
}

/// The first packet's candidate, and what is added for each further one.
fn steps(bench: &mut Bench, packets: u32, bounds: u32) -> u32 {
    let of = |packet: u32, bound: u32| MeshCandidate {
        object: 0.into(),
        packet: packet.into(),
        bound: bound.into(),
        near: single(0),
    };
    let sizes = of(size_of::<RayPacket>() as u32, size_of::<MeshBound>() as u32);
    put(bench, &[of(packets, bounds), sizes]).address
}

/// Where the bounds of packets would be.
const BOUNDS: u32 = 0x1_2340;

/// Calls `mesh_few_rays`. Returns each candidate's word and the number of its packet.
///
/// # Panics
///
/// Panics if a candidate's bound is not its packet's.
pub fn few_rays(
    bench: &mut Bench,
    packets: &[[Ray; 16]],
    nodes: &[Node],
    bits: u128,
    base: u32,
) -> Vec<(u32, u32)> {
    bench.reset();
    let (first, buffer, arguments) = put_for_few(bench, packets, nodes, bits, base);
    let end = bench.call("mesh_few_rays", &arguments).value;
    candidates_in(bench, first, buffer, end)
}

/// Puts the inputs of `mesh_few_rays` into local store. Returns the address of the packets, the
/// list's buffer and the arguments.
pub fn put_for_few(
    bench: &mut Bench,
    packets: &[[Ray; 16]],
    nodes: &[Node],
    bits: u128,
    base: u32,
) -> (u32, Place, Vec<u32>) {
    let batch = put_batch(bench, packets, nodes, bits);
    let most = 4 * nodes.len() * bits.count_ones() as usize + 3;
    let buffer = put(bench, &vec![MeshCandidate::new_zeroed(); most]);
    let steps = steps(bench, batch.packets.address, BOUNDS);
    let arguments = vec![
        batch.nodes,
        nodes.len() as u32,
        batch.bits,
        buffer.address,
        batch.records.address,
        steps,
        base,
        batch.list,
    ];
    (batch.packets.address, buffer, arguments)
}

fn candidates_in(bench: &Bench, packets: u32, buffer: Place, end: u32) -> Vec<(u32, u32)> {
    let list: Vec<MeshCandidate> = bench.read_all(buffer);
    let count = (end - buffer.address) as usize / size_of::<MeshCandidate>();
    assert_eq!(end, address::<MeshCandidate>(buffer, count), "the end");
    let candidate = |candidate: &MeshCandidate| {
        let packet = (candidate.packet.get() - packets) / size_of::<RayPacket>() as u32;
        let bound = BOUNDS + packet * size_of::<MeshBound>() as u32;
        assert_eq!(candidate.bound.get(), bound, "the bound of packet {packet}");
        (candidate.object.get(), packet)
    };
    list[..count].iter().map(candidate).collect()
}

/// Calls `mesh_candidates`. Returns each candidate's word and the number of its packet.
pub fn candidates(bench: &mut Bench, visits: &[Visit], base: u32) -> Vec<(u32, u32)> {
    bench.reset();
    let (buffer, arguments) = put_for_candidates(bench, visits, base);
    let end = bench.call("mesh_candidates", &arguments).value;
    candidates_in(bench, PACKETS, buffer, end)
}

/// Where the packets of these candidates would be.
const PACKETS: u32 = 0x2_0000;

/// Puts the inputs of `mesh_candidates` into local store. Returns the list's buffer and the
/// arguments.
pub fn put_for_candidates(bench: &mut Bench, visits: &[Visit], base: u32) -> (Place, Vec<u32>) {
    let records: Vec<MeshVisit> = visits
        .iter()
        .map(|visit| MeshVisit {
            child: visit.child.into(),
            reserved: 0.into(),
            near: single(visit.near),
            reserved_2: 0.into(),
            rays: std::array::from_fn(|word| ((visit.rays >> (96 - 32 * word)) as u32).into()),
        })
        .collect();
    let records = put(bench, &records);
    let buffer = vec![MeshCandidate::new_zeroed(); 8 * visits.len() + 7];
    let buffer = put(bench, &buffer);
    let steps = steps(bench, PACKETS, BOUNDS);
    let arguments = vec![records.address, visits.len() as u32, buffer.address, base, steps];
    (buffer, arguments)
}

/// Calls `mesh_prepare` with a block. Returns it as it is afterwards, or `None` if it is damaged.
pub fn prepare(bench: &mut Bench, block: &[u32; WORDS], known: &Known) -> Option<[u32; WORDS]> {
    bench.reset();
    let (place, arguments) = put_block(bench, block, known);
    if bench.call("mesh_prepare", &arguments).value != 0 {
        return None;
    }
    let bytes: Vec<[u8; 4]> = bench.read_all(place);
    Some(std::array::from_fn(|word| u32::from_be_bytes(bytes[word])))
}

/// Puts the inputs of `mesh_prepare` into local store. Returns the block's place and the arguments.
pub fn put_block(bench: &mut Bench, block: &[u32; WORDS], known: &Known) -> (Place, Vec<u32>) {
    let bytes: Vec<u8> = block.iter().flat_map(|word| word.to_be_bytes()).collect();
    let place = bench.place(&bytes);
    let eye: Vec<u8> =
        known.eye.iter().chain([&u32::MAX]).flat_map(|word| word.to_be_bytes()).collect();
    let eye = bench.place(&eye);
    let arguments =
        vec![place.address, known.number, eye.address, known.blocks, known.materials, known.sides];
    (place, arguments)
}
