//! Proxy DMA: the program moves data between local store and its own memory.

use libc::{c_int, c_uint, c_void};
use spu_emulator::spe::TagWait;

use crate::context::context;
use crate::error::{self, Errno};
use crate::types::{SPE_TAG_ALL, SPE_TAG_ANY, SPE_TAG_IMMEDIATE, SpeContext};

const PUT: u32 = 0x20;
const PUTB: u32 = 0x21;
const PUTF: u32 = 0x22;
const GET: u32 = 0x40;
const GETB: u32 = 0x41;
const GETF: u32 = 0x42;

/// Tags from here on are reserved for the kernel.
const TAGS: c_uint = 16;
const MAX_CLASS: c_uint = 255;

/// A proxy command as the program gives it.
pub(crate) struct Transfer {
    pub opcode: u32,
    pub ls: c_uint,
    pub ea: *mut c_void,
    pub size: c_uint,
    pub tag: c_uint,
    pub tid: c_uint,
    pub rid: c_uint,
}

/// # Safety
/// `spe` is NULL or a live context.
unsafe fn transfer(spe: *mut SpeContext, transfer: &Transfer) -> c_int {
    let &Transfer { tag, tid, rid, .. } = transfer;
    error::int(|| {
        // SAFETY: the caller vouches for the pointer.
        let context = unsafe { context(spe)? };
        if tag >= TAGS || tid > MAX_CLASS || rid > MAX_CLASS {
            return Err(Errno(libc::EINVAL));
        }
        context.backend.transfer(transfer).map(|()| 0)
    })
}

/// The tags that a mask asks about if the problem state is mapped.
pub(crate) fn asked(mask: u32, issued: u32) -> u32 {
    if mask == 0 { issued } else { mask }
}

macro_rules! transfers {
    ($($(#[$doc:meta])* $name:ident, $opcode:ident;)*) => {$(
        $(#[$doc])*
        ///
        /// # Safety
        /// `spe` is NULL or a live context. The memory at `ea` may be anything: an unmapped
        /// address becomes an error of the context's run.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $name(
            spe: *mut SpeContext,
            ls: c_uint,
            ea: *mut c_void,
            size: c_uint,
            tag: c_uint,
            tid: c_uint,
            rid: c_uint,
        ) -> c_int {
            let command = Transfer { opcode: $opcode, ls, ea, size, tag, tid, rid };
            // SAFETY: the caller vouches for the pointer.
            unsafe { transfer(spe, &command) }
        }
    )*};
}

transfers! {
    /// Copies from local store to memory.
    spe_mfcio_put, PUT;
    /// [`spe_mfcio_put`] with a barrier.
    spe_mfcio_putb, PUTB;
    /// [`spe_mfcio_put`] with a fence.
    spe_mfcio_putf, PUTF;
    /// Copies from memory to local store.
    spe_mfcio_get, GET;
    /// [`spe_mfcio_get`] with a barrier.
    spe_mfcio_getb, GETB;
    /// [`spe_mfcio_get`] with a fence.
    spe_mfcio_getf, GETF;
}

/// Stores which of the issued and not yet reported tags are complete, and marks those as reported.
/// `mask` is ignored. With a mapped problem state, it is instead about the tags of `mask`, or about
/// all that were ever issued if that is 0, and waiting for any is waiting for all.
///
/// # Safety
/// `spe` is NULL or a live context, `tag_status` NULL or valid.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn spe_mfcio_tag_status_read(
    spe: *mut SpeContext,
    mask: c_uint,
    behavior: c_uint,
    tag_status: *mut c_uint,
) -> c_int {
    error::int(|| {
        // SAFETY: the caller vouches for the pointer.
        let context = unsafe { context(spe)? };
        let wait = match behavior {
            SPE_TAG_ALL => TagWait::All,
            SPE_TAG_ANY => TagWait::Any,
            SPE_TAG_IMMEDIATE => TagWait::Immediate,
            _ => return Err(Errno(libc::EINVAL)),
        };
        if tag_status.is_null() {
            return Err(Errno(libc::EINVAL));
        }
        let complete = context.backend.tag_status(mask, wait)?;
        // SAFETY: the caller vouches for the pointer.
        unsafe { tag_status.write(complete) };
        Ok(0)
    })
}
