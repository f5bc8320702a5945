//! The decrementer, and the clock that drives it.

use std::sync::LazyLock;
use std::time::{Duration, Instant};

/// Time-base ticks a second on a PlayStation 3.
pub const TICKS_PER_SECOND: u64 = 79_800_000;

const NANOS_PER_SECOND: u128 = 1_000_000_000;

/// A time base: the host's time, or a simulated time.
pub trait Clock: Send + Sync {
    /// Ticks of 79.8 MHz since some fixed moment.
    fn ticks(&self) -> u64;
    /// How long a thread should sleep on the host before `ticks` may have passed.
    fn host_time(&self, ticks: u64) -> Duration;
}

/// The host's monotonic time.
#[derive(Clone, Copy, Debug, Default)]
pub struct HostClock;

static STARTED: LazyLock<Instant> = LazyLock::new(Instant::now);

impl Clock for HostClock {
    fn ticks(&self) -> u64 {
        let nanos = STARTED.elapsed().as_nanos();
        (nanos * u128::from(TICKS_PER_SECOND) / NANOS_PER_SECOND) as u64
    }

    fn host_time(&self, ticks: u64) -> Duration {
        let nanos = u128::from(ticks) * NANOS_PER_SECOND / u128::from(TICKS_PER_SECOND);
        // 13 ns, about one tick, are added so that a sleeper does not wake just before the event.
        Duration::from_nanos(u64::try_from(nanos).unwrap_or(u64::MAX).saturating_add(13))
    }
}

/// Ticks after which a 32-bit decrementer has the same value again.
const PERIOD: u64 = 1 << 32;

/// Counts down from the value written last. Stands still until the first write.
#[derive(Debug, Default)]
pub(crate) struct Decrementer {
    /// The value at `since`. While `since` is `None`, the decrementer stands still at this value.
    value: u32,
    since: Option<u64>,
    next_event: u64,
}

impl Decrementer {
    pub(crate) fn load(&mut self, value: u32, now: u64) {
        self.value = value;
        self.since = Some(now);
        self.next_event = now + u64::from(value) + 1;
    }

    pub(crate) fn value(&self, now: u64) -> u32 {
        match self.since {
            Some(since) => self.value.wrapping_sub(now.wrapping_sub(since) as u32),
            None => self.value,
        }
    }

    /// Stops counting until the next write. Acknowledging the masked event does this.
    pub(crate) fn freeze(&mut self, now: u64) {
        self.value = self.value(now);
        self.since = None;
    }

    /// Whether the value has passed from 0 to negative since the last call.
    pub(crate) fn expired(&mut self, now: u64) -> bool {
        let expired = self.since.is_some() && now >= self.next_event;
        if expired {
            self.next_event += ((now - self.next_event) / PERIOD + 1) * PERIOD;
        }
        expired
    }

    /// Ticks until the next event, if the decrementer is running.
    pub(crate) fn until_event(&self, now: u64) -> Option<u64> {
        self.since.map(|_| self.next_event.saturating_sub(now))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_counts_from_the_value_written_and_wraps() {
        let mut decrementer = Decrementer::default();
        assert_eq!(decrementer.value(50), 0);
        assert_eq!(decrementer.until_event(50), None);
        decrementer.load(10, 100);
        assert_eq!(decrementer.value(103), 7);
        assert_eq!(decrementer.value(111), u32::MAX);
    }

    #[test]
    fn the_event_comes_once_a_pass() {
        let mut decrementer = Decrementer::default();
        decrementer.load(10, 100);
        assert!(!decrementer.expired(110));
        assert_eq!(decrementer.until_event(110), Some(1));
        assert!(decrementer.expired(111));
        assert!(!decrementer.expired(112));
        assert!(decrementer.expired(111 + PERIOD));
        assert!(!decrementer.expired(110 + 2 * PERIOD));
        decrementer.freeze(111 + PERIOD);
        assert_eq!(decrementer.value(u64::MAX), u32::MAX);
        assert!(!decrementer.expired(u64::MAX));
    }

    #[test]
    fn host_time_and_ticks_agree() {
        let clock = HostClock;
        let second = clock.host_time(TICKS_PER_SECOND);
        assert!(second >= Duration::from_secs(1));
        assert!(second < Duration::from_millis(1001));
        let before = clock.ticks();
        std::thread::sleep(Duration::from_millis(20));
        assert!(clock.ticks() - before >= TICKS_PER_SECOND / 50);
    }
}
