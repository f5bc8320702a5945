//! Computes the overlay's speeds and loads from the statistics of the SPUs and the frame loop.

use std::time::{Duration, Instant};

use cellray::Report;
use cellray::statistics::FrameStatistics;

use crate::spu_clock::SpuClock;

/// Numbers are averages over this time; for shorter times they change too fast to be read.
const EVERY: Duration = Duration::from_millis(400);

/// How a frame was traced.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Quality {
    /// The width and height of the traced picture.
    pub picture: (u32, u32),
    /// Those of the display.
    pub area: (u32, u32),
    /// The most samples of a pixel.
    pub samples: u32,
    /// Whether the session's pictures never are better than this.
    pub is_full: bool,
}

/// Pictures that the SPUs completed, and the time that they took.
#[derive(Clone, Copy, Debug, Default)]
struct Traced {
    pictures: u32,
    seconds: f64,
}

impl Traced {
    fn of(report: &Report) -> Self {
        let pictures = report.frames_traced;
        let seconds = match report.frames_per_second > 0.0 {
            true => f64::from(pictures) / report.frames_per_second,
            false => 0.0,
        };
        Self { pictures, seconds }
    }
}

/// Measures the speed and the load of a session.
#[derive(Debug)]
pub struct Meter {
    clock: SpuClock,
    began: Instant,
    frames: u32,
    quality: Option<Quality>,
    /// The rays traced before the measured time, and up to the last frame.
    before: Traced,
    last: Traced,
    /// The speed of the SPUs alone, as text that names the quality.
    limit: Option<String>,
    loop_seconds: f64,
    shown: f64,
    free: f64,
    skipped: f64,
    kept: f64,
    lines: Vec<String>,
    loads: Vec<f32>,
}

impl Meter {
    #[must_use]
    pub fn new(now: Instant) -> Self {
        Self {
            clock: SpuClock::here(),
            began: now,
            frames: 0,
            quality: None,
            before: Traced::default(),
            last: Traced::default(),
            limit: None,
            loop_seconds: 0.0,
            shown: 0.0,
            free: 100.0,
            skipped: 0.0,
            kept: 0.0,
            lines: Vec::new(),
            loads: Vec::new(),
        }
    }

    /// The speeds in words, and each SPU's load, after a frame.
    pub fn frame(
        &mut self,
        now: Instant,
        report: &Report,
        last: &FrameStatistics,
        quality: Quality,
    ) -> (&[String], &[f32]) {
        if self.quality.replace(quality) != Some(quality) {
            // Speeds at two qualities have no meaningful average.
            self.before = self.last;
        }
        self.last = Traced::of(report);
        let passed = now.saturating_duration_since(self.began);
        if passed >= EVERY {
            self.measure(now, passed.as_secs_f64(), report);
        }
        // While nothing is traced, the last numbers stay.
        if last.is_traced() {
            let tests = last.tests();
            let needless = tests.skipped + tests.unseen;
            self.skipped = 100.0 * needless as f64 / (needless + tests.made).max(1) as f64;
            // A picture that is made by several frames keeps nothing.
            let pixels = f64::from(quality.picture.0) * f64::from(quality.picture.1);
            let kept = 1.0 - last.primary_rays() as f64 / pixels;
            self.kept = if last.tiles_left == 0 { 100.0 * kept.clamp(0.0, 1.0) } else { 0.0 };
            let ticks = last.ticks().max(1);
            self.loads.clear();
            let load = |busy: u64| busy as f32 / ticks as f32;
            let loads = last.spus.iter().map(|spu| load(spu.busy));
            self.loads.extend(loads);
        }
        let lines = &mut self.lines;
        lines.clear();
        lines.push(format!("{:.1} frames/s", self.shown));
        lines.extend(self.limit.clone());
        let Quality { picture, area, .. } = quality;
        let mut part = match quality.samples {
            1 => String::new(),
            most => format!(", up to {most} samples a pixel"),
        };
        if last.tiles_left > 0 {
            part += &format!(", {} tiles to come", last.tiles_left);
        }
        lines.push(format!("{}x{} of {}x{}{part}", picture.0, picture.1, area.0, area.1,));
        lines.push(format!(
            "{:.1} % of tests skipped, {:.0} % of pixels kept",
            self.skipped, self.kept
        ));
        lines.push(format!("frame loop {:.1} % free", self.free));
        (&self.lines, &self.loads)
    }

    fn measure(&mut self, now: Instant, seconds: f64, report: &Report) {
        self.shown = f64::from(report.frames - self.frames) / seconds;
        let pictures = self.last.pictures.saturating_sub(self.before.pictures);
        let spu_seconds = self.last.seconds - self.before.seconds;
        // While no picture is completed, the last speed stays, with the quality that it was for.
        if let Some(quality) = self.quality
            && pictures > 0
            && spu_seconds > 0.0
        {
            let rate = f64::from(pictures) / spu_seconds;
            let limit = self.clock.limit();
            self.limit = Some(match (quality.is_full, quality.picture) {
                (true, _) => format!("{limit}: {rate:.1} frames/s at full quality"),
                (false, (width, height)) => {
                    format!("{limit}: {rate:.1} frames/s at {width}x{height}")
                }
            });
            self.before = self.last;
        }
        let busy = report.loop_seconds - self.loop_seconds;
        self.free = 100.0 * (1.0 - busy / seconds).clamp(0.0, 1.0);
        self.began = now;
        self.frames = report.frames;
        self.loop_seconds = report.loop_seconds;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use cellray::statistics::SpuStatistics;

    #[test]
    fn remaining_tiles_are_shown() {
        let now = Instant::now();
        let report = Report::new("a scene", (64, 36), 1);
        let mut last = FrameStatistics {
            spus: vec![SpuStatistics::default()],
            tiles_left: 3,
            ..FrameStatistics::default()
        };
        let mut meter = Meter::new(now);
        let mut size = |last: &FrameStatistics, samples| {
            let quality = Quality { picture: (64, 36), area: (128, 72), samples, is_full: false };
            let (lines, _) = meter.frame(now, &report, last, quality);
            lines[1].clone()
        };
        assert_eq!(size(&last, 1), "64x36 of 128x72, 3 tiles to come");
        let refined = "64x36 of 128x72, up to 4 samples a pixel, 3 tiles to come";
        assert_eq!(size(&last, 4), refined);
        last.tiles_left = 0;
        assert_eq!(size(&last, 1), "64x36 of 128x72");
    }

    #[test]
    fn limit_names_its_quality() {
        let began = Instant::now();
        let last = FrameStatistics::default();
        let mut report = Report::new("a scene", (64, 36), 1);
        let mut meter = Meter::new(began);
        let coarse = Quality { picture: (32, 18), area: (64, 36), samples: 1, is_full: false };
        let full = Quality { picture: (64, 36), samples: 4, is_full: true, ..coarse };
        let mut seconds = 0.0;
        let mut after = 0;
        let limit = SpuClock::here().limit();
        // For each frame its quality, the pictures it completes, the time it takes, and the speed
        // that is then shown.
        for (quality, pictures, took, expected) in [
            (coarse, 1, 0.05, Some("20.0 frames/s at 32x18")),
            (coarse, 1, 0.1, Some("10.0 frames/s at 32x18")),
            // A picture that is made by two frames.
            (full, 0, 1.0, Some("10.0 frames/s at 32x18")),
            (full, 1, 1.0, Some("0.5 frames/s at full quality")),
            (full, 0, 0.0, Some("0.5 frames/s at full quality")),
            (coarse, 1, 0.25, Some("4.0 frames/s at 32x18")),
        ] {
            seconds += took;
            report.frames_traced += pictures;
            report.frames_per_second = f64::from(report.frames_traced) / seconds;
            after += 1;
            let (lines, _) = meter.frame(began + after * EVERY, &report, &last, quality);
            let shown = lines.iter().find_map(|line| line.strip_prefix(limit));
            let shown = shown.and_then(|line| line.strip_prefix(": "));
            assert_eq!(shown, expected, "frame {after}");
        }
    }
}
