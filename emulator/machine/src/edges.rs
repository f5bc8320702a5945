//! Operands at which instructions change what they do, for tests of an SPU's engines.

/// Words at the edges of floats, integers, counts and controls.
pub const WORDS: [u32; 36] = [
    0,
    1,
    2,
    7,
    15,
    16,
    31,
    32,
    63,
    64,
    0x7f,
    0x80,
    0xff,
    0x8000,
    0xffff,
    0x1_0000,
    0x0001_0203,
    0x1011_1213,
    0x007f_ffff,
    0x0080_0000,
    0x0080_0001,
    0x3f80_0000,
    0x3f7f_ffff,
    0x4f00_0000,
    0x4f80_0000,
    0x7e80_0000,
    0x7f00_0000,
    0x7f7f_ffff,
    0x7f80_0000,
    0x7fff_ffff,
    0x8000_0000,
    0x8000_0001,
    0x8080_0000,
    0xbf80_0000,
    0xff7f_ffff,
    0xffff_ffff,
];

/// Operands whose sums are the largest number, or just above or below it.
pub const LARGE: [u32; 8] =
    [0x7fff_ffff, 0xffff_ffff, 0x7fff_fffe, 0, 0x0080_0000, 0x8080_0000, 0x3f80_0000, 0x7380_0000];

/// Doubles at the edges: zeros, denormals, numbers whose products or sums leave the range of
/// doubles or of singles, infinities and NaNs.
pub const DOUBLES: [u64; 24] = [
    0,
    1,
    0x000f_ffff_ffff_ffff,
    0x0010_0000_0000_0000,
    0x0010_0000_0000_0001,
    0x0020_0000_0000_0000,
    0x1ff0_0000_0000_0000,
    0x2007_ffff_ffff_ffff,
    0x36a0_0000_0000_0000,
    0x380f_ffff_ffff_ffff,
    0x3810_0000_0000_0000,
    0x3fe0_0000_0000_0000,
    0x3fef_ffff_ffff_ffff,
    0x3ff0_0000_0000_0000,
    0x3ff0_0000_0000_0001,
    0x4340_0000_0000_0000,
    0x47ef_ffff_ffff_ffff,
    0x5fef_ffff_ffff_ffff,
    0x7fe0_0000_0000_0000,
    0x7fef_ffff_ffff_ffff,
    0x7ff0_0000_0000_0000,
    0x7ff0_0000_0000_0001,
    0x7ff8_0000_0000_0000,
    0x7fff_ffff_ffff_ffff,
];
