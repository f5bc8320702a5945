//! Time of the frame loop's thread: what passes, and what of it the thread has on its processor.

use std::time::{Duration, Instant};

/// A moment of the thread that asks.
#[derive(Clone, Copy, Debug)]
pub struct LoopTime {
    passed: Instant,
    processor: Duration,
}

impl LoopTime {
    /// This moment.
    #[must_use]
    pub fn now() -> Self {
        Self {
            passed: Instant::now(),
            processor: processor_time(),
        }
    }

    /// Time that has passed since, and what of it this thread had on its processor.
    pub(super) fn until_now(self) -> (Duration, Duration) {
        let processor = processor_time().saturating_sub(self.processor);
        (self.passed.elapsed(), processor)
    }
}

/// Time that this thread has had on a processor.
fn processor_time() -> Duration {
    let mut time = libc::timespec {
        tv_sec: 0,
        tv_nsec: 0,
    };
    // SAFETY: the call writes to `time` alone. It fails for no thread's own clock; then the time
    // is 0.
    unsafe { libc::clock_gettime(libc::CLOCK_THREAD_CPUTIME_ID, &raw mut time) };
    Duration::new(time.tv_sec as u64, time.tv_nsec as u32)
}
