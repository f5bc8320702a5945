//! The C types and constants of `libspe2.h` and `libspe2-types.h`. Their layouts are checked when
//! this is compiled.

use std::mem::{align_of, offset_of};

use libc::{c_int, c_uint, c_void};

/// `spe_program_handle_t`: an SPU ELF image in memory.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct SpeProgramHandle {
    /// Size of this handle in bytes.
    pub handle_size: c_uint,
    /// The complete SPU ELF file.
    pub elf_image: *mut c_void,
    /// The initial content of `.toe`, or NULL.
    pub toe_shadow: *mut c_void,
}

/// `struct spe_context`: opaque to programs.
#[repr(C)]
#[derive(Debug)]
pub struct SpeContext {
    pub(crate) handle: SpeProgramHandle,
    pub(crate) base_private: *mut c_void,
    pub(crate) event_private: *mut c_void,
}

/// `struct spe_gang_context`: opaque to programs.
#[repr(C)]
#[derive(Debug)]
pub struct SpeGangContext {
    pub(crate) base_private: *mut c_void,
    pub(crate) event_private: *mut c_void,
}

/// The `result` of `spe_stop_info_t`: every int member is at its start.
#[repr(C)]
#[derive(Clone, Copy)]
pub union SpeStopResult {
    /// `spe_exit_code`, `spe_signal_code`, `spe_runtime_error`, `spe_runtime_exception`,
    /// `spe_runtime_fatal`, `spe_callback_error`, `spe_isolation_error`
    pub code: c_int,
    /// Reserved.
    pub reserved_pointer: *mut c_void,
    /// Reserved.
    pub reserved: u64,
}

/// `spe_stop_info_t`
#[repr(C)]
#[derive(Clone, Copy)]
pub struct SpeStopInfo {
    /// One of the stop reasons.
    pub stop_reason: c_uint,
    /// The value that goes with the reason.
    pub result: SpeStopResult,
    /// The SPU status register, or -1.
    pub spu_status: c_int,
}

/// `spe_event_data_t`: data of the program's own.
#[repr(C)]
#[derive(Clone, Copy)]
pub union SpeEventData {
    /// As a pointer.
    pub ptr: *mut c_void,
    /// As a word.
    pub u32: c_uint,
    /// As a doubleword.
    pub u64: u64,
}

/// `spe_event_unit_t`
#[repr(C)]
#[derive(Clone, Copy)]
pub struct SpeEventUnit {
    /// Event bits.
    pub events: c_uint,
    /// The context.
    pub spe: *mut SpeContext,
    /// Data of the program's own.
    pub data: SpeEventData,
}

/// Layouts of 64-bit programs, and of 32-bit programs.
const fn of_width(wide: usize, narrow: usize) -> usize {
    if cfg!(target_pointer_width = "64") { wide } else { narrow }
}

const _: () = {
    assert!(size_of::<SpeProgramHandle>() == of_width(24, 12));
    assert!(offset_of!(SpeProgramHandle, elf_image) == of_width(8, 4));
    assert!(offset_of!(SpeProgramHandle, toe_shadow) == of_width(16, 8));
    assert!(size_of::<SpeContext>() == of_width(40, 20));
    assert!(offset_of!(SpeContext, base_private) == of_width(24, 12));
    assert!(offset_of!(SpeContext, event_private) == of_width(32, 16));
    assert!(size_of::<SpeGangContext>() == of_width(16, 8));
    assert!(size_of::<SpeStopInfo>() == 24);
    assert!(align_of::<SpeStopInfo>() == 8);
    assert!(offset_of!(SpeStopInfo, result) == 8);
    assert!(offset_of!(SpeStopInfo, spu_status) == 16);
    assert!(size_of::<SpeEventData>() == 8);
    assert!(size_of::<SpeEventUnit>() == of_width(24, 16));
    assert!(offset_of!(SpeEventUnit, spe) == of_width(8, 4));
    assert!(offset_of!(SpeEventUnit, data) == of_width(16, 8));
};

/// Creation flag: signal register 1 is in OR mode.
pub const SPE_CFG_SIGNOTIFY1_OR: c_uint = 0x10;
/// Creation flag: signal register 2 is in OR mode.
pub const SPE_CFG_SIGNOTIFY2_OR: c_uint = 0x20;
/// Creation flag: map the problem state.
pub const SPE_MAP_PS: c_uint = 0x40;
/// Creation flag: isolation mode. Not available on a PlayStation 3.
pub const SPE_ISOLATE: c_uint = 0x80;
/// Creation flag: emulated isolation mode.
pub const SPE_ISOLATE_EMULATE: c_uint = 0x100;
/// Creation flag: enable events and stop records.
pub const SPE_EVENTS_ENABLE: c_uint = 0x1000;
/// Creation flag: an SPE near to memory.
pub const SPE_AFFINITY_MEMORY: c_uint = 0x2000;
/// Creation flag: never preempted. For privileged users.
pub const SPE_NOSCHED: c_uint = 0x4000;

/// Run flag: `argp` points at registers 3 to 5.
pub const SPE_RUN_USER_REGS: c_uint = 1;
/// Run flag: report the SPU's library calls as stops.
pub const SPE_NO_CALLBACKS: c_uint = 2;
/// Entry point: the one that the loaded program names.
pub const SPE_DEFAULT_ENTRY: c_uint = 0xffff_ffff;

/// Stop reason: the program has ended.
pub const SPE_EXIT: c_uint = 1;
/// Stop reason: a stop instruction.
pub const SPE_STOP_AND_SIGNAL: c_uint = 2;
/// Stop reason: the SPU halted or met something that it can't run.
pub const SPE_RUNTIME_ERROR: c_uint = 3;
/// Stop reason: a DMA error.
pub const SPE_RUNTIME_EXCEPTION: c_uint = 4;
/// Stop reason: the run itself failed.
pub const SPE_RUNTIME_FATAL: c_uint = 5;
/// Stop reason: a library call had no handler, or its handler failed.
pub const SPE_CALLBACK_ERROR: c_uint = 6;
/// Stop reason: isolation.
pub const SPE_ISOLATION_ERROR: c_uint = 7;

/// SPU status: stopped by a stop instruction.
pub const SPE_SPU_STOPPED_BY_STOP: c_int = 0x02;
/// Runtime error and SPU status: halt.
pub const SPE_SPU_HALT: c_int = 0x04;
/// SPU status: waiting on a channel.
pub const SPE_SPU_WAITING_ON_CHANNEL: c_int = 0x08;
/// Runtime error and SPU status: invalid instruction.
pub const SPE_SPU_INVALID_INSTR: c_int = 0x20;
/// Runtime error and SPU status: invalid channel.
pub const SPE_SPU_INVALID_CHANNEL: c_int = 0x40;

/// Runtime exception: DMA alignment.
pub const SPE_DMA_ALIGNMENT: c_int = 0x0008;
/// Runtime exception: main memory that is not mapped.
pub const SPE_DMA_STORAGE: c_int = 0x0040;
/// Runtime exception: invalid DMA command.
pub const SPE_INVALID_DMA: c_int = 0x0800;

/// Event: a word in the outbound interrupt mailbox.
pub const SPE_EVENT_OUT_INTR_MBOX: c_uint = 1;
/// Event: a free entry in the inbound mailbox.
pub const SPE_EVENT_IN_MBOX: c_uint = 2;
/// Event: a proxy tag is complete.
pub const SPE_EVENT_TAG_GROUP: c_uint = 4;
/// Event: a run has ended.
pub const SPE_EVENT_SPE_STOPPED: c_uint = 8;
/// Every event.
pub const SPE_EVENT_ALL_EVENTS: c_uint = 0xf;

/// Mailbox behaviour: wait until all words are moved.
pub const SPE_MBOX_ALL_BLOCKING: c_uint = 1;
/// Mailbox behaviour: wait until one word is moved.
pub const SPE_MBOX_ANY_BLOCKING: c_uint = 2;
/// Mailbox behaviour: move as many words as possible without waiting.
pub const SPE_MBOX_ANY_NONBLOCKING: c_uint = 3;

/// Tag behaviour: wait for all tags.
pub const SPE_TAG_ALL: c_uint = 1;
/// Tag behaviour: wait for any tag.
pub const SPE_TAG_ANY: c_uint = 2;
/// Tag behaviour: do not wait.
pub const SPE_TAG_IMMEDIATE: c_uint = 3;

/// Callback mode: register in a free slot.
pub const SPE_CALLBACK_NEW: c_uint = 1;
/// Callback mode: replace the handler in a used slot.
pub const SPE_CALLBACK_UPDATE: c_uint = 2;

/// CPU information: number of Cell processors.
pub const SPE_COUNT_PHYSICAL_CPU_NODES: c_int = 1;
/// CPU information: number of SPEs.
pub const SPE_COUNT_PHYSICAL_SPES: c_int = 2;
/// CPU information: number of SPEs that programs can use.
pub const SPE_COUNT_USABLE_SPES: c_int = 3;
/// CPU information: kind of Cell.
pub const SPE_CPU_TYPE: c_int = 4;
/// The first Cell/B.E., the PlayStation 3's.
pub const SPE_CPU_IS_CELLBE: c_int = 1;
/// The PowerXCell 8i, with fast double precision.
pub const SPE_CPU_IS_CELLEDP: c_int = 2;

/// Signal register 1.
pub const SPE_SIG_NOTIFY_REG_1: c_uint = 1;
/// Signal register 2.
pub const SPE_SIG_NOTIFY_REG_2: c_uint = 2;

/// The last `enum ps_area`: signal notification 2.
pub const SPE_SIG_NOTIFY_2_AREA: c_uint = 4;
