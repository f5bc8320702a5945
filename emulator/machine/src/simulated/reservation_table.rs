//! The reservation table of a resource that serves one line at a time: which of its time slots are
//! taken. All times are in tenths of a cycle.
//!
//! Invariant: each slot is assigned once. Requests come in the order of simulated time, so slots
//! before the newest request are dropped, in whole words.

use std::collections::VecDeque;

const SLOTS_PER_WORD: u64 = u64::BITS as u64;

#[derive(Debug)]
pub(super) struct ReservationTable {
    slot: u64,
    /// Number of the first slot in `taken`. It is a multiple of [`SLOTS_PER_WORD`].
    first: u64,
    /// One bit for each slot, beginning with the lowest.
    taken: VecDeque<u64>,
}

impl ReservationTable {
    pub fn new(slot: u64) -> Self {
        Self { slot, first: 0, taken: VecDeque::new() }
    }

    /// Drops the slots before `time`.
    pub fn forget_before(&mut self, time: u64) {
        let word = time / self.slot / SLOTS_PER_WORD * SLOTS_PER_WORD;
        if word > self.first {
            let words = (word - self.first) / SLOTS_PER_WORD;
            let known = self.taken.len().min(usize::try_from(words).unwrap_or(usize::MAX));
            self.taken.drain(..known);
            self.first = word;
        }
    }

    /// The first time, at or after `time`, at which a free slot begins.
    pub fn first_free(&self, time: u64) -> u64 {
        let wanted = time.div_ceil(self.slot).max(self.first) - self.first;
        let mut word = wanted / SLOTS_PER_WORD;
        let mut before = (1_u64 << (wanted % SLOTS_PER_WORD)) - 1;
        loop {
            let bit = (self.word(word) | before).trailing_ones();
            if bit < u64::BITS {
                let slot = self.first + word * SLOTS_PER_WORD + u64::from(bit);
                return slot * self.slot;
            }
            word += 1;
            before = 0;
        }
    }

    /// Takes the slot that begins at `time`.
    pub fn take(&mut self, time: u64) {
        let slot = time / self.slot - self.first;
        let word = (slot / SLOTS_PER_WORD) as usize;
        if word >= self.taken.len() {
            self.taken.resize(word + 1, 0);
        }
        self.taken[word] |= 1 << (slot % SLOTS_PER_WORD);
    }

    /// How many of the `slots` slots before `time` are taken.
    pub fn taken_before(&self, time: u64, slots: u64) -> usize {
        let end = time / self.slot;
        (end.saturating_sub(slots).max(self.first)..end)
            .filter(|slot| {
                let slot = slot - self.first;
                self.word(slot / SLOTS_PER_WORD) >> (slot % SLOTS_PER_WORD) & 1 == 1
            })
            .count()
    }

    fn word(&self, number: u64) -> u64 {
        let word = usize::try_from(number).ok();
        word.and_then(|word| self.taken.get(word)).map_or(0, |bits| *bits)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn take_first(table: &mut ReservationTable, time: u64) -> u64 {
        let begins = table.first_free(time);
        table.take(begins);
        begins
    }

    #[test]
    fn every_slot_is_given_once_and_gaps_are_used() {
        let mut table = ReservationTable::new(16);
        assert_eq!(take_first(&mut table, 0), 0);
        assert_eq!(take_first(&mut table, 0), 16);
        assert_eq!(take_first(&mut table, 100), 112);
        assert_eq!(take_first(&mut table, 17), 32);
        for n in 3..200 {
            let slot = if n < 7 { n * 16 } else { n * 16 + 16 };
            assert_eq!(take_first(&mut table, 0), slot);
        }
        assert_eq!(table.taken_before(201 * 16, 300), 201);
        assert_eq!(table.taken_before(210 * 16, 10), 1);
        assert_eq!(table.taken_before(0, 10), 0);
    }

    #[test]
    fn the_past_is_forgotten_but_not_given_again() {
        let mut table = ReservationTable::new(16);
        for _ in 0..100 {
            take_first(&mut table, 0);
        }
        table.forget_before(16 * 70);
        assert_eq!(take_first(&mut table, 0), 16 * 100);
        table.forget_before(16 * 1_000_000);
        assert_eq!(take_first(&mut table, 0), 16 * (1_000_000 / 64 * 64));
    }
}
