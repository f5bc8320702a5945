//! The MFC commands of one SPU that are not complete yet in simulated time.
//!
//! Data moves when the command is given (its turn in the race), but to another local store when
//! its transfer is complete; what a program is told of it, tags and room in the queue, comes at
//! the simulated time. Ordering delays a command until those before it that it must follow are
//! complete.

use super::arrivals::{Arrivals, Parcel};
use super::memory_system::{
    COMMAND_CYCLES, Direction, LIST_ELEMENT_CYCLES, MemorySystem, Peer, Port,
};
use super::report::Commands;
use crate::mfc::command::{Command, Operation, Order, TAGS};

/// One contiguous piece of what a command moved.
pub(crate) struct Piece {
    pub ea: u64,
    pub size: u32,
    pub peer: Peer,
    /// The bytes, if they are still to be delivered.
    pub parcel: Option<Parcel>,
}

/// What a command moved, or a list until it stalled.
pub(crate) struct Movement {
    pub command: Command,
    pub pieces: Vec<Piece>,
    pub stalled: bool,
}

#[derive(Clone, Copy, Debug)]
struct Outstanding {
    tag: u8,
    complete: u64,
}

#[derive(Debug)]
pub(crate) struct Transfers {
    port: Port,
    outstanding: Vec<Outstanding>,
    /// Before which time no further command of each tag begins: barriers.
    held: [u64; TAGS as usize],
    /// When the elements before the last stall of a list have arrived.
    stalls: u64,
    /// When the status of the last atomic command can be read.
    atomic: u64,
    commands: Commands,
}

impl Transfers {
    pub fn new() -> Self {
        Self {
            atomic: 0,
            port: Port::new(),
            outstanding: Vec::new(),
            held: [0; TAGS as usize],
            stalls: 0,
            commands: Commands::default(),
        }
    }

    pub fn commands(&self) -> &Commands {
        &self.commands
    }

    /// Forgets what is complete at `now`.
    pub fn advance(&mut self, now: u64) {
        self.outstanding.retain(|command| command.complete > now);
    }

    pub fn busy_tags(&self) -> u32 {
        self.outstanding
            .iter()
            .fold(0, |tags, command| tags | 1 << command.tag)
    }

    pub fn len(&self) -> usize {
        self.outstanding.len()
    }

    /// When the next command will be complete.
    pub fn next(&self) -> Option<u64> {
        self.outstanding
            .iter()
            .map(|command| command.complete)
            .min()
    }

    /// When the SPU can be told of the lists that stall.
    pub fn stalled_at(&self) -> u64 {
        self.stalls
    }

    /// When the status of the last atomic command can be read.
    pub fn atomic_at(&self) -> u64 {
        self.atomic
    }

    fn last(&self, of: impl Fn(u8) -> bool) -> u64 {
        let complete = |command: &Outstanding| of(command.tag).then_some(command.complete);
        self.outstanding
            .iter()
            .filter_map(complete)
            .max()
            .unwrap_or(0)
    }

    /// Times a movement that was made at `now`, and sends off what is to be delivered; says when
    /// it is complete.
    pub fn add(
        &mut self,
        movement: Movement,
        now: u64,
        memory: &mut MemorySystem,
        arrivals: &Arrivals,
    ) -> u64 {
        let Command {
            operation,
            order,
            tag,
            ea,
            ..
        } = movement.command;
        if operation.is_immediate() {
            self.atomic = memory.atomic(ea, now);
            self.commands.atomic += 1;
            return self.atomic;
        }
        let held = &self.held[usize::from(tag)];
        let mut start = (now + COMMAND_CYCLES).max(*held);
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
                start += LIST_ELEMENT_CYCLES;
            }
            let what = (piece.ea, piece.size);
            let port = &mut self.port;
            let arrived = memory.transfer(port, direction, piece.peer, what, (now, start));
            complete = complete.max(arrived).max(start);
            if let Some(parcel) = piece.parcel {
                arrivals.send(arrived, parcel);
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mfc::command::{Parameters, Side};
    use crate::simulated::memory_system::{LINE_CYCLES, MEMORY_LATENCY};

    const LINE_TIME: u64 = COMMAND_CYCLES + LINE_CYCLES + MEMORY_LATENCY;

    fn movement(word: u32, tag: u32) -> Movement {
        let parameters = Parameters {
            size: 128,
            tag,
            ..Parameters::default()
        };
        Movement {
            command: Command::new(word, parameters, Side::Spu).unwrap(),
            pieces: vec![Piece {
                ea: 0,
                size: 128,
                peer: Peer::Memory,
                parcel: None,
            }],
            stalled: false,
        }
    }

    fn times(commands: &[(u32, u32)]) -> Vec<u64> {
        let (mut transfers, mut memory) = (Transfers::new(), MemorySystem::default());
        for &(word, tag) in commands {
            transfers.add(movement(word, tag), 3, &mut memory, &Arrivals::default());
        }
        let complete = |command: &Outstanding| command.complete;
        transfers.outstanding.iter().map(complete).collect()
    }

    #[test]
    fn commands_overlap_unless_they_are_ordered() {
        let free = times(&[(0x40, 1), (0x40, 1)]);
        assert_eq!(free, [3 + LINE_TIME, 3 + LINE_TIME + LINE_CYCLES]);
        let fenced = times(&[(0x40, 1), (0x42, 1), (0x40, 1)]);
        assert!(fenced[1] >= 3 + 2 * (LINE_TIME - COMMAND_CYCLES));
        assert!(fenced[2] < fenced[1]);
        let barred = times(&[(0x40, 1), (0x41, 1), (0x40, 1), (0x40, 2)]);
        assert!(barred[2] > barred[1]);
        assert!(barred[3] < barred[1]);
    }

    #[test]
    fn a_tag_is_busy_until_its_last_command_is_complete() {
        let (mut transfers, mut memory) = (Transfers::new(), MemorySystem::default());
        let arrivals = Arrivals::default();
        transfers.add(movement(0x40, 1), 0, &mut memory, &arrivals);
        transfers.add(movement(0x20, 5), 0, &mut memory, &arrivals);
        assert_eq!((transfers.busy_tags(), transfers.len()), (0b10_0010, 2));
        let first = transfers.next().unwrap();
        transfers.advance(first - 1);
        assert_eq!(transfers.len(), 2);
        transfers.advance(first);
        assert_eq!((transfers.busy_tags(), transfers.len()), (0b10_0000, 1));
        let commands = transfers.commands();
        assert_eq!(
            (commands.queued, commands.bytes_in, commands.bytes_out),
            (2, 128, 128)
        );
    }
}
