//! Calls the kernels that only rays from the eye have, and those that make the records of hits.

use protocol::layout::{
    Boxes, MESH_HIT, MESH_LEAF_PLACES, Material, MeshBound, MeshCandidate, MeshHeader, MeshHit,
    MeshLeaf, MeshRows, MeshVertex, MeshWindow, Object, Patch, RayPacket, SIDES_BOTH,
};
use twins::mesh_pairs::MeshBlock;
use twins::mesh_patches::{FlatPatch, flat_patch, list_hits};
use twins::mesh_rows;
use twins::{ONE, Single, sphere_ray};
use zerocopy::big_endian::U32;
use zerocopy::{FromBytes as _, FromZeros as _, IntoBytes as _};

use crate::bench::{Bench, Place};
use crate::cases::eye::call::{address, put};
use crate::cases::whitted::isect;
use crate::single::{bits, single};

use super::{Runs, leaf, put_sheared};

/// The record of a packet's window.
#[must_use]
pub fn window_record(window: &mesh_rows::MeshWindow) -> MeshWindow {
    let limits = |limit: fn(&mesh_rows::RowWindow) -> Single| {
        std::array::from_fn(|lane| single(limit(&window.rows[lane / 4])))
    };
    // A word of the first vertex, and then the same of the second.
    let words = window.axes.map(|axis| {
        let bytes = std::array::from_fn::<u8, 4, _>(|byte| (4 * axis + byte) as u8);
        [bytes, bytes.map(|byte| byte + 16)]
    });
    let nothing = [[0x80; 4]; 2];
    let shuffle = |first: [[u8; 4]; 2], last: [[u8; 4]; 2]| {
        let bytes = [first.concat(), last.concat()].concat();
        std::array::from_fn(|byte| bytes[byte])
    };
    MeshWindow {
        low_x: limits(|row| row.low[0]),
        high_x: limits(|row| row.high[0]),
        low_y: limits(|row| row.low[1]),
        high_y: limits(|row| row.high[1]),
        order: shuffle(words[0], words[1]),
        depth: shuffle(words[2], nothing),
    }
}

/// Puts the inputs of `mesh_eye_bounds_r16` into local store, with shears at `shears`, where
/// nothing needs to be. Returns the bounds' buffer, the windows' and the arguments.
pub fn put_for_eye_bounds(
    bench: &mut Bench,
    packets: &[[sphere_ray::Ray; 16]],
    shears: u32,
) -> (Place, Place, Vec<u32>) {
    let records: Vec<RayPacket> = packets.iter().map(|rays| isect::call::packet(rays, 0)).collect();
    let placed = put(bench, &records);
    let bounds = put(bench, &vec![MeshBound::new_zeroed(); packets.len()]);
    let windows = put(bench, &vec![MeshWindow::new_zeroed(); packets.len()]);
    let count = packets.len() as u32;
    let arguments = vec![placed.address, count, bounds.address, shears, windows.address];
    (bounds, windows, arguments)
}

/// Calls `mesh_eye_bounds_r16`. Returns the records.
pub fn eye_bounds(
    bench: &mut Bench,
    packets: &[[sphere_ray::Ray; 16]],
    shears: u32,
) -> (Vec<MeshBound>, Vec<MeshWindow>) {
    bench.reset();
    let (bounds, windows, arguments) = put_for_eye_bounds(bench, packets, shears);
    bench.call("mesh_eye_bounds_r16", &arguments);
    (bench.read_all(bounds), bench.read_all(windows))
}

/// Some rows of a packet and a triangle that they may hit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Rows {
    /// The triangle's index.
    pub triangle: usize,
    /// Which rows.
    pub rows: [bool; 4],
    /// The packet's number.
    pub packet: usize,
}

impl Rows {
    /// The record, whose packets and bounds are at these addresses.
    fn record(self, packet: u32, bound: u32, anything: u32) -> MeshRows {
        let bits = self.rows.iter().fold(0, |bits, row| bits << 1 | u32::from(*row));
        MeshRows {
            rows: ((self.triangle as u32) << 10 | bits).into(),
            packet: packet.into(),
            bound: bound.into(),
            rest: anything.into(),
        }
    }
}

/// Puts the inputs of `filter_triangles_r16` into local store. A packet's address is its number,
/// its bound's 16 times that. Returns the list's buffer and the arguments.
pub fn put_filter(
    bench: &mut Bench,
    windows: &[mesh_rows::MeshWindow],
    block: &MeshBlock,
    runs: &Runs,
    anything: u32,
) -> (Place, Vec<u32>) {
    let windows: Vec<MeshWindow> = windows.iter().map(window_record).collect();
    let windows = put(bench, &windows);
    let candidate = |(run, packet): &(std::ops::Range<usize>, usize)| MeshCandidate {
        object: (4 * run.start as u32 + ((run.len() as u32) << 16)).into(),
        packet: (*packet as u32).into(),
        bound: (16 * *packet as u32).into(),
        near: single(anything),
    };
    let candidates: Vec<MeshCandidate> = runs.iter().map(candidate).collect();
    let candidates = put(bench, &candidates);
    let block = bench.place(&leaf(block, 3, anything));
    let most: usize = runs.iter().map(|(run, _)| run.len()).sum();
    let buffer = put(bench, &vec![MeshRows::new_zeroed(); most + 1]);
    let arguments =
        vec![candidates.address, runs.len() as u32, block.address, buffer.address, windows.address];
    (buffer, arguments)
}

/// Calls `filter_triangles_r16`. Returns its list, how many rows it has by the kernel's count, and
/// how many triangles were tested.
///
/// # Panics
///
/// Panics if the list ends outside its buffer or within a record, or if a record belongs to
/// no packet of `put_filter`.
pub fn filtered(
    bench: &mut Bench,
    windows: &[mesh_rows::MeshWindow],
    block: &MeshBlock,
    runs: &Runs,
    anything: u32,
) -> (Vec<Rows>, u32, u32) {
    bench.reset();
    let (buffer, arguments) = put_filter(bench, windows, block, runs, anything);
    bench.call("filter_triangles_r16", &arguments);
    let [end, rows, triangles, _] = bench.returned_vector();
    let mut list: Vec<MeshRows> = bench.read_all(buffer);
    let ends = (0..list.len()).find(|at| address::<MeshRows>(buffer, *at) == end);
    list.truncate(ends.unwrap_or_else(|| panic!("no list ends at {end:#x}")));
    let found = list.iter().map(|record| {
        let word = record.rows.get();
        let found = Rows {
            triangle: (word >> 10) as usize,
            rows: std::array::from_fn(|row| word & 8 >> row != 0),
            packet: record.packet.get() as usize,
        };
        let packet = found.packet as u32;
        let expected = found.record(packet, 16 * packet, anything);
        assert_eq!(record.as_bytes(), expected.as_bytes());
        found
    });
    (found.collect(), rows, triangles)
}

/// Puts the inputs of `isect_mesh_rows_r4` into local store. Returns the packets' buffer and the
/// arguments.
pub fn put_rows(
    bench: &mut Bench,
    packets: &[RayPacket],
    block: &MeshBlock,
    rows: &[Rows],
    anything: u32,
) -> (Place, Vec<u32>) {
    let [placed, bounds] = put_sheared(bench, packets, anything);
    let record = |of: &Rows| {
        let packet = address::<RayPacket>(placed, of.packet);
        of.record(packet, address::<MeshBound>(bounds, of.packet), anything)
    };
    let list: Vec<MeshRows> = rows.iter().map(record).collect();
    let list = put(bench, &list);
    let block = bench.place(&leaf(block, 3, anything));
    let count: usize = rows.iter().flat_map(|of| of.rows).map(usize::from).sum();
    (placed, vec![list.address, count as u32, block.address])
}

/// Calls `isect_mesh_rows_r4`. Returns the packets after the call.
pub fn isect_rows(
    bench: &mut Bench,
    packets: &[[sphere_ray::Ray; 16]],
    block: &MeshBlock,
    rows: &[Rows],
    anything: u32,
) -> Vec<RayPacket> {
    bench.reset();
    let records: Vec<RayPacket> =
        packets.iter().map(|rays| isect::call::packet(rays, anything)).collect();
    let (placed, arguments) = put_rows(bench, &records, block, rows, anything);
    bench.call("isect_mesh_rows_r4", &arguments);
    bench.read_all(placed)
}

/// Puts the inputs of `mesh_list_hits_r16` into local store. Returns the packets' buffer, the
/// patches' and the arguments.
pub fn put_for_hits(bench: &mut Bench, objects: &[[u32; 16]]) -> (Place, Place, Vec<u32>) {
    let record = |objects: &[u32; 16]| RayPacket {
        object: objects.map(Into::into),
        ..RayPacket::new_zeroed()
    };
    let packets: Vec<RayPacket> = objects.iter().map(record).collect();
    let placed = put(bench, &packets);
    let patches = put(bench, &vec![Patch::new_zeroed(); 16 * packets.len()]);
    let none = bench.place(&[0; 16]);
    let arguments = vec![placed.address, packets.len() as u32, patches.address, none.address];
    (placed, patches, arguments)
}

/// Calls `mesh_list_hits_r16`, and its twin. Returns what the packets have as their objects and the
/// objects of the patches, of the kernel and of the twin.
///
/// # Panics
///
/// Panics if the list ends outside its buffer or within a patch, or if the words of a patch's first
/// quadword differ.
pub fn hits_listed(bench: &mut Bench, objects: &[[u32; 16]]) -> [(Vec<[u32; 16]>, Vec<u32>); 2] {
    bench.reset();
    let (packets, patches, arguments) = put_for_hits(bench, objects);
    let end = bench.call("mesh_list_hits_r16", &arguments).value;
    let records: Vec<RayPacket> = bench.read_all(packets);
    let mut list: Vec<Patch> = bench.read_all(patches);
    let ends = (0..=list.len()).find(|at| address::<Patch>(patches, *at) == end);
    list.truncate(ends.unwrap_or_else(|| panic!("no patch ends at {end:#x}")));
    let listed = list.iter().map(|patch| {
        let words: [U32; 4] = std::array::from_fn(|word| patch.triangle[word]);
        assert_eq!(words, [words[0]; 4]);
        words[0].get()
    });
    let found =
        (records.iter().map(|record| record.object.map(U32::get)).collect(), listed.collect());
    let mut expected = (Vec::new(), Vec::new());
    for objects in objects {
        let first = address::<Patch>(patches, expected.1.len());
        let (patches, mut listed) = list_hits(objects, first, size_of::<Patch>() as u32);
        expected.0.push(patches);
        expected.1.append(&mut listed);
    }
    [found, expected]
}

/// Puts the inputs of `mesh_flat_patches` into local store: patches of these objects, and leaves.
/// Returns the patches' buffer, the list's and the arguments.
pub fn put_for_patches(
    bench: &mut Bench,
    objects: &[u32],
    leaves: &[MeshBlock],
    anything: u32,
) -> (Place, Place, Vec<u32>) {
    let fours = objects.len().div_ceil(4);
    let mut patches = vec![Patch::new_zeroed(); objects.len() + 3];
    for (patch, object) in patches.iter_mut().zip(objects) {
        patch.triangle[..4].fill((*object).into());
    }
    let patches = put(bench, &patches);
    // Both versions of the kernel must read the same bytes for a leaf that isn't there.
    let nothing = bench.place(&[0; 5000]).address;
    let none = MeshLeaf {
        number: u32::MAX.into(),
        vertices: nothing.into(),
        faces: nothing.into(),
        sides: anything.into(),
    };
    let mut table = [none; MESH_LEAF_PLACES as usize];
    for leaf in leaves {
        let bytes = self::leaf(leaf, 2, anything);
        let place = bench.place(&bytes).address;
        let header = MeshHeader::read_from_prefix(&bytes).expect("a leaf").0;
        let vertices = place as usize + size_of::<MeshHeader>() + 2 * size_of::<Boxes>();
        let faces = vertices + leaf.vertices.len() * size_of::<MeshVertex>();
        table[(leaf.number % MESH_LEAF_PLACES) as usize] = MeshLeaf {
            number: leaf.number.into(),
            vertices: (vertices as u32).into(),
            faces: (faces as u32).into(),
            sides: header.sides,
        };
    }
    let table = put(bench, &table);
    let list = put(bench, &vec![MeshHit::new_zeroed(); objects.len() + 4]);
    let arguments = vec![patches.address, fours as u32, table.address, list.address, MATERIALS];
    (patches, list, arguments)
}

/// Where the mesh's first material is said to be.
const MATERIALS: u32 = 0x1_2340;

/// Calls `mesh_flat_patches`. The leaves' numbers must differ in their last bits. Returns the
/// objects that the kernel's list has and those that it should have, and for each other patch its
/// surface by the kernel and by the twin.
///
/// # Panics
///
/// Panics if the list is not as it should be, or if the rest of a patch's record is wrong.
pub fn flat_patches(
    bench: &mut Bench,
    objects: &[u32],
    leaves: &[MeshBlock],
    anything: u32,
) -> ([Vec<u32>; 2], Vec<[FlatPatch; 2]>) {
    bench.reset();
    let (placed, buffer, arguments) = put_for_patches(bench, objects, leaves, anything);
    let end = bench.call("mesh_flat_patches", &arguments).value;
    let mut list: Vec<MeshHit> = bench.read_all(buffer);
    let ends = (0..=list.len()).find(|at| address::<MeshHit>(buffer, *at) == end);
    list.truncate(ends.unwrap_or_else(|| panic!("no list ends at {end:#x}")));
    let patches: Vec<Patch> = bench.read_all(placed);
    let mut missing = Vec::new();
    let mut made = Vec::new();
    for (at, (object, patch)) in objects.iter().zip(&patches).enumerate() {
        let number = (object & !MESH_HIT) >> 7;
        let leaf = leaves.iter().find(|leaf| leaf.number == number);
        let Some(leaf) = leaf.filter(|_| object & MESH_HIT != 0) else {
            if object & MESH_HIT != 0 {
                let hit = list.get(missing.len()).map(|hit| hit.patch.get());
                assert_eq!(hit, Some(address::<Patch>(placed, at)));
                missing.push(*object);
            }
            continue;
        };
        let found = Object::read_from_prefix(patch.as_bytes()).expect("a record").0;
        let both = if leaf.both { SIDES_BOTH } else { 0 };
        let material = MATERIALS + (anything & 0xff) * size_of::<Material>() as u32;
        assert_eq!(bits(found.gain), 0);
        assert_eq!(bits(found.slope), ONE);
        assert_eq!(bits(found.offset), 0);
        assert_eq!(found.material.get(), material);
        assert_eq!(found.sides.get(), both | anything & !SIDES_BOTH);
        let found = FlatPatch {
            centre: found.centre.map(bits),
            normal: found.axis.map(bits),
            leave: bits(found.leave),
        };
        let index = (object & 127) as usize;
        made.push([found, flat_patch(&leaf.triangle(index).vertices)]);
    }
    let listed = list.iter().map(|hit| hit.object.get()).collect();
    ([listed, missing], made)
}
