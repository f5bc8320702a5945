//! Records in main memory by which SPUs refit a mesh whose vertices have moved.
//!
//! A leaf keeps the triangles that it has in the blocks as they were built. The SPUs fetch each
//! leaf block, replace its vertices and its boxes, and store it among the new blocks. They leave
//! the inner blocks to the PPU, which finds the boxes of the leaves in the `BUILD_BOUNDS`.

use zerocopy::big_endian::{F32, U32, U64};
use zerocopy::{FromBytes, Immutable, IntoBytes, KnownLayout, Unaligned};

use super::{Field, Record};

record! {
    /// What SPUs need to refit the mesh that a frame names. All addresses are multiples of 128.
    Build as "BUILD" {
        /// Effective address of the new blocks.
        blocks: U64,
        /// Effective address of the mesh's vertices, `MESH_VERTEX` records. All of their normals
        /// are there; the SPUs leave out those of blocks without `SIDES_SMOOTH`.
        vertices: U64,
        /// Effective address of the words that list the leaf blocks' vertices. Each block's begin
        /// at a quadword: the number of its runs, then for each run of vertices that follow one
        /// another in the mesh their number times 2^24, plus the index of the first one, then
        /// zeros.
        sources: U64,
        /// Effective address of the `BUILD_BOUNDS` of all blocks, of which those of leaves are
        /// written.
        bounds: U64,
        /// Vertices of the mesh, at most 2^24.
        vertex_count: U32,
        /// Words that list vertices.
        source_count: U32,
        /// 0.
        reserved: [U32; 22],
    }
}

record! {
    /// Leaf blocks that one SPU refits.
    BuildUnit as "BUILD_UNIT" {
        /// Number of the first one. The others follow it.
        first: U32,
        /// Blocks, 1 to `BUILD_LEAVES`.
        count: U32,
        /// The first of the words that list their vertices; a multiple of 4.
        source: U32,
        /// These words: a multiple of 4, at most 256 for each of `BUILD_LEAVES`.
        source_count: U32,
        /// 0.
        reserved: [U32; 28],
    }
}

record! {
    /// The box around the triangles of a leaf block that an SPU has refitted.
    BuildBounds as "BUILD_BOUNDS" {
        /// Lower corner: x, y, z.
        low: [F32; 3],
        /// Half the surfaces of the boxes in the block, each times the tests that a ray makes that
        /// meets it.
        cost: F32,
        /// Upper corner: x, y, z.
        high: [F32; 3],
        /// 0.
        reserved: U32,
    }
}

const _: () = {
    assert!(size_of::<Build>() == 128);
    assert!(size_of::<BuildBounds>() == 32);
};
