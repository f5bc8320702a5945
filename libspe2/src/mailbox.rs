//! Mailboxes, signal notification and multisource synchronisation.

use libc::{c_int, c_uint};
use spu_emulator::signal::SignalRegister;

use crate::backend::Backend;
use crate::context::context;
use crate::error::{self, Errno, set_errno};
use crate::types::{
    SPE_MBOX_ALL_BLOCKING, SPE_MBOX_ANY_BLOCKING, SPE_MBOX_ANY_NONBLOCKING, SPE_SIG_NOTIFY_REG_1,
    SPE_SIG_NOTIFY_REG_2, SpeContext,
};

/// How many of `count` words a behaviour waits for: all words before this index.
fn words_to_wait_for(count: usize, behavior: c_uint) -> Result<usize, Errno> {
    match behavior {
        SPE_MBOX_ALL_BLOCKING => Ok(count),
        SPE_MBOX_ANY_BLOCKING => Ok(1),
        SPE_MBOX_ANY_NONBLOCKING => Ok(0),
        _ => Err(Errno(libc::EINVAL)),
    }
}

fn checked_count(data: *mut c_uint, count: c_int) -> Result<usize, Errno> {
    match usize::try_from(count) {
        Ok(count) if count > 0 && !data.is_null() => Ok(count),
        _ => Err(Errno(libc::EINVAL)),
    }
}

/// Moves words one by one, waiting for each of the first `wait_for`. Returns how many were moved.
fn move_words(
    count: usize,
    wait_for: usize,
    mut one: impl FnMut(usize, bool) -> Result<bool, Errno>,
) -> Result<c_int, Errno> {
    let mut moved = 0;
    while moved < count && one(moved, moved < wait_for)? {
        moved += 1;
    }
    if moved == 0 {
        set_errno(0);
    }
    Ok(moved as c_int)
}

/// Reads up to `count` words of `take` into `data`.
///
/// # Safety
/// `data` is a buffer for `count` words.
unsafe fn read_words(
    data: *mut c_uint,
    count: usize,
    wait_for: usize,
    take: impl Fn(bool) -> Result<Option<u32>, Errno>,
) -> Result<c_int, Errno> {
    move_words(count, wait_for, |at, wait| {
        let word = take(wait)?;
        if let Some(word) = word {
            // SAFETY: `at` is less than `count`, for which the caller vouches.
            unsafe { data.add(at).write(word) };
        }
        Ok(word.is_some())
    })
}

/// Reads the words in the outbound mailbox without waiting.
///
/// # Safety
/// `spe` is NULL or a live context; `data` is NULL or a buffer for `count` words.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn spe_out_mbox_read(
    spe: *mut SpeContext,
    data: *mut c_uint,
    count: c_int,
) -> c_int {
    error::int(|| {
        // SAFETY: the caller vouches for the pointer.
        let context = unsafe { context(spe)? };
        let count = checked_count(data, count)?;
        // SAFETY: the caller vouches for the buffer.
        unsafe { read_words(data, count, 0, |_| context.backend.read_outbound()) }
    })
}

/// # Safety
/// `spe` is NULL or a live context.
unsafe fn status(
    spe: *mut SpeContext,
    words: impl FnOnce(&dyn Backend) -> Result<usize, Errno>,
) -> c_int {
    error::int(|| {
        // SAFETY: the caller vouches for the pointer.
        let context = unsafe { context(spe)? };
        words(&*context.backend).map(|words| words as c_int)
    })
}

/// Returns the number of words in the outbound mailbox.
///
/// # Safety
/// `spe` is NULL or a live context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn spe_out_mbox_status(spe: *mut SpeContext) -> c_int {
    // SAFETY: the caller vouches for the pointer.
    unsafe { status(spe, |backend| backend.outbound_waiting()) }
}

/// Writes words to the inbound mailbox and returns how many it took.
///
/// # Safety
/// `spe` is NULL or a live context; `data` is NULL or has `count` words.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn spe_in_mbox_write(
    spe: *mut SpeContext,
    data: *mut c_uint,
    count: c_int,
    behavior: c_uint,
) -> c_int {
    error::int(|| {
        // SAFETY: the caller vouches for the pointer.
        let context = unsafe { context(spe)? };
        let count = checked_count(data, count)?;
        let wait_for = words_to_wait_for(count, behavior)?;
        move_words(count, wait_for, |at, wait| {
            // SAFETY: `at` is less than `count`, for which the caller vouches.
            let word = unsafe { data.add(at).read() };
            context.backend.write_inbound(word, wait)
        })
    })
}

/// Returns how many words the inbound mailbox can take.
///
/// # Safety
/// `spe` is NULL or a live context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn spe_in_mbox_status(spe: *mut SpeContext) -> c_int {
    // SAFETY: the caller vouches for the pointer.
    unsafe { status(spe, |backend| backend.inbound_free()) }
}

/// Reads words from the outbound interrupt mailbox and returns how many.
///
/// # Safety
/// `spe` is NULL or a live context; `data` is NULL or a buffer for `count` words.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn spe_out_intr_mbox_read(
    spe: *mut SpeContext,
    data: *mut c_uint,
    count: c_int,
    behavior: c_uint,
) -> c_int {
    error::int(|| {
        // SAFETY: the caller vouches for the pointer.
        let context = unsafe { context(spe)? };
        let count = checked_count(data, count)?;
        let wait_for = words_to_wait_for(count, behavior)?;
        // SAFETY: the caller vouches for the buffer.
        unsafe {
            read_words(data, count, wait_for, |wait| context.backend.read_outbound_interrupt(wait))
        }
    })
}

/// Returns the number of words in the outbound interrupt mailbox.
///
/// # Safety
/// `spe` is NULL or a live context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn spe_out_intr_mbox_status(spe: *mut SpeContext) -> c_int {
    // SAFETY: the caller vouches for the pointer.
    unsafe { status(spe, |backend| backend.outbound_interrupt_waiting()) }
}

/// Writes a signal-notification register without waiting.
///
/// # Safety
/// `spe` is NULL or a live context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn spe_signal_write(
    spe: *mut SpeContext,
    signal_reg: c_uint,
    data: c_uint,
) -> c_int {
    error::int(|| {
        // SAFETY: the caller vouches for the pointer.
        let context = unsafe { context(spe)? };
        let register = match signal_reg {
            SPE_SIG_NOTIFY_REG_1 => SignalRegister::One,
            SPE_SIG_NOTIFY_REG_2 => SignalRegister::Two,
            _ => return Err(Errno(libc::EINVAL)),
        };
        context.backend.signal(register, data).map(|()| 0)
    })
}

/// # Safety
/// `spe` is NULL or a live context.
unsafe fn mssync(spe: *mut SpeContext, body: impl FnOnce(&dyn Backend) -> c_int) -> c_int {
    error::int(|| {
        // SAFETY: the caller vouches for the pointer.
        let context = unsafe { context(spe)? };
        if !context.backend.maps_areas() {
            return Err(Errno(libc::EINVAL));
        }
        Ok(body(&*context.backend))
    })
}

/// Starts a multisource synchronisation. Without a mapped problem state, it fails with EINVAL.
///
/// # Safety
/// `spe` is NULL or a live context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn spe_mssync_start(spe: *mut SpeContext) -> c_int {
    // SAFETY: the caller vouches for the pointer.
    unsafe {
        mssync(spe, |backend| {
            backend.synchronise();
            0
        })
    }
}

/// Returns 0 when a multisource synchronisation is over. Without a mapped problem state, it fails
/// with EINVAL.
///
/// # Safety
/// `spe` is NULL or a live context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn spe_mssync_status(spe: *mut SpeContext) -> c_int {
    // SAFETY: the caller vouches for the pointer.
    unsafe { mssync(spe, |backend| backend.synchronisation() as c_int) }
}
