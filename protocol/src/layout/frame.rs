//! Records in main memory that every frame has.

use zerocopy::big_endian::{F32, U32, U64};
use zerocopy::{FromBytes, Immutable, IntoBytes, KnownLayout, Unaligned};

use super::{Bvh, Field, Record};

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
        /// Effective address of the scene of Whitted's model; on a line.
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
        /// Most rays in a chain, the eye's counted.
        ray_depth: U32,
        /// Packets that are traced together, at most `MAX_BATCH`.
        batch: U32,
        /// Where in local store the lights are, one after the other.
        lights: U32,
        /// Lights.
        light_count: U32,
        /// A ray whose weight in its pixel is below this is not sent on.
        least_weight: F32,
        /// Zero; keeps the trees on quadwords.
        reserved: U32,
        /// The objects: spheres, parallelograms, triangles, cones.
        trees: [Bvh; 4],
        /// Brightness of the light that is everywhere: red, green, blue, 0.
        ambient: [F32; 4],
        /// The eye in the scene's coordinates: x, y, z, 0; for shaders.
        eye: [F32; 4],
    }
}

record! {
    /// One sphere as primary rays meet it; the records come in rising order of `near`. For programs whose kernel takes `EyeRecord::Axis`, all lengths but `near` are in parts of `distance`.
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
        /// Their numbers, counted row by row from the top left; `TILE_BLANK` with them.
        tiles: [U32; 31],
    }
}

record! {
    /// What a work unit has cost: the SPU that traced it writes this to the unit's line of `costs`.
    UnitCost as "COST" {
        /// Tiles, as in the unit.
        count: U32,
        /// Decrementer ticks that each tile took, about 2^29 for all that took longer; `TILE_BLANK` with them.
        ticks: [U32; 31],
    }
}

record! {
    /// What one SPU says of one frame.
    Statistics as "STATS" {
        /// Number of the frame.
        number: U32,
        /// Zero; keeps what follows on doublewords.
        unused: U32,
        /// Tiles, traced or filled.
        tiles: U64,
        /// Packets of 4x4 rays, traced or filled.
        packets: U64,
        /// Primary rays within the picture.
        primary_rays: U64,
        /// Primary rays that hit something.
        eye_hits: U64,
        /// Decrementer ticks from the mail to the answer, less `dma_wait`.
        busy: U64,
        /// Decrementer ticks spent waiting for the MFC.
        dma_wait: U64,
        /// Decrementer ticks spent waiting for the mail, less 2^32 each time that the decrementer has come round in that.
        idle: U64,
        /// Tests of one packet with one object.
        tests_made: U64,
        /// Such tests that were found needless.
        tests_skipped: U64,
        /// Of `tests_made`, those after which a hit was looked for.
        hits_looked_for: U64,
        /// Tiles that nothing can be seen in: filled.
        tiles_empty: U64,
        /// Of these, those that showed the background before: nothing was sent.
        tiles_blank: U64,
        /// Packets that nothing can be seen in, those of such tiles too: filled.
        packets_empty: U64,
        /// Tests left out because all of a packet's rays had hit something nearer.
        tests_hidden: U64,
        /// Tests of a frustum or of a packet's cone with an object.
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
        /// Rays that mirrors have sent on.
        reflected: U64,
        /// Rays that were let through.
        refracted: U64,
        /// Rays to lights.
        shadow: U64,
        /// Eye, reflected and refracted rays that hit something.
        hits: U64,
        /// Zero; fills the second line.
        reserved: [U64; 7],
    }
}
