//! The records of these kernels, made of the inputs of their twins.

use protocol::layout::{
    Boxes, MESH_BLOCK, MESH_LEAF, MESH_MAGIC, MeshBound, MeshFace, MeshHeader, MeshVertex,
    MeshWindow, SIDES_BOTH, Shear,
};
use twins::mesh::{self, Corners, Slab};
use twins::mesh_pairs::MeshBlock;
use twins::{mesh_rows, sphere_ray};
use zerocopy::big_endian::U16;

use crate::cases::whitted::isect;
use crate::prelude::*;

/// A node, or what takes its place in a test: four boxes and their words.
#[derive(Clone, Copy, Debug)]
pub struct Node {
    /// The boxes.
    pub boxes: [Corners; 4],
    /// The children's words.
    pub words: [u32; 4],
}

/// Offsets in `BOXES` of the lower corners' planes.
pub const LOWER: [usize; 3] = [
    std::mem::offset_of!(Boxes, lo_x),
    std::mem::offset_of!(Boxes, lo_y),
    std::mem::offset_of!(Boxes, lo_z),
];
/// From these to the upper ones'.
pub const TO_UPPER: usize = std::mem::offset_of!(Boxes, hi_x);

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

/// The word for the sides of a block's triangles.
#[must_use]
pub fn sides(block: &MeshBlock, anything: u32) -> u32 {
    if block.both { anything | SIDES_BOTH } else { anything & !SIDES_BOTH }
}

/// The bytes of a leaf block, as they are in local store. The fields that no kernel reads are
/// `anything`.
///
/// # Panics
///
/// Panics if the triangles do not fit.
#[must_use]
pub fn leaf(block: &MeshBlock, nodes: u32, anything: u32) -> Vec<u8> {
    let header = MeshHeader {
        magic: MESH_MAGIC.into(),
        number: block.number.into(),
        kind: MESH_LEAF.into(),
        levels: 1.into(),
        nodes: nodes.into(),
        triangles: (block.faces.len() as u32).into(),
        vertices: (block.vertices.len() as u32).into(),
        sides: sides(block, anything).into(),
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

/// Puts packets and their shears into local store, and bounds with nothing but the shears'
/// addresses. Returns the packets' buffer and the bounds'.
pub fn put_sheared(
    bench: &mut Bench,
    packets: &[[sphere_ray::Ray; 16]],
    anything: u32,
) -> [Place; 2] {
    let placed = put(bench, &isect::call::packets(packets, anything));
    let shears = isect::call::shear(bench, placed, packets.len());
    let bounds: Vec<MeshBound> = (0..packets.len())
        .map(|packet| MeshBound {
            shears: address::<Shear>(shears, packet).into(),
            farthest: single(anything),
            ..MeshBound::new_zeroed()
        })
        .collect();
    [placed, put(bench, &bounds)]
}
