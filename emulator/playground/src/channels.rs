//! The channels that make sense without a PPE and an MFC: mailboxes and the decrementer.
//!
//! The PPE's words are known beforehand, and the decrementer counts the SPU's own cycles. So equal
//! programs at equal steps are in equal states.

use std::cell::Cell;
use std::rc::Rc;

use serde::Serialize;
use spu_emulator::channel::Channels;
use spu_emulator::interp::{Observer, Spu};
use spu_emulator::stop::{ChannelAccess, Stop};
use spu_emulator::timer::Timer;
use spu_isa::Instruction;

/// Cycles of a tick of the decrementer: 3.2 GHz by 79.8 MHz, rounded.
const CYCLES_PER_TICK: u64 = 40;

/// The words that the inbound mailbox holds.
const DEPTH: usize = 4;

const WR_DEC: u8 = 7;
const RD_DEC: u8 = 8;
const RD_MACH_STAT: u8 = 13;
const WR_SRR0: u8 = 14;
const RD_SRR0: u8 = 15;
const WR_OUT_MBOX: u8 = 28;
const RD_IN_MBOX: u8 = 29;
const WR_OUT_INTR_MBOX: u8 = 30;

/// The words of the mailboxes.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Mail {
    /// The words that the PPE has sent.
    pub inbound: Vec<u32>,
    /// How many of them the SPU has read.
    pub read: usize,
    /// The words that the SPU has sent. The PPE takes each at once.
    outbound: Vec<u32>,
    outbound_interrupt: Vec<u32>,
}

/// The pipelines' timer, whose clock the channels can read.
pub struct Clocked {
    pub timer: Timer,
    clock: Rc<Cell<u64>>,
}

impl Observer for Clocked {
    fn before_instruction(&mut self, spu: &Spu, instruction: Instruction) {
        self.timer.before_instruction(spu, instruction);
        self.clock.set(self.timer.pipeline.clock());
    }
}

/// The channels of a program.
pub struct PlaygroundChannels {
    pub mail: Mail,
    /// The value that was written last, and the tick of that moment. Before, it stands still at 0.
    decrementer: Option<(u32, u64)>,
    clock: Rc<Cell<u64>>,
    interrupts_enabled: bool,
    srr0: u32,
}

impl PlaygroundChannels {
    /// Channels at the start, with the words that the PPE sends, and the timer that they read.
    pub fn new(inbound: Vec<u32>) -> (Self, Clocked) {
        let clock = Rc::<Cell<u64>>::default();
        let channels = Self {
            mail: Mail { inbound, ..Mail::default() },
            decrementer: None,
            clock: Rc::clone(&clock),
            interrupts_enabled: false,
            srr0: 0,
        };
        (channels, Clocked { timer: Timer::default(), clock })
    }

    fn ticks(&self) -> u64 {
        self.clock.get() / CYCLES_PER_TICK
    }

    /// The decrementer's present value.
    pub fn decrementer(&self) -> u32 {
        let passed = |since| self.ticks().wrapping_sub(since) as u32;
        self.decrementer.map_or(0, |(value, since)| value.wrapping_sub(passed(since)))
    }
}

impl Channels for PlaygroundChannels {
    fn read(&mut self, channel: u8) -> Result<u32, Stop> {
        match channel {
            RD_DEC => Ok(self.decrementer()),
            RD_MACH_STAT => Ok(self.interrupts_enabled.into()),
            RD_SRR0 => Ok(self.srr0),
            RD_IN_MBOX => {
                let word = self.mail.inbound.get(self.mail.read).ok_or(Stop::Waits)?;
                self.mail.read += 1;
                Ok(*word)
            }
            _ => Err(Stop::InvalidChannel(channel, ChannelAccess::Read)),
        }
    }

    fn write(&mut self, channel: u8, value: u32) -> Result<(), Stop> {
        match channel {
            WR_DEC => self.decrementer = Some((value, self.ticks())),
            WR_SRR0 => self.set_srr0(value),
            WR_OUT_MBOX => self.mail.outbound.push(value),
            WR_OUT_INTR_MBOX => self.mail.outbound_interrupt.push(value),
            _ => return Err(Stop::InvalidChannel(channel, ChannelAccess::Write)),
        }
        Ok(())
    }

    fn count(&mut self, channel: u8) -> Result<u32, Stop> {
        match channel {
            // The PPE waits while the mailbox is full.
            RD_IN_MBOX => Ok((self.mail.inbound.len() - self.mail.read).min(DEPTH) as u32),
            WR_DEC | RD_DEC | RD_MACH_STAT | WR_SRR0 | RD_SRR0 | WR_OUT_MBOX | WR_OUT_INTR_MBOX => {
                Ok(1)
            }
            _ => Err(Stop::InvalidChannel(channel, ChannelAccess::Count)),
        }
    }

    fn set_interrupts_enabled(&mut self, enabled: bool) {
        self.interrupts_enabled = enabled;
    }

    fn srr0(&self) -> u32 {
        self.srr0
    }

    fn set_srr0(&mut self, address: u32) {
        self.srr0 = address & spu_isa::LIMIT_MASK & !3;
    }
}
