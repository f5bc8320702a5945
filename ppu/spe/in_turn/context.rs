//! One emulated SPE.

use std::sync::Arc;
use std::sync::atomic::{AtomicU32, Ordering::Relaxed};

use spu_emulator::elf;
use spu_emulator::interp::Quad;
use spu_emulator::mfc::DmaError;
use spu_emulator::profile::ProgramId;
use spu_emulator::spe::{Config, Spe};
use spu_emulator::stop::{Stop, Stopped};

use super::super::{Ended, Outcome, Program, SpeError};
use super::{failed, machine};

/// Stop codes of an exit, with the exit code in the low byte.
const EXITS: std::ops::RangeInclusive<u16> = 0x2000..=0x20ff;

/// An SPE context.
pub struct Context {
    pub(super) spe: Arc<Spe>,
    entry: AtomicU32,
}

/// A program that runs in a context.
pub struct Running(Arc<Context>);

impl Running {
    /// Runs the program of a context, with `number` in `$4`.
    ///
    /// # Errors
    /// None; other hosts have some.
    pub fn start(context: &Arc<Context>, number: u32) -> Result<Self, SpeError> {
        context.spe.begin(context.entry.load(Relaxed), |spu| {
            // $3 is the context, which no program may follow, $4 the argument.
            spu.set_register(4, Quad([0, number, 0, 0]));
        });
        Ok(Self(Arc::clone(context)))
    }

    /// How the program has ended; `None` if it goes on.
    #[must_use]
    pub fn ended(self) -> Option<Ended> {
        let Stopped { reason, npc, .. } = self.0.spe.ended()?;
        let outcome = match reason {
            Stop::Signal(code) if EXITS.contains(&code) => Outcome::Exit(i32::from(code & 0xff)),
            Stop::Signal(code) => Outcome::Signal(code.into()),
            Stop::Halt => Outcome::Fault("a halt instruction found its condition true"),
            Stop::InvalidInstruction(_) => Outcome::Fault("invalid instruction"),
            Stop::InvalidChannel(..) => Outcome::Fault("invalid channel"),
            Stop::Dma(DmaError::Alignment { .. }) => Outcome::Dma("DMA alignment", 0),
            Stop::Dma(DmaError::Storage { .. }) => {
                Outcome::Dma("DMA to or from unmapped memory", 0)
            }
            Stop::Dma(DmaError::InvalidCommand { .. }) => Outcome::Dma("invalid DMA command", 0),
            Stop::Requested | Stop::Waits => Outcome::Fault("stopped by request"),
        };
        let instruction = self.0.spe.local_store().load_word(npc.wrapping_sub(4));
        Some(Ended { outcome, npc, instruction })
    }
}

impl Context {
    /// The stop code of [`Context::halt`]. The instruction word of a stop equals its code.
    pub const HALTED: u32 = 0x3ffe;

    /// Creates a context on the machine of [`use_machine`](super::use_machine).
    ///
    /// # Errors
    /// No machine was chosen.
    pub fn create() -> Result<Self, SpeError> {
        Ok(Self { spe: Spe::new(&machine()?, Config::default()), entry: AtomicU32::new(0) })
    }

    /// Copies a program into local store.
    ///
    /// # Errors
    /// The image is not an SPU program.
    pub fn load(&self, program: &Program) -> Result<(), SpeError> {
        let image = elf::Image::parse(program.image());
        let image = image.map_err(|error| failed("elf::Image::parse", error))?;
        image.load(self.spe.local_store(), 0);
        self.spe.profile_as(ProgramId::of(program.image()));
        self.entry.store(image.entry(), Relaxed);
        Ok(())
    }

    /// Stops the program wherever it is, by overwriting all of its instructions with stops.
    pub fn halt(&self, program: &Program) {
        for address in program.code().into_iter().flat_map(|code| code.step_by(4)) {
            self.spe.local_store().write(address, &Self::HALTED.to_be_bytes());
        }
    }

    /// Whether the inbound mailbox has words that the SPU has not read.
    #[must_use]
    pub fn has_unread_mail(&self) -> bool {
        self.spe.inbound_free() < spu_emulator::mailbox::INBOUND_DEPTH
    }

    /// Writes all words to the inbound mailbox.
    ///
    /// # Errors
    /// The mailbox is too full for them.
    pub fn mail<const COUNT: usize>(&self, words: [u32; COUNT]) -> Result<(), SpeError> {
        if self.spe.inbound_free() < COUNT {
            return Err(failed("spe_in_mbox_write", "the mailbox is full"));
        }
        for word in words {
            self.spe.write_inbound(word, None);
        }
        Ok(())
    }

    /// Reads a word from the outbound interrupt mailbox; `None` if it is empty.
    ///
    /// # Errors
    /// None; other hosts have some.
    pub fn reply(&self) -> Result<Option<u32>, SpeError> {
        let waiting = self.spe.outbound_interrupt_waiting() > 0;
        Ok(if waiting { self.spe.read_outbound_interrupt(None) } else { None })
    }

    /// Does nothing, because no record is kept.
    ///
    /// # Errors
    /// None; other hosts have some.
    pub fn take_stop_record(&self) -> Result<(), SpeError> {
        Ok(())
    }
}
