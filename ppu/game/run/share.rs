//! What the frames of a session take: the SPUs' time, and the frame loop's own.

use std::fmt;
use std::time::{Duration, Instant};

use serde::Serialize;

use crate::report::Report;
use crate::statistics::FrameStatistics;

/// The frames of a session, summed up. Times are in seconds.
#[derive(Clone, Debug, Serialize)]
pub struct SessionReport {
    /// What the SPUs say of them.
    pub frames: Report,
    /// Time of the frame loop's thread on its processor. Emulated SPUs run in threads of their own, and are not in
    /// it.
    pub loop_seconds: f64,
    /// Time that passed.
    pub seconds: f64,
    /// Part of that time in which the frame loop slept, in per cent.
    pub free_percent: f64,
}

impl SessionReport {
    pub(super) fn new(game: &str, size: (u32, u32), spus: u32) -> Self {
        Self {
            frames: Report::new(game, size, spus),
            loop_seconds: 0.0,
            seconds: 0.0,
            free_percent: 100.0,
        }
    }

    pub(super) fn add_time(&mut self, time: ThreadTime) {
        self.loop_seconds += time.processor.as_secs_f64();
        self.seconds += time.passed.as_secs_f64();
        if self.seconds > 0.0 {
            self.free_percent = 100.0 * (1.0 - self.loop_seconds / self.seconds).max(0.0);
        }
    }

    pub(super) fn add_frame(&mut self, statistics: &FrameStatistics) {
        self.frames.add(statistics, self.seconds);
    }

    /// Time of the frame loop's thread on its processor for one frame.
    #[must_use]
    pub fn loop_seconds_a_frame(&self) -> f64 {
        self.loop_seconds / f64::from(self.frames.frames.max(1))
    }
}

impl fmt::Display for SessionReport {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.frames.fmt(f)?;
        write!(
            f,
            "\nframe loop: {:.2} ms of its processor a frame, {:.1} % of the time free",
            1e3 * self.loop_seconds_a_frame(),
            self.free_percent
        )
    }
}

/// A moment of the thread that asks, or the time between two.
#[derive(Clone, Copy)]
pub(super) struct ThreadTime {
    began: Instant,
    processor: Duration,
    passed: Duration,
}

impl ThreadTime {
    pub fn now() -> Self {
        Self {
            began: Instant::now(),
            processor: processor_time(),
            passed: Duration::ZERO,
        }
    }

    pub fn until_now(self) -> Self {
        Self {
            processor: processor_time().saturating_sub(self.processor),
            passed: self.began.elapsed(),
            ..self
        }
    }
}

/// Time that this thread has had on a processor.
fn processor_time() -> Duration {
    let mut time = libc::timespec {
        tv_sec: 0,
        tv_nsec: 0,
    };
    // SAFETY: the call writes to `time` alone. It fails for no thread's own clock; then the time is 0.
    unsafe { libc::clock_gettime(libc::CLOCK_THREAD_CPUTIME_ID, &raw mut time) };
    Duration::new(time.tv_sec as u64, time.tv_nsec as u32)
}
