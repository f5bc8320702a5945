//! What SPUs say of their frames, and what that comes to.

use serde::Serialize;

use crate::work::layout::Statistics;

/// Ticks of the decrementer a second on a PlayStation 3, in the emulator too.
const PS3_TIMEBASE: f64 = 79_800_000.0;

/// Rays of a packet.
const PACKET_RAYS: u64 = 16;

/// One SPU's part of a frame.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct SpuStatistics {
    /// Tiles traced.
    pub tiles: u64,
    /// Packets of 16 rays traced.
    pub packets: u64,
    /// Eye rays within the picture.
    pub eye_rays: u64,
    /// Eye rays that hit something.
    pub eye_hits: u64,
    /// Tests of one ray with one object.
    pub tests_made: u64,
    /// Such tests that were found needless.
    pub tests_skipped: u64,
    /// Decrementer ticks at work.
    pub busy: u64,
    /// Ticks waiting for the MFC.
    pub dma_wait: u64,
    /// Ticks waiting for the frame.
    pub idle: u64,
}

/// One frame, SPU by SPU.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct FrameStatistics {
    /// In order of the SPUs' numbers.
    pub spus: Vec<SpuStatistics>,
}

impl FrameStatistics {
    pub(crate) fn new(lines: &[Statistics]) -> Self {
        let wide = |word: zerocopy::big_endian::U32| u64::from(word.get());
        let spus = lines.iter().map(|line| SpuStatistics {
            tiles: wide(line.tiles),
            packets: wide(line.packets),
            eye_rays: wide(line.eye_rays),
            eye_hits: wide(line.eye_hits),
            tests_made: line.tests_made.get() * PACKET_RAYS,
            tests_skipped: line.tests_skipped.get() * PACKET_RAYS,
            busy: wide(line.busy),
            dma_wait: wide(line.dma_wait),
            idle: wide(line.idle),
        });
        Self {
            spus: spus.collect(),
        }
    }

    /// Eye rays of all SPUs.
    #[must_use]
    pub fn eye_rays(&self) -> u64 {
        self.spus.iter().map(|spu| spu.eye_rays).sum()
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

/// Frames of one scene, summed up; its JSON is what `--stats` writes.
#[derive(Clone, Debug, Serialize)]
pub struct Report {
    /// The scene.
    pub scene: String,
    /// Pixels across.
    pub width: u32,
    /// Pixels down.
    pub height: u32,
    /// SPUs used.
    pub spus: u32,
    /// Frames traced.
    pub frames: u32,
    /// Seconds of the host's clock, from the first mail to the last answer.
    pub host_seconds: f64,
    /// By the SPUs' decrementers: the console's time on a console.
    pub frames_per_second: f64,
    /// Per SPU.
    pub spu: Vec<SpuReport>,
    /// Rays by kind.
    pub rays: Rays,
    /// Tests of one ray with one object.
    pub tests: Tests,
}

/// One SPU over all frames.
#[derive(Clone, Copy, Debug, Default, Serialize)]
pub struct SpuReport {
    /// Seconds at work.
    pub busy: f64,
    /// Seconds waiting for the MFC.
    pub dma_wait: f64,
    /// Seconds waiting for a frame.
    pub idle: f64,
    /// Tiles traced.
    pub tiles: u64,
    /// Packets of 16 rays traced.
    pub packets: u64,
}

/// Rays by kind, under the names of the Standard Procedural Databases.
#[derive(Clone, Copy, Debug, Default, Serialize)]
pub struct Rays {
    /// From the eye.
    pub eye: u64,
    /// Of these, those that hit something.
    pub eye_hit: u64,
    /// From mirrors: none yet.
    pub reflected: u64,
    /// Through glass: none yet.
    pub refracted: u64,
    /// To lights: none yet.
    pub shadow: u64,
}

/// Tests of one ray with one object.
#[derive(Clone, Copy, Debug, Default, Serialize)]
pub struct Tests {
    /// Made.
    pub made: u64,
    /// Found needless.
    pub skipped: u64,
}

impl Report {
    /// Sums up `frames`, which took `host_seconds`.
    #[must_use]
    pub fn new(
        scene: &str,
        (width, height): (u32, u32),
        frames: &[FrameStatistics],
        host_seconds: f64,
    ) -> Self {
        let timebase = timebase();
        let seconds = |ticks: u64| ticks as f64 / timebase;
        let spus = frames.first().map_or(0, |frame| frame.spus.len());
        let mut report = Self {
            scene: scene.to_owned(),
            width,
            height,
            spus: spus as u32,
            frames: frames.len() as u32,
            host_seconds,
            frames_per_second: 0.0,
            spu: vec![SpuReport::default(); spus],
            rays: Rays::default(),
            tests: Tests::default(),
        };
        for (sum, spu) in frames
            .iter()
            .flat_map(|frame| frame.spus.iter().enumerate())
        {
            let sum = &mut report.spu[sum];
            sum.busy += seconds(spu.busy);
            sum.dma_wait += seconds(spu.dma_wait);
            sum.idle += seconds(spu.idle);
            sum.tiles += spu.tiles;
            sum.packets += spu.packets;
            report.rays.eye += spu.eye_rays;
            report.rays.eye_hit += spu.eye_hits;
            report.tests.made += spu.tests_made;
            report.tests.skipped += spu.tests_skipped;
        }
        let ticks: u64 = frames.iter().map(FrameStatistics::ticks).sum();
        if ticks > 0 {
            report.frames_per_second = f64::from(report.frames) / seconds(ticks);
        }
        report
    }
}

/// Ticks of the decrementer a second: what Linux says of this machine, else the PlayStation 3's.
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

    #[test]
    fn the_timebase_is_what_linux_says() {
        let console = "cpu\t\t: Cell Broadband Engine, altivec supported\ntimebase\t: 79800000\n";
        assert_eq!(timebase_of(console), Some(79_800_000.0));
        assert_eq!(timebase_of("timebase : 0\n"), None);
        assert_eq!(timebase_of("model name : another\n"), None);
    }

    #[test]
    fn the_slowest_spu_sets_the_frame_rate() {
        let spu = |busy, dma_wait| SpuStatistics {
            busy,
            dma_wait,
            ..SpuStatistics::default()
        };
        let frame = FrameStatistics {
            spus: vec![spu(798_000, 0), spu(1_000_000, 596_000)],
        };
        let report = Report::new("s", (4, 4), &[frame.clone(), frame], 1.0);
        let expected = timebase() / 1_596_000.0;
        assert!((report.frames_per_second - expected).abs() < 1e-9 * expected);
        assert_eq!(report.frames, 2);
    }
}
