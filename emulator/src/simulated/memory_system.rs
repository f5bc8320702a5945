//! How long DMA takes: latencies, each SPU's port, and the main memory that all SPUs share.
//!
//! A transfer is split into lines of 128 bytes. A line waits until its SPU may have another line
//! outstanding. Then it occupies the SPU's port in its direction for the time of a line and, if it
//! goes to main memory, main memory for the same time. It arrives one latency later. So one SPU
//! gets at most the bandwidth that its port or its outstanding lines allow, and all SPUs together
//! get at most the bandwidth of main memory. Not modelled: the element interconnect's rings and
//! command bus, memory banks and refresh, read-write turnaround, address translation, the caches
//! of the PPE.
//!
//! All numbers are in [`MemoryFigures`]. Only the actor that has the turn makes requests, so they
//! come in the order of simulated time.

use std::collections::HashMap;

use super::figures::MemoryFigures;
use super::reservation_table::ReservationTable;
use crate::memory::LINE;
use crate::mfc::timing::Peer;

/// The direction of a transfer, as the SPU sees it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Direction {
    In,
    Out,
}

/// An SPU's part of the memory system.
#[derive(Debug)]
pub(crate) struct Port {
    /// One table for each direction.
    tables: [ReservationTable; 2],
    line_cycles: u64,
    outstanding_lines: usize,
}

impl Port {
    pub fn new(figures: &MemoryFigures) -> Self {
        Self {
            tables: [(); 2].map(|()| ReservationTable::new(figures.line_cycles)),
            line_cycles: figures.line_cycles,
            outstanding_lines: figures.outstanding_lines,
        }
    }

    /// The first slot, at or after `cycle`, in which a line can start that is in flight for
    /// `flight` cycles.
    fn first_free(&self, direction: Direction, cycle: u64, flight: u64) -> u64 {
        let slots = flight.div_ceil(self.line_cycles) - 1;
        let mut begins = cycle;
        loop {
            begins = self.tables[direction as usize].first_free(begins);
            let in_flight = self
                .tables
                .iter()
                .map(|table| table.taken_before(begins, slots));
            if in_flight.sum::<usize>() < self.outstanding_lines {
                return begins;
            }
            begins += self.line_cycles;
        }
    }
}

#[derive(Debug)]
pub(crate) struct MemorySystem {
    figures: MemoryFigures,
    memory: ReservationTable,
    /// The local stores that other SPEs access, by address and direction.
    stores: HashMap<(u64, u8), ReservationTable>,
    /// The cycle until which an atomic command holds each line.
    lines: HashMap<u64, u64>,
}

impl MemorySystem {
    pub fn new(figures: MemoryFigures) -> Self {
        assert!(
            figures.line_cycles > 0 && figures.outstanding_lines > 0,
            "no line would ever arrive: {figures:?}"
        );
        Self {
            figures,
            memory: ReservationTable::new(figures.line_cycles),
            stores: HashMap::new(),
            lines: HashMap::new(),
        }
    }

    /// Times a transfer of `size` bytes at `ea`. Its command was given at `now`, and its first
    /// line may be requested at `start`. Returns when all lines have arrived. A transfer of no
    /// bytes takes no time.
    pub fn transfer(
        &mut self,
        port: &mut Port,
        direction: Direction,
        peer: Peer,
        (ea, size): (u64, u32),
        (now, start): (u64, u64),
    ) -> u64 {
        let line_cycles = self.figures.line_cycles;
        let latency = match peer {
            Peer::Memory => self.figures.memory_latency,
            Peer::LocalStore(_) => self.figures.local_store_latency,
        };
        let table = match peer {
            Peer::Memory => &mut self.memory,
            Peer::LocalStore(base) => self
                .stores
                .entry((base, direction as u8))
                .or_insert_with(|| ReservationTable::new(line_cycles)),
        };
        table.forget_before(now);
        let flight = line_cycles + latency;
        for table in &mut port.tables {
            table.forget_before(now.saturating_sub(flight));
        }
        let mut arrived = start;
        let mut begins = start;
        for _ in 0..lines(ea, size) {
            loop {
                begins = port.first_free(direction, begins, flight);
                let free = table.first_free(begins);
                if free == begins {
                    break;
                }
                begins = free;
            }
            port.tables[direction as usize].take(begins);
            table.take(begins);
            arrived = begins + flight;
        }
        arrived
    }

    /// Times an atomic command on a line that is given at `now`. Returns when its status can be
    /// read.
    pub fn atomic(&mut self, line: u64, now: u64) -> u64 {
        self.lines.retain(|_, kept| *kept > now);
        let kept = self.lines.entry(line).or_insert(now);
        let begins = *kept;
        *kept += self.figures.atomic_line_cycles;
        begins + self.figures.atomic_cycles
    }
}

/// Number of lines that contain some of the `size` bytes at `ea`.
fn lines(ea: u64, size: u32) -> u64 {
    let line = LINE as u64;
    (ea % line + u64::from(size)).div_ceil(line)
}

#[cfg(test)]
mod tests {
    use super::*;

    const FIGURES: MemoryFigures = MemoryFigures::CONSOLE;
    const LINE_CYCLES: u64 = FIGURES.line_cycles;
    const MEMORY_LATENCY: u64 = FIGURES.memory_latency;
    const LOCAL_STORE_LATENCY: u64 = FIGURES.local_store_latency;
    const ATOMIC_CYCLES: u64 = FIGURES.atomic_cycles;
    const ATOMIC_LINE_CYCLES: u64 = FIGURES.atomic_line_cycles;

    fn get(system: &mut MemorySystem, port: &mut Port, size: u32, at: u64) -> u64 {
        system.transfer(port, Direction::In, Peer::Memory, (0, size), (at, at))
    }

    #[test]
    fn one_line_takes_its_time_and_its_latency() {
        let (mut system, mut port) = (MemorySystem::new(FIGURES), Port::new(&FIGURES));
        assert_eq!(get(&mut system, &mut port, 128, 0), 16 + MEMORY_LATENCY);
        assert_eq!(get(&mut system, &mut port, 0, 1600), 1600);
        assert_eq!(lines(0x7f, 2), 2);
        assert_eq!(lines(0x80, 128), 1);
        assert_eq!(lines(0x90, 128), 2);
    }

    #[test]
    fn one_spu_gets_what_its_outstanding_lines_allow() {
        let (mut system, mut port) = (MemorySystem::new(FIGURES), Port::new(&FIGURES));
        let cycles = get(&mut system, &mut port, 128 * 1600, 0);
        // A round trip takes whole slots, and 16 lines are in flight in it.
        let round_trip = (LINE_CYCLES + MEMORY_LATENCY).next_multiple_of(LINE_CYCLES);
        assert!(cycles.abs_diff(100 * round_trip) < 400, "{cycles}");
    }

    #[test]
    fn all_spus_share_the_memory() {
        let mut system = MemorySystem::new(FIGURES);
        let mut ports: Vec<_> = (0..6).map(|_| Port::new(&FIGURES)).collect();
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
        let mut system = MemorySystem::new(FIGURES);
        let mut ports: Vec<_> = (0..3).map(|_| Port::new(&FIGURES)).collect();
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
        let mut system = MemorySystem::new(FIGURES);
        assert_eq!(system.atomic(0, 100), 100 + ATOMIC_CYCLES);
        assert_eq!(
            system.atomic(0, 101),
            100 + ATOMIC_LINE_CYCLES + ATOMIC_CYCLES
        );
        assert_eq!(system.atomic(128, 102), 102 + ATOMIC_CYCLES);
        assert_eq!(system.atomic(0, 9000), 9000 + ATOMIC_CYCLES);
    }
}
