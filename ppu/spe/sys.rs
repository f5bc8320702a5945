//! The part of libspe2's C API that this program uses, as its headers declare it.
//!
//! The library is selected at link time: the console's libspe2.so.2, or on other hosts this
//! project's own, which is linked in.

#![allow(non_camel_case_types, reason = "the C names")]

use std::ffi::{c_int, c_uint, c_void};

/// An opaque type. An SPU program receives its address as the first argument.
#[repr(C)]
pub struct spe_context {
    _private: [u8; 0],
}
pub type spe_context_ptr_t = *mut spe_context;
pub type spe_gang_context_ptr_t = *mut c_void;
pub type spe_event_handler_ptr_t = *mut c_void;

#[repr(C)]
pub struct spe_program_handle_t {
    pub handle_size: c_uint,
    pub elf_image: *const c_void,
    pub toe_shadow: *const c_void,
}

/// The C header has a union with a 64-bit member here. `result` stands for its `int` members,
/// which are all at its beginning.
#[repr(C, align(8))]
#[derive(Clone, Copy, Default)]
pub struct spe_stop_info_t {
    pub stop_reason: c_uint,
    pub padding: c_uint,
    pub result: c_int,
    pub result_rest: c_int,
    pub spu_status: c_int,
}

/// `data` stands for the union of the C header, with its member `u64`.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct spe_event_unit_t {
    pub events: c_uint,
    pub spe: spe_context_ptr_t,
    pub data: u64,
}

#[cfg(target_pointer_width = "64")]
const _: () = {
    use std::mem::offset_of;
    assert!(size_of::<spe_program_handle_t>() == 24);
    assert!(offset_of!(spe_program_handle_t, elf_image) == 8);
    assert!(size_of::<spe_stop_info_t>() == 24);
    assert!(offset_of!(spe_stop_info_t, result) == 8);
    assert!(offset_of!(spe_stop_info_t, spu_status) == 16);
    assert!(size_of::<spe_event_unit_t>() == 24);
    assert!(offset_of!(spe_event_unit_t, data) == 16);
};

pub const SPE_EVENTS_ENABLE: c_uint = 0x1000;
pub const SPE_MAP_PS: c_uint = 0x40;
pub const SPE_DEFAULT_ENTRY: c_uint = 0xffff_ffff;

pub const SPE_EXIT: c_uint = 1;
pub const SPE_STOP_AND_SIGNAL: c_uint = 2;
pub const SPE_RUNTIME_ERROR: c_uint = 3;
pub const SPE_RUNTIME_EXCEPTION: c_uint = 4;

pub const SPE_SPU_HALT: c_int = 0x04;
pub const SPE_SPU_INVALID_INSTR: c_int = 0x20;
pub const SPE_SPU_INVALID_CHANNEL: c_int = 0x40;

pub const SPE_DMA_ALIGNMENT: c_int = 0x0008;
pub const SPE_DMA_STORAGE: c_int = 0x0040;
pub const SPE_INVALID_DMA: c_int = 0x0800;

pub const SPE_EVENT_OUT_INTR_MBOX: c_uint = 1;
pub const SPE_EVENT_SPE_STOPPED: c_uint = 8;

pub const SPE_MBOX_ALL_BLOCKING: c_uint = 1;
pub const SPE_MBOX_ANY_NONBLOCKING: c_uint = 3;

pub const SPE_SIG_NOTIFY_REG_1: c_uint = 1;
pub const SPE_SIG_NOTIFY_1_AREA: c_uint = 3;
/// The offset of the register in that area.
pub const SPE_SIG_NOTIFY_1_REGISTER: u64 = 12;

pub const SPE_COUNT_USABLE_SPES: c_int = 3;

unsafe extern "C" {
    pub fn spe_context_create(flags: c_uint, gang: spe_gang_context_ptr_t) -> spe_context_ptr_t;
    pub fn spe_context_destroy(spe: spe_context_ptr_t) -> c_int;
    pub fn spe_program_load(spe: spe_context_ptr_t, program: *mut spe_program_handle_t) -> c_int;
    pub fn spe_context_run(
        spe: spe_context_ptr_t,
        entry: *mut c_uint,
        runflags: c_uint,
        argp: *mut c_void,
        envp: *mut c_void,
        stopinfo: *mut spe_stop_info_t,
    ) -> c_int;
    pub fn spe_stop_info_read(spe: spe_context_ptr_t, stopinfo: *mut spe_stop_info_t) -> c_int;
    pub fn spe_event_handler_create() -> spe_event_handler_ptr_t;
    pub fn spe_event_handler_destroy(handler: spe_event_handler_ptr_t) -> c_int;
    pub fn spe_event_handler_register(
        handler: spe_event_handler_ptr_t,
        event: *mut spe_event_unit_t,
    ) -> c_int;
    pub fn spe_event_wait(
        handler: spe_event_handler_ptr_t,
        events: *mut spe_event_unit_t,
        max_events: c_int,
        timeout: c_int,
    ) -> c_int;
    pub fn spe_in_mbox_write(
        spe: spe_context_ptr_t,
        data: *mut c_uint,
        count: c_int,
        behavior: c_uint,
    ) -> c_int;
    pub fn spe_signal_write(spe: spe_context_ptr_t, signal_reg: c_uint, data: c_uint) -> c_int;
    pub fn spe_in_mbox_status(spe: spe_context_ptr_t) -> c_int;
    pub fn spe_out_intr_mbox_read(
        spe: spe_context_ptr_t,
        data: *mut c_uint,
        count: c_int,
        behavior: c_uint,
    ) -> c_int;
    pub fn spe_ps_area_get(spe: spe_context_ptr_t, area: c_uint) -> *mut c_void;
    pub fn spe_ls_area_get(spe: spe_context_ptr_t) -> *mut c_void;
    pub fn spe_ls_size_get(spe: spe_context_ptr_t) -> c_int;
    pub fn spe_cpu_info_get(info_requested: c_int, cpu_node: c_int) -> c_int;
}
