//! The MFC commands of one SPU that are not complete yet in simulated time.
//!
//! Data moves when the command is given, in the SPU's turn; another thread may move it in place of
//! the SPU's. Only data for another local store moves when its transfer is complete. Results that
//! the program can see, tags and free queue entries, appear at the simulated time. A command that
//! must follow earlier commands is delayed until those are complete.

use std::sync::{Arc, Mutex, MutexGuard};

use super::arrivals::Arrivals;
use super::figures::MemoryFigures;
use super::memory_system::{Direction, MemorySystem, Port};
use super::simulation::Simulation;
use crate::lock::lock;
use crate::mfc::Commands;
use crate::mfc::command::{Command, Operation, Order, TAGS};
use crate::mfc::timing::{Movement, TransferTimes};

#[derive(Clone, Copy, Debug)]
struct Outstanding {
    tag: u8,
    complete: u64,
}

#[derive(Debug)]
struct Transfers {
    figures: MemoryFigures,
    port: Port,
    outstanding: Vec<Outstanding>,
    /// For each tag, the time before which no further command may start, because of a barrier.
    held: [u64; TAGS as usize],
    /// When the elements before the last stall of a list have arrived.
    stalls: u64,
    /// When the status of the last atomic command can be read.
    atomic: u64,
    commands: Commands,
}

impl Transfers {
    fn new(number: u64, figures: MemoryFigures) -> Self {
        Self {
            atomic: 0,
            port: Port::new(number, &figures),
            figures,
            outstanding: Vec::new(),
            held: [0; TAGS as usize],
            stalls: 0,
            commands: Commands::default(),
        }
    }

    fn advance(&mut self, now: u64) {
        self.outstanding.retain(|command| command.complete > now);
    }

    fn busy_tags(&self) -> u32 {
        self.outstanding.iter().fold(0, |tags, command| tags | 1 << command.tag)
    }

    fn next(&self, tags: u32) -> Option<u64> {
        self.outstanding
            .iter()
            .filter(|command| 1 << command.tag & tags != 0)
            .map(|command| command.complete)
            .min()
    }

    fn last(&self, of: impl Fn(u8) -> bool) -> u64 {
        let complete = |command: &Outstanding| of(command.tag).then_some(command.complete);
        self.outstanding.iter().filter_map(complete).max().unwrap_or(0)
    }

    /// Times a movement that was made at `now`, and sends its data if it is delivered later.
    /// Returns when the movement is complete.
    fn add(
        &mut self,
        movement: Movement,
        now: u64,
        memory: &mut MemorySystem,
        arrivals: &Arrivals,
    ) -> u64 {
        let Command { operation, order, tag, ea, .. } = movement.command;
        if let Some(atomic) = movement.atomic {
            self.atomic = memory.atomic(ea, atomic, now);
            self.commands.atomic += 1;
            return self.atomic;
        }
        let held = &self.held[usize::from(tag)];
        let mut start = (now + self.figures.command_cycles).max(*held);
        match operation {
            Operation::QueueBarrier | Operation::Sync => start = start.max(self.last(|_| true)),
            _ if order != Order::Free => start = start.max(self.last(|other| other == tag)),
            _ => {}
        }
        match operation {
            Operation::QueueBarrier => self.held.fill(start),
            _ if order == Order::Barrier => self.held[usize::from(tag)] = start,
            _ => {}
        }
        let direction = match operation {
            Operation::Get | Operation::GetList => Direction::In,
            _ => Direction::Out,
        };
        let mut complete = start;
        for piece in movement.pieces {
            if operation.is_list() {
                start += self.figures.list_element_cycles;
            }
            let what = (piece.ea, piece.size);
            let port = &mut self.port;
            let arrived = memory.transfer(port, direction, piece.peer, what, (now, start));
            complete = complete.max(arrived).max(start);
            if let Some(pending) = piece.pending {
                arrivals.send(arrived, pending);
            }
            let bytes = u64::from(piece.size);
            match direction {
                Direction::In => self.commands.bytes_in += bytes,
                Direction::Out => self.commands.bytes_out += bytes,
            }
        }
        if movement.stalled {
            self.stalls = self.stalls.max(complete);
        } else {
            self.commands.queued += 1;
            self.outstanding.push(Outstanding { tag, complete });
        }
        complete
    }
}

/// The commands of one SPU in its machine's time.
#[derive(Clone)]
pub(super) struct SpuTransfers {
    transfers: Arc<Mutex<Transfers>>,
    simulation: Arc<Simulation>,
}

impl SpuTransfers {
    /// The transfers of SPE `number`.
    pub fn new(number: u64, simulation: &Arc<Simulation>) -> Self {
        Self {
            transfers: Arc::new(Mutex::new(Transfers::new(number, simulation.timing().memory))),
            simulation: Arc::clone(simulation),
        }
    }

    fn transfers(&self) -> MutexGuard<'_, Transfers> {
        lock(&self.transfers)
    }
}

impl TransferTimes for SpuTransfers {
    fn add(&mut self, movement: Movement, now: u64) -> u64 {
        let mut memory = self.simulation.memory();
        let arrivals = &self.simulation.scheduler().arrivals;
        self.transfers().add(movement, now, &mut memory, arrivals)
    }

    fn advance(&mut self, now: u64) {
        self.transfers().advance(now);
    }

    fn incomplete(&self) -> usize {
        self.transfers().outstanding.len()
    }

    fn busy_tags(&self) -> u32 {
        self.transfers().busy_tags()
    }

    fn next(&self, tags: u32) -> Option<u64> {
        self.transfers().next(tags)
    }

    fn stalled_at(&self) -> u64 {
        self.transfers().stalls
    }

    fn atomic_at(&self) -> u64 {
        self.transfers().atomic
    }

    fn commands(&self) -> Commands {
        self.transfers().commands
    }

    fn shared(&self) -> Box<dyn TransferTimes> {
        Box::new(self.clone())
    }
}

#[cfg(test)]
mod tests {
    use std::ops::RangeInclusive;

    use super::*;
    use crate::mfc::command::{Parameters, Side};
    use crate::mfc::timing::{Peer, Piece};

    const FIGURES: MemoryFigures = MemoryFigures::CONSOLE;
    const COMMAND_CYCLES: u64 = FIGURES.command_cycles;
    /// A line waits up to one slot of its port, and arrives after its own time and the latency.
    const LINE: RangeInclusive<u64> = {
        let soonest = COMMAND_CYCLES + 17 + FIGURES.get_latency;
        soonest..=soonest + 18
    };

    fn movement(word: u32, tag: u32) -> Movement {
        let parameters = Parameters { size: 128, tag, ..Parameters::default() };
        Movement {
            command: Command::new(word, parameters, Side::Spu).unwrap(),
            pieces: vec![Piece { lsa: 0, ea: 0, size: 128, peer: Peer::Memory, pending: None }],
            stalled: false,
            atomic: None,
        }
    }

    fn times(commands: &[(u32, u32)]) -> Vec<u64> {
        let (mut transfers, mut memory) = (Transfers::new(0, FIGURES), MemorySystem::new(FIGURES));
        for &(word, tag) in commands {
            transfers.add(movement(word, tag), 3, &mut memory, &Arrivals::default());
        }
        let complete = |command: &Outstanding| command.complete;
        transfers.outstanding.iter().map(complete).collect()
    }

    #[test]
    fn commands_overlap_unless_they_are_ordered() {
        let free = times(&[(0x40, 1), (0x40, 1)]);
        assert!(LINE.contains(&(free[0] - 3)), "{free:?}");
        assert!((17..=18).contains(&(free[1] - free[0])), "{free:?}");
        let fenced = times(&[(0x40, 1), (0x42, 1), (0x40, 1)]);
        assert!(fenced[1] >= 3 + 2 * (LINE.start() - COMMAND_CYCLES));
        assert!(fenced[2] < fenced[1]);
        let barred = times(&[(0x40, 1), (0x41, 1), (0x40, 1), (0x40, 2)]);
        assert!(barred[2] > barred[1]);
        assert!(barred[3] < barred[1]);
    }

    #[test]
    fn a_tag_is_busy_until_its_last_command_is_complete() {
        let (mut transfers, mut memory) = (Transfers::new(0, FIGURES), MemorySystem::new(FIGURES));
        let arrivals = Arrivals::default();
        transfers.add(movement(0x40, 1), 0, &mut memory, &arrivals);
        transfers.add(movement(0x20, 5), 0, &mut memory, &arrivals);
        assert_eq!((transfers.busy_tags(), transfers.outstanding.len()), (0b10_0010, 2));
        let first = transfers.next(u32::MAX).unwrap();
        transfers.advance(first - 1);
        assert_eq!(transfers.outstanding.len(), 2);
        transfers.advance(first);
        assert_eq!((transfers.busy_tags(), transfers.outstanding.len()), (0b10_0000, 1));
        let commands = &transfers.commands;
        assert_eq!((commands.queued, commands.bytes_in, commands.bytes_out), (2, 128, 128));
    }
}
