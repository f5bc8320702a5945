//! The SPUs' statistics of a frame.

use serde::Serialize;
use zerocopy::big_endian::U64;

use crate::work::Size;
use protocol::layout::{self, Statistics};

/// Rays of a packet.
pub(crate) const PACKET_RAYS: u64 = 16;
/// The generations that rays are counted by, each with its shadow rays.
pub const GENERATIONS: usize = 6;

/// One SPU's statistics of a frame.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct SpuStatistics {
    /// Number of tiles that were traced or filled.
    pub tiles: u64,
    /// Tiles that were filled with the background, because no object is visible in them.
    pub tiles_filled: u64,
    /// Filled tiles that were not written, because they showed the background before.
    pub tiles_blank: u64,
    /// Tiles that were not traced, because no change reached them.
    pub tiles_kept: u64,
    /// Pixels of these tiles, and of kept blocks of tiles that were traced in part.
    pub pixels_kept: u64,
    /// Number of packets of 16 rays that were traced or filled.
    pub packets: u64,
    /// Packets that were filled with the background.
    pub packets_filled: u64,
    /// Rays by kind.
    pub rays: Rays,
    /// Tests of rays with objects.
    pub tests: Tests,
    /// Blocks of meshes in main memory.
    pub blocks: Blocks,
    /// Tiles of textures.
    pub texture_tiles: TextureTiles,
    /// With Whitted's model: eye rays, the shadow rays from where they hit, the rays that these
    /// surfaces send on, their shadow rays, and the same for all later rays.
    pub generations: [Generation; GENERATIONS],
    /// Time at work, in ticks of the decrementer.
    pub busy: u64,
    /// Time waiting for the MFC, in ticks.
    pub dma_wait: u64,
    /// Time waiting for the frame, in ticks.
    pub idle: u64,
    /// `busy` by phase, in ticks.
    pub phases: Phases<u64>,
}

/// Numbers of rays by kind, with the names of the Standard Procedural Databases. The sum of eye,
/// reflected and refracted rays equals the sum of `hit` and `background`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Rays {
    /// Primary rays.
    pub eye: u64,
    /// Of these, the ones beyond the first of each pixel.
    pub samples: u64,
    /// Primary rays that hit something.
    pub eye_hit: u64,
    /// Reflected rays, including totally reflected ones.
    pub reflected: u64,
    /// Refracted rays.
    pub refracted: u64,
    /// Shadow rays.
    pub shadow: u64,
    /// Primary, reflected and refracted rays that hit something.
    pub hit: u64,
    /// Primary, reflected and refracted rays that hit nothing.
    pub background: u64,
}

/// Numbers of tests. Except for `cull` they count tests of one ray with one object.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Tests {
    /// Tests that were made.
    pub made: u64,
    /// Tests that went on to compute a hit, because at least one of the packet's rays could hit.
    pub intersections_computed: u64,
    /// Tests that the SPUs found unnecessary.
    pub skipped: u64,
    /// Skipped tests of packets whose rays had all hit something nearer.
    pub hidden: u64,
    /// Tests with objects that were not sent to the SPUs, because the picture can't show them.
    pub unseen: u64,
    /// Tests of a frustum or of a packet's cone with an object; the numbers above exclude them.
    pub cull: u64,
}

/// Blocks of meshes in main memory, and how an SPU's cache in local store served them.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Blocks {
    /// How often a batch of rays needed a block.
    pub used: u64,
    /// Blocks that were fetched, because they were not in the cache.
    pub fetched: u64,
    /// The part of the time waiting for the MFC that was spent waiting for blocks, in ticks.
    pub wait: u64,
}

/// Tiles of a mesh's textures, and how an SPU's cache in local store served them.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct TextureTiles {
    /// How often a packet of rays needed a tile.
    pub used: u64,
    /// Tiles that were fetched, because they were not in the cache.
    pub fetched: u64,
}

/// The work of an SPU for the rays of one generation, or for their shadow rays.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Generation {
    /// Number of rays, including those of primary rays' packets that are beyond the picture.
    pub rays: u64,
    /// Number of packets that these rays filled, some of them only in part.
    pub packets: u64,
    /// Packets whose rays were themselves tested with nodes, because they were scattered.
    pub packets_scattered: u64,
    /// Tests of a packet with a node or its children.
    pub nodes: u64,
    /// Tests of a packet with an object.
    pub tests: u64,
    /// Blocks of meshes in main memory.
    pub blocks: Blocks,
}

/// Time by phase of the work.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Phases<T> {
    /// Fetching and checking the frame and its scene.
    pub fetch: T,
    /// Culling.
    pub cull: T,
    /// Generating rays.
    pub rays: T,
    /// Intersecting rays with objects.
    pub isect: T,
    /// Shading and packing pixels.
    pub shade: T,
}

/// Numbers of tiles by the reason for which they were traced.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Causes {
    /// The framebuffer's contents were not known, or nothing was to be retained.
    pub unknown: u64,
    /// The camera had moved, or a light or an option had changed.
    pub view: u64,
    /// An object had changed, and there was no record of what the tile's rays had crossed.
    pub unrecorded: u64,
    /// A ray of the tile had crossed the place of a changed object.
    pub reached: u64,
    /// An earlier frame had left them out, because the number of tiles to trace was limited.
    pub left: u64,
}

/// The statistics of one frame.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct FrameStatistics {
    /// The SPUs, in the order of their numbers.
    pub spus: Vec<SpuStatistics>,
    /// Ticks from the mail to the slowest SPU's reply when a mesh was refitted before the frame.
    pub refit: u64,
    /// Tiles that were left unchanged, because the framebuffer showed them already.
    pub tiles_retained: u64,
    /// Why the others were traced.
    pub causes: Causes,
    /// Tiles that were left for the next frame, because the number of tiles to trace was limited.
    pub tiles_left: u64,
    /// Whether nothing was traced because something has moved while tiles were left; see
    /// [`Engine::limit_tiles`](crate::Engine::limit_tiles).
    pub is_put_off: bool,
}

impl FrameStatistics {
    /// Reads the SPUs' lines of statistics. `size` is the size of the planned frame.
    pub(crate) fn read(&mut self, lines: &[Statistics], size: Size) {
        self.spus.clear();
        self.refit = 0;
        let unseen = size.spheres_unseen;
        self.spus.extend(lines.iter().map(|line| SpuStatistics::of(line, unseen)));
        let kept: u64 = self.spus.iter().map(|spu| spu.tiles_kept).sum();
        self.tiles_retained = size.tiles_retained + kept;
        // Whether the tiles with paths are reached is what the SPUs find out.
        let reached = size.causes.reached.saturating_sub(kept);
        self.causes = Causes { reached, ..size.causes };
        self.tiles_left = size.tiles_left;
        self.is_put_off = size.is_put_off;
    }

    /// The number of primary rays of all SPUs, one for each pixel that was traced.
    #[must_use]
    pub fn primary_rays(&self) -> u64 {
        let rays = self.spus.iter().map(|spu| spu.rays);
        rays.map(|rays| rays.eye - rays.samples).sum()
    }

    /// The number of pixels that were not traced, because no ray of theirs had crossed the place of
    /// a change.
    #[must_use]
    pub fn pixels_kept(&self) -> u64 {
        self.spus.iter().map(|spu| spu.pixels_kept).sum()
    }

    /// Whether anything was traced.
    #[must_use]
    pub fn is_traced(&self) -> bool {
        self.primary_rays() > 0
    }

    /// The tests of all SPUs.
    #[must_use]
    pub fn tests(&self) -> Tests {
        self.spus.iter().fold(Tests::default(), |mut sum, spu| {
            sum += spu.tests;
            sum
        })
    }

    /// Ticks from the mail to the slowest SPU's reply, and those of `refit`.
    #[must_use]
    pub fn ticks(&self) -> u64 {
        let traced = self.spus.iter().map(|spu| spu.busy + spu.dma_wait).max().unwrap_or(0);
        traced + self.refit
    }
}

impl SpuStatistics {
    fn of(line: &Statistics, spheres_unseen: u64) -> Self {
        let generations = line.generations.each_ref().map(Generation::of);
        let all = generations.iter().fold(Generation::default(), |mut sum, of| {
            sum += *of;
            sum
        });
        let made = line.tests_made.get() + all.tests;
        Self {
            tiles: line.tiles.get(),
            tiles_filled: line.tiles_empty.get(),
            tiles_blank: line.tiles_blank.get(),
            tiles_kept: line.tiles_kept.get(),
            pixels_kept: line.pixels_kept.get(),
            packets: line.packets.get(),
            packets_filled: line.packets_empty.get(),
            rays: Rays::of(line),
            tests: Tests {
                made: made * PACKET_RAYS,
                intersections_computed: line.intersections_computed.get() * PACKET_RAYS,
                skipped: line.tests_possible.get().saturating_sub(made) * PACKET_RAYS,
                hidden: line.tests_hidden.get() * PACKET_RAYS,
                unseen: line.packets.get() * spheres_unseen * PACKET_RAYS,
                cull: line.cull_tests.get() + all.nodes,
            },
            blocks: all.blocks,
            texture_tiles: TextureTiles {
                used: line.texture_tiles_used.get(),
                fetched: line.texture_tiles_fetched.get(),
            },
            generations,
            busy: line.busy.get(),
            dma_wait: line.dma_wait.get(),
            idle: line.idle.get(),
            phases: Phases {
                fetch: line.ticks_fetch.get(),
                cull: line.ticks_cull.get(),
                rays: line.ticks_rays.get(),
                isect: line.ticks_isect.get(),
                shade: line.ticks_shade.get(),
            },
        }
    }
}

impl Generation {
    fn of(counts: &layout::Generation) -> Self {
        Self {
            rays: counts.rays.get(),
            packets: counts.packets.get(),
            packets_scattered: counts.packets_scattered.get(),
            nodes: counts.cull_tests.get(),
            tests: counts.tests_made.get(),
            blocks: Blocks {
                used: counts.blocks_used.get(),
                fetched: counts.blocks_fetched.get(),
                wait: counts.ticks_block_wait.get(),
            },
        }
    }
}

impl std::ops::AddAssign for Generation {
    fn add_assign(&mut self, other: Self) {
        self.rays += other.rays;
        self.packets += other.packets;
        self.packets_scattered += other.packets_scattered;
        self.nodes += other.nodes;
        self.tests += other.tests;
        self.blocks.used += other.blocks.used;
        self.blocks.fetched += other.blocks.fetched;
        self.blocks.wait += other.blocks.wait;
    }
}

impl Rays {
    fn of(line: &Statistics) -> Self {
        let [reflected, refracted] = [line.reflected, line.refracted].map(U64::get);
        let eye = line.primary_rays.get() + line.samples.get();
        // Depth shading has only primary rays, and counts only their hits.
        let hit = line.hits.get().max(line.eye_hits.get());
        Self {
            eye,
            samples: line.samples.get(),
            eye_hit: line.eye_hits.get(),
            reflected,
            refracted,
            shadow: line.shadow.get(),
            hit,
            background: (eye + reflected + refracted).saturating_sub(hit),
        }
    }
}

impl std::ops::AddAssign for Causes {
    fn add_assign(&mut self, other: Self) {
        self.unknown += other.unknown;
        self.view += other.view;
        self.unrecorded += other.unrecorded;
        self.reached += other.reached;
        self.left += other.left;
    }
}

impl std::ops::AddAssign for Rays {
    fn add_assign(&mut self, other: Self) {
        self.eye += other.eye;
        self.samples += other.samples;
        self.eye_hit += other.eye_hit;
        self.reflected += other.reflected;
        self.refracted += other.refracted;
        self.shadow += other.shadow;
        self.hit += other.hit;
        self.background += other.background;
    }
}

impl std::ops::AddAssign for Tests {
    fn add_assign(&mut self, other: Self) {
        self.made += other.made;
        self.intersections_computed += other.intersections_computed;
        self.skipped += other.skipped;
        self.hidden += other.hidden;
        self.unseen += other.unseen;
        self.cull += other.cull;
    }
}
