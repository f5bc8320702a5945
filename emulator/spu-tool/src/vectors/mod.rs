//! Test vectors of single instructions: the state of an SPU before and after, and the cycles.
//!
//! [`Generator`] makes the vectors of an instruction, with the interpreter. A file has them as
//! lines of JSON, which serde writes and reads, or in a [binary form](to_binary). The repository's
//! `examples/vectors/README.md` specifies both. Invariant: an instruction and a seed always give
//! the same vectors.

mod file;
mod generate;
mod truth;

pub use file::{FormatError, binary_header, from_binary, to_binary};
pub use generate::Generator;

use serde::{Deserialize, Serialize};
use spu_emulator::channel::Channels;
use spu_emulator::float::fpscr::Fpscr;
use spu_emulator::interp::{Quad, Spu};
use spu_emulator::local_store::LocalStore;
use spu_emulator::stop::{ChannelAccess, Stop};
use spu_isa::{Instruction, LIMIT_MASK};

/// [`Vector::stop`] of a halt. Codes of stops have 14 bits.
pub const HALT: u32 = 0x4000;

/// `SPU_WrSRR0` and `SPU_RdSRR0`, the only channels of vectors, because the others need an MFC, a
/// PPE or a clock.
pub const SRR0: [u8; 2] = [14, 15];

/// One instruction, the state before it, and the state after it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Vector {
    /// The number of the vector, and the instruction.
    pub name: String,
    /// The source of the state after the instruction.
    pub truth: Truth,
    /// The state before.
    pub initial: State,
    /// The state after.
    #[serde(rename = "final")]
    pub after: State,
    /// The code of a stop, or [`HALT`].
    pub stop: Option<u32>,
    /// The cycles.
    pub cycles: Cycles,
}

/// The part of an SPU's state that the instruction can read or write.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct State {
    /// The address of the instruction, or of the next one.
    pub pc: u32,
    /// Numbers and values of general registers.
    pub regs: Vec<(u8, Value)>,
    /// The floating-point status and control register.
    pub fpscr: Value,
    /// The return address of interrupts.
    pub srr0: u32,
    /// Whether interrupts are enabled.
    pub interrupts: bool,
    /// Whether the count of channel 0 is not 0.
    pub event: bool,
    /// Addresses and values of quadwords of local store.
    pub ram: Vec<(u32, Value)>,
}

/// 128 bits. In JSON they are 32 hexadecimal digits.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(try_from = "String", into = "String")]
pub struct Value(pub Quad);

impl From<Value> for String {
    fn from(value: Value) -> Self {
        format!("{:032x}", value.0.to_u128())
    }
}

impl TryFrom<String> for Value {
    type Error = String;

    fn try_from(text: String) -> Result<Self, String> {
        let digits = text.len() == 32 && text.bytes().all(|digit| digit.is_ascii_hexdigit());
        let value = digits.then(|| u128::from_str_radix(&text, 16).ok()).flatten();
        let value = value.ok_or_else(|| format!("{text:?} is not 32 hexadecimal digits"))?;
        Ok(Self(Quad::from_u128(value)))
    }
}

/// Where a figure comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Truth {
    /// The texts of the architecture, or the manuals.
    Architecture,
    /// A console has printed it.
    Console,
    /// One good source, or two independent ones.
    Fair,
    /// No source: what this emulator does.
    Open,
}

/// The cycles of an instruction whose operands are ready.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Cycles {
    /// From its issue to the issue of the next instruction, which reads the result if there is one.
    pub alone: u16,
    /// Paired with a no-operation of the other pipe: from the issue of the first of both to the
    /// issue of the next instruction, which reads nothing.
    pub pair: u16,
    /// The source of both.
    pub truth: Truth,
}

impl State {
    /// The value of a register, if the instruction can read or write it.
    #[must_use]
    pub fn register(&self, number: u8) -> Option<Quad> {
        self.regs.iter().find(|&&(register, _)| register == number).map(|&(_, value)| value.0)
    }

    /// The units around an SPU in this state.
    #[must_use]
    pub const fn unit(&self) -> Unit {
        Unit { srr0: self.srr0, event: self.event }
    }

    /// Puts the state into an SPU and its local store. Other registers, and the rest of local
    /// store, keep their contents.
    pub fn load(&self, spu: &mut Spu, local_store: &LocalStore) -> Unit {
        let mut unit = self.unit();
        for &(number, Value(value)) in &self.regs {
            spu.set_register(number, value);
        }
        for &(address, Value(value)) in &self.ram {
            local_store.store_quadword(address, value.0);
        }
        spu.fpscr = Fpscr::from_words(self.fpscr.0.0);
        spu.set_interrupts_enabled(self.interrupts, &mut unit);
        spu.set_pc(self.pc);
        unit
    }

    /// The part of an SPU's state that `self` describes.
    #[must_use]
    pub fn of(&self, spu: &Spu, local_store: &LocalStore, unit: &Unit) -> Self {
        let quadword = |address| Value(Quad(local_store.load_quadword(address)));
        Self {
            pc: spu.pc(),
            regs: self.regs.iter().map(|&(n, _)| (n, Value(spu.register(n)))).collect(),
            fpscr: Value(Quad(spu.fpscr.words())),
            srr0: unit.srr0,
            interrupts: spu.interrupts_enabled(),
            event: unit.event,
            ram: self.ram.iter().map(|&(address, _)| (address, quadword(address))).collect(),
        }
    }

    /// The instruction at the program counter.
    #[must_use]
    pub fn instruction(&self) -> Option<Instruction> {
        let (_, Value(code)) = self.ram.iter().find(|(address, _)| *address == self.pc & !15)?;
        Instruction::decode(code.0[self.pc as usize / 4 % 4])
    }
}

/// [`Vector::stop`] for a stop of the emulator, or `None` if no instruction of a vector can cause
/// it.
#[must_use]
pub fn stop_code(stop: &Stop) -> Option<u32> {
    match stop {
        Stop::Signal(code) => Some(u32::from(*code)),
        Stop::Halt => Some(HALT),
        _ => None,
    }
}

/// The units around an SPU, as far as instructions of vectors reach them.
#[derive(Clone, Debug, Default)]
pub struct Unit {
    srr0: u32,
    event: bool,
}

impl Channels for Unit {
    fn read(&mut self, channel: u8) -> Result<u32, Stop> {
        let invalid = Stop::InvalidChannel(channel, ChannelAccess::Read);
        if channel == SRR0[1] { Ok(self.srr0) } else { Err(invalid) }
    }

    fn write(&mut self, channel: u8, value: u32) -> Result<(), Stop> {
        if channel != SRR0[0] {
            return Err(Stop::InvalidChannel(channel, ChannelAccess::Write));
        }
        self.set_srr0(value);
        Ok(())
    }

    fn count(&mut self, channel: u8) -> Result<u32, Stop> {
        let invalid = Stop::InvalidChannel(channel, ChannelAccess::Count);
        if SRR0.contains(&channel) { Ok(1) } else { Err(invalid) }
    }

    fn external_condition(&mut self) -> bool {
        self.event
    }

    fn srr0(&self) -> u32 {
        self.srr0
    }

    fn set_srr0(&mut self, address: u32) {
        self.srr0 = address & LIMIT_MASK & !3;
    }
}
