//! `spe_context_run`: the calling thread acts as the SPU until it stops for a reason that the
//! program must handle.

use std::sync::atomic::Ordering::SeqCst;

use libc::{c_int, c_uint, c_void};
use spu_emulator::interp::{Quad, Spu};
use spu_emulator::local_store::{LocalStore, SIZE};
use spu_emulator::memory::MainMemory;
use spu_isa::LIMIT_MASK;

use crate::callback;
use crate::context::{Context, context};
use crate::error::{self, Errno, set_errno};
use crate::process_memory::ProcessMemory;
use crate::stop_record::StopRecord;
use crate::types::{
    SPE_CALLBACK_ERROR, SPE_DEFAULT_ENTRY, SPE_EXIT, SPE_ISOLATION_ERROR, SPE_NO_CALLBACKS,
    SPE_RUN_USER_REGS, SPE_RUNTIME_ERROR, SPE_RUNTIME_EXCEPTION, SPE_RUNTIME_FATAL,
    SPE_SPU_STOPPED_BY_STOP, SPE_STOP_AND_SIGNAL, SpeContext, SpeStopInfo,
};

/// Where the library puts the zero back chain: the initial stack pointer.
pub(crate) const STACK_TOP: u32 = SIZE - 16;
/// The library's start block. It overwrites any program data at the top of local store.
pub(crate) const START_BLOCK: usize = 128;
/// The word after a library call's stop is data.
const CALL_WORD: u32 = 4;
/// Size in bytes of the three registers of `SPE_RUN_USER_REGS`.
const USER_REGISTERS: usize = 48;

/// How a run ended, as reported to the program.
pub(crate) struct Outcome {
    /// The return value, or the errno if the call returns -1.
    returned: Result<c_int, Errno>,
    record: StopRecord,
}

impl Outcome {
    fn failed(errno: c_int, stop_reason: c_uint, result: c_int, spu_status: c_int) -> Self {
        Self { returned: Err(Errno(errno)), record: StopRecord { stop_reason, result, spu_status } }
    }

    /// The SPU met something that it can't run: a bit of its status.
    pub(crate) fn error(bit: c_int, spu_status: c_int) -> Self {
        Self::failed(libc::EFAULT, SPE_RUNTIME_ERROR, bit, spu_status)
    }

    /// A DMA error, with the event that reports it.
    pub(crate) fn exception(event: c_int) -> Self {
        Self::failed(libc::EIO, SPE_RUNTIME_EXCEPTION, event, -1)
    }

    /// The run itself failed, with this errno or -1.
    pub(crate) fn fatal(result: c_int) -> Self {
        Self::failed(libc::EFAULT, SPE_RUNTIME_FATAL, result, -1)
    }

    #[cfg(test)]
    pub(crate) fn record(&self) -> StopRecord {
        self.record
    }

    fn stopped(returned: c_int, stop_reason: c_uint, result: c_int, spu_status: c_int) -> Self {
        Self { returned: Ok(returned), record: StopRecord { stop_reason, result, spu_status } }
    }
}

/// The status of an SPU after a stop instruction with this code.
pub(crate) fn stop_status(code: u16) -> c_int {
    c_int::from(code) << 16 | SPE_SPU_STOPPED_BY_STOP
}

/// Why the SPU has stopped.
pub(crate) enum Ended {
    Stop {
        code: u16,
        status: c_int,
    },
    /// Nothing that the library or the program must handle: the SPU continues.
    Resume,
    Return(Outcome),
}

/// What happens after a stop.
enum Next {
    /// The SPU continues at this address.
    Resume(u32),
    Return(Outcome),
}

/// The next instruction after a library call: after the stop and the word that follows it.
pub(crate) fn after_call(npc: u32) -> u32 {
    npc.wrapping_add(CALL_WORD) & LIMIT_MASK
}

fn call_back(context: &Context, code: u16, status: c_int, npc: u32) -> Next {
    let ls_base = context.backend.local_store();
    match callback::call(c_uint::from(code & 0xff), ls_base.cast(), npc) {
        0 => Next::Resume(after_call(npc)),
        result => Next::Return(Outcome::failed(libc::EFAULT, SPE_CALLBACK_ERROR, result, status)),
    }
}

fn after_stop(context: &Context, flags: c_uint, code: u16, status: c_int, npc: u32) -> Next {
    let value = c_int::from(code);
    match code {
        0x2100..=0x21ff if flags & SPE_NO_CALLBACKS == 0 => call_back(context, code, status, npc),
        0x2000..=0x20ff => Next::Return(Outcome::stopped(0, SPE_EXIT, value & 0xff, status)),
        // The isolation loader's "load complete" is not reported to the program.
        0x2206 => Next::Resume(npc),
        0x2200..=0x220f => {
            Next::Return(Outcome::failed(libc::EFAULT, SPE_ISOLATION_ERROR, value & 0xf, status))
        }
        _ => Next::Return(Outcome::stopped(value, SPE_STOP_AND_SIGNAL, value, status)),
    }
}

fn pointer_quad(address: usize) -> Quad {
    Quad::from_doublewords([address as u64, 0])
}

/// The initial values of a program's registers.
pub(crate) struct StartRegisters {
    arguments: [Quad; 3],
    local_store: Quad,
}

impl StartRegisters {
    fn new(
        spe: *mut SpeContext,
        context: &Context,
        flags: c_uint,
        argp: *mut c_void,
        envp: *mut c_void,
    ) -> Result<Self, Errno> {
        let arguments = if flags & SPE_RUN_USER_REGS != 0 {
            let mut bytes = [0; USER_REGISTERS];
            ProcessMemory
                .read(argp.expose_provenance() as u64, &mut bytes)
                .map_err(|_| Errno(libc::EFAULT))?;
            let quad =
                |n: usize| Quad::from_bytes(std::array::from_fn(|byte| bytes[n * 16 + byte]));
            [quad(0), quad(1), quad(2)]
        } else {
            [
                pointer_quad(spe.expose_provenance()),
                pointer_quad(argp.expose_provenance()),
                pointer_quad(envp.expose_provenance()),
            ]
        };
        let area = context.backend.local_store();
        Ok(Self { arguments, local_store: pointer_quad(area.expose_provenance()) })
    }

    /// Registers 3 to 6.
    pub(crate) fn arguments(&self) -> [Quad; 4] {
        let [first, second, third] = self.arguments;
        [first, second, third, self.local_store]
    }

    /// Sets the registers of an emulated SPU.
    pub(crate) fn set(&self, store: &LocalStore, spu: &mut Spu) {
        const FIRST_ARGUMENT: u8 = 3;
        let top = SIZE - START_BLOCK as u32;
        store.write(top, &[0; START_BLOCK]);
        spu.set_register(1, Quad::scalar(STACK_TOP));
        spu.set_register(2, Quad::ZERO);
        for (register, value) in (FIRST_ARGUMENT..).zip(self.arguments()) {
            spu.set_register(register, value);
        }
    }
}

/// Runs a context on the calling thread until a stop must be reported to the program. `*entry` is
/// the address to start at, and afterwards the address to continue at.
///
/// # Safety
/// `spe` is NULL or a live context; `entry` and `stopinfo` are NULL or valid. The SPU program and
/// registered callbacks access only memory that they were given.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn spe_context_run(
    spe: *mut SpeContext,
    entry: *mut c_uint,
    runflags: c_uint,
    argp: *mut c_void,
    envp: *mut c_void,
    stopinfo: *mut SpeStopInfo,
) -> c_int {
    error::int(|| {
        // SAFETY: the caller vouches for the pointer.
        let context = unsafe { context(spe)? };
        if entry.is_null() {
            return Err(Errno(libc::EINVAL));
        }
        let program_entry = context.entry.load(SeqCst);
        // SAFETY: the caller vouches for the pointer.
        let asked = unsafe { entry.read() };
        let mut at = if asked == SPE_DEFAULT_ENTRY { program_entry } else { asked };
        let mut registers = if at == program_entry {
            Some(StartRegisters::new(spe, &context, runflags, argp, envp)?)
        } else {
            None
        };
        let outcome = loop {
            let start = registers.take();
            let (npc, ended) = context.backend.run(at, start.as_ref());
            let next = match ended {
                Ended::Stop { code, status } => after_stop(&context, runflags, code, status, npc),
                Ended::Resume => Next::Resume(npc),
                Ended::Return(outcome) => Next::Return(outcome),
            };
            at = npc;
            match next {
                Next::Resume(npc) => at = npc,
                Next::Return(outcome) => break outcome,
            }
        };
        context.backend.stopped(outcome.record.spu_status, at);
        // SAFETY: the caller vouches for the pointers.
        unsafe {
            entry.write(at);
            if !stopinfo.is_null() {
                stopinfo.write(outcome.record.to_c());
            }
        }
        if context.events_enabled {
            context.backend.change(&mut || context.stops.append(outcome.record));
        }
        outcome.returned
    })
}

/// Takes the oldest unread stop record. Fails with EAGAIN if there is none.
///
/// # Safety
/// `spe` is NULL or a live context, `stopinfo` valid.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn spe_stop_info_read(
    spe: *mut SpeContext,
    stopinfo: *mut SpeStopInfo,
) -> c_int {
    error::int(|| {
        // SAFETY: the caller vouches for the pointer.
        let context = unsafe { context(spe)? };
        if !context.events_enabled {
            return Err(Errno(libc::ENOTSUP));
        }
        if stopinfo.is_null() {
            return Err(Errno(libc::EINVAL));
        }
        let mut taken = None;
        context.backend.act(&mut || taken = context.stops.take());
        let record = taken.ok_or(Errno(libc::EAGAIN))?;
        // SAFETY: the caller vouches for the pointer.
        unsafe { stopinfo.write(record.to_c()) };
        set_errno(0);
        Ok(0)
    })
}
