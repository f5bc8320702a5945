//! A program on an SPU whose clock counts, as far as its reader has stepped.

use std::collections::BTreeSet;
use std::ops::Range;

use serde::Serialize;
use spu_emulator::interp::{Quad, Spu};
use spu_emulator::local_store::{LocalStore, SIZE};
use spu_emulator::stop::{Stop, Stopped};
use spu_isa::timing::Account;
use spu_isa::{Instruction, disassemble};

use crate::channels::{Clocked, Mail, PlaygroundChannels};

/// The number of instructions after which [`Session::run`] returns, so that a page with an endless
/// loop can still be used.
pub const LIMIT: u64 = 5_000_000;

/// The stack pointer with which `spu run` starts a program, too.
const STACK: u32 = 0x3fff0;

/// A program at one of its steps. Equal programs at equal steps are in equal states, so a step back
/// is a run from the start.
pub struct Session {
    /// The contents of local store at the start, from address 0.
    image: Vec<u8>,
    entry: u32,
    spu: Spu,
    store: LocalStore,
    clocked: Clocked,
    channels: PlaygroundChannels,
    stopped: Option<Stopped>,
    /// The instruction that ran last, and the quadword that it stored.
    last: Option<(Instruction, Option<u32>)>,
}

/// The registers and the quadword that the last instruction wrote.
#[derive(Serialize)]
struct Written {
    registers: Vec<u8>,
    /// The address of a quadword of local store.
    quadword: Option<u32>,
}

/// Where the cycles went.
#[derive(Serialize)]
pub struct Cycles {
    total: u64,
    single: u64,
    dual: u64,
    /// The causes and cycles in which nothing issued, the most expensive first.
    stalls: Vec<(String, u64)>,
}

impl Cycles {
    fn of(account: &Account) -> Self {
        let waits = account.waits().into_iter();
        Self {
            total: account.cycles(),
            single: account.single(),
            dual: account.dual(),
            stalls: waits.map(|(cause, cycles)| (cause.to_string(), cycles)).collect(),
        }
    }
}

/// The part of a session that the page shows.
#[derive(Serialize)]
pub struct View {
    /// The number of instructions that have run.
    step: u64,
    pc: u32,
    /// The next instruction.
    next: String,
    /// Why the SPU has stopped.
    stopped: Option<String>,
    cycles: Cycles,
    /// The 128 registers, in hexadecimal.
    registers: Vec<String>,
    written: Written,
    mail: Mail,
    decrementer: u32,
    /// The bytes of local store that were asked for, in hexadecimal, a string for each quadword.
    store: Vec<String>,
}

impl Session {
    /// A program at its start. `image` is local store, from address 0, and `inbound` what the PPE
    /// sends.
    pub fn new(image: Vec<u8>, entry: u32, inbound: Vec<u32>) -> Self {
        let (channels, clocked) = PlaygroundChannels::new(inbound);
        let mut session = Self {
            image,
            entry,
            spu: Spu::new(),
            store: LocalStore::new(),
            clocked,
            channels,
            stopped: None,
            last: None,
        };
        session.restart();
        session
    }

    fn restart(&mut self) {
        self.spu = Spu::new();
        self.spu.set_pc(self.entry);
        self.spu.set_register(1, Quad::scalar(STACK));
        self.store = LocalStore::new();
        self.store.write(0, &self.image);
        let inbound = std::mem::take(&mut self.channels.mail.inbound);
        (self.channels, self.clocked) = PlaygroundChannels::new(inbound);
        self.stopped = None;
        self.last = None;
    }

    /// Replaces the words that the PPE sends. The program stays at its step, unless it then comes
    /// to another.
    pub fn send(&mut self, inbound: Vec<u32>) {
        let step = self.spu.executed();
        self.channels.mail.inbound = inbound;
        self.restart();
        self.go(step);
    }

    /// Goes to the moment when this many instructions have run, or to the program's end.
    pub fn go(&mut self, step: u64) {
        if step < self.spu.executed() {
            self.restart();
        }
        // The last step is taken alone, to see its results.
        let alone = step.saturating_sub(1);
        let before = alone.saturating_sub(self.spu.executed());
        if before > 0 && self.stopped.is_none() {
            self.observe(before);
        }
        if step > self.spu.executed() {
            self.step();
        }
    }

    fn step(&mut self) {
        if self.stopped.is_some() {
            return;
        }
        let next = Instruction::decode(self.store.load_word(self.spu.pc()));
        self.last = next.map(|next| {
            let access = self.spu.access(next).filter(|access| access.is_store);
            (next, access.map(|access| access.address))
        });
        self.observe(1);
    }

    fn observe(&mut self, limit: u64) {
        let Self { spu, store, channels, clocked, .. } = self;
        self.stopped = spu.run_observed(store, channels, limit, clocked);
    }

    /// Why the program has stopped.
    fn reason(&self) -> Option<String> {
        let stopped = self.stopped.as_ref()?;
        let more = match stopped.reason {
            Stop::Waits => "; the PPE has sent no more words",
            Stop::InvalidChannel(..) => {
                "; the playground has mailboxes and the decrementer, and no MFC, signals or events"
            }
            _ => "",
        };
        Some(format!("{stopped}{more}"))
    }

    /// Runs to the program's end or to the next of these addresses, or for [`LIMIT`] instructions.
    pub fn run(&mut self, breakpoints: &BTreeSet<u32>) {
        let end = self.spu.executed() + LIMIT;
        while self.stopped.is_none() && self.spu.executed() < end {
            self.step();
            if breakpoints.contains(&self.spu.pc()) {
                break;
            }
        }
    }

    /// The cycles of the whole program, if it has stopped.
    pub fn cycles(&self) -> Option<u64> {
        self.stopped.as_ref().map(|_| self.clocked.timer.pipeline.account().cycles())
    }

    /// The present state, with some quadwords of local store.
    pub fn view(&self, quadwords: Range<u32>) -> View {
        let hexadecimal = |words: [u32; 4]| words.map(|word| format!("{word:08x}")).join(" ");
        let pc = self.spu.pc();
        let last = SIZE / 16;
        let shown = quadwords.start.min(last)..quadwords.end.min(last);
        View {
            step: self.spu.executed(),
            pc,
            next: disassemble(self.store.load_word(pc), pc).to_string().replace('\t', " "),
            stopped: self.reason(),
            cycles: Cycles::of(self.clocked.timer.pipeline.account()),
            registers: self.spu.registers.iter().map(|r| hexadecimal(r.0)).collect(),
            written: Written {
                registers: self.last.iter().flat_map(|(last, _)| last.writes().iter()).collect(),
                quadword: self.last.and_then(|(_, quadword)| quadword),
            },
            mail: self.channels.mail.clone(),
            decrementer: self.channels.decrementer(),
            store: shown.map(|at| hexadecimal(self.store.load_quadword(16 * at))).collect(),
        }
    }
}
