//! The work-unit layout: the single definition for the PPU program and the SPU assembler.
//!
//! All records are big-endian on any host; the field types have that byte order.
//! [`crate::assembler`] writes every size, offset and constant to `work_unit.inc` for the SPU's
//! sources.

/// The description of a record, for the assembler.
#[derive(Clone, Copy, Debug)]
pub struct Record {
    /// The prefix of the assembler's names.
    pub name: &'static str,
    /// A description of the record.
    pub doc: &'static str,
    /// Bytes.
    pub size: usize,
    /// The fields, in their order.
    pub fields: &'static [Field],
}

/// A field of a [`Record`].
#[derive(Clone, Copy, Debug)]
pub struct Field {
    /// The name in Rust and in the assembler.
    pub name: &'static str,
    /// The type, as in the Rust source.
    pub kind: &'static str,
    /// The offset from the start of the record in bytes.
    pub offset: usize,
    /// Bytes.
    pub size: usize,
    /// A description of the field.
    pub doc: &'static str,
}

macro_rules! record {
    (
        $( #[doc = $doc:literal] )+
        $name:ident as $prefix:literal {
            $( $( #[doc = $field_doc:literal] )+ $field:ident: $kind:ty, )*
        }
    ) => {
        $( #[doc = $doc] )+
        #[derive(Clone, Copy, Debug, FromBytes, IntoBytes, Immutable, KnownLayout, Unaligned)]
        #[repr(C)]
        pub struct $name {
            $( $( #[doc = $field_doc] )+ pub $field: $kind, )*
        }

        impl $name {
            /// The description of the record.
            pub const RECORD: Record = Record {
                name: $prefix,
                doc: concat!($($doc),+),
                size: size_of::<$name>(),
                fields: &[ $( Field {
                    name: stringify!($field),
                    kind: stringify!($kind),
                    offset: std::mem::offset_of!($name, $field),
                    size: size_of::<$kind>(),
                    doc: concat!($($field_doc),+),
                }, )* ],
            };
        }
    };
}

macro_rules! constants {
    ( $( $( #[doc = $doc:literal] )+ $name:ident = $value:expr; )* ) => {
        $( $( #[doc = $doc] )+ pub const $name: u32 = $value; )*

        /// All constants above: name, value, description.
        pub const CONSTANTS: &[(&str, u32, &str)] =
            &[ $( (stringify!($name), $name, concat!($($doc),+)), )* ];
    };
}

constants! {
    /// `CRAY`, the first word of a frame descriptor.
    MAGIC = 0x4352_4159;
    /// Version of this layout; raised by every change that an older SPU program would misread.
    VERSION = 23;
    /// Alignment in bytes of every record in main memory: the line of the MFC's atomic commands.
    LINE = 128;
    /// Feature bit: the scene has spheres.
    FEATURE_SPHERES = 1;
    /// Feature bit: Whitted's model; the scene is the one that `scene` has, and there are no sphere
    /// records.
    FEATURE_WHITTED = 2;
    /// Feature bit: with Whitted's model, no shadows.
    FEATURE_NO_SHADOWS = 4;
    /// Feature bit: every call of a shader is checked for what it must keep.
    FEATURE_CHECK_SHADERS = 8;
    /// Feature bit: the scene of Whitted's model has a mesh in main memory.
    FEATURE_MESH = 16;
    /// Feature bit: pixels have sRGB's values, not linear light.
    FEATURE_SRGB = 32;
    /// Feature bit: light that is nearly white or brighter is limited without a step.
    FEATURE_ROLL_OFF = 64;
    /// Feature bit: the mesh in main memory has textures.
    FEATURE_TEXTURES = 128;
    /// Feature bit: the materials of the mesh are in main memory, too.
    FEATURE_MATERIALS = 256;
    /// Feature bit: the mesh in main memory has colours at its vertices.
    FEATURE_COLOURS = 512;
    /// Feature bit: a ray may send more than one ray on.
    FEATURE_BRANCHES = 1024;
    /// Feature bit: no picture is traced. The work units are `BUILD_UNIT`s, by which the SPUs refit
    /// or build the mesh as the `BUILD` at `scene` describes.
    FEATURE_BUILD = 2048;
    /// Feature bit: the scene has a height field. Its triangles have colours, so
    /// `FEATURE_COLOURS` is set, too.
    FEATURE_HEIGHTS = 4096;
    /// Feature bit: the height field is all that is in main memory, and rays from the eye find it
    /// by cuts, unless they are further samples of a pixel.
    FEATURE_CUTS = 8192;
    /// Feature bit, with `FEATURE_COLOURS`: the blocks of the mesh have the visibility of lights.
    FEATURE_VISIBILITY = 16384;
    /// All feature bits that this version has.
    FEATURES_KNOWN = 32767;
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
    /// Most spheres of a scene: the capacity of the local store.
    MAX_SPHERES = 1024;
    /// Pixels across a tile: groups side by side.
    TILE_WIDTH = 64;
    /// Pixels down a tile: one group.
    TILE_HEIGHT = 16;
    /// Pixels across and down a group: sixteen packets of 4x4 rays that are culled together.
    GROUP_SIDE = 16;
    /// Most tiles of a work unit: its line holds no more.
    UNIT_TILES = 31;
    /// Flag. With a tile's number in a unit: the framebuffer shows the background there. With a
    /// tile's cost: it shows the background now.
    TILE_BLANK = 0x8000_0000;
    /// Flag. With a tile's number in a unit: the framebuffer shows the tile as its `PATHS` have it,
    /// so only those of its subtiles are traced that the frame's changes may have reached. With a
    /// tile's cost: the tile's `PATHS` have all of its rays.
    TILE_HAS_PATHS = 0x4000_0000;
    /// Flag with a tile's cost: the tile was not traced, or only in part.
    TILE_KEPT = 0x2000_0000;
    /// All flags of tiles and of their costs.
    TILE_FLAGS = TILE_BLANK | TILE_HAS_PATHS | TILE_KEPT;
    /// Pixels across a subtile: the part of a tile that is traced again or kept.
    SUBTILE_WIDTH = 8;
    /// Pixels down a subtile. A tile has 32 of them, a bit each.
    SUBTILE_HEIGHT = 4;
    /// Bytes for the `PATHS` of a tile and the `PATH` records that follow.
    PATHS_CAPACITY = 24576;
    /// Most `PATH` records of a tile.
    MAX_PATHS = 511;
    /// Most `NODE` records of changed places in a frame.
    MAX_CHANGES = 9;
    /// Largest position of a colour channel in the pixel word.
    MAX_SHIFT = 24;
    /// Most bytes of one DMA transfer.
    MAX_TRANSFER = 16384;
    /// Address in local store of the buffers that depth shading and Whitted's model each use in
    /// their own way.
    ARENA_ADDRESS = 0x17f80;
    /// Address in local store of the scene of Whitted's model, which begins with the background's
    /// `OBJECT`.
    SCENE_ADDRESS = 0x2a980;
    /// Bytes for the scene and the waiting rays.
    SCENE_CAPACITY = 0x1_4600;
    /// Address in local store of the code that tests boxes, after the background's `OBJECT` and
    /// `MATERIAL`; only the scenes with trees of boxes have it.
    BOX_CODE = SCENE_ADDRESS + 144;
    /// Bytes for that code.
    BOX_CODE_CAPACITY = 4736;
    /// Address in local store of the code that traces tiles with depth shading, which scenes of
    /// Whitted's model overwrite.
    DEPTH_CODE = 0x2d100;
    /// Bytes for that code.
    DEPTH_CODE_CAPACITY = 19968;
    /// Address in local store of the code that refits and builds meshes, in the memory of scenes.
    /// Each frame with `FEATURE_BUILD` brings it in. The code for spheres and cones is among it, in
    /// the place of the code that tests boxes.
    BUILD_CODE = 0x29100;
    /// Bytes for that code.
    BUILD_CODE_CAPACITY = 16384;
    /// `task` of a `BUILD`: leaf blocks are refitted.
    BUILD_REFIT = 0;
    /// `task`: chunks of triangles are sorted.
    BUILD_SORT = 1;
    /// `task`: sorted triangles are packed into leaf blocks.
    BUILD_PACK = 2;
    /// `task`: sorted spheres and cones are packed into leaf blocks.
    BUILD_PACK_OBJECTS = 3;
    /// In a `BUILD_TRIANGLE`'s `second`: it stands for a cone. The bit is `SIDES_BOTH` of
    /// triangles.
    BUILD_CONE = 0x4000_0000;
    /// The fewest spheres or cones of a leaf block, unless it has the last ones of their kind.
    BUILD_FEWEST = 10;
    /// The most.
    BUILD_MOST = 16;
    /// The load address, in the program's file, of the code for spheres and cones that
    /// `BUILD_CODE` has at `BOX_CODE`. No code has it in local store.
    OBJECTS_CODE_LOAD = 0x4_3000;
    /// Most triangles that are sorted together.
    BUILD_CHUNK = 4096;
    /// Most leaf blocks of a `BUILD_UNIT`.
    BUILD_LEAVES = 16;
    /// Most objects of one shape.
    MAX_OBJECTS = 1024;
    /// Most lights.
    MAX_LIGHTS = 64;
    /// Most nodes at the top of a tree.
    MAX_ROOTS = 4;
    /// Distance of a ray that has hit nothing, as bits: 2^62. Every host has its square, too.
    FARTHEST = 0x5e80_0000;
    /// Most levels of nodes.
    MAX_LEVELS = 6;
    /// Most rays in a chain, including the primary ray.
    MAX_DEPTH = 16;
    /// Bytes of main memory for queued rays of an SPU that don't fit in local store.
    WAITING_SIZE = 0x2_0000;
    /// In a ray's `pixel`: what one ray that came before it in its chain adds.
    CHAIN_STEP = 0x0100_0000;
    /// The mark of a packet of hits with highlights.
    SITE_SHINES = 0x80;
    /// Most packets that are traced together.
    MAX_BATCH = 16;
    /// Most packets that fit in the buffers of the arena. With a mesh there are no more. The
    /// rays of more packets are at the end of the scene's memory.
    SMALL_BATCH = 8;
    /// Most objects of one shape in a scene with larger batches.
    LARGE_OBJECTS = 512;
    /// Index of the tree of spheres in the frame's `trees`.
    BVH_SPHERES = 0;
    /// Index of the tree of parallelograms.
    BVH_RECTANGLES = 1;
    /// Index of the tree of triangles.
    BVH_TRIANGLES = 2;
    /// Index of the tree of cones.
    BVH_CONES = 3;
    /// Trees of a frame.
    TREES = 4;
    /// In `sides`: both sides are seen.
    SIDES_BOTH = 0x4000_0000;
    /// In `sides`: a sphere or cone is hit only where a ray leaves it.
    SIDES_EXIT = 0x8000_0000;
    /// In `sides`: a triangle with normals at its vertices.
    SIDES_SMOOTH = 0x2000_0000;
    /// In `sides`: a triangle of a mesh with texture coordinates at its vertices.
    SIDES_TEXTURED = 0x1000_0000;
    /// In `sides`: the triangles of a block whose materials have numbers of 16 bits. Their upper
    /// bytes are at `MESH_UPPER`.
    SIDES_WIDE = 0x0800_0000;
    /// In `sides`: a triangle of a mesh with colours at its vertices.
    SIDES_COLOURED = 0x0400_0000;
    /// In `sides`, with `SIDES_COLOURED`: a triangle of a mesh with the visibility of lights.
    SIDES_VISIBILITY = 0x0200_0000;
    /// First word of a mesh's block: `MESH`.
    MESH_MAGIC = 0x4d45_5348;
    /// Bytes of a mesh's block.
    MESH_BLOCK = 2048;
    /// Most blocks of a mesh.
    MESH_BLOCKS = 0x0100_0000;
    /// `kind` of a block: its children are blocks.
    MESH_INNER = 0;
    /// `kind` of a block: its children are runs of triangles.
    MESH_LEAF = 1;
    /// `kind` of a block: its children are spheres.
    MESH_SPHERES = 2;
    /// `kind` of a block: its children are cones.
    MESH_CONES = 3;
    /// Most levels of nodes in a block.
    MESH_LEVELS = 3;
    /// Most triangles of a block: an index of 7 bits.
    MESH_FACES = 127;
    /// Most vertices of a block: an index of 8 bits.
    MESH_VERTICES = 255;
    /// Most triangles of a run.
    MESH_RUN = 8;
    /// Offset in a block with `SIDES_WIDE` of a byte for each triangle, in their order.
    MESH_UPPER = 1920;
    /// Most materials of a mesh in local store.
    MESH_MATERIALS = 256;
    /// Most materials of a mesh in main memory.
    STREAMED_MATERIALS = 0x1_0000;
    /// Bytes from one of these to the next: a line.
    MATERIAL_STRIDE = 128;
    /// Most textures of a mesh.
    MESH_TEXTURES = 256;
    /// Bytes at the end of the scene's memory for the code that traces meshes.
    MESH_CODE_CAPACITY = 31616;
    /// Address in local store of that code.
    MESH_CODE = SCENE_ADDRESS + SCENE_CAPACITY - MESH_CODE_CAPACITY;
    /// Bytes in front of it for the code that traces eye rays through meshes without textures.
    EYE_CODE_CAPACITY = 7424;
    /// Address in local store of that code.
    EYE_CODE = MESH_CODE - EYE_CODE_CAPACITY;
    /// Fewest blocks that the cache of an SPU must hold.
    MESH_MIN_SLOTS = 4;
    /// Most blocks that the cache of an SPU can have.
    MESH_MAX_SLOTS = 20;
    /// Entries of the table of leaf blocks, `MESH_LEAVES`: a block's is that of the last bits of its
    /// number.
    MESH_LEAF_PLACES = 32;
    /// In `object` of `RAYS16`: a triangle of a mesh. Added to it are the number of the block times
    /// 128, and the triangle's index in it.
    MESH_HIT = 0x8000_0000;
    /// Texels across and down a tile of a texture, whose neighbours have its last ones, too.
    TEXTURE_SIDE = 9;
    /// Bytes of a tile: three lines.
    TEXTURE_TILE = 384;
    /// Most tiles of all textures.
    TEXTURE_TILES = 0x0010_0000;
    /// Most texels across and down a texture.
    MAX_TEXTURE_SIDE = 4096;
    /// Most levels of all textures.
    TEXTURE_LEVELS = 1024;
    /// Tiles in an SPU's cache.
    TEXTURE_SLOTS = 16;
    /// Bytes in front of `EYE_CODE` for the code that looks up textures.
    TEXTURE_CODE_CAPACITY = 4096;
    /// Address in local store of that code.
    TEXTURE_CODE = EYE_CODE - TEXTURE_CODE_CAPACITY;
    /// Bytes in front of `TEXTURE_CODE` for the code that interpolates colours, of meshes with or
    /// without textures.
    COLOUR_CODE_CAPACITY = 2688;
    /// Address in local store of that code.
    COLOUR_CODE = TEXTURE_CODE - COLOUR_CODE_CAPACITY;
    /// Bytes in front of `COLOUR_CODE` for the code that makes triangles of a height field.
    HEIGHT_CODE_CAPACITY = 7936;
    /// Address in local store of that code.
    HEIGHT_CODE = COLOUR_CODE - HEIGHT_CODE_CAPACITY;
    /// Bytes from `TEXTURE_CODE` on for the code that finds ground by cuts. The code for eye rays
    /// is not there then.
    CUTS_CODE_CAPACITY = TEXTURE_CODE_CAPACITY + EYE_CODE_CAPACITY;
    /// The load address of that code in the program's file, which no code has in local store.
    CUTS_CODE_LOAD = 0x4_0000;
    /// The most fours of cuts that are followed together: all that a tile may have.
    MAX_CUT_FOURS = 48;
    /// In a block's number: a block of a height field, which an SPU makes of samples. Added to it
    /// are the level times 2^19, the block's row times 2^9, and its column.
    HEIGHT_BLOCK = 0x0080_0000;
    /// In a block's number: an inner block above those of a height field. Its index is added.
    HEIGHT_TREE = 0x0040_0000;
    /// Squares across a block of a height field.
    HEIGHT_COLUMNS = 8;
    /// Squares down a block.
    HEIGHT_ROWS = 4;
    /// Most squares across and down a height field.
    MAX_HEIGHT_SIDE = 4096;
    /// Most levels of a height field whose triangles are traced. There is one level of samples
    /// more, which the last of these fades to.
    HEIGHT_LEVELS = 10;
    /// Levels of the cells with the ground's own shadow.
    SHADE_LEVELS = 6;
    /// Logarithm of a block's cells across and down.
    SHADE_SIDE_LOG2 = 3;
    /// Mask of the bits of a block's upper bound that count lines, and their value without an end.
    SHADE_ENDLESS = 255;
    /// Blocks of a row of these cells beside those of the field.
    SHADES_BESIDE = 5;
    /// Offset in a block where its samples arrive: rows of `HEIGHT_PITCH` bytes of its own level,
    /// then rows of `COARSE_PITCH` bytes of the next.
    HEIGHT_SAMPLES = 1360;
    /// Bytes of a row of samples: those of its vertices, four in front and three at the end.
    HEIGHT_PITCH = 64;
    /// Bytes of a row of samples of the next level: as many in front, and three at the end.
    COARSE_PITCH = 48;
    /// Address in local store of the tiles, which are in the place of the code for eye rays.
    TEXTURE_CACHE = EYE_CODE;
    /// In `wraps` of a texture: it is repeated at its sides.
    WRAP_ACROSS = 8;
    /// In `wraps`: with `WRAP_ACROSS`, it is mirrored each second time.
    WRAP_MIRRORED_ACROSS = 4;
    /// In `wraps`: it is repeated above and below.
    WRAP_DOWN = 2;
    /// In `wraps`: with `WRAP_DOWN`, it is mirrored each second time.
    WRAP_MIRRORED_DOWN = 1;
    /// Bits of `wraps` below the number of the texture's first tile.
    WRAP_BITS = 4;
    /// Corner of a box that is not there, as bits: 2^66, sixteen times `FARTHEST`.
    NO_BOX = 0x6080_0000;
    /// In `flags` of a material: it transmits light.
    MATERIAL_TRANSMITS = 1;
    /// In `flags`: it reflects light.
    MATERIAL_MIRRORS = 2;
    /// In `flags`: it is lit by lights.
    MATERIAL_LIT = 4;
    /// In `flags`: it has a highlight.
    MATERIAL_SHINES = 8;
    /// In `flags`: it has a shader of its own.
    MATERIAL_SHADED = 16;
    /// In `flags`: it has a texture, or triangles with colours at their vertices may have it.
    MATERIAL_TEXTURED = 32;
    /// In `flags`: its colour is light that it sends.
    MATERIAL_FLAT = 64;
    /// With the status `Shader`, times 256: no shader has this number. Added to it is the number
    /// times 2^24, at most 255.
    RULE_KNOWN = 1;
    /// The same: the shader changed a register. Added to it is the register's number times 2^16.
    RULE_REGISTER = 2;
    /// The same: the shader wrote below its stack.
    RULE_STACK = 3;
    /// The same: the shader changed a surface that it was not to shade.
    RULE_LANES = 4;
}

mod build;
mod frame;
mod height;
mod local;
mod mesh;
mod whitted;

pub use build::*;
pub use frame::*;
pub use height::*;
pub use local::*;
pub use mesh::*;
pub use whitted::*;

/// All records, in the order of the document.
pub const RECORDS: &[Record] = &[
    Frame::RECORD,
    Sphere::RECORD,
    UnitCounter::RECORD,
    WorkUnit::RECORD,
    UnitCost::RECORD,
    Statistics::RECORD,
    Generation::RECORD,
    Packet::RECORD,
    Basis::RECORD,
    Place::RECORD,
    Pair::RECORD,
    Frustum::RECORD,
    Depth::RECORD,
    Colours::RECORD,
    PixelShuffle::RECORD,
    Object::RECORD,
    Rectangle::RECORD,
    Triangle::RECORD,
    Patch::RECORD,
    Cone::RECORD,
    Material::RECORD,
    Light::RECORD,
    Node::RECORD,
    BoxNode::RECORD,
    Bvh::RECORD,
    RayPacket::RECORD,
    QueuedRay::RECORD,
    Bound::RECORD,
    Paths::RECORD,
    Path::RECORD,
    Candidate::RECORD,
    Shear::RECORD,
    Surfaces::RECORD,
    Site::RECORD,
    ShaderContext::RECORD,
    MeshHeader::RECORD,
    Boxes::RECORD,
    MeshVertex::RECORD,
    MeshFace::RECORD,
    MeshBound::RECORD,
    MeshCandidate::RECORD,
    MeshWindow::RECORD,
    MeshRows::RECORD,
    MeshLeaf::RECORD,
    MeshHit::RECORD,
    MeshRay::RECORD,
    MeshVisit::RECORD,
    MeshCoordinates::RECORD,
    MeshColour::RECORD,
    MeshVisibility::RECORD,
    Build::RECORD,
    BuildUnit::RECORD,
    BuildBounds::RECORD,
    BuildTriangle::RECORD,
    Texture::RECORD,
    TextureLevel::RECORD,
    Texels::RECORD,
    Heights::RECORD,
    HeightLevel::RECORD,
];

macro_rules! statuses {
    ( $( #[doc = $doc:literal] $name:ident = $value:literal, $field:literal; )* ) => {
        /// An SPU's reply to a frame: 0, or the rule that the frame breaks.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum Status {
            $( #[doc = $doc] $name = $value, )*
        }

        impl Status {
            /// All statuses: the assembler's name, the status, the field that it concerns, the
            /// rule.
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
    /// Must be a multiple of 128.
    Scene = 22, "scene";
    // The queue has space for 48 `batch` rays if chains have more than one; the buffers of a `batch`
    // of more than 8 are in the same memory.
    /// Must be a multiple of 128 and leave space in `SCENE_CAPACITY` for the queue and the batch.
    SceneBytes = 23, "scene_bytes, ray_depth, batch";
    /// Must be 1 to 16.
    RayDepth = 24, "ray_depth";
    /// Must be 1 to 16, and at most 8 with a mesh or more than 512 objects of a shape.
    Batch = 25, "batch";
    /// Must be at most 64 lights on quadwords of the scene.
    LightCount = 26, "lights, light_count";
    /// Must have at most 4 nodes at the top, 6 levels of them and 1024 objects, and lie in the scene.
    Trees = 27, "trees";
    /// There must be one of this number, and it must keep $1 and $80 to $127, its stack within 1 KB and the lanes that it is not to shade.
    Shader = 28, "shader";
    /// Must be a multiple of 128, and its bytes a multiple of 16: at most 19968 for depth shading, 39040 for a mesh, 31616 for one with textures, and 16 to 5120 to refit one.
    Code = 29, "code, code_bytes";
    /// Must be a multiple of 128, with 1 to 2^24 blocks.
    Mesh = 30, "mesh, mesh_blocks";
    /// Must be 1 to 256 materials on quadwords of the scene; or, in main memory, a multiple of 256 up to 65536 at a multiple of 128.
    MeshMaterials = 31, "mesh_materials, mesh_material_count, materials";
    /// Must be a multiple of 128, with 4 to 20 blocks behind the rays that wait and before the code.
    MeshCache = 32, "mesh_cache, mesh_slots";
    /// A block must be as the work unit's document has it, and its children must come after it.
    MeshBlock = 33, "mesh";
    /// Must be 1, 4 or 16 samples, and a contrast of at most 255.
    Samples = 34, "samples, contrast";
    /// Must be a multiple of 128, and its bytes a multiple of 16, at most 4096.
    TextureCode = 35, "texture_code, texture_code_bytes";
    /// Must be a multiple of 128, with 1 to 2^20 tiles.
    Textures = 36, "textures, texture_tiles";
    /// Must be 1 to 256 textures with up to 1024 levels, on quadwords of the scene.
    TextureRecords = 37, "texture_records, texture_count, texture_level_count";
    /// A texture's levels must be among those of the frame and their tiles among its tiles, and a material must have one of the textures, or none.
    Texture = 38, "texture_records";
    /// Must be a multiple of 128.
    Waiting = 39, "waiting";
    /// Must be bits of the 4 trees, and with any, the scene must have the 4736 bytes of the code for boxes.
    BoxTrees = 40, "box_trees, scene_bytes";
    /// Must be a multiple of 128.
    ColourCode = 41, "colour_code";
    /// Must be a multiple of 128.
    Paths = 42, "paths";
    /// Must be a multiple of 16, with at most 9 nodes.
    Changes = 43, "changes, change_count";
    /// A `BUILD` must have a task, its records at multiples of 128, and vertices and sorted triangles that do not reach across a multiple of 2^32; a `BUILD_UNIT` as many blocks or triangles as its record allows, and a list of as many vertices or triangles as these have; a block must be as the mesh's document has it, and each triangle's vertices must exist.
    Build = 44, "scene, units";
    /// Must be a multiple of 128, with 1 to 10 levels.
    Heights = 45, "heights";
    /// Must be with a height field whose materials are in local store, with 1 to 48 fours, and code at a multiple of 128, its bytes a multiple of 16, at most 11520.
    Cuts = 46, "features, cut_fours, cut_code, cut_code_bytes";
}

const _: () = {
    assert!(std::mem::offset_of!(Frame, trees) % 16 == 0);
    assert!(
        BOX_CODE == SCENE_ADDRESS + (size_of::<Object>() + size_of::<Material>()) as u32
            && BOX_CODE_CAPACITY.is_multiple_of(16)
    );
    assert!(size_of::<Frame>() == 640);
    assert!(TEXTURE_SIDE * TEXTURE_SIDE * 4 <= TEXTURE_TILE);
    assert!(std::mem::offset_of!(Frame, mesh) % 16 == 0);
    assert!(MESH_UPPER + MESH_FACES < MESH_BLOCK && MESH_UPPER.is_multiple_of(16));
    assert!(size_of::<Material>() <= MATERIAL_STRIDE as usize);
    assert!(COLOUR_CODE.is_multiple_of(LINE) && HEIGHT_CODE.is_multiple_of(LINE));
    assert!(HEIGHT_BLOCK * 2 == MESH_BLOCKS && HEIGHT_TREE * 2 == HEIGHT_BLOCK);
    assert!(HEIGHT_LEVELS <= 1 << 4 && MAX_HEIGHT_SIDE / HEIGHT_COLUMNS == 1 << 9);
    assert!(MAX_HEIGHT_SIDE / HEIGHT_ROWS == 1 << 10);
    assert!(HEIGHT_SAMPLES + 7 * HEIGHT_PITCH + 5 * COARSE_PITCH == MESH_BLOCK);
    assert!(size_of::<Sphere>() == 48);
    assert!(size_of::<Paths>() + MAX_PATHS as usize * size_of::<Path>() <= PATHS_CAPACITY as usize);
    assert!(size_of::<UnitCounter>() == LINE as usize);
    assert!(size_of::<BuildUnit>() == size_of::<WorkUnit>());
    assert!(size_of::<WorkUnit>() == LINE as usize);
    assert!(size_of::<UnitCost>() == LINE as usize);
    assert!(size_of::<Statistics>() == 5 * LINE as usize);
    assert!(std::mem::offset_of!(Statistics, generations) % 16 == 0);
    assert!(std::mem::offset_of!(Frame, corner) % 16 == 0);
    assert!(std::mem::offset_of!(Frame, framebuffer) % 8 == 0);
};
