//! A debugger that executes commands, one a line, from a person at a terminal or from a script.
//!
//! It runs on the thread of the SPE, before each instruction, so that a session takes the same
//! course in every run. Bad commands get a message and change nothing. Output follows the command
//! that asks for it, and nothing else is written, so that a script can read it.

mod command;
mod frames;
mod show;

use std::collections::BTreeSet;
use std::io::{self, BufRead, Write};
use std::ops::ControlFlow;

use spu_emulator::elf::Image;
use spu_emulator::interp::Spu;
use spu_emulator::local_store::{LocalStore, SIZE};
use spu_emulator::spe::{ChannelState, Halted};
use spu_isa::{Instruction, Op};

use command::{Command, Target, parse};

pub use show::instruction_text;

const PROMPT: &str = "(spu) ";

/// What the SPE does until it halts again.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Going {
    /// Until a breakpoint.
    On,
    /// A number of instructions.
    Steps(u64),
    /// A number of instructions, where a call counts as one.
    Next(u64),
    /// Until the function returns.
    Out,
}

/// Where the SPE was before it ran the last instruction.
#[derive(Clone, Copy, Debug)]
struct Last {
    pc: u32,
    instruction: Option<Instruction>,
}

/// A session with one SPE.
pub struct Console<'a, R, W> {
    input: R,
    output: W,
    is_terminal: bool,
    image: &'a Image<'a>,
    breakpoints: BTreeSet<u32>,
    going: Going,
    /// The calls that were made since the SPE last halted, without those that have returned.
    depth: i64,
    last: Option<Last>,
    /// The state at the last halt before an instruction.
    channels: ChannelState,
    cycles: Option<u64>,
    has_quit: bool,
    result: io::Result<()>,
    /// Whether the user has interrupted the program since this was last asked.
    interrupted: fn() -> bool,
}

/// What a command works on.
struct Scene<'a> {
    spu: &'a mut Spu,
    store: &'a LocalStore,
    /// Whether the program can go on.
    runs: bool,
}

impl<'a, R: BufRead, W: Write> Console<'a, R, W> {
    /// A session that halts at the program's first instruction. With a terminal it prompts.
    pub fn new(image: &'a Image<'a>, input: R, output: W, is_terminal: bool) -> Self {
        Self {
            input,
            output,
            is_terminal,
            image,
            breakpoints: BTreeSet::new(),
            going: Going::Steps(0),
            depth: 0,
            last: None,
            channels: ChannelState::default(),
            cycles: None,
            has_quit: false,
            result: Ok(()),
            interrupted: || false,
        }
    }

    /// `interrupted` returns whether the user has interrupted the program since its last call.
    #[must_use]
    pub fn interrupted_by(self, interrupted: fn() -> bool) -> Self {
        Self { interrupted, ..self }
    }

    /// Whether the user has ended the session.
    #[must_use]
    pub fn has_quit(&self) -> bool {
        self.has_quit
    }

    /// The first error in reading commands or printing results.
    pub fn finish(mut self) -> io::Result<()> {
        self.result?;
        self.output.flush()
    }

    /// The SPE is about to run the instruction at its program counter. Halts there if it must, and
    /// obeys commands until one lets it go on. Breaks if the session is over.
    pub fn before_instruction(
        &mut self,
        spu: &mut Spu,
        store: &LocalStore,
        halted: &Halted<'_>,
    ) -> ControlFlow<()> {
        self.follow(spu, store);
        if let Some(why) = self.reason(spu.pc()) {
            self.channels = halted.channels();
            self.cycles = halted.cycles();
            if !why.is_empty() {
                self.print_line(why);
            }
            self.print_place(spu.pc(), store);
            self.obey(&mut Scene { spu, store, runs: true });
        }
        if self.has_quit {
            return ControlFlow::Break(());
        }
        self.last = Some(Last {
            pc: spu.pc(),
            instruction: Instruction::decode(store.load_word(spu.pc())),
        });
        ControlFlow::Continue(())
    }

    /// The program has failed at the instruction at its program counter, and can't go on. Obeys
    /// commands until the user has seen enough.
    pub fn after_fault(
        &mut self,
        spu: &mut Spu,
        store: &LocalStore,
        halted: &Halted<'_>,
        what: &str,
    ) {
        self.channels = halted.channels();
        self.cycles = halted.cycles();
        self.print_line(&format!("The program has failed: {what}"));
        self.print_place(spu.pc(), store);
        self.obey(&mut Scene { spu, store, runs: false });
    }

    /// The program has ended with this exit status.
    pub fn ended(&mut self, status: u8) {
        self.print_line(&format!("The program has ended with status {status}."));
    }

    /// Counts calls and returns.
    fn follow(&mut self, spu: &Spu, store: &LocalStore) {
        let Some(Last { pc, instruction: Some(instruction) }) = self.last.take() else {
            return;
        };
        let after = pc.wrapping_add(4);
        if is_call(instruction) && spu.pc() != after {
            self.depth += 1;
        } else if instruction.op == Op::Bi {
            let before = store.load_word(spu.pc().wrapping_sub(4));
            if Instruction::decode(before).is_some_and(is_call) {
                self.depth -= 1;
            }
        }
        match &mut self.going {
            Going::Steps(left) => *left = left.saturating_sub(1),
            Going::Next(left) if self.depth <= 0 => {
                *left = left.saturating_sub(1);
                self.depth = 0;
            }
            Going::Next(_) | Going::On | Going::Out => {}
        }
    }

    /// Why the SPE must halt before the instruction at `pc`, if it must.
    fn reason(&self, pc: u32) -> Option<&'static str> {
        let arrived = match self.going {
            Going::On => false,
            Going::Steps(left) | Going::Next(left) => left == 0,
            Going::Out => self.depth < 0,
        };
        if arrived {
            Some("")
        } else if self.breakpoints.contains(&pc) {
            Some("Breakpoint:")
        } else if (self.interrupted)() {
            Some("Interrupted:")
        } else {
            None
        }
    }

    fn print_line(&mut self, text: &str) {
        self.print(&format!("{text}\n"));
    }

    fn print(&mut self, text: &str) {
        if self.result.is_ok() {
            let written = self.output.write_all(text.as_bytes());
            self.result = written.and_then(|()| self.output.flush());
        }
    }

    fn print_place(&mut self, pc: u32, store: &LocalStore) {
        let line = show::line(self.image, store, pc);
        self.print_line(&line);
    }

    /// The next line, or `None` at the end.
    fn line(&mut self) -> Option<String> {
        if self.is_terminal {
            self.print(PROMPT);
        }
        let mut bytes = Vec::new();
        match self.input.read_until(b'\n', &mut bytes) {
            Ok(1..) if self.result.is_ok() => {
                Some(String::from_utf8_lossy(&bytes).trim().to_owned())
            }
            Ok(_) => None,
            Err(error) => {
                self.result = Err(error);
                None
            }
        }
    }

    /// Obeys commands until one lets the program go on, or the session is over.
    fn obey(&mut self, scene: &mut Scene<'_>) {
        loop {
            let Some(line) = self.line() else {
                self.has_quit = true;
                return;
            };
            let going = match parse(&line) {
                Ok(None) => continue,
                Ok(Some(command)) => self.carry_out(command, scene),
                Err(error) => Err(error),
            };
            match going {
                Ok(None) if self.has_quit => return,
                Ok(None) => {}
                Ok(Some(_)) if !scene.runs => {
                    self.print_line(
                        "The program has failed and can't go on; quit ends the session",
                    );
                }
                Ok(Some(going)) => {
                    self.going = going;
                    self.depth = 0;
                    return;
                }
                Err(error) => self.print_line(&error),
            }
        }
    }

    /// The address that the user means.
    fn address(&self, target: &Target, pc: u32) -> Result<u32, String> {
        let address = match target {
            Target::Here => pc,
            Target::Address(address) => *address,
            Target::Symbol(name, distance) => {
                let symbol = self.image.symbol(name);
                let symbol = symbol.ok_or_else(|| self.no_symbol(name))?;
                symbol.wrapping_add(*distance)
            }
        };
        if address < SIZE {
            Ok(address)
        } else {
            Err(format!("{address:#x} is beyond local store, which ends at {SIZE:#x}"))
        }
    }

    fn no_symbol(&self, name: &str) -> String {
        let known = self.image.symbols().map(|(_, known)| known);
        match closest(name, known) {
            Some(known) => format!("the program has no symbol {name}; did you mean {known}?"),
            None => format!("the program has no symbol {name}, and it is no number"),
        }
    }

    /// Carries out a command. Returns how the program goes on, if it does.
    fn carry_out(
        &mut self,
        command: Command,
        scene: &mut Scene<'_>,
    ) -> Result<Option<Going>, String> {
        let pc = scene.spu.pc();
        let text = match command {
            Command::Continue => return Ok(Some(Going::On)),
            Command::Step(count) => return Ok(Some(Going::Steps(count))),
            Command::Next(count) => return Ok(Some(Going::Next(count))),
            Command::Finish => return Ok(Some(Going::Out)),
            Command::Quit => {
                self.has_quit = true;
                return Ok(None);
            }
            Command::Break(target) => self.set_breakpoint(&target, pc)?,
            Command::Delete(None) => {
                self.breakpoints.clear();
                String::new()
            }
            Command::Delete(Some(target)) => {
                let address = self.address(&target, pc)?;
                if !self.breakpoints.remove(&address) {
                    let place = self.image.place(address);
                    return Err(format!("there is no breakpoint at {place}"));
                }
                String::new()
            }
            Command::Breakpoints => self.list_breakpoints(),
            Command::Registers(wanted) => show::registers(scene.spu, &wanted),
            Command::SetRegister(number, words) => {
                let register = &mut scene.spu.registers[usize::from(number)];
                register.0[..words.len()].copy_from_slice(&words);
                String::new()
            }
            Command::SetPc(target) => {
                let address = self.address(&target, pc)?;
                if address % 4 != 0 {
                    return Err(format!("{address:#x} is no address of an instruction"));
                }
                scene.spu.set_pc(address);
                String::new()
            }
            Command::SetWord(target, word) => {
                let address = self.address(&target, pc)?;
                scene.store.write(address, &word.to_be_bytes());
                String::new()
            }
            Command::Memory(target, words) => {
                let address = self.address(&target, pc)?;
                show::memory(scene.store, address, words)
            }
            Command::Disassemble(target, count) => {
                let start = match target {
                    None => show::before(self.image, pc),
                    Some(target) => self.address(&target, pc)?,
                };
                show::code(self.image, scene.store, (start, count), pc, &self.breakpoints)
            }
            Command::Backtrace => {
                let frames = frames::backtrace(self.image, scene.store, scene.spu);
                show::frames(self.image, &frames)
            }
            Command::Mfc => show::mfc(&self.channels),
            Command::Channels => show::channels(&self.channels),
            Command::Cycles => match self.cycles {
                Some(cycles) => format!("{cycles} cycles\n"),
                None => "cycles are counted in simulated time: start with --timing\n".into(),
            },
            Command::Frame => format!("{}\n", show::line(self.image, scene.store, pc)),
            Command::Help => command::HELP.into(),
        };
        self.print(&text);
        Ok(None)
    }

    fn set_breakpoint(&mut self, target: &Target, pc: u32) -> Result<String, String> {
        let address = self.address(target, pc)?;
        if address % 4 != 0 {
            return Err(format!("{address:#x} is no address of an instruction"));
        }
        self.breakpoints.insert(address);
        Ok(format!("breakpoint at {}\n", self.image.place(address)))
    }

    fn list_breakpoints(&self) -> String {
        if self.breakpoints.is_empty() {
            return "no breakpoints\n".into();
        }
        let line = |&address: &u32| format!("{}\n", self.image.place(address));
        self.breakpoints.iter().map(line).collect()
    }
}

/// Whether the instruction branches and leaves the address after it in a register.
fn is_call(instruction: Instruction) -> bool {
    matches!(instruction.op, Op::Brsl | Op::Brasl | Op::Bisl | Op::Bisled)
}

/// The name with the smallest edit distance from `asked`, if that is small.
pub(crate) fn closest<'n>(asked: &str, names: impl Iterator<Item = &'n str>) -> Option<&'n str> {
    let ranked = names.map(|name| (distance(asked, name), name));
    let (distance, name) = ranked.min()?;
    (distance <= 1 + asked.len() / 4).then_some(name)
}

/// The number of characters to insert, remove or replace to make `b` of `a`.
fn distance(a: &str, b: &str) -> usize {
    let b: Vec<char> = b.chars().collect();
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (n, from) in a.chars().enumerate() {
        let mut diagonal = std::mem::replace(&mut row[0], n + 1);
        for (m, to) in b.iter().enumerate() {
            let replaced = diagonal + usize::from(from != *to);
            diagonal = row[m + 1];
            row[m + 1] = replaced.min(diagonal + 1).min(row[m] + 1);
        }
    }
    row[b.len()]
}
