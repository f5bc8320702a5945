//! A context's emulated SPE.

use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::Instant;

use libc::{c_int, c_uint, c_void};
use spu_debugger::{Attached, signal_of};
use spu_emulator::interp::Spu;
use spu_emulator::mfc::{DmaError, MAX_TRANSFER};
use spu_emulator::signal::{SignalMode, SignalRegister};
use spu_emulator::simulated::Simulation;
use spu_emulator::spe::{Config, ProxyCommand, Spe, TagWait, Watcher};
use spu_emulator::stop::{Stop, Stopped};

use crate::backend::Backend;
use crate::builtin;
use crate::error::Errno;
use crate::fault_signal::{After, FaultSignal};
use crate::machine::{machine, policy};
use crate::mfc::{Transfer, asked};
use crate::problem_state::{Areas, RunState};
use crate::process_memory::ProcessMemory;
use crate::quick_copy::{self, QuickCopies};
use crate::run::{Ended, Outcome, StartRegisters, after_call, stop_status};
use crate::types::{
    SPE_AFFINITY_MEMORY, SPE_CFG_SIGNOTIFY1_OR, SPE_CFG_SIGNOTIFY2_OR, SPE_DMA_ALIGNMENT,
    SPE_DMA_STORAGE, SPE_EVENTS_ENABLE, SPE_INVALID_DMA, SPE_ISOLATE, SPE_MAP_PS, SPE_NOSCHED,
    SPE_SPU_HALT, SPE_SPU_INVALID_CHANNEL, SPE_SPU_INVALID_INSTR,
};

/// An emulated SPE, and what the library keeps for it.
pub(crate) struct Emulated {
    spe: Arc<Spe>,
    events_enabled: bool,
    /// Proxy tags that were used and have not been reported complete.
    issued_tags: Mutex<u32>,
    /// The SPU's state as its registers show it.
    run_state: Arc<RunState>,
    /// The mapped problem state, if the program asked for it.
    areas: Option<Areas>,
    /// The SPE as a debugger's thread, if there is one.
    debugged: Option<Attached>,
}

impl Emulated {
    /// Creates an SPE for a context with these creation flags.
    pub(crate) fn create(flags: c_uint) -> Result<Self, Errno> {
        let has = |flag| flags & flag != 0;
        if has(SPE_ISOLATE) {
            return Err(Errno(libc::ENODEV));
        }
        // A PlayStation 3 kernel has no record of where its SPEs are, so affinity is not supported.
        if has(SPE_AFFINITY_MEMORY) {
            return Err(Errno(libc::EINVAL));
        }
        // SAFETY: geteuid can't fail and takes no pointers.
        if has(SPE_NOSCHED) && unsafe { libc::geteuid() } != 0 {
            return Err(Errno(libc::EPERM));
        }
        ProcessMemory::prepare().map_err(|_| Errno(libc::EFAULT))?;
        quick_copy::prepare()?;
        let mode = |flag| {
            if has(flag) { SignalMode::Or } else { SignalMode::Overwrite }
        };
        let config = Config {
            signal_modes: [mode(SPE_CFG_SIGNOTIFY1_OR), mode(SPE_CFG_SIGNOTIFY2_OR)],
            policy: policy()?,
        };
        let machine = machine()?;
        let spe = Spe::new(&machine.emulated, config);
        let area = spe.local_store().as_ptr();
        spe.map_local_store(area.expose_provenance() as u64);
        let run_state = Arc::new(RunState::default());
        let areas = has(SPE_MAP_PS).then(|| Areas::map(&spe, &run_state)).transpose()?;
        let debugged = machine.debugger.as_ref();
        Ok(Self {
            debugged: debugged.map(|debugger| debugger.attach(&spe)),
            spe,
            events_enabled: has(SPE_EVENTS_ENABLE),
            issued_tags: Mutex::new(0),
            run_state,
            areas,
        })
    }

    fn issued(&self) -> MutexGuard<'_, u32> {
        self.issued_tags.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Runs the SPU, and obeys the debugger before each instruction. Returns `None` if it has
    /// killed the program.
    fn run_under(
        &self,
        thread: &Attached,
        at: u32,
        prepare: impl FnOnce(&mut Spu),
    ) -> Option<Stopped> {
        let look = |spu: &mut Spu, cycles| thread.before_instruction(spu, cycles);
        let stopped = self.spe.run_stepwise(at, look, prepare)?;
        thread.stopped(&self.spe, &stopped, signal_of(&stopped.reason));
        Some(stopped)
    }

    fn after(&self, stopped: &Stopped) -> (u32, Ended) {
        let npc = stopped.npc;
        if let Some((_, difference)) = self.spe.difference() {
            messages::print!("libspe2: {difference}");
            return (npc, Ended::Return(Outcome::fatal(-1)));
        }
        let dma = |event, signal| {
            if self.events_enabled {
                Ended::Return(Outcome::exception(event))
            } else {
                raise(signal)
            }
        };
        let error = |bit| Ended::Return(Outcome::error(bit, bit));
        let ended = match &stopped.reason {
            Stop::Signal(0x2104) if builtin::system_call(self.spe.local_store().as_ref(), npc) => {
                return (after_call(npc), Ended::Resume);
            }
            Stop::Signal(0x3fff) => raise(FaultSignal::breakpoint()),
            Stop::Signal(code) => Ended::Stop { code: *code, status: stop_status(*code) },
            Stop::Halt => error(SPE_SPU_HALT),
            Stop::InvalidInstruction(_) if self.events_enabled => error(SPE_SPU_INVALID_INSTR),
            Stop::InvalidInstruction(_) => raise(FaultSignal::invalid_instruction(stopped.pc)),
            Stop::InvalidChannel(..) => error(SPE_SPU_INVALID_CHANNEL),
            Stop::Dma(DmaError::Alignment { .. }) => {
                dma(SPE_DMA_ALIGNMENT, FaultSignal::dma_alignment())
            }
            Stop::Dma(DmaError::InvalidCommand { .. }) => {
                dma(SPE_INVALID_DMA, FaultSignal::invalid_dma())
            }
            Stop::Dma(DmaError::Storage { ea, .. }) => {
                dma(SPE_DMA_STORAGE, FaultSignal::dma_storage(*ea))
            }
            Stop::Requested | Stop::Waits => Ended::Return(Outcome::fatal(-1)),
        };
        (npc, ended)
    }
}

fn raise(signal: FaultSignal) -> Ended {
    match signal.raise() {
        After::Resume => Ended::Resume,
        After::Interrupted => Ended::Return(Outcome::fatal(libc::EINTR)),
    }
}

/// Until when a wait lasts: for ever, or not at all.
fn deadline(wait: bool) -> Option<Instant> {
    (!wait).then(Instant::now)
}

/// Makes the kernel's checks of a command before it reaches the hardware.
fn kernel_accepts(command: &ProxyCommand, transfer: &Transfer) -> bool {
    let ls_low = command.lsa & 15;
    let aligned = match command.size & 15 {
        0 => ls_low == 0,
        n @ (1 | 2 | 4 | 8) => ls_low.is_multiple_of(n),
        _ => false,
    };
    aligned
        && ls_low == command.ea as u32 & 15
        && command.size <= MAX_TRANSFER
        && transfer.tid == 0
        && transfer.rid == 0
}

impl Backend for Emulated {
    fn local_store(&self) -> *mut u8 {
        self.spe.local_store().as_ptr()
    }

    fn write_local_store(&self, address: u32, bytes: &[u8]) {
        self.spe.local_store().write(address, bytes);
    }

    fn loaded(&self, image: &[u8]) {
        // The SPE was created on it.
        if let Ok(machine) = machine() {
            machine.loaded(&self.spe, image);
        }
        self.spe.expect_run();
    }

    fn run(&self, at: u32, start: Option<&StartRegisters>) -> (u32, Ended) {
        self.run_state.starts();
        let _copies = QuickCopies::where_handled();
        let prepare = |spu: &mut Spu| {
            if let Some(start) = start {
                start.set(self.spe.local_store(), spu);
            }
        };
        let stopped = match &self.debugged {
            None => Some(self.spe.run_prepared(at, prepare)),
            Some(thread) => self.run_under(thread, at, prepare),
        };
        match stopped {
            Some(stopped) => self.after(&stopped),
            None => (at, Ended::Return(Outcome::fatal(-1))),
        }
    }

    fn stopped(&self, status: c_int, npc: u32) {
        self.run_state.stops(status, npc);
    }

    fn read_outbound(&self) -> Result<Option<u32>, Errno> {
        Ok(self.spe.read_outbound(deadline(false)))
    }

    fn outbound_waiting(&self) -> Result<usize, Errno> {
        Ok(self.spe.outbound_waiting())
    }

    fn write_inbound(&self, word: u32, wait: bool) -> Result<bool, Errno> {
        Ok(self.spe.write_inbound(word, deadline(wait)))
    }

    fn inbound_free(&self) -> Result<usize, Errno> {
        Ok(self.spe.inbound_free())
    }

    fn read_outbound_interrupt(&self, wait: bool) -> Result<Option<u32>, Errno> {
        Ok(self.spe.read_outbound_interrupt(deadline(wait)))
    }

    fn outbound_interrupt_waiting(&self) -> Result<usize, Errno> {
        Ok(self.spe.outbound_interrupt_waiting())
    }

    fn signal(&self, register: SignalRegister, word: u32) -> Result<(), Errno> {
        self.spe.signal(register, word);
        Ok(())
    }

    fn maps_areas(&self) -> bool {
        self.areas.is_some()
    }

    fn area(&self, number: usize) -> Option<*mut c_void> {
        self.areas.as_ref()?.area(number)
    }

    /// A synchronisation is over as soon as it starts, because transfers are seen in order.
    fn synchronise(&self) {}

    fn synchronisation(&self) -> u32 {
        0
    }

    fn transfer(&self, transfer: &Transfer) -> Result<(), Errno> {
        let command = ProxyCommand {
            opcode: transfer.opcode,
            lsa: transfer.ls,
            ea: transfer.ea.expose_provenance() as u64,
            size: transfer.size,
            tag: transfer.tag,
        };
        // The kernel does not see commands that go to mapped registers.
        if self.areas.is_none() && !kernel_accepts(&command, transfer) {
            return Err(Errno(libc::EIO));
        }
        // Marked as issued before it is queued, so that whoever learns of its completion finds it
        // in the set.
        *self.issued() |= 1 << transfer.tag;
        match self.spe.proxy_command(command) {
            Ok(()) => Ok(()),
            Err(error) if self.areas.is_some() => {
                self.spe.proxy_failed(error);
                Ok(())
            }
            Err(_) => Err(Errno(libc::EIO)),
        }
    }

    fn tag_status(&self, mask: u32, wait: TagWait) -> Result<u32, Errno> {
        let tags = *self.issued();
        Ok(match (&self.areas, wait) {
            (None, wait) => {
                let complete = self.spe.proxy_tags(tags, wait);
                *self.issued() &= !complete;
                complete
            }
            (Some(_), TagWait::Immediate) => self.spe.proxy_tags(asked(mask, tags), wait),
            (Some(_), _) => self.spe.proxy_tags(asked(mask, tags), TagWait::All),
        })
    }

    fn tag_waiting(&self) -> bool {
        let tags = *self.issued();
        tags != 0 && self.spe.proxy_tags(tags, TagWait::Immediate) != 0
    }

    fn watch(&self, watcher: Arc<dyn Watcher>) {
        self.spe.watch(watcher);
    }

    fn unwatch(&self, watcher: &Arc<dyn Watcher>) {
        self.spe.unwatch(watcher);
    }

    fn change(&self, body: &mut dyn FnMut()) {
        self.spe.act(|| {
            body();
            self.spe.announce();
        });
    }

    fn act(&self, body: &mut dyn FnMut()) {
        self.spe.act(body);
    }

    fn simulation(&self) -> Option<&Arc<Simulation>> {
        self.spe.simulation()
    }
}
