//! Computes the overlay's speeds and loads from the statistics of the SPUs and the frame loop.

use std::time::{Duration, Instant};

use cellray::Report;
use cellray::statistics::FrameStatistics;

use crate::spu_clock::SpuClock;

/// Numbers are averages over this time; for shorter times they change too fast to be read.
const EVERY: Duration = Duration::from_millis(400);

/// Measures the speed and the load of a session.
#[derive(Debug)]
pub struct Meter {
    clock: SpuClock,
    began: Instant,
    frames: u32,
    traced: u32,
    spu_seconds: f64,
    loop_seconds: f64,
    shown: f64,
    simulated: f64,
    free: f64,
    skipped: f64,
    lines: Vec<String>,
    loads: Vec<f32>,
}

impl Meter {
    /// Starts to measure.
    #[must_use]
    pub fn new(now: Instant) -> Self {
        Self {
            clock: SpuClock::here(),
            began: now,
            frames: 0,
            traced: 0,
            spu_seconds: 0.0,
            loop_seconds: 0.0,
            shown: 0.0,
            simulated: 0.0,
            free: 100.0,
            skipped: 0.0,
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
        (picture, area): ((u32, u32), (u32, u32)),
        samples: u32,
    ) -> (&[String], &[f32]) {
        let passed = now.saturating_duration_since(self.began);
        if passed >= EVERY {
            self.measure(now, passed.as_secs_f64(), report);
        }
        // While nothing is traced, the last numbers stay.
        if last.is_traced() {
            let tests = last.tests();
            let needless = tests.skipped + tests.unseen;
            self.skipped = 100.0 * needless as f64 / (needless + tests.made).max(1) as f64;
            let ticks = last.ticks().max(1);
            self.loads.clear();
            let load = |busy: u64| busy as f32 / ticks as f32;
            let loads = last.spus.iter().map(|spu| load(spu.busy));
            self.loads.extend(loads);
        }
        let lines = &mut self.lines;
        lines.clear();
        lines.push(format!("{:.1} frames/s are shown here", self.shown));
        let words = self.clock.words(last.spus.len());
        lines.push(format!("{:.1} frames/s {words}", self.simulated));
        let mut part = match samples {
            1 => String::new(),
            most => format!(", up to {most} samples a pixel"),
        };
        if last.tiles_left > 0 {
            part += &format!(", {} tiles to come", last.tiles_left);
        }
        lines.push(format!(
            "{}x{} of {}x{}{part}",
            picture.0, picture.1, area.0, area.1,
        ));
        lines.push(format!("{:.1} % of tests skipped", self.skipped));
        lines.push(format!("frame loop {:.1} % free", self.free));
        (&self.lines, &self.loads)
    }

    fn measure(&mut self, now: Instant, seconds: f64, report: &Report) {
        let spu_seconds = if report.frames_per_second > 0.0 {
            f64::from(report.frames_traced) / report.frames_per_second
        } else {
            0.0
        };
        self.shown = f64::from(report.frames - self.frames) / seconds;
        // While no picture is completed, the last speed stays.
        if report.frames_traced > self.traced && spu_seconds > self.spu_seconds {
            let traced = f64::from(report.frames_traced - self.traced);
            self.simulated = traced / (spu_seconds - self.spu_seconds);
            self.traced = report.frames_traced;
            self.spu_seconds = spu_seconds;
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
    fn tiles_that_are_left_are_told() {
        let now = Instant::now();
        let report = Report::new("a scene", (64, 36), 1);
        let mut last = FrameStatistics {
            spus: vec![SpuStatistics::default()],
            tiles_left: 3,
            ..FrameStatistics::default()
        };
        let mut meter = Meter::new(now);
        let mut size = |last: &FrameStatistics, samples| {
            let (lines, _) = meter.frame(now, &report, last, ((64, 36), (128, 72)), samples);
            lines[2].clone()
        };
        assert_eq!(size(&last, 1), "64x36 of 128x72, 3 tiles to come");
        let refined = "64x36 of 128x72, up to 4 samples a pixel, 3 tiles to come";
        assert_eq!(size(&last, 4), refined);
        last.tiles_left = 0;
        assert_eq!(size(&last, 1), "64x36 of 128x72");
    }
}
