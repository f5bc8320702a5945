//! Inline prefetch: fetching straight-line code from local store (see `Rules::inline_prefetch`).
//!
//! The local store has one port. A load, a store or a hint's fetch occupies it for a cycle. In any
//! other cycle the next line is requested if the buffer has space for it. After a branch, the
//! target's line and the next one are present, because the branch's own cost includes their fetch.
//! Everything except the line's size and the order of priorities is a guess.

use super::rules::{INLINE_LINES, LINE_BYTES, LINE_CYCLES};

const LINE_INSTRUCTIONS: u32 = LINE_BYTES / 4;
const CAPACITY: u32 = INLINE_LINES * LINE_INSTRUCTIONS;

/// The instruction buffer.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(super) struct InlineBuffer {
    /// Number of instructions in the buffer.
    buffered: u32,
    /// When the requested line arrives.
    arrival: Option<u64>,
    /// The current cycle, and whether the port is occupied in it.
    cycle: u64,
    port_taken: bool,
}

/// The state after a branch to the start of a line.
impl Default for InlineBuffer {
    fn default() -> Self {
        Self { buffered: CAPACITY, arrival: None, cycle: 0, port_taken: false }
    }
}

impl InlineBuffer {
    /// The first cycle, at or after `cycle`, in which the next instruction is available.
    pub fn available(&mut self, cycle: u64) -> u64 {
        self.advance(cycle);
        if self.buffered > 0 {
            return cycle;
        }
        // Until then nothing issues, so nothing else occupies the port.
        let asked = cycle + u64::from(self.port_taken);
        let arrival = self.arrival.unwrap_or(asked + LINE_CYCLES);
        self.advance(arrival);
        arrival
    }

    /// An instruction left the buffer in `cycle`.
    pub fn issued(&mut self, cycle: u64, takes_port: bool) {
        self.advance(cycle);
        self.buffered = self.buffered.saturating_sub(1);
        self.port_taken |= takes_port;
    }

    /// Issue continues at `target`.
    pub fn redirected(&mut self, target: u32) {
        self.buffered = CAPACITY - target % LINE_BYTES / 4;
        self.arrival = None;
    }

    /// Advances time up to `cycle`, not including it.
    fn advance(&mut self, cycle: u64) {
        while self.cycle < cycle {
            if self.arrival.is_some_and(|arrival| arrival <= self.cycle) {
                self.receive();
            }
            let has_space = self.buffered + LINE_INSTRUCTIONS <= CAPACITY;
            if self.arrival.is_none() && has_space && !self.port_taken {
                self.arrival = Some(self.cycle + LINE_CYCLES);
            }
            // Nothing changes between this cycle and the line's arrival.
            let next = self.cycle + 1;
            self.cycle = match self.arrival {
                Some(arrival) => arrival.clamp(next, cycle.max(next)),
                None if self.port_taken => next,
                None => cycle,
            };
            self.port_taken = false;
        }
        if self.arrival.is_some_and(|arrival| arrival <= self.cycle) {
            self.receive();
        }
    }

    fn receive(&mut self) {
        self.arrival = None;
        self.buffered += LINE_INSTRUCTIONS;
    }

    /// The state relative to `clock`. Equal relative states behave equally in the future.
    pub fn relative(&self, clock: u64) -> Self {
        self.moved(clock.wrapping_neg())
    }

    /// The inverse of [`relative`](Self::relative), for another `clock`.
    pub fn at(&self, clock: u64) -> Self {
        self.moved(clock)
    }

    fn moved(&self, by: u64) -> Self {
        Self {
            arrival: self.arrival.map(|arrival| arrival.wrapping_add(by)),
            cycle: self.cycle.wrapping_add(by),
            ..*self
        }
    }
}
