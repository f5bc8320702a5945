//! The report of a run: the statistics of its frames, added up. `--stats` writes it as JSON. A run
//! prints its summary at its end, and all of it with `--verbose`.

mod generations;
mod loop_time;
mod memory;

use std::fmt;

use serde::Serialize;

use crate::scene::Scene;
use crate::statistics::{Blocks, Causes, FrameStatistics, GENERATIONS, Phases, Rays, Tests};
use protocol::formulation::Formulations;
use protocol::layout::MESH_BLOCK;

pub use generations::GenerationReport;
pub use loop_time::LoopTime;

/// Ticks a second of the decrementer on a PlayStation 3, and in the emulator.
const PS3_TIMEBASE: f64 = 79_800_000.0;
/// A television's frames a second.
const TELEVISION: f64 = 60.0;

/// The statistics of a run's frames, added up; `--stats` writes them as JSON. Times are in
/// seconds.
#[derive(Clone, Debug, Serialize)]
pub struct Report {
    /// Name of the scene.
    pub scene: String,
    /// The formulations that rays were intersected with, if the SPU program names them.
    pub formulations: Option<Intersected>,
    /// Width of the picture in pixels.
    pub width: u32,
    /// Height of the picture in pixels.
    pub height: u32,
    /// Number of SPUs.
    pub spus: u32,
    /// Number of frames that were shown.
    pub frames: u32,
    /// Number of frames with anything to trace; the others were already in the framebuffer.
    pub frames_traced: u32,
    /// Time spent in the frame loop, in seconds of the host's clock.
    pub host_seconds: f64,
    /// Processor time of the loop's thread in `host_seconds`. Emulated SPUs run in threads of their
    /// own, which don't count here.
    pub loop_seconds: f64,
    /// Part of `host_seconds` in which the loop's thread slept, in per cent.
    pub loop_free_percent: f64,
    /// Peak memory use of the program in bytes, including emulated SPUs;
    /// [`Report::add_memory`] measures it.
    pub peak_bytes: Option<u64>,
    /// Traced frames a second, measured by the SPUs' decrementers: the console's time on a console.
    pub frames_per_second: f64,
    /// Part of the frames' time in which the SPUs were at work, from 0 to 1. A frame's time is that
    /// of its slowest SPU. It is 1 if no SPU ever waited for another or for a transfer.
    pub busy_share: f64,
    /// Part of the frames' time in which an SPU waited for the MFC, from 0 to 1; the largest of all
    /// SPUs.
    pub dma_wait_share: f64,
    /// The SPUs, in the order of their numbers.
    pub spu: Vec<SpuReport>,
    /// Time at work of all SPUs, by phase.
    pub phases: Phases<f64>,
    /// Rays by kind.
    pub rays: Rays,
    /// Tests of single rays with single objects, and of groups of rays.
    pub tests: Tests,
    /// Blocks of meshes in main memory.
    pub blocks: BlockReport,
    /// Tiles of textures.
    pub texture_tiles: TextureReport,
    /// Rays by generation, with their tests and blocks.
    pub generations: [GenerationReport; GENERATIONS],
    /// Tiles by how they were handled.
    pub tiles: Tiles,
    /// Packets by how they were handled.
    pub packets: Packets,
    #[serde(skip)]
    timebase: f64,
    #[serde(skip)]
    ticks: u64,
}

/// The formulations that rays were intersected with.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Intersected {
    /// Name of the formulation for primary rays and spheres.
    pub spheres: &'static str,
    /// Name of the formulation for all rays and triangles.
    pub triangles: &'static str,
}

/// The statistics of one SPU over all frames. Times are in seconds.
#[derive(Clone, Copy, Debug, Default, Serialize)]
pub struct SpuReport {
    /// Time at work.
    pub busy: f64,
    /// Time waiting for the MFC.
    pub dma_wait: f64,
    /// Time waiting for a frame.
    pub idle: f64,
    /// `busy` in per cent of all three times.
    pub busy_percent: f64,
    /// `dma_wait` in per cent of all three times.
    pub dma_wait_percent: f64,
    /// `idle` in per cent of all three times.
    pub idle_percent: f64,
    /// Number of tiles that were traced or filled.
    pub tiles: u64,
    /// Number of packets of 16 rays that were traced or filled.
    pub packets: u64,
    /// `busy` by phase.
    pub phases: Phases<f64>,
}

/// Blocks of meshes in main memory, and how the SPUs' caches served them.
#[derive(Clone, Copy, Debug, Default, Serialize)]
pub struct BlockReport {
    /// How often a batch of rays needed a block.
    pub used: u64,
    /// Blocks that were fetched, because they were not in the cache.
    pub fetched: u64,
    /// The part of the uses, in per cent, for which the block was in the cache or on its way.
    pub hit_percent: f64,
    /// Bytes of blocks that were fetched for a ray of any kind.
    pub bytes_a_ray: f64,
    /// Seconds that all SPUs together waited for blocks.
    pub wait: f64,
    /// These in per cent of the SPUs' time.
    pub wait_percent: f64,
}

/// Tiles of a mesh's textures, and how the SPUs' caches served them.
#[derive(Clone, Copy, Debug, Default, Serialize)]
pub struct TextureReport {
    /// How often a packet of rays needed a tile.
    pub used: u64,
    /// Tiles that were fetched, because they were not in the cache.
    pub fetched: u64,
    /// The part of the uses, in per cent, for which the tile was in the cache.
    pub cached_percent: f64,
}

/// Numbers of tiles by how they were handled.
#[derive(Clone, Copy, Debug, Default, Serialize)]
pub struct Tiles {
    /// Tiles that were traced.
    pub traced: u64,
    /// Tiles that were filled with the background, because no object is visible in them.
    pub filled: u64,
    /// Filled tiles that were not written, because they showed the background before.
    pub blank: u64,
    /// Tiles that were left unchanged, because the framebuffer showed them already.
    pub retained: u64,
    /// Why the others were traced.
    pub causes: Causes,
    /// Pixels that were not traced, because no ray of theirs had crossed the place of a change.
    pub pixels_kept: u64,
}

/// Numbers of packets by how they were handled.
#[derive(Clone, Copy, Debug, Default, Serialize)]
pub struct Packets {
    /// Packets that were traced.
    pub traced: u64,
    /// Packets that were filled with the background, because no object is visible in them.
    pub filled: u64,
}

impl Report {
    /// A report without frames, for a scene, a size of width and height in pixels, and a number of
    /// SPUs.
    #[must_use]
    pub fn new(scene: &str, (width, height): (u32, u32), spus: u32) -> Self {
        Self {
            scene: scene.to_owned(),
            formulations: None,
            width,
            height,
            spus,
            frames: 0,
            frames_traced: 0,
            host_seconds: 0.0,
            loop_seconds: 0.0,
            loop_free_percent: 100.0,
            peak_bytes: None,
            frames_per_second: 0.0,
            busy_share: 0.0,
            dma_wait_share: 0.0,
            spu: vec![SpuReport::default(); spus as usize],
            phases: Phases::default(),
            rays: Rays::default(),
            tests: Tests::default(),
            blocks: BlockReport::default(),
            texture_tiles: TextureReport::default(),
            generations: GenerationReport::all(),
            tiles: Tiles::default(),
            packets: Packets::default(),
            timebase: timebase(),
            ticks: 0,
        }
    }

    /// Records which of a program's formulations intersect the rays of a scene.
    #[must_use]
    pub fn intersected(mut self, scene: &Scene, formulations: Option<Formulations>) -> Self {
        self.formulations = formulations.map(|formulations| Intersected {
            spheres: scene.sphere_formulation(&formulations).name,
            triangles: formulations.triangle.name,
        });
        self
    }

    /// Adds the time since `began`, which must be a time of this thread.
    pub fn add_time_since(&mut self, began: LoopTime) {
        let (passed, processor) = began.until_now();
        self.host_seconds += passed.as_secs_f64();
        self.loop_seconds += processor.as_secs_f64();
        if self.host_seconds > 0.0 {
            let busy = self.loop_seconds / self.host_seconds;
            self.loop_free_percent = 100.0 * (1.0 - busy).max(0.0);
        }
    }

    /// Records the program's peak memory use, as the system reports it.
    pub fn add_memory(&mut self) {
        self.peak_bytes = memory::peak_bytes();
    }

    /// Processor time of the loop's thread for one frame, in seconds.
    #[must_use]
    pub fn loop_seconds_a_frame(&self) -> f64 {
        self.loop_seconds / f64::from(self.frames.max(1))
    }

    /// The run in one line: the size, the frames, the rays, and the time.
    #[must_use]
    pub fn summary(&self) -> String {
        let Rays { eye, reflected, refracted, shadow, .. } = self.rays;
        let rays = match eye + reflected + refracted + shadow {
            few @ ..100_000 => few.to_string(),
            many => format!("{:.2} million", many as f64 / 1e6),
        };
        let frames = match (self.frames, self.frames_traced) {
            (1, 1) => String::new(),
            (frames, traced) => format!("{frames} frame(s), {traced} traced, "),
        };
        format!(
            "{}x{}, {frames}{rays} rays in {:.2} s on {} SPUs; {:.2} frames/s in SPU time",
            self.width, self.height, self.host_seconds, self.spus, self.frames_per_second
        )
    }

    /// Adds a frame's statistics.
    pub fn add(&mut self, frame: &FrameStatistics) {
        self.frames += 1;
        // A picture that is made by several frames counts once, with the last of them.
        self.frames_traced += u32::from(frame.is_traced() && frame.tiles_left == 0);
        self.ticks += frame.ticks();
        self.tests += frame.tests();
        self.tiles.retained += frame.tiles_retained;
        self.tiles.causes += frame.causes;
        self.tiles.pixels_kept += frame.pixels_kept();
        for (sum, spu) in self.spu.iter_mut().zip(&frame.spus) {
            let seconds = |ticks: u64| ticks as f64 / self.timebase;
            let phases = spu.phases.map(seconds);
            sum.busy += seconds(spu.busy);
            sum.dma_wait += seconds(spu.dma_wait);
            sum.idle += seconds(spu.idle);
            sum.tiles += spu.tiles;
            sum.packets += spu.packets;
            sum.phases = sum.phases.plus(phases);
            self.phases = self.phases.plus(phases);
            self.rays += spu.rays;
            self.blocks.add(spu.blocks, self.timebase);
            self.texture_tiles.used += spu.texture_tiles.used;
            self.texture_tiles.fetched += spu.texture_tiles.fetched;
            for (sum, generation) in self.generations.iter_mut().zip(&spu.generations) {
                sum.add(generation, self.timebase);
            }
            self.tiles.traced += spu.tiles - spu.tiles_filled;
            self.tiles.filled += spu.tiles_filled;
            self.tiles.blank += spu.tiles_blank;
            self.packets.traced += spu.packets - spu.packets_filled;
            self.packets.filled += spu.packets_filled;
        }
        self.share();
    }

    /// Computes the quotients from the sums.
    fn share(&mut self) {
        let part = |of: f64, all: f64| if all > 0.0 { of / all } else { 0.0 };
        let seconds = self.ticks as f64 / self.timebase;
        self.frames_per_second = part(f64::from(self.frames_traced), seconds);
        self.busy_share =
            part(self.spu.iter().map(|spu| spu.busy).sum(), f64::from(self.spus) * seconds);
        let Rays { eye, reflected, refracted, shadow, .. } = self.rays;
        let of_all = f64::from(self.spus) * seconds;
        self.blocks.share(eye + reflected + refracted + shadow, of_all);
        let TextureReport { used, fetched, .. } = self.texture_tiles;
        self.texture_tiles.cached_percent = 100.0 * part((used - fetched) as f64, used as f64);
        for generation in &mut self.generations {
            generation.share(of_all);
        }
        for spu in &mut self.spu {
            let all = spu.busy + spu.dma_wait + spu.idle;
            spu.busy_percent = 100.0 * part(spu.busy, all);
            spu.dma_wait_percent = 100.0 * part(spu.dma_wait, all);
            spu.idle_percent = 100.0 * part(spu.idle, all);
        }
        let waits = self.spu.iter().map(|spu| part(spu.dma_wait, seconds));
        self.dma_wait_share = waits.fold(0.0, f64::max);
    }
}

impl BlockReport {
    fn add(&mut self, blocks: Blocks, timebase: f64) {
        self.used += blocks.used;
        self.fetched += blocks.fetched;
        self.wait += blocks.wait as f64 / timebase;
    }

    /// Computes the quotients from the sums, for this number of rays and the time of all SPUs.
    fn share(&mut self, rays: u64, seconds: f64) {
        let part = |of: f64, all: f64| if all > 0.0 { of / all } else { 0.0 };
        let found = self.used.saturating_sub(self.fetched) as f64;
        self.hit_percent = 100.0 * part(found, self.used as f64);
        let bytes = self.fetched as f64 * f64::from(MESH_BLOCK);
        self.bytes_a_ray = part(bytes, rays as f64);
        self.wait_percent = 100.0 * part(self.wait, seconds);
    }
}

impl fmt::Display for BlockReport {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "{} blocks used, {} fetched, {:.1} % cached; {:.1} bytes a ray, {:.1} % of the time waiting \
             for them",
            self.used, self.fetched, self.hit_percent, self.bytes_a_ray, self.wait_percent
        )
    }
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { tests, tiles, packets, rays, .. } = self;
        writeln!(f, "{}", self.summary())?;
        let all = tests.made + tests.skipped + tests.unseen;
        if rays.reflected + rays.refracted + rays.shadow > 0 {
            writeln!(
                f,
                "rays: {} eye, {} eye_hit, {} reflected, {} refracted, {} shadow, {} hit, {} background",
                rays.eye,
                rays.eye_hit,
                rays.reflected,
                rays.refracted,
                rays.shadow,
                rays.hit,
                rays.background
            )?;
        }
        writeln!(
            f,
            "tests: {:.2} of {:.2} million made, {:.2} million computed, {:.2} million hidden\n\
             tiles: {} traced, {} filled ({} of them blank before), {} retained; packets: {} traced, {} \
             filled",
            tests.made as f64 / 1e6,
            all as f64 / 1e6,
            tests.intersections_computed as f64 / 1e6,
            tests.hidden as f64 / 1e6,
            tiles.traced,
            tiles.filled,
            tiles.blank,
            tiles.retained,
            packets.traced,
            packets.filled
        )?;
        let Causes { unknown, view, unrecorded, reached, left } = tiles.causes;
        if view + unrecorded + reached + left > 0 {
            writeln!(
                f,
                "causes: {unknown} tiles unknown, {view} of another view, {unrecorded} unrecorded, \
                 {reached} reached by a change, {left} left before; {:.2} million pixels kept",
                tiles.pixels_kept as f64 / 1e6
            )?;
        }
        if self.blocks.used > 0 {
            writeln!(f, "mesh: {}", self.blocks)?;
        }
        let TextureReport { used, fetched, cached_percent } = self.texture_tiles;
        if used > 0 {
            writeln!(
                f,
                "textures: {used} tiles used, {fetched} fetched, {cached_percent:.1} % cached"
            )?;
        }
        for generation in self.generations.iter().filter(|of| of.rays > 0) {
            writeln!(f, "{generation}")?;
        }
        let busy: f64 = self.spu.iter().map(|spu| spu.busy).sum();
        let percent = |of: f64, all: f64| if all > 0.0 { 100.0 * of / all } else { 0.0 };
        let phases = self.phases;
        writeln!(
            f,
            "SPUs: {:.1} % busy, at most {:.1} % waiting for DMA; at work: {:.1} % fetching, {:.1} % \
             culling, {:.1} % making rays, {:.1} % testing, {:.1} % shading",
            100.0 * self.busy_share,
            100.0 * self.dma_wait_share,
            percent(phases.fetch, busy),
            percent(phases.cull, busy),
            percent(phases.rays, busy),
            percent(phases.isect, busy),
            percent(phases.shade, busy)
        )?;
        // Per cent of the frames' time, which the slowest SPU determines. The other SPUs spend the
        // rest of it waiting for that one.
        let seconds = self.ticks as f64 / self.timebase;
        for (number, spu) in self.spu.iter().enumerate() {
            let (busy, wait) = (percent(spu.busy, seconds), percent(spu.dma_wait, seconds));
            let idle = (100.0 - busy - wait).max(0.0);
            writeln!(
                f,
                "SPU {number}: {busy:.1} % busy, {wait:.1} % waiting for DMA, {idle:.1} % idle; {} tiles, \
                 {} packets",
                spu.tiles, spu.packets
            )?;
        }
        let a_frame = self.loop_seconds_a_frame();
        write!(
            f,
            "frame loop: {:.2} ms of its processor a frame, {:.1} % of the time free; {:.1} % at {TELEVISION} \
             frames/s",
            1e3 * a_frame,
            self.loop_free_percent,
            100.0 * (1.0 - TELEVISION * a_frame).max(0.0)
        )?;
        match self.peak_bytes {
            Some(bytes) => {
                write!(f, "\nmemory: {:.1} MiB at most", bytes as f64 / f64::from(1 << 20))
            }
            None => Ok(()),
        }
    }
}

impl Phases<u64> {
    fn map(self, seconds: impl Fn(u64) -> f64) -> Phases<f64> {
        Phases {
            fetch: seconds(self.fetch),
            cull: seconds(self.cull),
            rays: seconds(self.rays),
            isect: seconds(self.isect),
            shade: seconds(self.shade),
        }
    }
}

impl Phases<f64> {
    fn plus(self, other: Self) -> Self {
        Self {
            fetch: self.fetch + other.fetch,
            cull: self.cull + other.cull,
            rays: self.rays + other.rays,
            isect: self.isect + other.isect,
            shade: self.shade + other.shade,
        }
    }
}

/// Ticks a second of the decrementer: as Linux reports for this machine, otherwise the PlayStation
/// 3's.
fn timebase() -> f64 {
    std::fs::read_to_string("/proc/cpuinfo")
        .ok()
        .as_deref()
        .and_then(timebase_of)
        .unwrap_or(PS3_TIMEBASE)
}

/// The `timebase` line of PowerPC's `/proc/cpuinfo`.
fn timebase_of(cpuinfo: &str) -> Option<f64> {
    let line = cpuinfo.lines().find(|line| line.starts_with("timebase"))?;
    let ticks: f64 = line.split(':').nth(1)?.trim().parse().ok()?;
    (ticks > 0.0).then_some(ticks)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::statistics::{Rays, SpuStatistics};

    #[test]
    fn timebase_is_read_from_cpuinfo() {
        let console = "cpu\t\t: Cell Broadband Engine, altivec supported\ntimebase\t: 79800000\n";
        assert_eq!(timebase_of(console), Some(79_800_000.0));
        assert_eq!(timebase_of("timebase : 0\n"), None);
        assert_eq!(timebase_of("model name : another\n"), None);
    }

    fn frame(ticks: [(u64, u64); 2], eye: u64) -> FrameStatistics {
        let spu = |(busy, dma_wait)| SpuStatistics {
            busy,
            dma_wait,
            idle: 100,
            rays: Rays { eye, ..Rays::default() },
            tiles: 5,
            tiles_filled: 2,
            tiles_blank: 1,
            packets: 70,
            packets_filled: 30,
            ..SpuStatistics::default()
        };
        FrameStatistics {
            spus: ticks.map(spu).into(),
            tiles_retained: 3,
            ..FrameStatistics::default()
        }
    }

    #[test]
    fn slowest_spu_determines_frame_rate() {
        let mut report = Report::new("s", (4, 4), 2);
        let traced = frame([(798_000, 0), (1_000_000, 596_000)], 16);
        report.add(&traced);
        report.add(&traced);
        let expected = timebase() / 1_596_000.0;
        assert!((report.frames_per_second - expected).abs() < 1e-9 * expected);
        assert_eq!((report.frames, report.frames_traced), (2, 2));
        assert!((report.busy_share - 1_798_000.0 / 3_192_000.0).abs() < 1e-12);
        assert!((report.dma_wait_share - 596_000.0 / 1_596_000.0).abs() < 1e-12);
        assert_eq!((report.tiles.traced, report.tiles.filled), (12, 8));
        assert_eq!((report.tiles.blank, report.tiles.retained), (4, 6));
        assert_eq!((report.packets.traced, report.packets.filled), (160, 120));
        for spu in &report.spu {
            let percent = spu.busy_percent + spu.dma_wait_percent + spu.idle_percent;
            assert!((percent - 100.0).abs() < 1e-9);
        }
    }

    #[test]
    fn frames_without_traced_tiles_do_not_count_as_speed() {
        let mut report = Report::new("s", (4, 4), 2);
        report.add(&frame([(798_000, 0), (798_000, 0)], 16));
        let expected = report.frames_per_second;
        report.add(&FrameStatistics::default());
        assert_eq!((report.frames, report.frames_traced), (2, 1));
        assert!((report.frames_per_second - expected).abs() < 1e-9 * expected);
        let text = report.to_string();
        assert!(text.contains("2 frame(s), 1 traced"), "{text}");
    }

    #[test]
    fn sleeping_loop_counts_as_idle() {
        let mut report = Report::new("s", (4, 4), 2);
        let began = LoopTime::now();
        std::thread::sleep(std::time::Duration::from_millis(50));
        report.add_time_since(began);
        assert!(report.host_seconds >= 0.05);
        assert!(report.loop_seconds < 0.5 * report.host_seconds);
        assert!(report.loop_free_percent > 50.0, "{report}");

        let mut report = Report::new("s", (4, 4), 2);
        let began = LoopTime::now();
        while report.loop_seconds < 0.02 {
            report = Report::new("s", (4, 4), 2);
            report.add_time_since(began);
        }
        report.frames = 2;
        assert!(report.loop_seconds_a_frame() >= 0.01);
        assert!(report.to_string().ends_with(" at 60 frames/s"), "{report}");
    }
}
