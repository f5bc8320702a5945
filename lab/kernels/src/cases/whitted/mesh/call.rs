//! Calls these kernels with the inputs of their twins.

mod eye;
mod streams;

use protocol::layout::{
    Boxes, MESH_BLOCK, MESH_LEAF, MESH_MAGIC, MeshBound, MeshCandidate, MeshFace, MeshHeader,
    MeshVertex, RayPacket, SIDES_BOTH, Shear,
};
use twins::mesh::{self, Corners, Slab};
use twins::mesh_pairs::MeshBlock;
use twins::primary_rays::Ray;
use twins::{Single, sphere_ray};
use zerocopy::big_endian::{F32, U16};
use zerocopy::{FromZeros as _, IntoBytes as _};

use crate::bench::{Bench, Place};
use crate::cases::eye::call::{address, put};
use crate::cases::whitted::{isect, rays};
use crate::single::{bits, single};

pub use eye::*;
pub use streams::*;

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
    let near_scale = [record.near_scale_x, record.near_scale_y, record.near_scale_z].map(one);
    let near_shift = [record.near_shift_x, record.near_shift_y, record.near_shift_z].map(one);
    let far_scale = [record.far_scale_x, record.far_scale_y, record.far_scale_z].map(one);
    let far_shift = [record.far_shift_x, record.far_shift_y, record.far_shift_z].map(one);
    let planes = [record.near_plane_x, record.near_plane_y, record.near_plane_z];
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
    let before: Vec<MeshBound> = bounds.iter().map(|bound| bound_record(bound, shears)).collect();
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
    pub buffer: Place,
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
    let bounds: Vec<MeshBound> =
        packets.iter().map(|(_, bound)| bound_record(bound, u32::MAX)).collect();
    let bounds = put(bench, &bounds);
    let packets: Vec<RayPacket> =
        packets.iter().map(|(rays, _)| rays::call::packet(rays)).collect();
    let packets = put(bench, &packets);
    let candidate = |(number, &[node, packet]): (usize, &[usize; 2])| MeshCandidate {
        object: address::<Boxes>(nodes, node).into(),
        packet: address::<RayPacket>(packets, packet).into(),
        bound: address::<MeshBound>(bounds, packet).into(),
        near: single(number as u32),
    };
    let given: Vec<MeshCandidate> = pairs.iter().enumerate().map(candidate).collect();
    let list = put(bench, &given);
    let buffer = vec![MeshCandidate::new_zeroed(); 4 * pairs.len() + 3];
    let buffer = put(bench, &buffer);
    Candidates {
        arguments: vec![list.address, given.len() as u32, buffer.address, base],
        given: given.iter().map(words).collect(),
        buffer,
    }
}

fn words(candidate: &MeshCandidate) -> [u32; 4] {
    [candidate.object.get(), candidate.packet.get(), candidate.bound.get(), bits(candidate.near)]
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
    let mut list: Vec<MeshCandidate> = bench.read_all(placed.buffer);
    let ends = (0..=4 * pairs.len()).find(|at| address::<MeshCandidate>(placed.buffer, *at) == end);
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
    let face = |vertex: &[u8; 3]| MeshFace { vertex: *vertex, material: anything as u8 };
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

/// Puts packets and their shears into local store, and bounds with nothing but the shears'
/// addresses. Returns the packets' buffer and the bounds'.
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
    let records: Vec<RayPacket> =
        packets.iter().map(|rays| isect::call::packet(rays, anything)).collect();
    let (placed, arguments) = put_runs(bench, &records, block, runs, anything);
    bench.call("isect_mesh_pairs_r16", &arguments);
    bench.read_all(placed)
}
