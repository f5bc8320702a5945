//! The work-unit layout: the one definition that the PPU program, the SPU assembler and
//! `docs/work-unit.md` all follow.
//!
//! All records are big-endian whatever the host, with the byte order in the field types. `build.rs`
//! includes this file and writes every size, offset and constant into `work_unit.inc` for the
//! assembler; a test compares the tables in the document. So this file knows nothing else of the
//! program.

use zerocopy::big_endian::{F32, U32, U64};
use zerocopy::{FromBytes, Immutable, IntoBytes, KnownLayout, Unaligned};

/// A record's shape, as the assembler and the document see it.
#[derive(Clone, Copy, Debug)]
pub struct Record {
    /// Prefix of the assembler's names.
    pub name: &'static str,
    /// What the record is.
    pub doc: &'static str,
    /// Bytes.
    pub size: usize,
    /// All fields, in order.
    pub fields: &'static [Field],
}

/// One field of a [`Record`].
#[derive(Clone, Copy, Debug)]
pub struct Field {
    /// Name, in Rust as in the assembler.
    pub name: &'static str,
    /// Type, as written here.
    pub kind: &'static str,
    /// Bytes from the start of the record.
    pub offset: usize,
    /// Bytes.
    pub size: usize,
    /// What it says.
    pub doc: &'static str,
}

macro_rules! record {
    (
        #[doc = $doc:literal]
        $name:ident as $prefix:literal {
            $( #[doc = $field_doc:literal] $field:ident: $kind:ty, )*
        }
    ) => {
        #[doc = $doc]
        #[derive(Clone, Copy, Debug, FromBytes, IntoBytes, Immutable, KnownLayout, Unaligned)]
        #[repr(C)]
        pub struct $name {
            $( #[doc = $field_doc] pub $field: $kind, )*
        }

        impl $name {
            /// Shape of the record.
            pub const RECORD: Record = Record {
                name: $prefix,
                doc: $doc,
                size: size_of::<$name>(),
                fields: &[ $( Field {
                    name: stringify!($field),
                    kind: stringify!($kind),
                    offset: std::mem::offset_of!($name, $field),
                    size: size_of::<$kind>(),
                    doc: $field_doc,
                }, )* ],
            };
        }
    };
}

macro_rules! constants {
    ( $( #[doc = $doc:literal] $name:ident = $value:expr; )* ) => {
        $( #[doc = $doc] pub const $name: u32 = $value; )*

        /// Every constant above: name, value, meaning.
        pub const CONSTANTS: &[(&str, u32, &str)] = &[ $( (stringify!($name), $name, $doc), )* ];
    };
}

constants! {
    /// `CRAY`, the first word of a frame descriptor.
    MAGIC = 0x4352_4159;
    /// Version of this layout; raised by every change that an older SPU program would misread.
    VERSION = 1;
    /// Alignment in bytes of every record in main memory: the line of the MFC's atomic commands.
    LINE = 128;
    /// Feature bit: the scene has spheres.
    FEATURE_SPHERES = 1;
    /// All feature bits that this version knows.
    FEATURES_KNOWN = FEATURE_SPHERES;
    /// `split`: every SPU takes the next tile from the shared counter.
    SPLIT_TILES = 0;
    /// `split`: every SPU has a fixed share of consecutive tiles, as in the paper.
    SPLIT_SLICES = 1;
    /// Most SPUs that share a frame; `slices` has one entry more.
    MAX_SPUS = 16;
    /// Most pixels across and down.
    MAX_SIDE = 8192;
    /// Most bytes from one row to the next: it is multiplied in 16 bits.
    MAX_STRIDE = 65520;
    /// Most spheres of a scene: what the local store has room for.
    MAX_SPHERES = 2048;
    /// Pixels across a tile.
    TILE_WIDTH = 64;
    /// Pixels down a tile.
    TILE_HEIGHT = 16;
    /// Largest position of a colour channel in the pixel word.
    MAX_SHIFT = 24;
    /// Most bytes of one DMA transfer.
    MAX_TRANSFER = 16384;
}

record! {
    /// Frame descriptor: what the PPU mails the address of.
    Frame as "FRAME" {
        /// `MAGIC`.
        magic: U32,
        /// `VERSION`.
        version: U32,
        /// Bytes of this record.
        size: U32,
        /// What the scene has: `FEATURE_` bits.
        features: U32,
        /// Number of the frame, repeated in the statistics.
        number: U32,
        /// SPUs that share the frame.
        spus: U32,
        /// How tiles are handed out: a `SPLIT_` value.
        split: U32,
        /// Pixels across.
        width: U32,
        /// Pixels down.
        height: U32,
        /// Bytes from one framebuffer row to the next; a multiple of 16.
        stride: U32,
        /// Effective address of the framebuffer's first pixel; a multiple of 16.
        framebuffer: U64,
        /// Effective address of the sphere records; on a line.
        spheres: U64,
        /// Effective address of the tile counter; on a line.
        tile_counter: U64,
        /// Effective address of the statistics records, one a SPU in order; on a line.
        statistics: U64,
        /// Sphere records.
        sphere_count: U32,
        /// Left shift of the red channel in the pixel word.
        red_shift: U32,
        /// Left shift of the green channel.
        green_shift: U32,
        /// Left shift of the blue channel.
        blue_shift: U32,
        /// Distance at which depth shading has faded to black.
        depth_far: F32,
        /// One over the distance in which it fades.
        depth_scale: F32,
        /// Zero; keeps the vectors below on quadwords.
        reserved: [U32; 4],
        /// Eye: x, y, z, 0.
        eye: [F32; 4],
        /// Direction through the centre of pixel (0, 0): x, y, z, 0.
        corner: [F32; 4],
        /// Step of that direction to the next pixel of a row.
        right: [F32; 4],
        /// Step of that direction to the next row.
        down: [F32; 4],
        /// Background colour: red, green, blue, 0.
        background: [F32; 4],
        /// First tile of each SPU's slice; a slice ends where the next begins.
        slices: [U32; 17],
        /// Zero; fills the last line.
        reserved_end: [U32; 31],
    }
}

record! {
    /// One sphere in main memory.
    Sphere as "SPHERE" {
        /// Centre: x, y, z.
        centre: [F32; 3],
        /// Radius, over 0.
        radius: F32,
        /// Colour: red, green, blue, each 0 to 1.
        colour: [F32; 3],
        /// Zero.
        reserved: U32,
    }
}

record! {
    /// The line from which SPUs take tiles by getllar and putllc.
    TileCounter as "COUNTER" {
        /// Number of the next tile; tiles are counted row by row from the top left.
        next: U32,
        /// Zero; fills the line.
        reserved: [U32; 31],
    }
}

record! {
    /// What one SPU says of one frame.
    Statistics as "STATS" {
        /// Number of the frame.
        number: U32,
        /// Tiles traced.
        tiles: U32,
        /// Packets of 4x4 rays traced.
        packets: U32,
        /// Eye rays within the picture.
        eye_rays: U32,
        /// Eye rays that hit something.
        eye_hits: U32,
        /// Decrementer ticks from the mail to the answer, less `dma_wait`.
        busy: U32,
        /// Decrementer ticks spent waiting for the MFC.
        dma_wait: U32,
        /// Decrementer ticks spent waiting for the mail.
        idle: U32,
        /// Tests of one packet with one object.
        tests_made: U64,
        /// Such tests that were found needless.
        tests_skipped: U64,
        /// Zero; fills the line.
        reserved: [U32; 20],
    }
}

record! {
    /// Local store: sixteen eye rays and what they have hit; arrays of 16 in rows of four.
    Packet as "PACKET" {
        /// Unit directions, x.
        direction_x: [F32; 16],
        /// Unit directions, y.
        direction_y: [F32; 16],
        /// Unit directions, z.
        direction_z: [F32; 16],
        /// Distance of the nearest hit so far; the largest single if none.
        t: [F32; 16],
        /// Number of the object hit, from 1; 0 if none.
        object: [U32; 16],
    }
}

record! {
    /// Local store: camera of the frame, every value in all four lanes.
    Basis as "BASIS" {
        /// Direction through pixel (0, 0): x, y, z.
        corner: [[F32; 4]; 3],
        /// Step to the next pixel: x, y, z.
        right: [[F32; 4]; 3],
        /// Step to the next row: x, y, z.
        down: [[F32; 4]; 3],
    }
}

record! {
    /// Local store: a sphere as the eye's rays meet it, every value in all four lanes.
    EyeSphere as "EYESPHERE" {
        /// Centre less eye: x, y, z.
        centre: [[F32; 4]; 3],
        /// Radius squared.
        radius_squared: [F32; 4],
    }
}

record! {
    /// Local store: depth shading of the frame, every value in all four lanes.
    Depth as "DEPTH" {
        /// Distance at which everything is black.
        far: [F32; 4],
        /// One over the distance in which it fades.
        scale: [F32; 4],
    }
}

record! {
    /// Local store: colours of a packet, 0 to 1 (more is shown as 1).
    Colours as "COLOURS" {
        /// Red.
        red: [F32; 16],
        /// Green.
        green: [F32; 16],
        /// Blue.
        blue: [F32; 16],
    }
}

record! {
    /// Local store: where a pixel's channels stand, every value in all four lanes.
    PixelShifts as "SHIFTS" {
        /// Left shift of red.
        red: [U32; 4],
        /// Left shift of green.
        green: [U32; 4],
        /// Left shift of blue.
        blue: [U32; 4],
    }
}

/// All records, in the order of the document.
pub const RECORDS: &[Record] = &[
    Frame::RECORD,
    Sphere::RECORD,
    TileCounter::RECORD,
    Statistics::RECORD,
    Packet::RECORD,
    Basis::RECORD,
    EyeSphere::RECORD,
    Depth::RECORD,
    Colours::RECORD,
    PixelShifts::RECORD,
];

macro_rules! statuses {
    ( $( #[doc = $doc:literal] $name:ident = $value:literal, $field:literal; )* ) => {
        /// An SPU's answer to a frame: 0, or what it refused.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum Status {
            $( #[doc = $doc] $name = $value, )*
        }

        impl Status {
            /// Every status: assembler's name, status, the field that it is about, rule.
            pub const ALL: &[(&str, Status, &str, &str)] =
                &[ $( (stringify!($name), Status::$name, $field, $doc), )* ];
        }
    };
}

statuses! {
    /// The frame is done.
    Done = 0, "";
    /// The mailed address must be a multiple of 128.
    Address = 1, "address";
    /// The first word must be `MAGIC`.
    Magic = 2, "magic";
    /// Must be `VERSION`.
    Version = 3, "version";
    /// Must be the size of the frame descriptor.
    Size = 4, "size";
    /// Only known feature bits may be set.
    Features = 5, "features";
    /// Must be 1 to 16, and more than this SPU's number.
    Spus = 6, "spus";
    /// Must be a known way to split.
    Split = 7, "split";
    /// Must be 1 to 8192.
    Width = 8, "width";
    /// Must be 1 to 8192.
    Height = 9, "height";
    /// Must be a multiple of 16, at most 65520, and hold a row in whole groups of four pixels.
    Stride = 10, "stride";
    /// Must be a multiple of 16.
    Framebuffer = 11, "framebuffer";
    /// Must be a multiple of 128.
    Spheres = 12, "spheres";
    /// Must be a multiple of 128.
    TileCounter = 13, "tile_counter";
    /// Must be a multiple of 128.
    Statistics = 14, "statistics";
    /// Must be at most 2048, and 0 without `FEATURE_SPHERES`.
    SphereCount = 15, "sphere_count";
    /// Shifts must be at most 24.
    PixelFormat = 16, "red_shift, green_shift, blue_shift";
}

const _: () = {
    assert!(size_of::<Frame>() == 384);
    assert!(size_of::<Sphere>() == 32);
    assert!(size_of::<TileCounter>() == LINE as usize);
    assert!(size_of::<Statistics>() == LINE as usize);
    assert!(std::mem::offset_of!(Frame, eye) % 16 == 0);
    assert!(std::mem::offset_of!(Frame, framebuffer) % 8 == 0);
};
