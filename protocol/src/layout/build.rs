//! Records in main memory by which SPUs refit a mesh whose vertices have moved, or build the leaf
//! blocks of any triangles.
//!
//! A leaf keeps the triangles that it has in the blocks as they were built. The SPUs fetch each
//! leaf block, replace its vertices and its boxes, and store it among the new blocks. They leave
//! the inner blocks to the PPU, which finds the boxes of the leaves in the `BUILD_BOUNDS`.
//!
//! To build blocks takes two frames. In the first, with `BUILD_SORT`, each unit is a chunk of
//! triangles that an SPU sorts by the codes of their centroids. The PPU then divides the codes into
//! ranges. In the second frame, with `BUILD_PACK`, each unit is such a range: its triangles are
//! parts of all chunks, which an SPU sorts again and packs into leaf blocks.
//!
//! Spheres and cones are built in the same way, with `BUILD_PACK_OBJECTS` in the second frame. The
//! records that their blocks get take the place of the vertices: three quadwords of a sphere, its
//! `OBJECT`; five of a cone, its `CONE` and a point at three quarters of its height on the axis. A
//! sphere's `BUILD_TRIANGLE` has its first quadword three times. A cone's has its first quadword
//! and the point twice, so that the centroid is the middle of the axis.

use zerocopy::big_endian::{F32, U32, U64};
use zerocopy::{FromBytes, Immutable, IntoBytes, KnownLayout, Unaligned};

use super::{Field, Record};

record! {
    /// What SPUs need to refit the mesh that a frame names. All addresses are multiples of 128.
    Build as "BUILD" {
        /// Effective address of the new blocks.
        blocks: U64,
        /// Effective address of the mesh's vertices, `MESH_VERTEX` records. All of their normals
        /// are there; the SPUs leave out those of blocks without `SIDES_SMOOTH`. Of spheres and
        /// cones it is that of their records.
        vertices: U64,
        /// Effective address of the words that list the leaf blocks' vertices. Each block's begin
        /// at a quadword: the number of its runs, then for each run of vertices that follow one
        /// another in the mesh their number times 2^24, plus the index of the first one, then
        /// zeros.
        sources: U64,
        /// Effective address of the `BUILD_BOUNDS` of all blocks, of which those of leaves are
        /// written.
        bounds: U64,
        /// Vertices of the mesh, or quadwords of the records, at most 2^24.
        vertex_count: U32,
        /// Words that list vertices, or parts of sorted chunks.
        source_count: U32,
        /// `BUILD_REFIT`, `BUILD_SORT`, `BUILD_PACK` or `BUILD_PACK_OBJECTS`.
        task: U32,
        /// Triangles to sort, at most 2^24.
        triangle_count: U32,
        /// Effective address of the `BUILD_TRIANGLE` records.
        triangles: U64,
        /// Effective address of as many sorted ones.
        sorted: U64,
        /// Smallest cells of centroids: x, y, z. A centroid's cell is the sum of the whole parts of
        /// its corners' coordinates, each times `scale`.
        low: [U32; 3],
        /// A power of 2.
        scale: F32,
        /// A code has bits 0 to 9 of a cell less the smallest one, after a shift to the right by
        /// this.
        shift: U32,
        /// 0.
        reserved: [U32; 11],
    }
}

record! {
    /// Leaf blocks that one SPU refits or packs, or triangles that it sorts.
    BuildUnit as "BUILD_UNIT" {
        /// Number of the first one. The others follow it.
        first: U32,
        /// With `BUILD_REFIT` the blocks, 1 to `BUILD_LEAVES`; when packing the most, 1 to 255.
        count: U32,
        /// The first of the words that list their vertices, or the parts of sorted chunks that have
        /// their triangles, in the same form but without their number; a multiple of 4.
        source: U32,
        /// These words: a multiple of 4, at most 256 for each of `BUILD_LEAVES` blocks, or at most
        /// 512 when packing.
        source_count: U32,
        /// Triangles to sort, 1 to `BUILD_CHUNK`.
        triangles: U32,
        /// 0.
        reserved: [U32; 27],
    }
}

record! {
    /// A triangle, a sphere or a cone to sort.
    BuildTriangle as "BUILD_TRIANGLE" {
        /// Its code, which an SPU writes: `SIDES_BOTH` and `SIDES_SMOOTH` times 2, then 30 bits.
        /// Those of the cell's z, y and x take turns, from the last bit on, and each is combined
        /// with all above it by an exclusive or.
        code: U32,
        /// Vertex of its first corner, plus its material's number times 2^24.
        first: U32,
        /// Vertex of its second corner, plus its `SIDES_BOTH` and `SIDES_SMOOTH`, or `BUILD_CONE`.
        second: U32,
        /// Vertex of its third corner.
        third: U32,
    }
}

record! {
    /// The box around the triangles of a leaf block that an SPU has refitted.
    BuildBounds as "BUILD_BOUNDS" {
        /// Lower corner: x, y, z.
        low: [F32; 3],
        /// Half the surfaces of the boxes in the block, each times the tests that a ray makes that
        /// meets it; 0 of spheres and cones.
        cost: F32,
        /// Upper corner: x, y, z.
        high: [F32; 3],
        /// An SPU writes 0. Where it packs fewer blocks than it may, this stays as it was.
        unused: U32,
    }
}

const _: () = {
    assert!(size_of::<Build>() == 128);
    assert!(size_of::<BuildBounds>() == 32);
    assert!(size_of::<BuildTriangle>() == 16);
};
