//! The registers of the problem-state areas, by their offsets in the map.

use std::sync::atomic::Ordering::SeqCst;
use std::sync::atomic::{AtomicI32, AtomicU32};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Instant;

use spu_emulator::mfc::PROXY_QUEUE_DEPTH;
use spu_emulator::signal::SignalRegister;
use spu_emulator::spe::{ProxyCommand, Spe, TagWait};

pub(crate) const SIZE: usize = 0x20000;

pub(super) const SIGNAL_1: usize = 0x1400c;
pub(super) const SIGNAL_2: usize = 0x1c00c;

const MFC_LSA: usize = 0x3004;
const MFC_EAH: usize = 0x3008;
const MFC_EAL: usize = 0x300c;
const MFC_SIZE_TAG: usize = 0x3010;
/// When written; the command status when read.
const MFC_CLASS_ID_COMMAND: usize = 0x3014;
const MFC_COMMAND_STATUS: usize = MFC_CLASS_ID_COMMAND;
const MFC_QUEUE_STATUS: usize = 0x3104;
const PROXY_QUERY_TYPE: usize = 0x3204;
const PROXY_QUERY_MASK: usize = 0x321c;
const PROXY_TAG_STATUS: usize = 0x322c;
const OUT_MAILBOX: usize = 0x4004;
const IN_MAILBOX: usize = 0x400c;
const MAILBOX_STATUS: usize = 0x4014;
const RUN_CONTROL: usize = 0x401c;
const STATUS: usize = 0x4024;
const NEXT_PROGRAM_COUNTER: usize = 0x4034;

/// The queue status while no command is outstanding.
const QUEUE_EMPTY: u32 = 1 << 31;
/// The status of an SPU that runs.
const RUNNING: u32 = 1;

/// The state of the SPU as its registers show it.
#[derive(Default)]
pub(crate) struct RunState {
    status: AtomicI32,
    next: AtomicU32,
}

impl RunState {
    pub(crate) fn starts(&self) {
        self.status.store(RUNNING as i32, SeqCst);
    }

    /// `status` is -1 if the run has none.
    pub(crate) fn stops(&self, status: i32, next: u32) {
        self.next.store(next, SeqCst);
        self.status.store(status.max(0), SeqCst);
    }
}

/// The command status: a command was queued, or the sequence was not kept.
const SUCCESS: u32 = 0;
const SEQUENCE_ERROR: u32 = 1;

/// Which registers of the sequence that gives a command have been written.
///
/// Provenance: the order of the registers, and the meanings of the status, are those of IBM's SDK
/// (Programming Tutorial, "Issuing DMA commands from the PPE"): LSA, EAH and EAL, size and tag,
/// class and opcode, and then the status is read, which ends the sequence. An example of an error
/// there is a second sequence within the first; it must begin anew with the LSA. That every
/// register must be written, EAH too and for every opcode, and that the status is an error if
/// nothing was, is how the emulator RPCS3 behaves. That another order is an error is inferred from
/// the tutorial, and is not known of a console.
struct Sequence {
    /// The registers that have been written, in their order; `None` after one out of order.
    written: Option<u8>,
    status: u32,
}

impl Sequence {
    const LSA: u8 = 1;
    const EAH: u8 = 2;
    const EAL: u8 = 4;
    const SIZE_AND_TAG: u8 = 8;
    const EA: u8 = Self::EAH | Self::EAL;

    /// Takes note that a parameter is written.
    fn write(&mut self, register: u8) {
        let expected = |written: u8| match register {
            Self::EAH | Self::EAL => written & !Self::EA == Self::LSA,
            Self::SIZE_AND_TAG => written & !register == Self::LSA | Self::EA,
            _ => false,
        };
        self.written = match register {
            Self::LSA => Some(register),
            _ => self.written.filter(|&written| expected(written)),
        };
        self.written = self.written.map(|written| written | register);
    }

    /// Whether the command that is written now has all its parameters. They are used up.
    fn is_complete(&mut self) -> bool {
        const ALL: u8 = Sequence::LSA | Sequence::EA | Sequence::SIZE_AND_TAG;
        let is_complete = self.written == Some(ALL);
        *self =
            Self { status: if is_complete { SUCCESS } else { SEQUENCE_ERROR }, ..Self::default() };
        is_complete
    }

    /// Reads the status, and ends the sequence.
    fn end(&mut self) -> u32 {
        std::mem::take(self).status
    }
}

impl Default for Sequence {
    fn default() -> Self {
        Self { written: Some(0), status: SEQUENCE_ERROR }
    }
}

/// The parameters of the next proxy command, and what is asked about its tags.
#[derive(Default)]
struct Command {
    sequence: Sequence,
    lsa: u32,
    ea: [u32; 2],
    size_and_tag: u32,
    query_type: u32,
    query_mask: u32,
}

pub(super) struct Registers {
    spe: Arc<Spe>,
    run: Arc<RunState>,
    command: Mutex<Command>,
}

impl Registers {
    pub fn new(spe: Arc<Spe>, run: Arc<RunState>) -> Self {
        Self { spe, run, command: Mutex::default() }
    }

    fn command(&self) -> std::sync::MutexGuard<'_, Command> {
        self.command.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Reads the register at an offset. Offsets without a register read as 0.
    pub fn read(&self, offset: usize) -> u32 {
        let spe = &self.spe;
        match offset {
            MFC_LSA => self.command().lsa,
            MFC_EAH => self.command().ea[0],
            MFC_EAL => self.command().ea[1],
            MFC_SIZE_TAG => self.command().size_and_tag,
            // The queue is never full: a command waits until an entry is free.
            MFC_COMMAND_STATUS => self.command().sequence.end(),
            MFC_QUEUE_STATUS => {
                let idle = spe.proxy_tags(u32::MAX, TagWait::Immediate) == u32::MAX;
                PROXY_QUEUE_DEPTH as u32 | if idle { QUEUE_EMPTY } else { 0 }
            }
            PROXY_QUERY_TYPE => self.command().query_type,
            PROXY_QUERY_MASK => self.command().query_mask,
            PROXY_TAG_STATUS => {
                let mask = self.command().query_mask;
                spe.proxy_tags(mask, TagWait::Immediate)
            }
            OUT_MAILBOX => spe.read_outbound(Some(Instant::now())).unwrap_or(0),
            MAILBOX_STATUS => {
                let counts =
                    [spe.outbound_waiting(), spe.inbound_free(), spe.outbound_interrupt_waiting()];
                (counts[0] | counts[1] << 8 | counts[2] << 16) as u32
            }
            RUN_CONTROL => self.status() & RUNNING,
            STATUS => self.status(),
            NEXT_PROGRAM_COUNTER => self.run.next.load(SeqCst),
            // A synchronisation has nothing to wait for.
            _ => 0,
        }
    }

    fn status(&self) -> u32 {
        self.run.status.load(SeqCst) as u32
    }

    /// Writes the register at an offset. Elsewhere a write has no effect.
    pub fn write(&self, offset: usize, value: u32) {
        let spe = &self.spe;
        match offset {
            MFC_LSA => {
                let mut command = self.command();
                command.lsa = value;
                command.sequence.write(Sequence::LSA);
            }
            MFC_EAH => {
                let mut command = self.command();
                command.ea[0] = value;
                command.sequence.write(Sequence::EAH);
            }
            MFC_EAL => {
                let mut command = self.command();
                command.ea[1] = value;
                command.sequence.write(Sequence::EAL);
            }
            MFC_SIZE_TAG => {
                let mut command = self.command();
                command.size_and_tag = value;
                command.sequence.write(Sequence::SIZE_AND_TAG);
            }
            MFC_CLASS_ID_COMMAND => self.start(value),
            PROXY_QUERY_TYPE => self.command().query_type = value,
            PROXY_QUERY_MASK => self.command().query_mask = value,
            // If the mailbox is full, the word is lost.
            IN_MAILBOX => {
                spe.write_inbound(value, Some(Instant::now()));
            }
            RUN_CONTROL if value & RUNNING == 0 => spe.request_stop(),
            SIGNAL_1 => spe.signal(SignalRegister::One, value),
            SIGNAL_2 => spe.signal(SignalRegister::Two, value),
            _ => {}
        }
    }

    /// Gives a command with the parameters that were written before it, if all were. A wrong one
    /// stops the SPU, as the interrupt of the hardware does.
    fn start(&self, class_and_opcode: u32) {
        const OPCODE: u32 = 0xffff;
        let command = {
            let mut command = self.command();
            if !command.sequence.is_complete() {
                return;
            }
            ProxyCommand {
                opcode: class_and_opcode & OPCODE,
                lsa: command.lsa,
                ea: u64::from(command.ea[0]) << 32 | u64::from(command.ea[1]),
                size: command.size_and_tag >> 16,
                tag: command.size_and_tag & 0xffff,
            }
        };
        if let Err(error) = self.spe.proxy_command(command) {
            self.spe.proxy_failed(error);
        }
    }
}
