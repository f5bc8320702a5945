//! How long DMA takes: latencies, each SPU's port, and the memory that all share.
//!
//! A transfer is split into lines of 128 bytes. A line waits for a free place among the lines that its
//! SPU has outstanding, takes the SPU's port in its direction for [`LINE_CYCLES`] and, if it goes to main
//! memory, the memory for [`LINE_CYCLES`]; it is there a latency later. So one SPU gets at most
//! what its port or its outstanding lines give, and all together what the memory gives. Not modelled:
//! the element interconnect's rings and command bus, memory banks and refresh, read-write turnaround,
//! address translation, the caches of the PPE.
//!
//! Every number is here, with its source and certainty. Whoever asks has the turn, so requests come in
//! the order of simulated time.

use std::collections::HashMap;

use super::calendar::Calendar;
use crate::memory::LINE;

/// Cycles for which a line takes an SPU's port, or the memory: 128 bytes at 16 bytes per cycle of
/// the bus, which has half the core's clock, or 25.5 GB/s. Source: 25.6 GB/s at 3.2 GHz in IBM's
/// lecture at MIT for the memory, in measurements of Kistler, Perrone and Petrini (2006) for the
/// port. Firm.
pub const LINE_CYCLES: u64 = 16;

/// Cycles from the write of the command channel to the first request on the bus. Source: the same
/// measurements give under 4 ns (13 cycles) for issuing a command, IBM's lecture about 20 for all its
/// channel writes, of which the pipeline counts six. Fair.
pub const COMMAND_CYCLES: u64 = 13;

/// Cycles from a line's time on the bus until it has arrived, to or from main memory. With
/// [`COMMAND_CYCLES`] and [`LINE_CYCLES`], one line takes 309 cycles: under 100 ns, 319 cycles,
/// were measured by Kistler, Perrone and Petrini (2006). Fair.
pub const MEMORY_LATENCY: u64 = 280;

/// The same between two local stores. Estimate: no figure was found apart from memory's.
pub const LOCAL_STORE_LATENCY: u64 = 200;

/// Cycles from a command until what it sends to another local store can be there: the shortest way
/// on which one SPU reaches what another one loads.
pub const LOCAL_STORE_DELAY: u64 = COMMAND_CYCLES + LINE_CYCLES + LOCAL_STORE_LATENCY;

/// Lines that one SPU has under way at most. Source: IBM's lecture says over 100 outstanding requests
/// for the interconnect, whose eight SPEs would have 16 each. Inferred.
pub const OUTSTANDING_LINES: usize = 16;

/// Cycles that each element of a list adds. Estimate: no figure was found.
pub const LIST_ELEMENT_CYCLES: u64 = 16;

/// Cycles from an atomic command until its status can be read: one line from memory.
/// Inferred from [`MEMORY_LATENCY`].
pub const ATOMIC_CYCLES: u64 = COMMAND_CYCLES + LINE_CYCLES + MEMORY_LATENCY;

/// Cycles for which an atomic command keeps others' atomic commands off its line. Estimate: the line
/// goes from one SPU to the other in the time of a transfer between local stores.
pub const ATOMIC_LINE_CYCLES: u64 = LOCAL_STORE_LATENCY;

/// The constants of the machine by name, in cycles where they are times: for reports.
pub const CONSTANTS: [(&str, u64); 8] = [
    ("line_cycles", LINE_CYCLES),
    ("command_cycles", COMMAND_CYCLES),
    ("memory_latency", MEMORY_LATENCY),
    ("local_store_latency", LOCAL_STORE_LATENCY),
    ("outstanding_lines", OUTSTANDING_LINES as u64),
    ("list_element_cycles", LIST_ELEMENT_CYCLES),
    ("atomic_cycles", ATOMIC_CYCLES),
    ("atomic_line_cycles", ATOMIC_LINE_CYCLES),
];

/// Which way data goes, as the SPU sees it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Direction {
    In,
    Out,
}

/// What lies at the other end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Peer {
    Memory,
    /// The SPE whose local store or signal register is there, by the address where it begins.
    LocalStore(u64),
}

/// An SPU's part of the memory system.
#[derive(Debug)]
pub(crate) struct Port {
    /// By direction.
    ways: [Calendar; 2],
}

impl Port {
    pub fn new() -> Self {
        Self {
            ways: [(); 2].map(|()| Calendar::new(LINE_CYCLES)),
        }
    }

    /// The first slot from `cycle` on in which a line may set out that is under way for `flight`
    /// cycles.
    fn first_free(&self, direction: Direction, cycle: u64, flight: u64) -> u64 {
        let slots = flight.div_ceil(LINE_CYCLES) - 1;
        let mut begins = cycle;
        loop {
            begins = self.ways[direction as usize].first_free(begins);
            let under_way = self.ways.iter().map(|way| way.taken_before(begins, slots));
            if under_way.sum::<usize>() < OUTSTANDING_LINES {
                return begins;
            }
            begins += LINE_CYCLES;
        }
    }
}

#[derive(Debug)]
pub(crate) struct MemorySystem {
    memory: Calendar,
    /// Local stores that others reach, by address and direction.
    stores: HashMap<(u64, u8), Calendar>,
    /// Until when each line is kept by an atomic command.
    lines: HashMap<u64, u64>,
}

impl Default for MemorySystem {
    fn default() -> Self {
        Self {
            memory: Calendar::new(LINE_CYCLES),
            stores: HashMap::new(),
            lines: HashMap::new(),
        }
    }
}

impl MemorySystem {
    /// Moves `size` bytes at `ea` in a command given at `now` whose first line may be asked for at
    /// `start`; says when all have arrived. Nothing moves in no time.
    pub fn transfer(
        &mut self,
        port: &mut Port,
        direction: Direction,
        peer: Peer,
        (ea, size): (u64, u32),
        (now, start): (u64, u64),
    ) -> u64 {
        let latency = match peer {
            Peer::Memory => MEMORY_LATENCY,
            Peer::LocalStore(_) => LOCAL_STORE_LATENCY,
        };
        let calendar = match peer {
            Peer::Memory => &mut self.memory,
            Peer::LocalStore(base) => self
                .stores
                .entry((base, direction as u8))
                .or_insert_with(|| Calendar::new(LINE_CYCLES)),
        };
        calendar.forget_before(now);
        let flight = LINE_CYCLES + latency;
        for way in &mut port.ways {
            way.forget_before(now.saturating_sub(flight));
        }
        let mut arrived = start;
        let mut begins = start;
        for _ in 0..lines(ea, size) {
            loop {
                begins = port.first_free(direction, begins, flight);
                let free = calendar.first_free(begins);
                if free == begins {
                    break;
                }
                begins = free;
            }
            port.ways[direction as usize].take(begins);
            calendar.take(begins);
            arrived = begins + flight;
        }
        arrived
    }

    /// An atomic command on a line, given at `now`; says when its status can be read.
    pub fn atomic(&mut self, line: u64, now: u64) -> u64 {
        self.lines.retain(|_, kept| *kept > now);
        let kept = self.lines.entry(line).or_insert(now);
        let begins = *kept;
        *kept += ATOMIC_LINE_CYCLES;
        begins + ATOMIC_CYCLES
    }
}

/// Lines that `size` bytes at `ea` touch.
fn lines(ea: u64, size: u32) -> u64 {
    let line = LINE as u64;
    (ea % line + u64::from(size)).div_ceil(line)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn get(system: &mut MemorySystem, port: &mut Port, size: u32, at: u64) -> u64 {
        system.transfer(port, Direction::In, Peer::Memory, (0, size), (at, at))
    }

    #[test]
    fn one_line_takes_its_time_and_its_latency() {
        let (mut system, mut port) = (MemorySystem::default(), Port::new());
        assert_eq!(get(&mut system, &mut port, 128, 0), 16 + MEMORY_LATENCY);
        assert_eq!(get(&mut system, &mut port, 0, 1600), 1600);
        assert_eq!(lines(0x7f, 2), 2);
        assert_eq!(lines(0x80, 128), 1);
        assert_eq!(lines(0x90, 128), 2);
    }

    #[test]
    fn one_spu_gets_what_its_outstanding_lines_allow() {
        let (mut system, mut port) = (MemorySystem::default(), Port::new());
        let cycles = get(&mut system, &mut port, 128 * 1600, 0);
        // 16 lines a round trip, of whole slots.
        let round_trip = (LINE_CYCLES + MEMORY_LATENCY).next_multiple_of(LINE_CYCLES);
        assert!(cycles.abs_diff(100 * round_trip) < 400, "{cycles}");
    }

    #[test]
    fn all_spus_share_the_memory() {
        let mut system = MemorySystem::default();
        let mut ports: Vec<_> = (0..6).map(|_| Port::new()).collect();
        let mut last = 0;
        for _ in 0..50 {
            for port in &mut ports {
                last = last.max(get(&mut system, port, 16384, 0));
            }
        }
        let busy = 50 * 6 * 128 * LINE_CYCLES;
        assert!(last >= busy, "{last} {busy}");
        assert!(last < busy + busy / 20, "{last} {busy}");
    }

    #[test]
    fn local_stores_do_not_take_the_memory() {
        let mut system = MemorySystem::default();
        let mut ports: Vec<_> = (0..3).map(|_| Port::new()).collect();
        let mut to =
            |port: &mut Port, peer| system.transfer(port, Direction::Out, peer, (0, 1024), (0, 0));
        let alone = 8 * LINE_CYCLES + LOCAL_STORE_LATENCY;
        assert_eq!(to(&mut ports[0], Peer::LocalStore(1)), alone);
        assert_eq!(to(&mut ports[1], Peer::LocalStore(2)), alone);
        assert_eq!(
            to(&mut ports[2], Peer::LocalStore(2)),
            alone + 8 * LINE_CYCLES
        );
    }

    #[test]
    fn atomic_commands_queue_for_their_line() {
        let mut system = MemorySystem::default();
        assert_eq!(system.atomic(0, 100), 100 + ATOMIC_CYCLES);
        assert_eq!(
            system.atomic(0, 101),
            100 + ATOMIC_LINE_CYCLES + ATOMIC_CYCLES
        );
        assert_eq!(system.atomic(128, 102), 102 + ATOMIC_CYCLES);
        assert_eq!(system.atomic(0, 9000), 9000 + ATOMIC_CYCLES);
    }
}
