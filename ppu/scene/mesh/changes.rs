//! Where the surfaces of two versions of a mesh differ.

use glam::Vec3;
use protocol::layout::{
    Boxes, Cone, MESH_CONES, MESH_INNER, MESH_LEAF, MESH_UPPER, MeshFace, MeshHeader, MeshVertex,
    NO_BOX, Object, SIDES_WIDE,
};
use zerocopy::FromBytes as _;
use zerocopy::big_endian::F32;

use super::tree::Bounds;
use super::{Block, MeshBlocks};

impl MeshBlocks {
    /// Calls `found` with boxes around all surfaces that only one of two versions has, and around
    /// those whose material's number `is_other`. They are relative to the mesh's origin, and each
    /// has its lower and its upper corner.
    ///
    /// Where nothing has moved, a refitted tree has the blocks that it had before.
    pub(crate) fn changes(
        &self,
        before: &Self,
        is_other: impl Fn(u32) -> bool,
        found: impl FnMut([Vec3; 2]),
    ) {
        let count = self.blocks.len().max(before.blocks.len());
        let pairs = (0..count).map(|number| (self.blocks.get(number), before.blocks.get(number)));
        let changed = pairs.filter(|pair| match pair {
            (Some(new), Some(old)) => {
                new.0 != old.0 || Leaf::of(new).is_some_and(|leaf| leaf.has_material(&is_other))
            }
            _ => true,
        });
        let leaves = changed.flat_map(|(new, old)| new.into_iter().chain(old)).filter_map(Leaf::of);
        leaves.map(|leaf| leaf.bounds()).for_each(found);
    }
}

/// The parts of a block that has surfaces.
struct Leaf<'a> {
    header: &'a MeshHeader,
    root: &'a Boxes,
    /// The records after the nodes.
    records: &'a [u8],
    /// The upper bytes of the numbers of materials, if they have any.
    upper: &'a [u8],
}

impl<'a> Leaf<'a> {
    fn of(Block(bytes): &'a Block) -> Option<Self> {
        let (header, rest) = MeshHeader::ref_from_prefix(bytes).ok()?;
        if header.kind.get() == MESH_INNER {
            return None;
        }
        let nodes = header.nodes.get() as usize;
        let (nodes, records) = <[Boxes]>::ref_from_prefix_with_elems(rest, nodes).ok()?;
        let upper = match header.sides.get() & SIDES_WIDE {
            0 => &[],
            _ => &bytes[MESH_UPPER as usize..],
        };
        Some(Self { header, root: nodes.first()?, records, upper })
    }

    fn bounds(&self) -> [Vec3; 2] {
        let Boxes { lo_x, lo_y, lo_z, hi_x, hi_y, hi_z, .. } = self.root;
        let lanes = (0..lo_x.len()).filter(|&lane| lo_x[lane].get().to_bits() != NO_BOX);
        let bounds = lanes.fold(Bounds::EMPTY, |bounds, lane| {
            let corner = |axes: [&[F32; 4]; 3]| Vec3::from(axes.map(|axis| axis[lane].get()));
            let (low, high) = (corner([lo_x, lo_y, lo_z]), corner([hi_x, hi_y, hi_z]));
            bounds.with(Bounds { low, high })
        });
        [bounds.low, bounds.high]
    }

    /// Whether a surface has a material with such a number.
    fn has_material(&self, is_such: &impl Fn(u32) -> bool) -> bool {
        let count = self.header.triangles.get() as usize;
        if self.header.kind.get() != MESH_LEAF {
            let size = match self.header.kind.get() {
                MESH_CONES => size_of::<Cone>(),
                _ => size_of::<Object>(),
            };
            let objects = self.records.chunks(size).take(count);
            let objects = objects.filter_map(|record| Object::ref_from_prefix(record).ok());
            return objects.into_iter().any(|(object, _)| is_such(object.material.get()));
        }
        let vertices = self.header.vertices.get() as usize * size_of::<MeshVertex>();
        let faces = self.records.get(vertices..).unwrap_or_default();
        let faces = <[MeshFace]>::ref_from_prefix_with_elems(faces, count);
        let (faces, _) = faces.unwrap_or_default();
        let upper = self.upper.iter().copied().chain(std::iter::repeat(0));
        let mut numbers = faces.iter().zip(upper);
        numbers.any(|(face, upper)| is_such(u32::from_be_bytes([0, 0, upper, face.material])))
    }
}
