//! Records of meshes: the blocks that stay in main memory, and what a packet is in local store
//! while it is traced through them.
//!
//! A block is `MESH_BLOCK` bytes: a `MESH_HEADER`, `BOXES` for each of its nodes, then
//! `MESH_VERTEX` and `MESH_FACE` records, or an `OBJECT` for each sphere, or a `CONE` for each
//! cone, then zeros. In these, `material` is the material's number among the mesh's, and `leave`
//! how far a cone's surface is from its base at most, less its offset, or 0. With
//! `SIDES_TEXTURED`, `MESH_UV` records of the vertices begin at the next quadword. With
//! `SIDES_COLOURED`, `MESH_COLOUR` records of the vertices begin at the quadword after these. With
//! `SIDES_VISIBILITY`, `MESH_VISIBILITY` records of the triangles begin at the quadword after
//! these. With `SIDES_WIDE` the upper bytes of the materials' numbers are at `MESH_UPPER`.
//! Positions are in the mesh's own coordinates until a block is in local store, and relative to
//! the eye there.
//!
//! Block 0 is the root, and a child comes after its parent. The nodes of a block are stored level
//! by level, each level complete, and a level's nodes are in the order of their parents. A node's
//! children have its first lanes; the other lanes have the box `NO_BOX` and the child 0. Above the
//! lowest level, a child is the offset of a node. At the lowest level of an inner block, it is the
//! number of a block. In a leaf it is a run of triangles, four times the first one's index plus its
//! length times 2^16, or the offset of an `OBJECT` or a `CONE`.

use zerocopy::big_endian::{F32, U16, U32};
use zerocopy::{FromBytes, Immutable, IntoBytes, KnownLayout, Unaligned};

use super::{Field, Record};

record! {
    /// The beginning of a mesh's block.
    MeshHeader as "MESH_HEADER" {
        /// `MESH_MAGIC`.
        magic: U32,
        /// The block's own number.
        number: U32,
        /// `MESH_INNER`, `MESH_LEAF`, `MESH_SPHERES` or `MESH_CONES`.
        kind: U32,
        /// Levels of nodes, 1 to `MESH_LEVELS`.
        levels: U32,
        /// Nodes.
        nodes: U32,
        /// Triangles, at most `MESH_FACES`, or spheres, or cones; 0 in an inner block.
        triangles: U32,
        /// Vertices, at most `MESH_VERTICES`; 0 unless there are triangles.
        vertices: U32,
        /// `SIDES_BOTH`, `SIDES_SMOOTH`, `SIDES_TEXTURED`, `SIDES_WIDE`, `SIDES_COLOURED` and
        /// `SIDES_VISIBILITY`, for all triangles of the block.
        sides: U32,
    }
}

record! {
    /// A node of a mesh: the boxes of four children. A lane without a child has `NO_BOX` as its
    /// lower corner, -`NO_BOX` as its upper one, and the child 0.
    Boxes as "BOXES" {
        /// Lower corners, x.
        lo_x: [F32; 4],
        /// Lower corners, y.
        lo_y: [F32; 4],
        /// Lower corners, z.
        lo_z: [F32; 4],
        /// Upper corners, x.
        hi_x: [F32; 4],
        /// Upper corners, y.
        hi_y: [F32; 4],
        /// Upper corners, z.
        hi_z: [F32; 4],
        /// Above the lowest level, offsets of nodes in the block. There, in an inner block, numbers
        /// of blocks; in a leaf, runs of triangles: four times the first one's index, and their
        /// number, 1 to `MESH_RUN`, times 2^16; or the offsets of spheres or cones in the block.
        child: [U32; 4],
    }
}

record! {
    /// A vertex of a mesh.
    MeshVertex as "MESH_VERTEX" {
        /// Position: x, y, z.
        position: [F32; 3],
        /// Octahedral normal with `SIDES_SMOOTH`, two signed halves, u and v; else 0.
        normal: U32,
    }
}

record! {
    /// A triangle of a mesh.
    MeshFace as "MESH_FACE" {
        /// Indices of its vertices in the block: counter-clockwise as seen from outside.
        vertex: [u8; 3],
        /// Index of its material among the mesh's; its last byte with `SIDES_WIDE`.
        material: u8,
    }
}

record! {
    /// A vertex's texture coordinates.
    MeshCoordinates as "MESH_UV" {
        /// From the left, in widths of the texture.
        u: F32,
        /// From above, in heights of the texture.
        v: F32,
    }
}

record! {
    /// A vertex's colour, by which the material's is multiplied.
    MeshColour as "MESH_COLOUR" {
        /// Red, green and blue times 1023, from the bits 2^22, 2^12 and 2^2 on: light, or its
        /// square root with `FEATURE_SRGB`.
        packed: U32,
    }
}

record! {
    /// The lights of which it is known whether they reach a triangle. The bit 2^n is for all lights
    /// whose number is n modulo 16.
    MeshVisibility as "MESH_VISIBILITY" {
        /// Those that reach no place of it.
        dark: U16,
        /// Those that reach all places of it in their range.
        lit: U16,
    }
}

record! {
    /// A texture. Its levels follow one another, the largest first, and so do their tiles. Textures
    /// of one size have the same levels.
    Texture as "TEXTURE" {
        /// Address of the first `LEVEL`.
        levels: U32,
        /// Number of the last level.
        last: U32,
        /// Texels of the first level.
        texels: F32,
        /// `WRAP_` bits, and 2^`WRAP_BITS` times the number of the texture's first tile.
        wraps: U32,
    }
}

record! {
    /// A level of a texture. Its tiles follow one another, row by row: `width` / 8 + 1 across and
    /// `height` / 8 + 1 down, rounded down. A tile has `TEXTURE_SIDE` rows of as many texels, each
    /// a word of red, green, blue and 0, eight texels from those of the next tile. Its first row
    /// and column begin one texel before the texture, whose edges are continued as its `wraps`
    /// specify. A byte over 255 is light, or its square root with `FEATURE_SRGB`.
    TextureLevel as "LEVEL" {
        /// Texels across.
        width: F32,
        /// Texels down.
        height: F32,
        /// Tiles across.
        across: U32,
        /// Number of the first tile, from the texture's first one on.
        first: U32,
    }
}

record! {
    /// Local store: where the texels of sixteen rays' hits are; rows of four.
    Texels as "TEXELS" {
        /// Number of the tile; all ones without a texture.
        tile: [U32; 16],
        /// Of the upper left one of four texels, the offset in the tile; later its address.
        place: [U32; 16],
        /// Part of the way from the left texels to the right ones.
        right: [F32; 16],
        /// Part of the way from the upper texels to the lower ones.
        down: [F32; 16],
    }
}

record! {
    /// Local store: what a packet's rays have in common, for tests with boxes. The rays meet a
    /// plane of an axis no earlier than near_scale plane + near_shift, where the plane is the one
    /// that they meet first: of the lower corners, or of the upper ones if they all go down the
    /// axis. They leave by the opposite plane no later than far_scale plane + far_shift. If they go
    /// up and down the axis, that product is where they meet the opposite plane; then near_scale
    /// is above 0 and far_scale below.
    MeshBound as "MESH_BOUND" {
        /// Scale of the plane that is met first, x; in all lanes, as the next eleven.
        near_scale_x: [F32; 4],
        /// The same, y.
        near_scale_y: [F32; 4],
        /// The same, z.
        near_scale_z: [F32; 4],
        /// Shift of the plane that is met first, x.
        near_shift_x: [F32; 4],
        /// The same, y.
        near_shift_y: [F32; 4],
        /// The same, z.
        near_shift_z: [F32; 4],
        /// Scale of the opposite plane, x.
        far_scale_x: [F32; 4],
        /// The same, y.
        far_scale_y: [F32; 4],
        /// The same, z.
        far_scale_z: [F32; 4],
        /// Shift of the opposite plane, x.
        far_shift_x: [F32; 4],
        /// The same, y.
        far_shift_y: [F32; 4],
        /// The same, z.
        far_shift_z: [F32; 4],
        /// Upper half of the single by which the origins are moved apart; its last two bits are 0.
        slack: U16,
        /// Offset in `BOXES` of the planes that are met first: of `lo_x` or of `hi_x`.
        near_plane_x: U16,
        /// The same, of `lo_y` or `hi_y`.
        near_plane_y: U16,
        /// The same, of `lo_z` or `hi_z`.
        near_plane_z: U16,
        /// Address of the packet's `SHEARS`.
        shears: U32,
        /// Largest distance that a ray counts to; -1 if there is no ray.
        farthest: F32,
    }
}

record! {
    /// Local store: a node or a run of triangles of a mesh, and a packet to test with it.
    MeshCandidate as "MESH_CANDIDATE" {
        /// Address of the node's `BOXES`, or the run, or the number of the block.
        object: U32,
        /// Address of the packet.
        packet: U32,
        /// Address of the packet's `MESH_BOUND`.
        bound: U32,
        /// No ray of the packet meets the box nearer than this; not below 0.
        near: F32,
    }
}

record! {
    /// Local store: where the rays of a packet from the eye go, for tests with triangles. The
    /// packet's own axes are in a cyclic order, with z the one along which it goes. The limits are
    /// those of direction x/z and y/z over a row's four rays, in all lanes of the row; a row
    /// without rays has low above high.
    MeshWindow as "MESH_WINDOW" {
        /// Smallest direction x/z.
        low_x: [F32; 16],
        /// Largest direction x/z.
        high_x: [F32; 16],
        /// Smallest direction y/z.
        low_y: [F32; 16],
        /// Largest direction y/z.
        high_y: [F32; 16],
        /// Shuffle of two vertices: their x, then their y.
        order: [u8; 16],
        /// Shuffle of two vertices: their z in the first two words.
        depth: [u8; 16],
    }
}

record! {
    /// Local store: where a leaf block has its triangles, if these have neither normals at their
    /// vertices nor textures.
    MeshLeaf as "MESH_LEAVES" {
        /// The block's number; all ones if it isn't there.
        number: U32,
        /// Address of its vertices.
        vertices: U32,
        /// Address of its faces.
        faces: U32,
        /// Its `sides`.
        sides: U32,
    }
}

record! {
    /// Local store: a triangle of a mesh that a packet has hit.
    MeshHit as "MESH_HITS" {
        /// What `RAYS16` has of it.
        object: U32,
        /// Address of its `PATCH`.
        patch: U32,
        /// Anything.
        rest: [U32; 2],
    }
}

record! {
    /// Local store: a triangle of a mesh and the rows of a packet that may hit it.
    MeshRows as "MESH_ROWS" {
        /// The triangle's index times 2^10, plus a bit for each row: 8 for the first one.
        rows: U32,
        /// Address of the packet.
        packet: U32,
        /// Address of the packet's `MESH_BOUND`.
        bound: U32,
        /// Anything.
        rest: U32,
    }
}

record! {
    /// Local store: a ray of a batch, for tests with the boxes of meshes one by one. It meets a
    /// plane of an axis that it meets first no earlier than inverse plane + near_shift, and the
    /// opposite one no later than inverse plane + far_shift.
    MeshRay as "MESH_RAY" {
        /// Offset in `BOXES` of the planes that are met first, of `lo_x` or of `hi_x`; in the first
        /// byte the same of `lo_z` or `hi_z`.
        planes: U32,
        /// 1 / direction: x, y, z.
        inverse: [F32; 3],
        /// Offset of the planes of `lo_y` or `hi_y`; in the first byte 127 minus the ray's number in
        /// the batch.
        number: U32,
        /// Shifts of the planes that are met first: x, y, z.
        near_shift: [F32; 3],
        /// The farthest distance that counts.
        t: F32,
        /// Shifts of the opposite planes: x, y, z.
        far_shift: [F32; 3],
    }
}

record! {
    /// Local store: a child of a mesh's node, and the rays of a batch that meet its box.
    MeshVisit as "MESH_VISIT" {
        /// The child's word.
        child: U32,
        /// 0.
        reserved: U32,
        /// No ray meets the box nearer than this.
        near: F32,
        /// 0.
        reserved_2: U32,
        /// A bit for each ray; the first ray's is the sign of the first word.
        rays: [U32; 4],
    }
}

const _: () = {
    assert!(size_of::<MeshHeader>() == 32);
    assert!(size_of::<MeshRay>() == 48);
    assert!(size_of::<MeshVisit>() == 32);
    assert!(size_of::<Boxes>() == 112);
    assert!(size_of::<MeshVertex>() == 16);
    assert!(size_of::<MeshFace>() == 4);
    assert!(size_of::<MeshCoordinates>() == 8);
    assert!(size_of::<MeshVisibility>() == 4);
    assert!(size_of::<Texture>() == 16);
    assert!(size_of::<TextureLevel>() == 16);
    assert!(size_of::<MeshBound>() == size_of::<super::Bound>());
    assert!(size_of::<MeshCandidate>() == size_of::<super::Candidate>());
};
