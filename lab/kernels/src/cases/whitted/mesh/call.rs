//! Calls these kernels with the inputs of their twins.

use protocol::layout::{
    Boxes, MESH_BLOCK, MESH_HIT, MESH_LEAF, MESH_LEAF_PLACES, MESH_MAGIC, Material, MeshBound,
    MeshCandidate, MeshFace, MeshHeader, MeshHit, MeshLeaf, MeshRay, MeshRows, MeshVertex,
    MeshVisit, MeshWindow, Object, Patch, RayPacket, SIDES_BOTH, Shear,
};
use twins::mesh::{self, Corners, Slab};
use twins::mesh_pairs::MeshBlock;
use twins::mesh_patches::{FlatPatch, flat_patch, list_hits};
use twins::mesh_prepare::{Known, WORDS};
use twins::mesh_rays::{self, Visit};
use twins::mesh_rows;
use twins::primary_rays::Ray;
use twins::{ONE, Single, sphere_ray};
use zerocopy::big_endian::{F32, U16, U32};
use zerocopy::{FromBytes as _, FromZeros as _, IntoBytes as _};

use crate::bench::{Bench, Place};
use crate::cases::eye::call::{address, put};
use crate::cases::whitted::{isect, rays};
use crate::single::{bits, single};

/// A node, or what takes its place in a test: four boxes and their words.
#[derive(Clone, Copy, Debug)]
pub struct Node {
    /// The boxes.
    pub boxes: [Corners; 4],
    /// The children's words.
    pub words: [u32; 4],
}

/// Offsets in `BOXES` of the lower corners' planes.
const LOWER: [usize; 3] = [
    std::mem::offset_of!(Boxes, lo_x),
    std::mem::offset_of!(Boxes, lo_y),
    std::mem::offset_of!(Boxes, lo_z),
];
/// From these to the upper ones'.
const TO_UPPER: usize = std::mem::offset_of!(Boxes, hi_x);

/// The record of a node.
#[must_use]
pub fn boxes(node: &Node) -> Boxes {
    let plane = |corner: usize, axis: usize| node.boxes.map(|of| single(of[corner][axis]));
    Boxes {
        lo_x: plane(0, 0),
        lo_y: plane(0, 1),
        lo_z: plane(0, 2),
        hi_x: plane(1, 0),
        hi_y: plane(1, 1),
        hi_z: plane(1, 2),
        child: node.words.map(Into::into),
    }
}

/// The record of a packet's bound.
#[must_use]
pub fn bound_record(bound: &mesh::MeshBound, shears: u32) -> MeshBound {
    let splat = |value: fn(&Slab) -> Single| bound.slabs.map(|slab| [single(value(&slab)); 4]);
    let [near_scale_x, near_scale_y, near_scale_z] = splat(|slab| slab.near_scale);
    let [near_shift_x, near_shift_y, near_shift_z] = splat(|slab| slab.near_shift);
    let [far_scale_x, far_scale_y, far_scale_z] = splat(|slab| slab.far_scale);
    let [far_shift_x, far_shift_y, far_shift_z] = splat(|slab| slab.far_shift);
    let [near_plane_x, near_plane_y, near_plane_z] = std::array::from_fn(|axis| {
        let up = LOWER[axis] as u16;
        let to_upper = TO_UPPER as u16;
        U16::new(up + if bound.slabs[axis].down { to_upper } else { 0 })
    });
    MeshBound {
        near_scale_x,
        near_scale_y,
        near_scale_z,
        near_shift_x,
        near_shift_y,
        near_shift_z,
        far_scale_x,
        far_scale_y,
        far_scale_z,
        far_shift_x,
        far_shift_y,
        far_shift_z,
        slack: U16::new((bound.slack >> 16) as u16),
        near_plane_x,
        near_plane_y,
        near_plane_z,
        shears: shears.into(),
        farthest: single(bound.farthest),
    }
}

/// The bound in a record, and the address of the shears.
///
/// # Panics
///
/// Panics if the lanes of a value differ, or if an offset is that of no plane.
#[must_use]
pub fn bound(record: &MeshBound) -> (mesh::MeshBound, u32) {
    let one = |lanes: [F32; 4]| {
        let lanes = lanes.map(bits);
        assert_eq!(lanes, [lanes[0]; 4], "lanes of a bound");
        lanes[0]
    };
    let near_scale = [
        record.near_scale_x,
        record.near_scale_y,
        record.near_scale_z,
    ]
    .map(one);
    let near_shift = [
        record.near_shift_x,
        record.near_shift_y,
        record.near_shift_z,
    ]
    .map(one);
    let far_scale = [record.far_scale_x, record.far_scale_y, record.far_scale_z].map(one);
    let far_shift = [record.far_shift_x, record.far_shift_y, record.far_shift_z].map(one);
    let planes = [
        record.near_plane_x,
        record.near_plane_y,
        record.near_plane_z,
    ];
    let slabs = std::array::from_fn(|axis| {
        let plane = usize::from(planes[axis].get());
        let down = plane == LOWER[axis] + TO_UPPER;
        assert!(down || plane == LOWER[axis], "plane {plane} of axis {axis}");
        Slab {
            down,
            near_scale: near_scale[axis],
            near_shift: near_shift[axis],
            far_scale: far_scale[axis],
            far_shift: far_shift[axis],
        }
    });
    let bound = mesh::MeshBound {
        slabs,
        slack: u32::from(record.slack.get()) << 16,
        farthest: bits(record.farthest),
    };
    (bound, record.shears.get())
}

/// Puts the inputs of `mesh_bounds_r16` into local store, with shears at `shears`, where nothing
/// needs to be. Returns the bounds' buffer and the arguments; the first three are those of
/// `mesh_farthest_r16`.
pub fn put_for_bounds(
    bench: &mut Bench,
    packets: &[[Ray; 16]],
    before: &[MeshBound],
    shears: u32,
) -> (Place, Vec<u32>) {
    let records: Vec<RayPacket> = packets.iter().map(rays::call::packet).collect();
    let records = put(bench, &records);
    let bounds = put(bench, before);
    let count = packets.len() as u32;
    (bounds, vec![records.address, count, bounds.address, shears])
}

/// Calls `mesh_bounds_r16`. Returns the bounds, each with the address of its shears.
pub fn bounds(
    bench: &mut Bench,
    packets: &[[Ray; 16]],
    shears: u32,
) -> Vec<(mesh::MeshBound, u32)> {
    bench.reset();
    let before = vec![MeshBound::new_zeroed(); packets.len()];
    let (bounds, arguments) = put_for_bounds(bench, packets, &before, shears);
    bench.call("mesh_bounds_r16", &arguments);
    bench.read_all(bounds).iter().map(bound).collect()
}

/// Calls `mesh_farthest_r16` with these bounds. Returns them as it leaves them.
pub fn farthest(
    bench: &mut Bench,
    packets: &[[Ray; 16]],
    bounds: &[mesh::MeshBound],
    shears: u32,
) -> Vec<(mesh::MeshBound, u32)> {
    bench.reset();
    let before: Vec<MeshBound> = bounds
        .iter()
        .map(|bound| bound_record(bound, shears))
        .collect();
    let (bounds, arguments) = put_for_bounds(bench, packets, &before, shears);
    bench.call("mesh_farthest_r16", &arguments[..3]);
    bench.read_all(bounds).iter().map(bound).collect()
}

/// The inputs of `cull_boxes` and `filter_boxes_r16`.
pub struct Candidates {
    /// The arguments.
    pub arguments: Vec<u32>,
    /// The candidates' words: object, packet, bound, near.
    pub given: Vec<[u32; 4]>,
    /// The buffer for the list.
    pub room: Place,
}

/// Puts nodes, packets, their bounds and candidates into local store. Each candidate is a node and
/// a packet, given by number. Its near distance is its own number.
pub fn put_candidates(
    bench: &mut Bench,
    nodes: &[Node],
    packets: &[([Ray; 16], mesh::MeshBound)],
    pairs: &[[usize; 2]],
    base: u32,
) -> Candidates {
    let nodes: Vec<Boxes> = nodes.iter().map(boxes).collect();
    let nodes = put(bench, &nodes);
    let bounds: Vec<MeshBound> = packets
        .iter()
        .map(|(_, bound)| bound_record(bound, u32::MAX))
        .collect();
    let bounds = put(bench, &bounds);
    let packets: Vec<RayPacket> = packets
        .iter()
        .map(|(rays, _)| rays::call::packet(rays))
        .collect();
    let packets = put(bench, &packets);
    let candidate = |(number, &[node, packet]): (usize, &[usize; 2])| MeshCandidate {
        object: address::<Boxes>(nodes, node).into(),
        packet: address::<RayPacket>(packets, packet).into(),
        bound: address::<MeshBound>(bounds, packet).into(),
        near: single(number as u32),
    };
    let given: Vec<MeshCandidate> = pairs.iter().enumerate().map(candidate).collect();
    let list = put(bench, &given);
    let room = vec![MeshCandidate::new_zeroed(); 4 * pairs.len() + 3];
    let room = put(bench, &room);
    Candidates {
        arguments: vec![list.address, given.len() as u32, room.address, base],
        given: given.iter().map(words).collect(),
        room,
    }
}

fn words(candidate: &MeshCandidate) -> [u32; 4] {
    [
        candidate.object.get(),
        candidate.packet.get(),
        candidate.bound.get(),
        bits(candidate.near),
    ]
}

/// Calls `cull_boxes` or `filter_boxes_r16`. Returns the candidates that it gets, and its list.
///
/// # Panics
///
/// Panics if the list ends outside its buffer or within an entry.
pub fn listed(
    bench: &mut Bench,
    kernel: &str,
    nodes: &[Node],
    packets: &[([Ray; 16], mesh::MeshBound)],
    pairs: &[[usize; 2]],
    base: u32,
) -> [Vec<[u32; 4]>; 2] {
    bench.reset();
    let placed = put_candidates(bench, nodes, packets, pairs, base);
    let end = bench.call(kernel, &placed.arguments).value;
    let mut list: Vec<MeshCandidate> = bench.read_all(placed.room);
    let ends = (0..=4 * pairs.len()).find(|at| address::<MeshCandidate>(placed.room, *at) == end);
    list.truncate(ends.unwrap_or_else(|| panic!("no list ends at {end:#x}")));
    [placed.given, list.iter().map(words).collect()]
}

/// The bytes of a leaf block, as they are in local store. The fields that no kernel reads are
/// `anything`.
///
/// # Panics
///
/// Panics if the triangles do not fit.
#[must_use]
pub fn leaf(block: &MeshBlock, nodes: u32, anything: u32) -> Vec<u8> {
    let both = if block.both { SIDES_BOTH } else { 0 };
    let header = MeshHeader {
        magic: MESH_MAGIC.into(),
        number: block.number.into(),
        kind: MESH_LEAF.into(),
        levels: 1.into(),
        nodes: nodes.into(),
        triangles: (block.faces.len() as u32).into(),
        vertices: (block.vertices.len() as u32).into(),
        sides: (both | anything & !SIDES_BOTH).into(),
    };
    let vertex = |position: &[Single; 3]| MeshVertex {
        position: position.map(single),
        normal: anything.into(),
    };
    let face = |vertex: &[u8; 3]| MeshFace {
        vertex: *vertex,
        material: anything as u8,
    };
    let vertices: Vec<MeshVertex> = block.vertices.iter().map(vertex).collect();
    let faces: Vec<MeshFace> = block.faces.iter().map(face).collect();
    let mut bytes = header.as_bytes().to_vec();
    bytes.resize(bytes.len() + nodes as usize * size_of::<Boxes>(), 0x55);
    bytes.extend(vertices.as_bytes());
    bytes.extend(faces.as_bytes());
    assert!(bytes.len() <= MESH_BLOCK as usize, "{} bytes", bytes.len());
    bytes.resize(MESH_BLOCK as usize, 0);
    bytes
}

/// Runs of a block's triangles, each with the number of the packet to test.
pub type Runs = [(std::ops::Range<usize>, usize)];

/// Puts packets and their shears into local store, and bounds with nothing but the shears' addresses.
/// Returns the packets' buffer and the bounds'.
fn put_sheared(bench: &mut Bench, packets: &[RayPacket], anything: u32) -> [Place; 2] {
    let count = packets.len() as u32;
    let placed = put(bench, packets);
    let shears = bench.place(&vec![0x55; size_of::<Shear>() * packets.len()]);
    let sheared = [placed.address, count, shears.address];
    bench.call("shear_packets_r16", &sheared);
    let bounds: Vec<MeshBound> = (0..packets.len())
        .map(|packet| MeshBound {
            shears: address::<Shear>(shears, packet).into(),
            farthest: single(anything),
            ..MeshBound::new_zeroed()
        })
        .collect();
    [placed, put(bench, &bounds)]
}

/// Puts packets, their shears and bounds, a block and candidates into local store. Returns the
/// packets' buffer and the arguments of `isect_mesh_pairs_r16`.
pub fn put_runs(
    bench: &mut Bench,
    packets: &[RayPacket],
    block: &MeshBlock,
    runs: &Runs,
    anything: u32,
) -> (Place, Vec<u32>) {
    let [placed, bounds] = put_sheared(bench, packets, anything);
    let candidate = |(run, packet): &(std::ops::Range<usize>, usize)| MeshCandidate {
        object: (4 * run.start as u32 + ((run.len() as u32) << 16)).into(),
        packet: address::<RayPacket>(placed, *packet).into(),
        bound: address::<MeshBound>(bounds, *packet).into(),
        near: single(anything),
    };
    let candidates: Vec<MeshCandidate> = runs.iter().map(candidate).collect();
    let candidates = put(bench, &candidates);
    let block = bench.place(&leaf(block, 3, anything));
    let arguments = vec![candidates.address, runs.len() as u32, block.address];
    (placed, arguments)
}

/// Calls `isect_mesh_pairs_r16`. Returns the packets after the call.
pub fn isect_runs(
    bench: &mut Bench,
    packets: &[[sphere_ray::Ray; 16]],
    block: &MeshBlock,
    runs: &Runs,
    anything: u32,
) -> Vec<RayPacket> {
    bench.reset();
    let records: Vec<RayPacket> = packets
        .iter()
        .map(|rays| isect::call::packet(rays, anything))
        .collect();
    let (placed, arguments) = put_runs(bench, &records, block, runs, anything);
    bench.call("isect_mesh_pairs_r16", &arguments);
    bench.read_all(placed)
}

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

/// Puts the inputs of `mesh_eye_bounds_r16` into local store, with shears at `shears`, where nothing
/// needs to be. Returns the bounds' buffer, the windows' and the arguments.
pub fn put_for_eye_bounds(
    bench: &mut Bench,
    packets: &[[sphere_ray::Ray; 16]],
    shears: u32,
) -> (Place, Place, Vec<u32>) {
    let records: Vec<RayPacket> = packets
        .iter()
        .map(|rays| isect::call::packet(rays, 0))
        .collect();
    let placed = put(bench, &records);
    let bounds = put(bench, &vec![MeshBound::new_zeroed(); packets.len()]);
    let windows = put(bench, &vec![MeshWindow::new_zeroed(); packets.len()]);
    let count = packets.len() as u32;
    let arguments = vec![
        placed.address,
        count,
        bounds.address,
        shears,
        windows.address,
    ];
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
        let bits = self
            .rows
            .iter()
            .fold(0, |bits, row| bits << 1 | u32::from(*row));
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
    let room = put(bench, &vec![MeshRows::new_zeroed(); most + 1]);
    let arguments = vec![
        candidates.address,
        runs.len() as u32,
        block.address,
        room.address,
        windows.address,
    ];
    (room, arguments)
}

/// Calls `filter_triangles_r16`. Returns its list, how many rows it has by the kernel's count, and
/// how many triangles were tested.
///
/// # Panics
///
/// Panics if the list ends outside its buffer or within a record, or if a record is none of a
/// packet of `put_filter`.
pub fn filtered(
    bench: &mut Bench,
    windows: &[mesh_rows::MeshWindow],
    block: &MeshBlock,
    runs: &Runs,
    anything: u32,
) -> (Vec<Rows>, u32, u32) {
    bench.reset();
    let (room, arguments) = put_filter(bench, windows, block, runs, anything);
    bench.call("filter_triangles_r16", &arguments);
    let [end, rows, triangles, _] = bench.returned_vector();
    let mut list: Vec<MeshRows> = bench.read_all(room);
    let ends = (0..list.len()).find(|at| address::<MeshRows>(room, *at) == end);
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
    let records: Vec<RayPacket> = packets
        .iter()
        .map(|rays| isect::call::packet(rays, anything))
        .collect();
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
    let arguments = vec![
        placed.address,
        packets.len() as u32,
        patches.address,
        none.address,
    ];
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
    let found = (
        records
            .iter()
            .map(|record| record.object.map(U32::get))
            .collect(),
        listed.collect(),
    );
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
    // What is read of a leaf that isn't there must be the same for both versions of the kernel.
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
    let arguments = vec![
        patches.address,
        fours as u32,
        table.address,
        list.address,
        MATERIALS,
    ];
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
    let (placed, room, arguments) = put_for_patches(bench, objects, leaves, anything);
    let end = bench.call("mesh_flat_patches", &arguments).value;
    let mut list: Vec<MeshHit> = bench.read_all(room);
    let ends = (0..=list.len()).find(|at| address::<MeshHit>(room, *at) == end);
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
        let found = Object::read_from_prefix(patch.as_bytes())
            .expect("a record")
            .0;
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
    /// The bits, and room for those of other nodes.
    pub bits: u32,
    /// The rays' records.
    pub records: Place,
    /// The packets.
    pub packets: Place,
    /// Room for a list of rays.
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
    let mut room = bits.to_be_bytes().to_vec();
    room.resize(16 * (nodes.len() + 3), 0x55);
    Batch {
        nodes: put(bench, &nodes).address,
        bits: bench.place(&room).address,
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
    let (room, arguments) = put_for_filter(bench, packets, nodes, bits);
    let end = bench.call("mesh_filter_rays", &arguments).value;
    let tests = bench.returned_second();
    let visits: Vec<MeshVisit> = bench.read_all(room);
    let count = (end - room.address) as usize / size_of::<MeshVisit>();
    assert_eq!(
        end,
        address::<MeshVisit>(room, count),
        "the end of the list"
    );
    let visit = |visit: &MeshVisit| {
        assert_eq!([visit.reserved.get(), visit.reserved_2.get()], [0; 2]);
        Visit {
            child: visit.child.get(),
            near: single_of(visit.near),
            rays: visit
                .rays
                .iter()
                .fold(0, |rays, word| rays << 32 | u128::from(word.get())),
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
    let room = put(bench, &vec![MeshVisit::new_zeroed(); 4 * nodes.len() + 3]);
    let arguments = vec![
        batch.nodes,
        nodes.len() as u32,
        batch.bits,
        room.address,
        batch.records.address,
        batch.packets.address,
        batch.list,
    ];
    (room, arguments)
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
    let (first, room, arguments) = put_for_few(bench, packets, nodes, bits, base);
    let end = bench.call("mesh_few_rays", &arguments).value;
    candidates_in(bench, first, room, end)
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
    let room = put(bench, &vec![MeshCandidate::new_zeroed(); most]);
    let steps = steps(bench, batch.packets.address, BOUNDS);
    let arguments = vec![
        batch.nodes,
        nodes.len() as u32,
        batch.bits,
        room.address,
        batch.records.address,
        steps,
        base,
        batch.list,
    ];
    (batch.packets.address, room, arguments)
}

fn candidates_in(bench: &Bench, packets: u32, room: Place, end: u32) -> Vec<(u32, u32)> {
    let list: Vec<MeshCandidate> = bench.read_all(room);
    let count = (end - room.address) as usize / size_of::<MeshCandidate>();
    assert_eq!(end, address::<MeshCandidate>(room, count), "the end");
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
    let (room, arguments) = put_for_candidates(bench, visits, base);
    let end = bench.call("mesh_candidates", &arguments).value;
    candidates_in(bench, PACKETS, room, end)
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
    let room = vec![MeshCandidate::new_zeroed(); 8 * visits.len() + 7];
    let room = put(bench, &room);
    let steps = steps(bench, PACKETS, BOUNDS);
    let arguments = vec![
        records.address,
        visits.len() as u32,
        room.address,
        base,
        steps,
    ];
    (room, arguments)
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
    let eye: Vec<u8> = known
        .eye
        .iter()
        .chain([&u32::MAX])
        .flat_map(|word| word.to_be_bytes())
        .collect();
    let eye = bench.place(&eye);
    let arguments = vec![
        place.address,
        known.number,
        eye.address,
        known.blocks,
        known.materials,
        known.sides,
    ];
    (place, arguments)
}
