//! How long DMA takes: latencies, each SPU's port, the rings between local stores, and the main
//! memory that all SPUs share.
//!
//! A transfer is split into lines of 128 bytes. A line waits until its SPU may have another line
//! outstanding. Then it occupies the SPU's port in its direction for the time of a line and, if it
//! goes to main memory, main memory for the time of a line there. A line between local stores
//! occupies the other one's port instead, and the rings. It arrives one latency later. So one SPU
//! gets at most the bandwidth that its port or its outstanding lines allow, and all SPUs together
//! get at most the bandwidth of main memory.
//!
//! The four rings of the interconnect are one resource here, with the throughput that was measured
//! of six flows at once. Not modelled: where SPEs are on the rings, the command bus, memory banks
//! and refresh, read-write turnaround, address translation, the caches of the PPE.
//!
//! All numbers are in [`MemoryFigures`]. Times of lines are no whole cycles, so reservations are
//! kept in tenths of a cycle. Each resource has slots of its own length, and a line takes slots
//! that begin less than a line's time apart. Only the actor that has the turn makes requests, so
//! they come in the order of simulated time.

use std::collections::HashMap;

use super::figures::MemoryFigures;
use super::reservation_table::ReservationTable;
use super::time::Tenths;
use crate::memory::LINE;
use crate::mfc::timing::{Atomic, Peer};

/// The number of lines with remembered puts above which those that are over are dropped.
const REMEMBERED_PUTS: usize = 1 << 10;

impl MemoryFigures {
    /// Tenths of a cycle for which a line is in flight: from main memory, to it, and between local
    /// stores.
    fn flights(&self) -> [u64; 3] {
        [
            (self.get_line, self.get_latency),
            (self.put_line, self.put_latency),
            (self.port_line, self.local_store_latency),
        ]
        .map(|(line, latency)| line.0 + Tenths::of_cycles(latency).0)
    }
}

/// The direction of a transfer, as the SPU sees it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Direction {
    In,
    Out,
}

/// An SPU's part of the memory system.
#[derive(Debug)]
pub(crate) struct Port {
    /// The SPU's number, for conflicts between SPUs.
    number: u64,
    /// One table for each direction.
    tables: [ReservationTable; 2],
    line: u64,
    outstanding_lines: u64,
    /// The longest time for which a line is in flight.
    longest_flight: u64,
}

impl Port {
    /// The port of SPU `number`.
    pub fn new(number: u64, figures: &MemoryFigures) -> Self {
        Self {
            number,
            tables: [(); 2].map(|()| ReservationTable::new(figures.port_line.0)),
            line: figures.port_line.0,
            outstanding_lines: figures.outstanding_lines,
            longest_flight: figures.flights().into_iter().max().unwrap_or(0),
        }
    }

    /// The first slot, at or after `time`, in which a line can start that is in flight for
    /// `flight`.
    fn first_free(&self, direction: Direction, time: u64, flight: u64) -> u64 {
        let slots = flight.div_ceil(self.line) - 1;
        let mut begins = time;
        loop {
            begins = self.tables[direction as usize].first_free(begins);
            let in_flight =
                self.tables.iter().map(|table| table.taken_before(begins, slots) as u64);
            if in_flight.sum::<u64>() < self.outstanding_lines {
                return begins;
            }
            begins += self.line;
        }
    }
}

/// Main memory: a table with slots of the shorter of its two lines. The longer line takes an
/// additional slot whenever its excess adds up to one.
#[derive(Debug)]
struct Memory {
    slots: ReservationTable,
    /// What a line of each direction takes beyond a slot.
    excess: [u64; 2],
    slot: u64,
    /// The excess of lines so far that has not been taken.
    owed: u64,
}

impl Memory {
    fn new(figures: &MemoryFigures) -> Self {
        let lines = [figures.get_line.0, figures.put_line.0];
        let slot = lines[0].min(lines[1]);
        Self {
            slots: ReservationTable::new(slot),
            excess: lines.map(|line| line - slot),
            slot,
            owed: 0,
        }
    }

    fn take(&mut self, time: u64, direction: Direction) {
        self.slots.take(time);
        self.owed += self.excess[direction as usize];
        while self.owed >= self.slot {
            self.owed -= self.slot;
            let free = self.slots.first_free(time);
            self.slots.take(free);
        }
    }
}

/// The last `put` to a line.
#[derive(Clone, Copy, Debug)]
struct Put {
    /// The number of the SPU that gave it.
    by: u64,
    /// The time until which it keeps other SPUs from the line.
    until: u64,
}

#[derive(Debug)]
pub(crate) struct MemorySystem {
    figures: MemoryFigures,
    memory: Memory,
    rings: ReservationTable,
    /// The local stores that other SPEs access, by address and direction.
    stores: HashMap<(u64, u8), ReservationTable>,
    /// The last puts to lines that are the first or the last of a transfer.
    puts: HashMap<u64, Put>,
    /// The cycle until which atomic commands keep others from each line.
    lines: HashMap<u64, u64>,
}

impl MemorySystem {
    pub fn new(figures: MemoryFigures) -> Self {
        let MemoryFigures { port_line, get_line, put_line, ring_line, .. } = figures;
        let lines = [port_line, get_line, put_line, ring_line];
        assert!(
            lines.iter().all(|line| line.0 > 0) && figures.outstanding_lines > 0,
            "no line would ever arrive: {figures:?}"
        );
        Self {
            figures,
            memory: Memory::new(&figures),
            rings: ReservationTable::new(ring_line.0),
            stores: HashMap::new(),
            puts: HashMap::new(),
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
        let [get, put, between_stores] = self.figures.flights();
        let flight = match (peer, direction) {
            (Peer::Memory, Direction::In) => get,
            (Peer::Memory, Direction::Out) => put,
            (Peer::LocalStore(_), _) => between_stores,
        };
        self.forget_before(now, port);
        if let Peer::LocalStore(base) = peer {
            let slot = self.figures.port_line.0;
            let store = self.stores.entry((base, direction as u8));
            let store = store.or_insert_with(|| ReservationTable::new(slot));
            store.forget_before(Tenths::of_cycles(now).0);
        }
        let start = Tenths::of_cycles(start).0;
        let (mut arrived, mut from) = (start, start);
        let (first, count) = (ea / LINE as u64, lines(ea, size));
        for number in first..first + count {
            let shared = peer == Peer::Memory
                && direction == Direction::Out
                && (number == first || number + 1 == first + count);
            let earliest = match self.puts.get(&number) {
                Some(put) if shared && put.by != port.number => from.max(put.until),
                _ => from,
            };
            let (slot, begins) = self.take_line(port, direction, peer, (earliest, flight));
            // Lines that follow a waiting one don't wait for it.
            if earliest == from {
                from = slot;
            }
            if shared {
                // Counted from when it could begin, so that waits for slots don't add up.
                let until = earliest + Tenths::of_cycles(self.figures.put_line_conflict_cycles).0;
                let by = port.number;
                self.puts.insert(number, Put { by, until });
            }
            arrived = arrived.max(begins + flight);
        }
        Tenths(arrived).cycles()
    }

    /// Drops what no request at `now` or later can meet.
    fn forget_before(&mut self, now: u64, port: &mut Port) {
        let now = Tenths::of_cycles(now).0;
        self.memory.slots.forget_before(now);
        self.rings.forget_before(now);
        if self.puts.len() > REMEMBERED_PUTS {
            self.puts.retain(|_, put| put.until > now);
        }
        for table in &mut port.tables {
            table.forget_before(now.saturating_sub(port.longest_flight));
        }
    }

    /// Takes the first slots, not before `earliest`, for a line that is in flight for `flight`.
    /// Returns the slot of the SPU's port, and the beginning of the last of all slots.
    fn take_line(
        &mut self,
        port: &mut Port,
        direction: Direction,
        peer: Peer,
        (mut earliest, flight): (u64, u64),
    ) -> (u64, u64) {
        let mut store = match peer {
            Peer::Memory => None,
            Peer::LocalStore(base) => self.stores.get_mut(&(base, direction as u8)),
        };
        loop {
            let slot = port.first_free(direction, earliest, flight);
            let (other, last) = match &store {
                None => {
                    let other = self.memory.slots.first_free(slot);
                    (other, other)
                }
                Some(store) => {
                    let other = store.first_free(slot);
                    (other, self.rings.first_free(other))
                }
            };
            if last - slot >= port.line {
                earliest = last + 1 - port.line;
                continue;
            }
            port.tables[direction as usize].take(slot);
            match &mut store {
                None => self.memory.take(other, direction),
                Some(store) => {
                    store.take(other);
                    self.rings.take(last);
                }
            }
            return (slot, last);
        }
    }

    /// Times an atomic command on a line that is given at `now`. Returns when its status can be
    /// read.
    pub fn atomic(&mut self, line: u64, atomic: Atomic, now: u64) -> u64 {
        self.lines.retain(|_, kept| *kept > now);
        let keeps = match atomic {
            Atomic::Read => self.figures.getllar_line_cycles,
            Atomic::Written => self.figures.atomic_write_line_cycles,
            Atomic::Lost => return now + self.figures.putllc_lost_latency,
        };
        let kept = self.lines.entry(line).or_insert(now);
        let begins = *kept;
        *kept += keeps;
        begins + self.figures.atomic_latency
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

    fn ports(count: u64) -> Vec<Port> {
        (0..count).map(|number| Port::new(number, &FIGURES)).collect()
    }

    fn get(system: &mut MemorySystem, port: &mut Port, size: u32, at: u64) -> u64 {
        system.transfer(port, Direction::In, Peer::Memory, (0, size), (at, at))
    }

    #[test]
    fn one_line_takes_its_time_and_its_latency() {
        let mut system = MemorySystem::new(FIGURES);
        let port = &mut ports(1)[0];
        assert_eq!(get(&mut system, port, 128, 0), 17 + 280);
        assert_eq!(get(&mut system, port, 0, 1600), 1600);
        let put = system.transfer(port, Direction::Out, Peer::Memory, (0, 128), (17_000, 17_000));
        // The port's slots are 17.3 cycles long, so a line waits up to that for the next.
        assert!((17_318..17_336).contains(&put), "{put}");
        assert_eq!(lines(0x7f, 2), 2);
        assert_eq!(lines(0x80, 128), 1);
        assert_eq!(lines(0x90, 128), 2);
    }

    #[test]
    fn one_spu_gets_what_its_outstanding_lines_allow() {
        let mut system = MemorySystem::new(FIGURES);
        let cycles = get(&mut system, &mut ports(1)[0], 128 * 1600, 0);
        // A round trip of 297 cycles takes 18 slots of 17.3, and 16 lines are in flight in it.
        assert!(cycles.abs_diff(100 * 18 * 173 / 10) < 400, "{cycles}");
    }

    /// Cycles a line when six SPUs move much data in this direction.
    fn saturated(direction: Direction) -> f64 {
        let mut system = MemorySystem::new(FIGURES);
        let mut ports = ports(6);
        let mut last = 0;
        for _ in 0..50 {
            for port in &mut ports {
                let own = (port.number << 20, 16384);
                last = last.max(system.transfer(port, direction, Peer::Memory, own, (0, 0)));
            }
        }
        last as f64 / (50.0 * 6.0 * 128.0)
    }

    #[test]
    fn all_spus_share_the_memory() {
        let (get, put) = (saturated(Direction::In), saturated(Direction::Out));
        assert!((17.0..17.1).contains(&get), "{get}");
        assert!((17.4..17.5).contains(&put), "{put}");
    }

    #[test]
    fn local_stores_share_the_rings_but_not_the_memory() {
        // Cycles a line of pairs of SPUs of which each reads the other's local store.
        let read = |pairs: u64| {
            let mut system = MemorySystem::new(FIGURES);
            let mut ports = ports(2 * pairs);
            let mut last = 0;
            for _ in 0..50 {
                for port in &mut ports {
                    let peer = Peer::LocalStore(port.number ^ 1);
                    let what = (0, 16384);
                    last = last.max(system.transfer(port, Direction::In, peer, what, (0, 0)));
                }
            }
            last as f64 / (50.0 * 128.0)
        };
        let (one, three) = (read(1), read(3));
        assert!((17.3..17.4).contains(&one), "{one}");
        assert!((21.6..22.0).contains(&three), "{three}");
        let mut system = MemorySystem::new(FIGURES);
        let mut ports = ports(3);
        let mut to = |number: usize, store| {
            let peer = Peer::LocalStore(store);
            let port = &mut ports[number];
            system.transfer(port, Direction::Out, peer, (0, 1024), (0, 0))
        };
        let (first, second, same) = (to(0, 1), to(1, 2), to(2, 2));
        assert!((339..343).contains(&first), "{first}");
        assert!(second < first + 5, "{second}");
        assert!(same >= second + 8 * 17, "{same}");
    }

    #[test]
    fn puts_of_several_spus_to_one_line_wait_for_each_other() {
        let mut system = MemorySystem::new(FIGURES);
        let mut ports = ports(2);
        let mut put = |number: usize, what| {
            let port = &mut ports[number];
            system.transfer(port, Direction::Out, Peer::Memory, what, (0, 0))
        };
        let first = put(0, (0, 32));
        assert!(put(0, (32, 32)) < first + 40);
        // It waits for the second one, and then for slots of its port and of memory.
        let other = put(1, (64, 32));
        assert!((first + 200..first + 255).contains(&other), "{other}");
        // The first line of this transfer waits, and the others don't.
        assert!(put(1, (512, 256)) < other);
        assert!(put(0, (64, 4096)) > other);
    }

    #[test]
    fn atomic_commands_queue_for_their_line() {
        let mut system = MemorySystem::new(FIGURES);
        let latency = FIGURES.atomic_latency;
        assert_eq!(system.atomic(0, Atomic::Read, 100), 100 + latency);
        assert_eq!(system.atomic(0, Atomic::Written, 101), 164 + latency);
        assert_eq!(system.atomic(0, Atomic::Lost, 102), 122);
        assert_eq!(system.atomic(0, Atomic::Read, 102), 359 + latency);
        assert_eq!(system.atomic(128, Atomic::Read, 102), 102 + latency);
        assert_eq!(system.atomic(0, Atomic::Read, 9000), 9000 + latency);
    }
}
