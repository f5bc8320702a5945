//! Conversions between cycles, tenths of them, ticks and the host's time.

use std::time::Duration;

use crate::decrementer::TICKS_PER_SECOND;

/// A time that never comes, for a sleeper that only another actor can wake.
pub(super) const NEVER: u64 = u64::MAX;

/// Cycles in a decrementer tick. Source: cycle counts that programs print on a PlayStation 3 are
/// multiples of it. Firm.
pub const CYCLES_PER_TICK: u64 = 40;

/// The SPU's clock: 3.192 GHz.
pub const CYCLES_PER_SECOND: u64 = CYCLES_PER_TICK * TICKS_PER_SECOND;

/// A time in tenths of a cycle.
///
/// The bus and the memory of a console serve a line in a time that is no whole number of cycles.
/// Tenths are what the measurements resolve, and sums of integers are the same on every host.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Tenths(pub u64);

impl Tenths {
    /// Tenths in a cycle.
    pub const PER_CYCLE: u64 = 10;

    /// The time of whole cycles.
    #[must_use]
    pub const fn of_cycles(cycles: u64) -> Self {
        Self(cycles * Self::PER_CYCLE)
    }

    /// The first cycle that begins at this time or later.
    #[must_use]
    pub const fn cycles(self) -> u64 {
        self.0.div_ceil(Self::PER_CYCLE)
    }
}

/// Decrementer ticks in `cycles`.
#[must_use]
pub const fn ticks(cycles: u64) -> u64 {
    cycles / CYCLES_PER_TICK
}

/// The first cycle in which [`ticks`] is `ticks`.
#[must_use]
pub const fn cycle_of_tick(ticks: u64) -> u64 {
    ticks.saturating_mul(CYCLES_PER_TICK)
}

/// Cycles in `time`, to the microsecond, at least one.
pub(crate) fn cycles(time: Duration) -> u64 {
    let micros = u64::try_from(time.as_micros()).unwrap_or(u64::MAX);
    micros.saturating_mul(CYCLES_PER_SECOND / 1_000_000).max(1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_and_cycles_agree() {
        assert_eq!(CYCLES_PER_SECOND, 3_192_000_000);
        assert_eq!(ticks(CYCLES_PER_SECOND), TICKS_PER_SECOND);
        assert_eq!((ticks(39), ticks(40), ticks(80)), (0, 1, 2));
        for tick in [1, 2, 399, 79_800_000, 1 << 40] {
            let cycle = cycle_of_tick(tick);
            assert_eq!((ticks(cycle - 1), ticks(cycle)), (tick - 1, tick));
        }
        assert_eq!(cycle_of_tick(u64::MAX), u64::MAX);
    }
}
