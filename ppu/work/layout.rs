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
    VERSION = 2;
    /// Alignment in bytes of every record in main memory: the line of the MFC's atomic commands.
    LINE = 128;
    /// Feature bit: the scene has spheres.
    FEATURE_SPHERES = 1;
    /// All feature bits that this version knows.
    FEATURES_KNOWN = FEATURE_SPHERES;
    /// `split`: every SPU takes the next work unit from the shared counter.
    SPLIT_UNITS = 0;
    /// `split`: every SPU has a fixed share of consecutive work units, as in the paper.
    SPLIT_SLICES = 1;
    /// `skip`: every ray is tested with every object, as in the paper.
    SKIP_NOTHING = 0;
    /// `skip`: what can't be hit is not tested.
    SKIP_MISSES = 1;
    /// Most SPUs that share a frame; `slices` has one entry more.
    MAX_SPUS = 16;
    /// Most pixels across and down.
    MAX_SIDE = 8192;
    /// Most bytes from one row to the next: it is multiplied in 16 bits.
    MAX_STRIDE = 65520;
    /// Most spheres of a scene: what the local store has room for.
    MAX_SPHERES = 1024;
    /// Pixels across a tile: groups side by side.
    TILE_WIDTH = 64;
    /// Pixels down a tile: one group.
    TILE_HEIGHT = 16;
    /// Pixels across and down a group: sixteen packets of 4x4 rays that are culled together.
    GROUP_SIDE = 16;
    /// Most tiles of a work unit: what its line has room for.
    UNIT_TILES = 31;
    /// With a tile's number in a unit: the framebuffer shows the background there. With a tile's cost: it does now.
    TILE_BLANK = 0x8000_0000;
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
        /// How work units are handed out: a `SPLIT_` value.
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
        /// Effective address of the unit counter; on a line.
        unit_counter: U64,
        /// Effective address of the statistics records, one a SPU in order; on a line.
        statistics: U64,
        /// Effective address of the work units; on a line.
        units: U64,
        /// Effective address of the lines that take the units' costs; on a line.
        costs: U64,
        /// Work units.
        unit_count: U32,
        /// What need not be tested: a `SKIP_` value.
        skip: U32,
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
        reserved: [U32; 2],
        /// Direction through the centre of pixel (0, 0): x, y, z, 0.
        corner: [F32; 4],
        /// Step of that direction to the next pixel of a row.
        right: [F32; 4],
        /// Step of that direction to the next row.
        down: [F32; 4],
        /// Background colour: red, green, blue, 0.
        background: [F32; 4],
        /// First work unit of each SPU's slice; a slice ends where the next begins.
        slices: [U32; 17],
        /// Zero; fills the last line.
        reserved_end: [U32; 31],
    }
}

record! {
    /// One sphere as the eye's rays meet it; the records come in rising order of `near`.
    Sphere as "SPHERE" {
        /// Centre less eye: x, y, z.
        centre: [F32; 3],
        /// Radius squared.
        radius_squared: F32,
        /// No ray of the eye enters it nearer than this.
        near: F32,
        /// A unit direction d whose ray enters it has centre.d above this, by the SPU's rounding too.
        ray_limit: F32,
        /// The same for the middle d of a packet, some ray of which enters it.
        packet_limit: F32,
        /// Radius, and the rounding of the test with a plane through the eye.
        reach: F32,
        /// Colour: red, green, blue, each 0 to 1.
        colour: [F32; 3],
        /// Zero.
        reserved: U32,
    }
}

record! {
    /// The line from which SPUs take work units by getllar and putllc.
    UnitCounter as "COUNTER" {
        /// Number of the next work unit.
        next: U32,
        /// Zero; fills the line.
        reserved: [U32; 31],
    }
}

record! {
    /// One work unit: tiles that one SPU traces.
    WorkUnit as "UNIT" {
        /// Tiles, at least 1.
        count: U32,
        /// Their numbers, counted row by row from the top left; `TILE_BLANK` with them.
        tiles: [U32; 31],
    }
}

record! {
    /// What a work unit has cost: the SPU that traced it writes this to the unit's line of `costs`.
    UnitCost as "COST" {
        /// Tiles, as in the unit.
        count: U32,
        /// Decrementer ticks that each tile took; `TILE_BLANK` with them.
        ticks: [U32; 31],
    }
}

record! {
    /// What one SPU says of one frame.
    Statistics as "STATS" {
        /// Number of the frame.
        number: U32,
        /// Tiles, traced or filled.
        tiles: U32,
        /// Packets of 4x4 rays, traced or filled.
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
        /// Of `tests_made`, those after which a hit was looked for.
        hits_looked_for: U64,
        /// Tiles that nothing can be seen in: filled.
        tiles_empty: U32,
        /// Of these, those that showed the background before: nothing was sent.
        tiles_blank: U32,
        /// Packets that nothing can be seen in, those of such tiles too: filled.
        packets_empty: U32,
        /// Tests left out because all of a packet's rays had hit something nearer.
        tests_hidden: U32,
        /// Tests of a frustum or of a packet's cone with an object.
        cull_tests: U32,
        /// Ticks spent fetching and checking the frame and its scene.
        ticks_fetch: U32,
        /// Ticks spent culling.
        ticks_cull: U32,
        /// Ticks spent making rays.
        ticks_rays: U32,
        /// Ticks spent testing rays with objects.
        ticks_isect: U32,
        /// Ticks spent shading and packing pixels.
        ticks_shade: U32,
        /// Zero; fills the line.
        reserved: [U32; 8],
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
        /// Address of the record of the object hit; of the background's if none.
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
    /// Local store: a packet of the group at hand, and where its pixels go.
    Place as "PLACE" {
        /// Address of the packet.
        packet: U32,
        /// Address of its top left pixel in the tile buffer.
        pixels: U32,
        /// Column of that pixel in the picture.
        x: U32,
        /// Row of that pixel.
        y: U32,
    }
}

record! {
    /// Local store: an object and a packet that is to be tested with it.
    Pair as "PAIR" {
        /// Address of the object's record.
        object: U32,
        /// Address of the packet.
        packet: U32,
        /// Anything.
        unused: [U32; 2],
    }
}

record! {
    /// Local store: four planes through the eye, one a lane; their normals point inwards.
    Frustum as "FRUSTUM" {
        /// Unit normals, x.
        normal_x: [F32; 4],
        /// Unit normals, y.
        normal_y: [F32; 4],
        /// Unit normals, z.
        normal_z: [F32; 4],
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
    /// Local store: how three quadwords of colour bytes become the framebuffer's words.
    PixelShuffle as "PIXELS" {
        /// Takes red and green to their places in the word.
        red_green: [U32; 4],
        /// Takes blue to its place.
        blue: [U32; 4],
    }
}

/// All records, in the order of the document.
pub const RECORDS: &[Record] = &[
    Frame::RECORD,
    Sphere::RECORD,
    UnitCounter::RECORD,
    WorkUnit::RECORD,
    UnitCost::RECORD,
    Statistics::RECORD,
    Packet::RECORD,
    Basis::RECORD,
    Place::RECORD,
    Pair::RECORD,
    Frustum::RECORD,
    Depth::RECORD,
    Colours::RECORD,
    PixelShuffle::RECORD,
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
    UnitCounter = 13, "unit_counter";
    /// Must be a multiple of 128.
    Statistics = 14, "statistics";
    /// Must be at most 1024, and 0 without `FEATURE_SPHERES`.
    SphereCount = 15, "sphere_count";
    /// Shifts must be 0, 8, 16 or 24, and differ.
    PixelFormat = 16, "red_shift, green_shift, blue_shift";
    /// Must be a multiple of 128.
    Units = 17, "units";
    /// Must be a multiple of 128.
    Costs = 18, "costs";
    /// Must be at most the tiles of the picture.
    UnitCount = 19, "unit_count";
    /// Must be a known way to skip.
    Skip = 20, "skip";
    /// A unit's tiles must be 1 to 31, each within the picture.
    Tile = 21, "tiles";
}

const _: () = {
    assert!(size_of::<Frame>() == 384);
    assert!(size_of::<Sphere>() == 48);
    assert!(size_of::<UnitCounter>() == LINE as usize);
    assert!(size_of::<WorkUnit>() == LINE as usize);
    assert!(size_of::<UnitCost>() == LINE as usize);
    assert!(size_of::<Statistics>() == LINE as usize);
    assert!(std::mem::offset_of!(Frame, corner) % 16 == 0);
    assert!(std::mem::offset_of!(Frame, framebuffer) % 8 == 0);
};
