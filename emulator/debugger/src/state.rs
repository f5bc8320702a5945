//! What the server and the SPEs' threads share.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::mpsc::Sender;
use std::sync::{Arc, Weak};

use gdbstub::common::Tid;
use gdbstub::target::ext::breakpoints::WatchKind;
use spu_emulator::interp::{Quad, Spu};
use spu_emulator::local_store::LocalStore;
use spu_emulator::spe::Spe;

use crate::End;
use crate::accesses::{Parameters, Range};
use crate::server::Event;

/// Why an SPE halts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Halt {
    Stepped,
    Breakpoint,
    /// Watched bytes at this address were accessed in this way.
    Accessed(WatchKind, u32),
    /// The program has done something that ends it with this signal.
    Signal(u8),
}

/// What a thread does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Phase {
    /// Its SPE does not run.
    Stopped,
    /// The instruction at the program counter, in which it may sleep.
    Executing,
    /// It halts before the instruction at the program counter.
    Halted,
}

/// How a thread goes on.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Action {
    #[default]
    Continue,
    Step,
    /// It stays where it is.
    Stay,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Watchpoint {
    pub range: Range,
    pub kind: WatchKind,
}

/// The debugger's state of an SPE.
pub struct Thread {
    spe: Weak<Spe>,
    pub local_store: Arc<LocalStore>,
    pub phase: Phase,
    pub registers: Box<[Quad; 128]>,
    pub pc: u32,
    pub cycles: Option<u64>,
    /// The debugger has changed registers or the program counter.
    changed: bool,
    action: Action,
    /// It has executed an instruction since the last step command.
    has_stepped: bool,
    /// Its halt at the program counter was reported, so a breakpoint there is not reported again.
    reported: bool,
    parameters: Parameters,
    /// A watchpoint that the last instruction has hit.
    hit: Option<(WatchKind, u32)>,
    /// The bytes of each watchpoint when they were last compared.
    watched: Vec<Vec<u8>>,
}

impl Thread {
    fn bytes(&self, range: Range) -> Vec<u8> {
        let mut bytes = vec![0; range.length as usize];
        self.local_store.read(range.start, &mut bytes);
        bytes
    }
}

/// The state of all threads.
#[derive(Default)]
pub struct State {
    pub halted: bool,
    pub threads: BTreeMap<Tid, Thread>,
    last: Option<Tid>,
    /// Whether an SPE has come to an instruction.
    pub started: bool,
    pub breakpoints: BTreeSet<u32>,
    watchpoints: Vec<Watchpoint>,
    /// The server's queue, while a debugger is connected.
    session: Option<Sender<Event>>,
    /// A halt that was not reported yet.
    pub pending: Option<(Tid, Halt)>,
    pub end: Option<End>,
    pub killed: bool,
}

impl State {
    pub fn add(&mut self, spe: &Arc<Spe>) -> Tid {
        let number = self.last.map_or(Tid::MIN, |last| last.saturating_add(1));
        self.last = Some(number);
        let mut thread = Thread {
            spe: Arc::downgrade(spe),
            local_store: Arc::clone(spe.local_store()),
            phase: Phase::Stopped,
            registers: Box::new([Quad::ZERO; 128]),
            pc: 0,
            cycles: None,
            changed: false,
            action: Action::Continue,
            has_stepped: false,
            reported: false,
            parameters: Parameters::default(),
            hit: None,
            watched: Vec::new(),
        };
        let watched = self.watchpoints.iter().map(|w| thread.bytes(w.range));
        thread.watched = watched.collect();
        self.threads.insert(number, thread);
        number
    }

    pub fn remove(&mut self, number: Tid) {
        self.threads.remove(&number);
    }

    pub fn spes(&self) -> Vec<Arc<Spe>> {
        self.threads.values().filter_map(|thread| thread.spe.upgrade()).collect()
    }

    /// Whether a thread executes an instruction and doesn't sleep in it. A program that has stopped
    /// for a library call may wait there.
    pub fn is_any_awake(&self) -> bool {
        let mut threads = self.threads.values();
        threads.any(|thread| {
            let spe = thread.spe.upgrade();
            thread.phase == Phase::Executing
                && spe.is_some_and(|spe| spe.is_running() && !spe.sleeps())
        })
    }

    pub fn is_connected(&self) -> bool {
        self.session.is_some()
    }

    /// A debugger comes: all threads halt.
    pub fn connect(&mut self, session: Sender<Event>) {
        self.session = Some(session);
        self.halted = true;
        self.pending = None;
    }

    /// The debugger leaves: all threads run freely.
    pub fn disconnect(&mut self) {
        self.session = None;
        self.halted = false;
        self.pending = None;
        self.breakpoints.clear();
        self.watchpoints.clear();
        for thread in self.threads.values_mut() {
            thread.action = Action::Continue;
            thread.watched.clear();
            thread.hit = None;
        }
    }

    /// Makes the server look for news.
    pub fn nudge(&self) {
        if let Some(session) = &self.session {
            // A server that is gone needs none.
            let _ = session.send(Event::News);
        }
    }

    /// Lets the threads go on, those of `actions` in their ways and the others in this one.
    pub fn resume(&mut self, actions: &BTreeMap<Tid, Action>, others: Action) {
        for (number, thread) in &mut self.threads {
            thread.action = actions.get(number).copied().unwrap_or(others);
            thread.has_stepped = thread.action == Action::Step && thread.phase != Phase::Halted;
        }
        self.halted = false;
        self.pending = None;
    }

    /// A thread has come to an instruction. Returns whether it is the first of all.
    pub fn arrive(&mut self, number: Tid, spu: &Spu, cycles: Option<u64>) -> bool {
        if let Some(thread) = self.threads.get_mut(&number) {
            thread.registers.copy_from_slice(&spu.registers);
            thread.pc = spu.pc();
            thread.cycles = cycles;
            thread.reported = false;
            thread.changed = false;
        }
        !std::mem::replace(&mut self.started, true)
    }

    pub fn may_go(&self, number: Tid) -> bool {
        let thread = self.threads.get(&number);
        !self.halted && thread.is_none_or(|thread| thread.action != Action::Stay)
    }

    pub fn park(&mut self, number: Tid) {
        if let Some(thread) = self.threads.get_mut(&number) {
            thread.phase = Phase::Halted;
        }
    }

    /// Why a thread that may go on must halt where it is.
    pub fn reason(&mut self, number: Tid) -> Option<Halt> {
        self.session.as_ref()?;
        let thread = self.threads.get_mut(&number)?;
        let hit = thread.hit.take();
        if let Some((kind, address)) = Self::changed(thread, &self.watchpoints).or(hit) {
            return Some(Halt::Accessed(kind, address));
        }
        if thread.action == Action::Step && thread.has_stepped {
            return Some(Halt::Stepped);
        }
        let breakpoint = !thread.reported && self.breakpoints.contains(&thread.pc);
        breakpoint.then_some(Halt::Breakpoint)
    }

    /// The first watchpoint of writes whose bytes have changed.
    fn changed(thread: &mut Thread, watchpoints: &[Watchpoint]) -> Option<(WatchKind, u32)> {
        let mut changed = None;
        for (n, watchpoint) in watchpoints.iter().enumerate() {
            let now = thread.bytes(watchpoint.range);
            if thread.watched[n] != now {
                thread.watched[n] = now;
                if watchpoint.kind != WatchKind::Read {
                    changed = changed.or(Some((watchpoint.kind, watchpoint.range.start)));
                }
            }
        }
        changed
    }

    /// All threads must halt, because this one does.
    pub fn halt(&mut self, number: Tid, halt: Halt) {
        self.halted = true;
        self.pending = Some((number, halt));
        if let Some(thread) = self.threads.get_mut(&number) {
            thread.reported = true;
        }
        self.nudge();
    }

    /// A thread executes the instruction at its program counter.
    pub fn leave(&mut self, number: Tid, spu: &Spu) {
        let Some(thread) = self.threads.get_mut(&number) else {
            return;
        };
        thread.phase = Phase::Executing;
        thread.has_stepped = thread.action == Action::Step;
        let accesses = thread.parameters.before(spu, &thread.local_store);
        let meets = |range: Option<Range>, watched| range.is_some_and(|r| r.meets(watched));
        let hits = |watchpoint: &&Watchpoint| match watchpoint.kind {
            WatchKind::Write => false,
            WatchKind::Read => meets(accesses.read, watchpoint.range),
            WatchKind::ReadWrite => {
                meets(accesses.read, watchpoint.range) || meets(accesses.stored, watchpoint.range)
            }
        };
        let hit = self.watchpoints.iter().find(hits);
        thread.hit = hit.map(|watchpoint| (watchpoint.kind, watchpoint.range.start));
    }

    /// The SPE of a thread has stopped at this address.
    pub fn stop(&mut self, number: Tid, spu: &Spu, pc: u32) {
        if let Some(thread) = self.threads.get_mut(&number) {
            thread.registers.copy_from_slice(&spu.registers);
            thread.pc = pc;
            thread.phase = Phase::Stopped;
        }
    }

    /// The debugger sets a thread's registers. Returns `false` if it does not halt before an
    /// instruction.
    pub fn set_registers(&mut self, number: Tid, registers: &[Quad; 128], pc: u32) -> bool {
        let halted = |thread: &&mut Thread| thread.phase == Phase::Halted;
        let Some(thread) = self.threads.get_mut(&number).filter(halted) else {
            return false;
        };
        thread.registers.copy_from_slice(registers);
        thread.pc = pc & spu_isa::LIMIT_MASK & !3;
        thread.changed = true;
        true
    }

    /// Gives the SPU the registers that the debugger has set.
    pub fn change_registers(&mut self, number: Tid, spu: &mut Spu) {
        if let Some(thread) = self.threads.get_mut(&number)
            && std::mem::take(&mut thread.changed)
        {
            spu.registers.copy_from_slice(&*thread.registers);
            spu.set_pc(thread.pc);
        }
    }

    pub fn watch(&mut self, watchpoint: Watchpoint) {
        self.watchpoints.push(watchpoint);
        for thread in self.threads.values_mut() {
            thread.watched.push(thread.bytes(watchpoint.range));
        }
    }

    /// Returns whether there was such a watchpoint.
    pub fn unwatch(&mut self, watchpoint: Watchpoint) -> bool {
        let Some(at) = self.watchpoints.iter().position(|w| *w == watchpoint) else {
            return false;
        };
        self.watchpoints.remove(at);
        for thread in self.threads.values_mut() {
            thread.watched.remove(at);
        }
        true
    }

    /// A change by the user does not trigger watchpoints.
    pub fn write(&mut self, number: Tid, address: u32, bytes: &[u8]) {
        if let Some(thread) = self.threads.get_mut(&number) {
            thread.local_store.write(address, bytes);
            Self::changed(thread, &self.watchpoints);
        }
    }
}
