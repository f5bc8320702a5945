//! Records in main memory that every frame has.

use zerocopy::big_endian::{F32, U32, U64};
use zerocopy::{FromBytes, Immutable, IntoBytes, KnownLayout, Unaligned};

use super::{Bvh, Field, Record};

record! {
    /// Frame descriptor: the record whose address the PPU mails.
    Frame as "FRAME" {
        /// `MAGIC`.
        magic: U32,
        /// `VERSION`.
        version: U32,
        /// Bytes of this record.
        size: U32,
        /// Parts that the scene has: `FEATURE_` bits.
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
        /// Effective address of the sphere records; a multiple of 128.
        spheres: U64,
        /// Effective address of the unit counter; a multiple of 128.
        unit_counter: U64,
        /// Effective address of the statistics records, one for each SPU, in order; a multiple of
        /// 128.
        statistics: U64,
        /// Effective address of the work units; a multiple of 128.
        units: U64,
        /// Effective address of the lines for the units' costs; a multiple of 128.
        costs: U64,
        /// Work units.
        unit_count: U32,
        /// Tests that may be left out: a `SKIP_` value.
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
        /// Effective address of the scene of Whitted's model, or with `FEATURE_BUILD` of a `BUILD`;
        /// a multiple of 128.
        scene: U64,
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
        /// Bytes of the scene; a multiple of 128.
        scene_bytes: U32,
        /// Most rays in a chain, including the primary ray.
        ray_depth: U32,
        /// Packets that are traced together, at most `MAX_BATCH`.
        batch: U32,
        /// Where in local store the lights are, one after the other.
        lights: U32,
        /// Lights.
        light_count: U32,
        /// A ray whose weight in its pixel is below this is not sent on.
        least_weight: F32,
        /// Trees whose nodes are boxes: the bit 1 << index for each. With any, the scene has the
        /// code for them at `BOX_CODE`.
        box_trees: U32,
        /// The objects: spheres, parallelograms, triangles, cones.
        trees: [Bvh; 4],
        /// Brightness of the ambient light: red, green, blue, 0.
        ambient: [F32; 4],
        /// The density of the fog, times the logarithm of e with the base 2; its red, green, blue.
        /// A density of 0 is none.
        fog: [F32; 4],
        /// The eye in the scene's coordinates: x, y, z, 0; for shaders.
        eye: [F32; 4],
        /// The eye in the mesh's coordinates: x, y, z, 0.
        mesh_eye: [F32; 4],
        /// Effective address of the mesh's first block; a multiple of 128. With `FEATURE_BUILD`
        /// these are the blocks as they were built.
        mesh: U64,
        /// Effective address of the code that other scenes may have overwritten; a multiple of 128.
        /// Depth shading needs what the program has at `DEPTH_CODE`, and a mesh what it has from
        /// `EYE_CODE` on, or with textures from `MESH_CODE` on. With `FEATURE_BUILD` it is what the
        /// program has at `BUILD_CODE`.
        code: U64,
        /// Blocks of the mesh.
        mesh_blocks: U32,
        /// Bytes of that code; a multiple of 16.
        code_bytes: U32,
        /// Where in local store the first of the mesh's materials is, which the others follow; not
        /// used with `FEATURE_MATERIALS`.
        mesh_materials: U32,
        /// Materials of the mesh. With `FEATURE_MATERIALS` it is a multiple of 256, and there may
        /// be some that nothing has.
        mesh_material_count: U32,
        /// Where in local store blocks are cached; a multiple of 128.
        mesh_cache: U32,
        /// Blocks that are cached.
        mesh_slots: U32,
        /// Samples of a pixel that is antialiased: 4 or 16; 1: none is.
        samples: U32,
        /// A pixel is antialiased if a channel differs by at least this, in 1/255, from a neighbour
        /// in its tile; 0: every pixel is.
        contrast: U32,
        /// Effective address of the textures' first tile; a multiple of 128.
        textures: U64,
        /// Effective address of the code that looks up textures; a multiple of 128.
        texture_code: U64,
        /// Bytes of that code; a multiple of 16.
        texture_code_bytes: U32,
        /// Tiles of all textures.
        texture_tiles: U32,
        /// Where in local store the first `TEXTURE` is, which the others and then the levels
        /// follow.
        texture_records: U32,
        /// Textures.
        texture_count: U32,
        /// Levels of all textures.
        texture_level_count: U32,
        /// The angle between the rays of neighbouring pixels in the middle of the picture.
        pixel_angle: F32,
        /// Effective address of the buffers for queued rays, `WAITING_SIZE` bytes for each SPU, in
        /// order; a multiple of 128.
        waiting: U64,
        /// Effective address of the first of the mesh's materials with `FEATURE_MATERIALS`, a
        /// `MATERIAL` each `MATERIAL_STRIDE` bytes; a multiple of 128.
        materials: U64,
        /// Effective address of the code that interpolates colours, `COLOUR_CODE_CAPACITY` bytes;
        /// a multiple of 128. With `FEATURE_HEIGHTS`, the `HEIGHT_CODE_CAPACITY` bytes at
        /// `HEIGHT_CODE` are in front of it.
        colour_code: U64,
        /// Effective address of the `PATHS` of all tiles, `PATHS_CAPACITY` bytes each; a multiple
        /// of 128. 0: the SPUs keep none.
        paths: U64,
        /// Effective address of the places in which something has changed, `NODE` records; a
        /// multiple of 16.
        changes: U64,
        /// These records; without them nothing has changed in a tile with `TILE_HAS_PATHS`. If
        /// there are several, the spheres of the first one are around those of all others.
        change_count: U32,
        /// 0.
        reserved: U32,
        /// Effective address of the `HEIGHTS` with `FEATURE_HEIGHTS`; a multiple of 128.
        heights: U64,
        /// With `FEATURE_CUTS`: the part of a ray's direction across the view's horizontal axis: of
        /// the ray through pixel (0, 0), what the next pixel of a row adds, and the next row; 0.
        cut_lat: [F32; 4],
        /// The same along that axis.
        cut_den: [F32; 4],
        /// The same upwards.
        cut_num: [F32; 4],
        /// That axis, x and z, and the one across it.
        cut_ahead: [F32; 4],
        /// Fours of cuts that are followed together, so few that the ground between them fits.
        cut_fours: U32,
        /// Bytes of the code for cuts; a multiple of 16.
        cut_code_bytes: U32,
        /// Effective address of that code; a multiple of 128.
        cut_code: U64,
    }
}

record! {
    /// One sphere relative to the eye, for primary rays; the records are in rising order of `near`.
    /// For programs whose kernel takes `EyeRecord::Axis`, all lengths except `near` are fractions
    /// of `distance`.
    Sphere as "SPHERE" {
        /// Centre less eye: x, y, z.
        centre: [F32; 3],
        /// Radius squared.
        radius_squared: F32,
        /// No primary ray enters the sphere nearer than this.
        near: F32,
        /// If a ray of unit direction d enters the sphere, centre.d is above this, also with the
        /// SPU's rounding.
        ray_limit: F32,
        /// The same for a packet: if any of its rays enters the sphere, the packet's middle d is
        /// above this.
        packet_limit: F32,
        /// Radius plus the rounding of the test with a plane through the eye.
        reach: F32,
        /// Colour: red, green, blue, each 0 to 1.
        colour: [F32; 3],
        /// Distance of the centre from the eye.
        distance: F32,
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
        /// The tiles' numbers, counted row by row from the top left, with the flags `TILE_BLANK`
        /// and `TILE_HAS_PATHS`.
        tiles: [U32; 31],
    }
}

record! {
    /// The cost of a work unit, which the SPU that traced it writes to the unit's line of `costs`.
    UnitCost as "COST" {
        /// Tiles, as in the unit.
        count: U32,
        /// Decrementer ticks that each tile took, at most about 2^29, with the flags `TILE_BLANK`,
        /// `TILE_HAS_PATHS` and `TILE_KEPT`.
        ticks: [U32; 31],
    }
}

record! {
    /// One SPU's report on one frame.
    Statistics as "STATS" {
        /// Number of the frame.
        number: U32,
        /// Zero; aligns the following fields to doublewords.
        unused: U32,
        /// Tiles, traced or filled.
        tiles: U64,
        /// Packets of 4x4 rays, traced or filled.
        packets: U64,
        /// Primary rays within the picture.
        primary_rays: U64,
        /// Primary rays that hit something.
        eye_hits: U64,
        /// Decrementer ticks from the mail to the reply, less `dma_wait`.
        busy: U64,
        /// Decrementer ticks spent waiting for the MFC.
        dma_wait: U64,
        /// Decrementer ticks spent waiting for the mail, less 2^32 for each time that the
        /// decrementer wrapped round meanwhile.
        idle: U64,
        /// Tests of one packet with one object, except those that `generations` count.
        tests_made: U64,
        /// Such tests without any skipping, including those that `generations` count.
        tests_possible: U64,
        /// Those of `tests_made` after which the SPU computed the intersections.
        intersections_computed: U64,
        /// Tiles in which nothing can be seen: filled.
        tiles_empty: U64,
        /// Of these, those that showed the background before: nothing was sent.
        tiles_blank: U64,
        /// Packets in which nothing can be seen, including those of such tiles: filled.
        packets_empty: U64,
        /// Tests left out because all of a packet's rays had hit something nearer.
        tests_hidden: U64,
        /// Tests of a frustum or of a packet's cone with an object, except those that `generations`
        /// count.
        cull_tests: U64,
        /// Ticks spent fetching and checking the frame and its scene.
        ticks_fetch: U64,
        /// Ticks spent culling.
        ticks_cull: U64,
        /// Ticks spent making rays.
        ticks_rays: U64,
        /// Ticks spent testing rays with objects.
        ticks_isect: U64,
        /// Ticks spent shading and packing pixels.
        ticks_shade: U64,
        /// Reflected rays.
        reflected: U64,
        /// Refracted rays.
        refracted: U64,
        /// Shadow rays.
        shadow: U64,
        /// Eye, reflected and refracted rays that hit something.
        hits: U64,
        /// Primary rays beyond the first one of each pixel.
        samples: U64,
        /// Tiles of textures that were looked up, each for a whole packet.
        texture_tiles_used: U64,
        /// Tiles of textures that were fetched.
        texture_tiles_fetched: U64,
        /// Tiles of which no subtile was traced, because no change reached them.
        tiles_kept: U64,
        /// Pixels that were not traced for that reason, including those of other tiles' subtiles.
        pixels_kept: U64,
        /// With Whitted's model: eye rays, the shadow rays from where they hit, the rays that these
        /// surfaces send on, their shadow rays, and the same for all later rays. A batch counts as
        /// its first ray's generation.
        generations: [Generation; 6],
        /// Not written; fills the last line.
        reserved: [U64; 2],
    }
}

record! {
    /// The work for rays of one generation, or for their shadow rays.
    Generation as "GENERATION" {
        /// Rays, including those of primary rays' packets that are beyond the picture.
        rays: U64,
        /// Packets that these rays filled, some of them only in part.
        packets: U64,
        /// Tests of a packet's cone or of its rays with a node or its children.
        cull_tests: U64,
        /// Tests of one packet with one object.
        tests_made: U64,
        /// Blocks of meshes that were looked up, each for a whole batch.
        blocks_used: U64,
        /// Blocks of meshes that were fetched.
        blocks_fetched: U64,
        /// Packets whose rays were themselves tested with nodes, because they were scattered.
        packets_scattered: U64,
        /// Ticks of `dma_wait` spent waiting for blocks of meshes.
        ticks_block_wait: U64,
    }
}
