//! Proxy DMA: the program moves data between local store and its own memory.

use std::sync::PoisonError;

use libc::{c_int, c_uint, c_void};
use spu_emulator::mfc::MAX_TRANSFER;
use spu_emulator::spe::{ProxyCommand, TagWait};

use crate::context::{Context, context};
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

/// Makes the kernel's checks of a command before it reaches the hardware.
fn kernel_accepts(command: &ProxyCommand, tid: c_uint, rid: c_uint) -> bool {
    let ls_low = command.lsa & 15;
    let aligned = match command.size & 15 {
        0 => ls_low == 0,
        n @ (1 | 2 | 4 | 8) => ls_low.is_multiple_of(n),
        _ => false,
    };
    aligned
        && ls_low == command.ea as u32 & 15
        && command.size <= MAX_TRANSFER
        && tid == 0
        && rid == 0
}

struct Transfer {
    opcode: u32,
    ls: c_uint,
    ea: *mut c_void,
    size: c_uint,
    tag: c_uint,
    tid: c_uint,
    rid: c_uint,
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
        let command = ProxyCommand {
            opcode: transfer.opcode,
            lsa: transfer.ls,
            ea: transfer.ea.expose_provenance() as u64,
            size: transfer.size,
            tag,
        };
        // The kernel does not see commands that go to mapped registers.
        if context.areas.is_none() && !kernel_accepts(&command, tid, rid) {
            return Err(Errno(libc::EIO));
        }
        // Marked as issued before it is queued, so that whoever learns of its completion finds it
        // in the set.
        *issued(&context) |= 1 << tag;
        match context.spe.proxy_command(command) {
            Ok(()) => Ok(0),
            Err(error) if context.areas.is_some() => {
                context.spe.proxy_failed(error);
                Ok(0)
            }
            Err(_) => Err(Errno(libc::EIO)),
        }
    })
}

fn issued(context: &Context) -> std::sync::MutexGuard<'_, u32> {
    context
        .issued_tags
        .lock()
        .unwrap_or_else(PoisonError::into_inner)
}

fn asked(mask: u32, issued: u32) -> u32 {
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

/// Whether a tag is complete and has not been reported yet.
pub(crate) fn tag_waiting(context: &Context) -> bool {
    let tags = *issued(context);
    tags != 0 && context.spe.proxy_tags(tags, TagWait::Immediate) != 0
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
        let tags = *issued(&context);
        let complete = match (&context.areas, wait) {
            (None, wait) => {
                let complete = context.spe.proxy_tags(tags, wait);
                *issued(&context) &= !complete;
                complete
            }
            (Some(_), TagWait::Immediate) => context.spe.proxy_tags(asked(mask, tags), wait),
            (Some(_), _) => context.spe.proxy_tags(asked(mask, tags), TagWait::All),
        };
        // SAFETY: the caller vouches for the pointer.
        unsafe { tag_status.write(complete) };
        Ok(0)
    })
}
