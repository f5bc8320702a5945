//! What SPUs say of their frames.

use serde::Serialize;
use zerocopy::big_endian::U64;

use crate::work::Size;
use protocol::layout::Statistics;

/// Rays of a packet.
const PACKET_RAYS: u64 = 16;

/// One SPU's part of a frame.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct SpuStatistics {
    /// Tiles traced or filled.
    pub tiles: u64,
    /// Of these, filled with the background: nothing can be seen in them.
    pub tiles_filled: u64,
    /// Of these, not sent: they showed the background before.
    pub tiles_blank: u64,
    /// Packets of 16 rays traced or filled.
    pub packets: u64,
    /// Of these, filled with the background.
    pub packets_filled: u64,
    /// Rays.
    pub rays: Rays,
    /// Tests.
    pub tests: Tests,
    /// Decrementer ticks at work.
    pub busy: u64,
    /// Ticks waiting for the MFC.
    pub dma_wait: u64,
    /// Ticks waiting for the frame.
    pub idle: u64,
    /// Ticks at work, by what was done.
    pub phases: Phases<u64>,
}

/// Rays by kind, under the names of the Standard Procedural Databases. Eye, reflected and
/// refracted rays are as many as those that hit and those that see the background.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Rays {
    /// From the eye.
    pub eye: u64,
    /// Of these, those that hit something.
    pub eye_hit: u64,
    /// From mirrors, and totally reflected ones.
    pub reflected: u64,
    /// Through glass.
    pub refracted: u64,
    /// To lights.
    pub shadow: u64,
    /// Eye, reflected and refracted rays that hit something.
    pub hit: u64,
    /// Those that hit nothing.
    pub background: u64,
}

/// Tests of one ray with one object, and of groups of rays.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Tests {
    /// Made.
    pub made: u64,
    /// Of these, those after which a hit was looked for: of a packet's rays one at least could
    /// hit.
    pub hits_looked_for: u64,
    /// Found needless by the SPUs.
    pub skipped: u64,
    /// Of these, those left out because all rays of a packet had hit something nearer.
    pub hidden: u64,
    /// With objects that no SPU was told of: the picture can't show them.
    pub unseen: u64,
    /// Tests of a frustum or of a packet's cone with an object; those are not among the tests
    /// above.
    pub cull: u64,
}

/// Time by what it was spent on.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Phases<T> {
    /// Fetching and checking the frame and its scene.
    pub fetch: T,
    /// Culling.
    pub cull: T,
    /// Making rays.
    pub rays: T,
    /// Testing rays with objects.
    pub isect: T,
    /// Shading and packing pixels.
    pub shade: T,
}

/// One frame, SPU by SPU.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct FrameStatistics {
    /// In order of the SPUs' numbers.
    pub spus: Vec<SpuStatistics>,
    /// Tiles that already showed what they should, and were left alone.
    pub tiles_retained: u64,
}

impl FrameStatistics {
    /// Reads the SPUs' lines of a frame that was planned to be of this size.
    pub(crate) fn read(&mut self, lines: &[Statistics], size: Size) {
        self.spus.clear();
        let unseen = size.spheres_unseen;
        self.spus
            .extend(lines.iter().map(|line| SpuStatistics::of(line, unseen)));
        self.tiles_retained = size.tiles_retained;
    }

    /// Primary rays of all SPUs.
    #[must_use]
    pub fn primary_rays(&self) -> u64 {
        self.spus.iter().map(|spu| spu.rays.eye).sum()
    }

    /// Whether anything was traced.
    #[must_use]
    pub fn is_traced(&self) -> bool {
        self.primary_rays() > 0
    }

    /// Tests of all SPUs.
    #[must_use]
    pub fn tests(&self) -> Tests {
        self.spus.iter().fold(Tests::default(), |mut sum, spu| {
            sum += spu.tests;
            sum
        })
    }

    /// Ticks from the mail to the last answer: the slowest SPU's.
    #[must_use]
    pub fn ticks(&self) -> u64 {
        self.spus
            .iter()
            .map(|spu| spu.busy + spu.dma_wait)
            .max()
            .unwrap_or(0)
    }
}

impl SpuStatistics {
    fn of(line: &Statistics, spheres_unseen: u64) -> Self {
        Self {
            tiles: line.tiles.get(),
            tiles_filled: line.tiles_empty.get(),
            tiles_blank: line.tiles_blank.get(),
            packets: line.packets.get(),
            packets_filled: line.packets_empty.get(),
            rays: Rays::of(line),
            tests: Tests {
                made: line.tests_made.get() * PACKET_RAYS,
                hits_looked_for: line.hits_looked_for.get() * PACKET_RAYS,
                skipped: line.tests_skipped.get() * PACKET_RAYS,
                hidden: line.tests_hidden.get() * PACKET_RAYS,
                unseen: line.packets.get() * spheres_unseen * PACKET_RAYS,
                cull: line.cull_tests.get(),
            },
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

impl Rays {
    fn of(line: &Statistics) -> Self {
        let [eye, reflected, refracted] =
            [line.primary_rays, line.reflected, line.refracted].map(U64::get);
        // By depth shading there are no rays but the eye's, and no other hits are counted.
        let hit = line.hits.get().max(line.eye_hits.get());
        Self {
            eye,
            eye_hit: line.eye_hits.get(),
            reflected,
            refracted,
            shadow: line.shadow.get(),
            hit,
            background: (eye + reflected + refracted).saturating_sub(hit),
        }
    }
}

impl std::ops::AddAssign for Rays {
    fn add_assign(&mut self, other: Self) {
        self.eye += other.eye;
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
        self.hits_looked_for += other.hits_looked_for;
        self.skipped += other.skipped;
        self.hidden += other.hidden;
        self.unseen += other.unseen;
        self.cull += other.cull;
    }
}
