//! The lines of main memory that are being transferred.
//!
//! Invariant: of two accesses that have a line in common, one of which writes, one begins when the
//! other has ended. So a line is seen as it was before a write or after it, and never in between.
//! Accesses without a common line don't wait for each other.
//!
//! Who comes when a line is free goes before those that have not noticed it yet. Otherwise SPEs
//! that count in one line would take turns at each command, and no conditional put would succeed.
//! But who has slept for long goes first, so nobody waits for ever: a line that many poll can
//! still be written.
//!
//! Lines are distinguished by their effective address. A line that is mapped at two addresses
//! counts as two lines.

use std::sync::{Condvar, Mutex, MutexGuard, PoisonError};

use crate::lock::lock;
use crate::memory::LINE;

/// How often an access looks again before its thread sleeps: first at once, because most waits are
/// for one system call of a thread that runs, and then after other threads could run.
const LOOKS_AT_ONCE: u32 = 4;
const LOOKS: u32 = 24;
const PAUSES_BETWEEN_LOOKS: u32 = 64;
/// The number of futile wake-ups after which an access has priority over later ones.
const PATIENCE: u32 = 8;

/// The first and the last line of a range, by their addresses.
type Range = (u64, u64);

fn range((ea, length): (u64, usize)) -> Range {
    const LINE_MASK: u64 = !(LINE as u64 - 1);
    let last = ea.saturating_add((length as u64).saturating_sub(1));
    (ea & LINE_MASK, last & LINE_MASK)
}

/// The lines that an access touches.
enum Lines {
    One(Range),
    /// In ascending order of their first lines.
    Many(Vec<Range>),
}

impl Lines {
    fn of(pieces: impl Iterator<Item = (u64, usize)>) -> Self {
        let mut ranges = pieces.filter(|&(_, length)| length > 0).map(range);
        let Some(first) = ranges.next() else {
            return Self::Many(Vec::new());
        };
        let Some(second) = ranges.next() else {
            return Self::One(first);
        };
        let (_, most) = ranges.size_hint();
        let mut all = Vec::with_capacity(2 + most.unwrap_or(0));
        all.extend([first, second]);
        all.extend(ranges);
        all.sort_unstable();
        Self::Many(all)
    }

    fn as_slice(&self) -> &[Range] {
        match self {
            Self::One(only) => std::slice::from_ref(only),
            Self::Many(ranges) => ranges,
        }
    }

    fn overlap(&self, other: &Self) -> bool {
        let (mut own, mut its) = (self.as_slice(), other.as_slice());
        while let ([(own_first, own_last), own_rest @ ..], [(its_first, its_last), its_rest @ ..]) =
            (own, its)
        {
            if own_first <= its_last && its_first <= own_last {
                return true;
            }
            // The range that ends first is wholly before the other one, and so before those that
            // follow it.
            if own_last < its_last {
                own = own_rest;
            } else {
                its = its_rest;
            }
        }
        false
    }
}

struct Access {
    ticket: u64,
    writes: bool,
    lines: Lines,
    stage: Stage,
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Stage {
    Waits,
    /// It has waited for so long that those that came later wait for it.
    GoesFirst,
    UnderWay,
}

#[derive(Default)]
struct State {
    /// In the order of arrival, those that wait among them.
    accesses: Vec<Access>,
    next_ticket: u64,
    sleepers: usize,
}

impl State {
    fn arrive(&mut self, writes: bool, lines: Lines) -> u64 {
        let ticket = self.next_ticket;
        self.next_ticket += 1;
        self.accesses.push(Access { ticket, writes, lines, stage: Stage::Waits });
        ticket
    }

    /// Whether an access is in the way of this one.
    fn is_held_up(&self, ticket: u64) -> bool {
        let Some(at) = self.position(ticket) else {
            return false;
        };
        let own = &self.accesses[at];
        let in_the_way = |(its_place, other): (usize, &Access)| {
            let goes_before = match other.stage {
                Stage::Waits => false,
                Stage::GoesFirst => its_place < at,
                Stage::UnderWay => true,
            };
            goes_before
                && its_place != at
                && (own.writes || other.writes)
                && own.lines.overlap(&other.lines)
        };
        self.accesses.iter().enumerate().any(in_the_way)
    }

    fn set_stage(&mut self, ticket: u64, stage: Stage) {
        if let Some(at) = self.position(ticket) {
            self.accesses[at].stage = stage;
        }
    }

    fn position(&self, ticket: u64) -> Option<usize> {
        let is_it = |access: &Access| access.ticket == ticket;
        self.accesses.iter().position(is_it)
    }
}

#[derive(Default)]
pub(crate) struct LineLocks {
    state: Mutex<State>,
    ended: Condvar,
}

impl LineLocks {
    /// Waits until the pieces may be read. Until the result is dropped, they are not written.
    pub(crate) fn read(&self, pieces: &[(u64, usize)]) -> Held<'_> {
        self.hold(false, Lines::of(pieces.iter().copied()))
    }

    /// Waits until the pieces may be written. Until the result is dropped, they are neither read
    /// nor written by others.
    pub(crate) fn write(&self, pieces: impl Iterator<Item = (u64, usize)>) -> Held<'_> {
        self.hold(true, Lines::of(pieces))
    }

    fn hold(&self, writes: bool, lines: Lines) -> Held<'_> {
        let mut state = lock(&self.state);
        let ticket = state.arrive(writes, lines);
        let mut looks = 0;
        while state.is_held_up(ticket) {
            looks += 1;
            if looks > LOOKS + PATIENCE {
                state.set_stage(ticket, Stage::GoesFirst);
            }
            state = if looks > LOOKS {
                self.sleep(state)
            } else {
                drop(state);
                if looks <= LOOKS_AT_ONCE {
                    (0..PAUSES_BETWEEN_LOOKS).for_each(|_| std::hint::spin_loop());
                } else {
                    std::thread::yield_now();
                }
                lock(&self.state)
            };
        }
        state.set_stage(ticket, Stage::UnderWay);
        Held { locks: self, ticket }
    }

    fn sleep<'a>(&'a self, mut state: MutexGuard<'a, State>) -> MutexGuard<'a, State> {
        state.sleepers += 1;
        let woken = self.ended.wait(state);
        let mut state = woken.unwrap_or_else(PoisonError::into_inner);
        state.sleepers -= 1;
        state
    }
}

/// An access that is under way.
pub(crate) struct Held<'a> {
    locks: &'a LineLocks,
    ticket: u64,
}

impl Drop for Held<'_> {
    fn drop(&mut self) {
        let mut state = lock(&self.locks.state);
        if let Some(at) = state.position(self.ticket) {
            state.accesses.remove(at);
        }
        if state.sleepers > 0 {
            self.locks.ended.notify_all();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lines(pieces: &[(u64, usize)]) -> Lines {
        Lines::of(pieces.iter().copied())
    }

    /// Whether the second access waits for the first, while that is under way.
    fn second_waits(first: (bool, &[(u64, usize)]), second: (bool, &[(u64, usize)])) -> bool {
        let locks = LineLocks::default();
        let _first = locks.hold(first.0, lines(first.1));
        let mut state = lock(&locks.state);
        let ticket = state.arrive(second.0, lines(second.1));
        state.is_held_up(ticket)
    }

    #[test]
    fn a_write_and_another_access_to_one_line_exclude_each_other() {
        let (line, next) = (&[(0x1000, 16)][..], &[(0x1080, 128)][..]);
        let same = &[(0x107f, 1)][..];
        assert!(second_waits((true, line), (true, same)));
        assert!(second_waits((true, line), (false, same)));
        assert!(second_waits((false, line), (true, same)));
        assert!(!second_waits((false, line), (false, same)));
        assert!(!second_waits((true, line), (true, next)));
        assert!(second_waits((true, &[(0x1000, 129)]), (true, next)));
        assert!(!second_waits((true, &[(0x1000, 0)]), (true, line)));
        assert!(second_waits((true, &[(u64::MAX, 16)]), (true, &[(u64::MAX, 1)])));
    }

    #[test]
    fn pieces_are_compared_each_with_each() {
        let rows = |at: u64| (0..64).map(move |row| (at + row * 5120, 256));
        let left: Vec<_> = rows(0x10000).collect();
        let right: Vec<_> = rows(0x10100).rev().collect();
        assert!(!second_waits((true, &left), (true, &right)));
        for row in [0, 31, 63] {
            let one = [left[row]];
            assert!(second_waits((true, &left), (true, &one)), "{row}");
            assert!(second_waits((true, &one), (true, &left)), "{row}");
            let mut touching = right.clone();
            touching.push((left[row].0 + 255, 1));
            assert!(second_waits((true, &left), (true, &touching)), "{row}");
        }
        // A long range that covers shorter ones, before which it begins.
        let covering = [(0x0, 0x100_0000), (0x100, 16), (0x300, 16)];
        assert!(second_waits((true, &covering), (true, &[(0x80_0000, 16)])));
    }

    #[test]
    fn long_waiting_access_precedes_later_ones() {
        let locks = LineLocks::default();
        let line = [(0x1000, 128)];
        let reading = locks.read(&[(0x1000, 128)]);
        let arrive = |writes| lock(&locks.state).arrive(writes, lines(&line));
        let (write, later_read) = (arrive(true), arrive(false));
        let held_up = || {
            let state = lock(&locks.state);
            (state.is_held_up(write), state.is_held_up(later_read))
        };
        assert_eq!(held_up(), (true, false));
        lock(&locks.state).set_stage(write, Stage::GoesFirst);
        assert_eq!(held_up(), (true, true));
        drop(reading);
        assert_eq!(held_up(), (false, true));
    }

    /// Each thread finds what it wrote, and all end.
    #[test]
    fn many_threads_share_a_line() {
        let locks = LineLocks::default();
        let count = std::sync::atomic::AtomicU32::new(0);
        std::thread::scope(|scope| {
            for _ in 0..8 {
                scope.spawn(|| {
                    for _ in 0..500 {
                        let _alone = locks.write([(0x1000, 16)].into_iter());
                        let before = count.load(std::sync::atomic::Ordering::Relaxed);
                        std::thread::yield_now();
                        count.store(before + 1, std::sync::atomic::Ordering::Relaxed);
                    }
                });
            }
        });
        assert_eq!(count.into_inner(), 4000);
        assert!(lock(&locks.state).accesses.is_empty());
    }
}
