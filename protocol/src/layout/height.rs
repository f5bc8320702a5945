//! Records of height fields.
//!
//! The samples of a level are rows from north to south, and a row has them from west to east. A
//! sample is a word: its height in the upper half, its colour in the lower one, red and blue in
//! five bits and green in six. Four more samples are in front of a row, at least seven after it,
//! a row is in front of the first one and two or more are after the last: there the samples at
//! the edge are repeated. A sample of a level is two of the one before apart.

use zerocopy::big_endian::{F32, U32, U64};
use zerocopy::{FromBytes, Immutable, IntoBytes, KnownLayout, Unaligned};

use super::{Field, Record};

record! {
    /// A height field as a frame shows it.
    Heights as "HEIGHTS" {
        /// Effective address of the samples; a multiple of 16. They don't cross a multiple of 4 GB.
        samples: U64,
        /// Effective address of the inner blocks above its blocks; a multiple of 128.
        tree: U64,
        /// The number of these.
        tree_blocks: U32,
        /// Levels that blocks may have, 1 to `HEIGHT_LEVELS`.
        levels: U32,
        /// The inner blocks, and all blocks that they have.
        blocks: U32,
        /// 0.
        reserved: U32,
        /// The first sample's position relative to the eye, if its height is 0: x, y, z.
        corner: [F32; 3],
        /// The square of the eye's height above the ground.
        above: F32,
        /// The distance between samples of the first level, x; the length of a height of 1; z.
        step: [F32; 3],
        /// 0.
        reserved_2: F32,
        /// The last sample's column, anything, and its row.
        last: [F32; 3],
        /// 0.
        reserved_3: F32,
        /// The levels, the first one with the most samples.
        levels_of: [HeightLevel; 11],
        /// Effective address of the blocks of cells with the ground's own shadow, or 0; a multiple
        /// of 16.
        shades: U64,
        /// The number of the light for which they do.
        shades_light: U32,
        /// Rows of blocks in the first of `SHADE_LEVELS` levels; a multiple of 32. The next has
        /// half of them.
        shades_rows: U32,
        /// Blocks of such a row, without `SHADES_BESIDE` more; a multiple of 32.
        shades_columns: U32,
        /// How far a row begins farther right than the one below it, in parts of 65536 of a block.
        shades_slant: U32,
        /// How far a ray to the light goes from a line to the next.
        shades_length: F32,
        /// 0.
        reserved_4: U32,
        /// A place's line is x and z times the first and third, and the second. The fourth is the
        /// last line.
        shades_line: [F32; 4],
        /// The same for its sample of the line.
        shades_place: [F32; 4],
        /// Its lane is its sample, less its line times the first, and the second. Its height above
        /// the plane is y, its line times the third, and the fourth.
        shades_lane: [F32; 4],
    }
}

record! {
    /// A level of a height field.
    HeightLevel as "HEIGHT_LEVEL" {
        /// Bytes from the first level's samples to its own.
        offset: U32,
        /// Bytes from a row to the next; a multiple of 16.
        stride: U32,
        /// Columns of blocks.
        across: U32,
        /// Rows of blocks.
        down: U32,
        /// The square of the distance from the eye where it begins to fade to the next level.
        fades_from: F32,
        /// One over what is from there to the square of the distance where it has become that.
        fade: F32,
        /// The distance from a sample of the next level but one to the next, in heights of 1:
        /// upwards in normals whose other parts are differences of two samples of the next level.
        up: F32,
        /// The square of the distance where it has faded.
        until: F32,
    }
}

const _: () = {
    assert!(size_of::<HeightLevel>() == 32);
    assert!(size_of::<Heights>() == 512);
    assert!(super::HEIGHT_LEVELS < 11);
};
