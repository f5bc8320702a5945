//! Elapsed time and processor time of the frame loop's thread.

use std::time::{Duration, Instant};

/// A point in time, as elapsed time and as processor time of the current thread.
#[derive(Clone, Copy, Debug)]
pub struct LoopTime {
    passed: Instant,
    processor: Duration,
}

impl LoopTime {
    /// The current time of this thread.
    #[must_use]
    pub fn now() -> Self {
        Self { passed: Instant::now(), processor: processor_time() }
    }

    /// The elapsed time and this thread's processor time since then.
    pub(super) fn until_now(self) -> (Duration, Duration) {
        let processor = processor_time().saturating_sub(self.processor);
        (self.passed.elapsed(), processor)
    }
}

/// This thread's processor time so far.
fn processor_time() -> Duration {
    let mut time = libc::timespec { tv_sec: 0, tv_nsec: 0 };
    // SAFETY: the call writes only to `time`. It doesn't fail for a thread's own clock; if it did,
    // the time would be 0.
    unsafe { libc::clock_gettime(libc::CLOCK_THREAD_CPUTIME_ID, &raw mut time) };
    Duration::new(time.tv_sec as u64, time.tv_nsec as u32)
}
