//! `spu_run`.

use spu_emulator::mfc::DmaError;
use spu_emulator::stop::{Stop, Stopped};

use crate::context::{Context, EVENTS_ENABLED};
use crate::error::Errno;
use crate::fault;
use crate::fault_signal::{After, FaultSignal};
use crate::quick_copy::QuickCopies;
use crate::system_call;

const STOPPED: i32 = 0x02;
const HALTED: i32 = 0x04;
const INVALID_INSTRUCTION: i32 = 0x20;
const INVALID_CHANNEL: i32 = 0x40;

const DMA_ALIGNMENT: u32 = 0x08;
const SPE_ERROR: u32 = 0x10;
const DMA_STORAGE: u32 = 0x40;
const INVALID_DMA: u32 = 0x800;

enum Next {
    Return {
        status: i32,
        event: u32,
    },
    Signal(FaultSignal),
    /// The SPU continues after the stop and the word that follows it.
    Skip,
}

/// The word after a call's stop is data.
const CALL_WORD: u32 = 4;

fn after(context: &Context, stopped: &Stopped) -> Next {
    let events = context.flags & EVENTS_ENABLED != 0;
    let status = |status| Next::Return { status, event: 0 };
    let fault = |status, event, signal| {
        if events { Next::Return { status, event } } else { Next::Signal(signal) }
    };
    match &stopped.reason {
        Stop::Signal(0x2104) if system_call::serve(context.spe().local_store(), stopped.npc) => {
            Next::Skip
        }
        Stop::Signal(0x3fff) => Next::Signal(FaultSignal::breakpoint()),
        Stop::Signal(code) => status(i32::from(*code) << 16 | STOPPED),
        Stop::Halt => status(HALTED),
        Stop::InvalidInstruction(_) => {
            let signal = FaultSignal::invalid_instruction(stopped.pc);
            fault(INVALID_INSTRUCTION, SPE_ERROR, signal)
        }
        Stop::InvalidChannel(..) => status(INVALID_CHANNEL),
        Stop::Dma(DmaError::Alignment { .. }) => {
            fault(0, DMA_ALIGNMENT, FaultSignal::dma_alignment())
        }
        Stop::Dma(DmaError::InvalidCommand { .. }) => {
            fault(0, INVALID_DMA, FaultSignal::invalid_dma())
        }
        Stop::Dma(DmaError::Storage { ea, .. }) => {
            fault(0, DMA_STORAGE, FaultSignal::dma_storage(*ea))
        }
        Stop::Requested | Stop::Waits => status(0),
    }
}

/// Runs a context from `npc`, which is then the address to continue at. Returns the SPU's status
/// and the event word.
pub(crate) fn run(context: &Context, npc: &mut u32) -> Result<(i32, u32), Errno> {
    loop {
        context.run_state.starts();
        while fault::is_silent(context.number) {
            std::thread::park();
        }
        let _copies = QuickCopies::where_handled();
        let stopped = context.loaded(|| context.spe().run(*npc & spu_isa::LIMIT_MASK));
        *npc = stopped.npc;
        let next = after(context, &stopped);
        let status = match &next {
            Next::Return { status, .. } => *status,
            _ => 0,
        };
        context.run_state.stops(status, stopped.npc);
        match next {
            Next::Return { status, event } => return Ok((status, event)),
            Next::Skip => *npc = npc.wrapping_add(CALL_WORD),
            Next::Signal(signal) => {
                if signal.raise() == After::Interrupted {
                    return Err(Errno(libc::EINTR));
                }
            }
        }
    }
}
