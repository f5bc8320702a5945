//! Races between the SPU and its own DMA commands: an instruction uses local store that a command
//! in flight reads or writes, or two commands that no order binds use the same local store.
//!
//! The SPU learns that a command is complete only by reading a channel. So a command counts as in
//! flight until the program reads a channel, on whose other side something happens, in a cycle in
//! which the command is complete. It does not matter which channel: a word in a mailbox may be the
//! notification, too. Between two such reads a program has no evidence that data has arrived.
//! What races therefore depends only on the order and the cycles of channel instructions, which all
//! engines and methods share.
//!
//! Where local store is accessed from outside, a load may bring the news, too. There a command is
//! in flight only as long as it is not complete.
//!
//! Known weakness: the PPE's own accesses and its proxy commands are not watched, and neither is
//! the fetch of instructions.

use std::fmt;
use std::sync::atomic::AtomicU8;
use std::sync::atomic::Ordering::{Relaxed, SeqCst};
use std::sync::{Arc, Mutex, OnceLock};

use portable_atomic::AtomicU64;

use super::simulation::Simulation;
use crate::interp::Spu;
use crate::local_store::{LocalStore, SIZE};
use crate::lock::lock;
use crate::memory::LINE;
use crate::mfc::command::{Command, ELEMENT, Operation, Order};
use crate::mfc::timing::Movement;
use crate::profile::ProgramId;
use spu_isa::Instruction;

const QUADWORD: u32 = 16;
const QUADWORDS: usize = (SIZE / QUADWORD) as usize;
/// A command in flight writes bytes of the quadword, so loads race.
const LOADS: u8 = 1;
/// A command in flight reads or writes bytes of the quadword, so stores race.
const STORES: u8 = 2;

/// For each quadword of local store, which accesses may race.
#[derive(Debug)]
pub struct Marks(Box<[AtomicU8]>);

impl Default for Marks {
    fn default() -> Self {
        Self((0..QUADWORDS).map(|_| AtomicU8::new(0)).collect())
    }
}

impl Marks {
    /// One byte for each quadword.
    pub(crate) fn as_ptr(&self) -> *const u8 {
        self.0.as_ptr().cast()
    }

    fn of(&self, address: u32) -> u8 {
        self.0[(address / QUADWORD) as usize % QUADWORDS].load(Relaxed)
    }

    fn quadwords(&self, range: &Range) -> impl Iterator<Item = &AtomicU8> {
        let first = range.start / QUADWORD;
        let end = (range.start + range.length).div_ceil(QUADWORD);
        (first..end).map(|number| &self.0[number as usize % QUADWORDS])
    }
}

/// Bytes of local store that a command uses.
#[derive(Clone, Copy, Debug)]
struct Range {
    start: u32,
    length: u32,
    /// Whether the command writes them.
    is_written: bool,
}

impl Range {
    /// The bytes of the quadword at `address` that belong to it, as a mask, first byte first.
    fn bytes_of(&self, address: u32) -> u16 {
        let is_inside =
            |byte: &u32| (address + byte).wrapping_sub(self.start) & (SIZE - 1) < self.length;
        let bytes = (0..QUADWORD).filter(is_inside);
        bytes.fold(0, |mask, byte| mask | 0x8000 >> byte)
    }

    /// The first byte that both have.
    fn meets(&self, other: &Self) -> Option<u32> {
        let distance = |from: u32, to: u32| to.wrapping_sub(from) & (SIZE - 1);
        if distance(self.start, other.start) < self.length && other.length > 0 {
            Some(other.start & (SIZE - 1))
        } else if distance(other.start, self.start) < other.length && self.length > 0 {
            Some(self.start & (SIZE - 1))
        } else {
            None
        }
    }
}

/// What uses local store.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Use {
    /// An instruction loads a quadword.
    Load,
    /// An instruction stores a quadword.
    Store,
    /// A later command, with this opcode.
    Command(u8),
}

/// A command in flight.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CommandInFlight {
    /// The address of the instruction that gave it.
    pub pc: u32,
    /// Its opcode.
    pub opcode: u8,
    /// Its local-store address.
    pub lsa: u32,
    /// Its effective address.
    pub ea: u64,
    /// The number of bytes that it moves, or the size of its list.
    pub size: u32,
    /// Its tag.
    pub tag: u8,
    /// Whether it is an atomic command, which has no tag.
    pub is_atomic: bool,
    /// Whether it writes the bytes that are used, and not only reads them.
    pub writes: bool,
}

/// A use of local store that races with a command in flight.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Race {
    /// The program, if it was [registered](crate::spe::Spe::profile_as).
    pub program: Option<ProgramId>,
    /// The address of the instruction.
    pub pc: u32,
    /// What it does.
    pub by: Use,
    /// The local-store address of the first byte that both use.
    pub address: u32,
    /// The command with which it races.
    pub command: CommandInFlight,
}

/// IBM's name of a DMA command.
#[must_use]
pub fn command_name(opcode: u8) -> &'static str {
    match opcode {
        0x20 => "put",
        0x21 => "putb",
        0x22 => "putf",
        0x24 => "putl",
        0x25 => "putlb",
        0x26 => "putlf",
        0x30 => "putr",
        0x31 => "putrb",
        0x32 => "putrf",
        0x34 => "putrl",
        0x35 => "putrlb",
        0x36 => "putrlf",
        0x40 => "get",
        0x41 => "getb",
        0x42 => "getf",
        0x44 => "getl",
        0x45 => "getlb",
        0x46 => "getlf",
        0xa0 => "sndsig",
        0xa1 => "sndsigb",
        0xa2 => "sndsigf",
        0xb0 => "putlluc",
        0xb4 => "putllc",
        0xb8 => "putqlluc",
        0xd0 => "getllar",
        _ => "a command",
    }
}

impl Race {
    /// Describes it in sentences. `place` names an address of the program.
    #[must_use]
    pub fn describe(&self, place: impl Fn(u32) -> String) -> String {
        let CommandInFlight { opcode, lsa, ea, size, tag, is_atomic, writes, pc } = self.command;
        let what = match self.by {
            Use::Load => "a load reads",
            Use::Store => "a store writes",
            Use::Command(later) => &format!("{} uses", command_name(later)),
        };
        let how = if writes { "writes" } else { "reads" };
        let (of_tag, remedy) = if is_atomic {
            (String::new(), "First read MFC_RdAtomicStat.".into())
        } else {
            let order = match self.by {
                Use::Command(_) => {
                    ", or give the later command the same tag and a fence or barrier"
                }
                Use::Load | Use::Store => "",
            };
            let bit = 1_u32 << tag;
            let remedy = format!(
                "First write {bit:#x} to MFC_WrTagMask and 2 to MFC_WrTagUpdate, and read \
                 MFC_RdTagStat{order}."
            );
            (format!(", tag {tag}"), remedy)
        };
        format!(
            "at {} {what} local store at {:#07x},\n     \
             which {} still {how} ({size} bytes, local store {lsa:#07x}, effective address \
             {ea:#x}{of_tag}),\n     \
             given at {}. {remedy}",
            place(self.pc),
            self.address,
            command_name(opcode),
            place(pc),
        )
    }
}

impl fmt::Display for Race {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.describe(|address| format!("{address:#07x}")))
    }
}

/// When a command is complete.
#[derive(Debug)]
enum Completion {
    At(u64),
    /// Another thread will write it here. Until then it is [`UNKNOWN`].
    Deferred(Arc<AtomicU64>),
}

/// The completion of a command whose time has not been counted yet.
const UNKNOWN: u64 = u64::MAX;

impl Completion {
    fn cycle(&self) -> u64 {
        match self {
            Self::At(cycle) => *cycle,
            Self::Deferred(cycle) => cycle.load(SeqCst),
        }
    }
}

/// A command that the program has not seen complete.
#[derive(Debug)]
struct InFlight {
    command: CommandInFlight,
    ranges: Vec<Range>,
    complete: Completion,
    /// The tags whose further commands follow it.
    followed_by: u32,
}

impl InFlight {
    fn new(movement: &Movement, pc: u32) -> Self {
        let Command { operation, opcode, lsa, ea, size, tag, .. } = movement.command;
        Self {
            command: CommandInFlight {
                pc,
                opcode,
                lsa: lsa & (SIZE - 1),
                ea,
                size,
                tag,
                is_atomic: movement.atomic.is_some(),
                writes: false,
            },
            ranges: ranges(movement, operation),
            complete: Completion::At(0),
            followed_by: 0,
        }
    }

    fn writing(&self, writes: bool) -> CommandInFlight {
        CommandInFlight { writes, ..self.command }
    }
}

/// The bytes of local store that a movement uses.
fn ranges(movement: &Movement, operation: Operation) -> Vec<Range> {
    let command = &movement.command;
    let is_written = match operation {
        Operation::Get | Operation::GetList | Operation::GetLine => true,
        Operation::Put
        | Operation::PutList
        | Operation::SendSignal
        | Operation::PutLineQueued
        | Operation::PutLineConditional
        | Operation::PutLineUnconditional => false,
        Operation::QueueBarrier | Operation::Sync | Operation::CacheHint | Operation::ZeroRange => {
            return Vec::new();
        }
    };
    let range = |start: u32, length: u32| Range { start: start & (SIZE - 1), length, is_written };
    if movement.atomic.is_some() {
        return vec![range(command.lsa, LINE as u32)];
    }
    let mut ranges: Vec<Range> = Vec::new();
    for piece in movement.pieces.iter().filter(|piece| piece.size > 0) {
        match ranges.last_mut() {
            Some(last) if last.start + last.length == piece.lsa & (SIZE - 1) => {
                last.length += piece.size;
            }
            _ => ranges.push(range(piece.lsa, piece.size)),
        }
    }
    if operation.is_list() {
        ranges.push(Range {
            start: command.ea as u32 & (SIZE - 1),
            length: movement.pieces.len() as u32 * ELEMENT,
            is_written: false,
        });
    }
    ranges
}

/// The program that is loaded on an SPE, if it was registered.
pub(super) type LoadedProgram = Arc<Mutex<Option<ProgramId>>>;

/// The commands of one SPU that its program has not seen complete.
#[derive(Default)]
pub(crate) struct Races {
    /// Present if the machine looks for races.
    simulation: Option<Arc<Simulation>>,
    marks: Arc<Marks>,
    in_flight: Vec<InFlight>,
    program: LoadedProgram,
    /// The address of the channel instruction that runs.
    channel_pc: u32,
}

impl Races {
    /// For an SPE on which `program` is loaded.
    pub fn new(simulation: &Arc<Simulation>, program: &LoadedProgram) -> Self {
        let options = simulation.options();
        Self {
            simulation: options.races.then(|| Arc::clone(simulation)),
            program: Arc::clone(program),
            ..Self::default()
        }
    }

    pub fn marks(&self) -> &Arc<Marks> {
        &self.marks
    }

    /// Whether the machine looks for races.
    #[inline]
    pub fn are_watched(&self) -> bool {
        self.simulation.is_some()
    }

    /// Whether an access may race.
    #[inline]
    pub fn are_possible(&self) -> bool {
        !self.in_flight.is_empty()
    }

    /// The commands that are not complete at `now`, oldest first.
    pub fn in_flight(&self, now: u64) -> impl Iterator<Item = CommandInFlight> {
        let commands = self.in_flight.iter();
        let incomplete = commands.filter(move |command| command.complete.cycle() > now);
        incomplete.map(|command| command.command)
    }

    /// The next channel instruction is at this address.
    #[inline]
    pub fn channel_instruction_at(&mut self, pc: u32) {
        self.channel_pc = pc;
    }

    /// The program reads a channel, or local store that is accessed from outside: from now on it
    /// may rely on the commands that are complete at `now`. No completion may be
    /// [awaited](Self::await_another_thread) any more.
    pub fn learn(&mut self, now: u64) {
        let before = self.in_flight.len();
        let marks = Arc::clone(&self.marks);
        self.in_flight.retain(|command| {
            let stays = command.complete.cycle() > now;
            if !stays {
                let quadwords = command.ranges.iter().flat_map(|range| marks.quadwords(range));
                quadwords.for_each(|mark| mark.store(0, Relaxed));
            }
            stays
        });
        if self.in_flight.len() < before {
            self.in_flight.iter().for_each(|command| mark(&marks, command));
        }
    }

    /// A command that moves this data was given. Reports its races with earlier commands. Returns
    /// it for [`is_complete_at`](Self::is_complete_at), if the machine looks for races.
    pub fn give(&mut self, movement: &Movement) -> Option<Given> {
        self.simulation.as_ref()?;
        let given = InFlight::new(movement, self.channel_pc);
        let Command { operation, order, tag, .. } = movement.command;
        let (own, follows) = (1 << tag, order != Order::Free);
        for earlier in &mut self.in_flight {
            let same_tag = earlier.command.tag == tag && !earlier.command.is_atomic;
            match operation {
                Operation::QueueBarrier => earlier.followed_by = u32::MAX,
                Operation::Sync => earlier.followed_by |= own,
                _ if order == Order::Barrier && same_tag => earlier.followed_by |= own,
                _ => {}
            }
        }
        let is_atomic = movement.atomic.is_some();
        let mut races = Vec::new();
        for earlier in &self.in_flight {
            let is_ordered = !is_atomic
                && (earlier.followed_by & own != 0
                    || follows && earlier.command.tag == tag && !earlier.command.is_atomic);
            if !is_ordered && let Some(race) = conflict(earlier, &given) {
                races.push(race);
            }
        }
        let by = Use::Command(given.command.opcode);
        for (address, command) in races {
            self.report(self.channel_pc, by, address, command);
        }
        Some(Given(given))
    }

    /// The command will be complete at this cycle.
    pub fn is_complete_at(&mut self, given: Given, complete: u64) {
        self.add(given, Completion::At(complete));
    }

    /// Another thread will count the command's time. Returns where it writes the cycle in which the
    /// command is complete.
    pub fn is_deferred(&mut self, given: Given) -> Arc<AtomicU64> {
        let cycle = Arc::new(AtomicU64::new(UNKNOWN));
        self.add(given, Completion::Deferred(Arc::clone(&cycle)));
        cycle
    }

    /// Whether the completion of a command is not known yet.
    pub fn await_another_thread(&self) -> bool {
        let mut commands = self.in_flight.iter();
        commands.any(|command| command.complete.cycle() == UNKNOWN)
    }

    fn add(&mut self, given: Given, complete: Completion) {
        let Given(mut command) = given;
        if command.ranges.iter().any(|range| range.length > 0) {
            command.complete = complete;
            mark(&self.marks, &command);
            self.in_flight.push(command);
        }
    }

    /// The instruction at the program counter is about to run.
    #[inline]
    pub fn look(&self, spu: &Spu, store: &LocalStore, instruction: Instruction) {
        if let Some(access) = spu.access(instruction) {
            let kinds = if access.is_store { STORES } else { LOADS };
            if self.marks.of(access.address) & kinds != 0 {
                self.look_closely(spu, store, instruction);
            }
        }
    }

    #[cold]
    fn look_closely(&self, spu: &Spu, store: &LocalStore, instruction: Instruction) {
        let Some(access) = spu.access(instruction) else {
            return;
        };
        let address = access.address & (SIZE - QUADWORD);
        // A store that only puts neighbours of what it changes back leaves what a put reads as it
        // is.
        let changed = {
            let old = store.load_quadword(address).map(u32::to_be_bytes).concat();
            let new = spu.register(instruction.rt).0.map(u32::to_be_bytes).concat();
            let differs = |byte: &usize| old[*byte] != new[*byte];
            let bytes = (0..QUADWORD as usize).filter(differs);
            bytes.fold(0, |mask: u16, byte| mask | 0x8000 >> byte)
        };
        for command in &self.in_flight {
            for range in &command.ranges {
                let common = match (access.is_store, range.is_written) {
                    (false, false) => 0,
                    (true, false) => range.bytes_of(address) & changed,
                    (_, true) => range.bytes_of(address),
                };
                if common != 0 {
                    let by = if access.is_store { Use::Store } else { Use::Load };
                    let first = address + common.leading_zeros();
                    let command = command.writing(range.is_written);
                    self.report(spu.pc(), by, first, command);
                }
            }
        }
    }

    fn report(&self, pc: u32, by: Use, address: u32, command: CommandInFlight) {
        if let Some(simulation) = &self.simulation {
            simulation.report_race(&Race {
                program: *lock(&self.program),
                pc,
                by,
                address,
                command,
            });
        }
    }
}

/// A command that was given, before it is known when it is complete.
pub(crate) struct Given(InFlight);

fn mark(marks: &Marks, command: &InFlight) {
    for range in &command.ranges {
        let kinds = if range.is_written { LOADS | STORES } else { STORES };
        for quadword in marks.quadwords(range) {
            quadword.store(quadword.load(Relaxed) | kinds, Relaxed);
        }
    }
}

/// Local store that both commands use, and one of them writes.
fn conflict(earlier: &InFlight, later: &InFlight) -> Option<(u32, CommandInFlight)> {
    earlier.ranges.iter().find_map(|own| {
        later.ranges.iter().find_map(|other| {
            let writes = own.is_written || other.is_written;
            let address = own.meets(other).filter(|_| writes)?;
            Some((address, earlier.writing(own.is_written)))
        })
    })
}

/// The receiver of a machine's races.
pub(super) type Reporter = Box<dyn Fn(&Race) + Send + Sync>;

/// Reports each race of a machine once: that of one instruction with the commands of one other.
#[derive(Default)]
pub(super) struct RaceReports {
    reporter: OnceLock<Reporter>,
    reported: Mutex<Vec<(Option<ProgramId>, u32, u32)>>,
}

impl RaceReports {
    /// Sets the receiver. A later one is ignored.
    pub fn set(&self, reporter: Reporter) {
        self.reporter.get_or_init(|| reporter);
    }

    pub fn report(&self, race: &Race) {
        let place = (race.program, race.pc, race.command.pc);
        let mut reported = lock(&self.reported);
        if reported.contains(&place) {
            return;
        }
        reported.push(place);
        if let Some(reporter) = self.reporter.get() {
            reporter(race);
        }
    }
}
