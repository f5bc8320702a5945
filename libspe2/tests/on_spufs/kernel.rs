//! Effects that only the kernel's side shows.

use std::ptr;
use std::sync::atomic::{AtomicBool, Ordering::SeqCst};

use spe2::context::{
    spe_context_create, spe_context_create_affinity, spe_gang_context_create,
    spe_gang_context_destroy,
};
use spe2::event::{spe_event_handler_create, spe_event_handler_destroy, spe_event_wait};
use spe2::mailbox::spe_out_intr_mbox_read;
use spe2::mfc::{spe_mfcio_get, spe_mfcio_tag_status_read};
use spe2::types::{
    SPE_MAP_PS, SPE_MBOX_ALL_BLOCKING, SPE_NOSCHED, SPE_TAG_ALL, SPE_TAG_IMMEDIATE, SpeEventData,
    SpeEventUnit,
};

use crate::support::{Aligned, Context, assert_fails, assert_null, elsewhere};

/// The number of `spu_create`, which other processors do not have.
const SPU_CREATE: libc::c_long =
    if cfg!(any(target_arch = "powerpc", target_arch = "powerpc64")) { 279 } else { -279 };

/// The library's contexts are the kernel's, by the names that IBM's library gives them.
#[test]
fn contexts_have_named_folders() {
    let context = Context::new(0);
    let number = context.pointer().addr();
    let name = format!("/spu/spethread-{}-{number}", std::process::id());
    let name = std::ffi::CString::new(name).unwrap();
    let create = || {
        let (flags, mode): (libc::c_long, libc::c_long) = (0, 0o700);
        unsafe { libc::syscall(SPU_CREATE, name.as_ptr(), flags, mode) as i32 }
    };
    assert_fails(create(), libc::EEXIST);
    drop(context);
    let again = create();
    assert!(again >= 0);
    assert_eq!(unsafe { libc::close(again) }, 0);
}

#[test]
fn contexts_of_gang_are_not_in_its_folder() {
    let gang = unsafe { spe_gang_context_create(0) };
    assert!(!gang.is_null());
    let context = Context::owning(unsafe { spe_context_create(0, gang) });
    // Newer kernels remove a gang's folder with the first context in it, so it has none.
    let name = format!("/spu/spethread-{}-{}", std::process::id(), context.pointer().addr());
    let name = std::ffi::CString::new(name).unwrap();
    let again = unsafe { libc::syscall(SPU_CREATE, name.as_ptr(), 0 as libc::c_long, 0o700) };
    assert_fails(again as i32, libc::EEXIST);
    unsafe {
        assert_eq!(spe_gang_context_destroy(gang), 0);
    }
    context.load("stop 0x2003");
    let stop = elsewhere(|| context.run(), || ());
    assert_eq!(stop.code, 3);
}

#[test]
fn affinity_is_refused_by_kernel() {
    let gang = unsafe { spe_gang_context_create(0) };
    let neighbor = Context::owning(unsafe { spe_context_create(0, gang) });
    assert_null(unsafe { spe_context_create_affinity(0, neighbor.pointer(), gang) }, libc::EINVAL);
    assert_eq!(unsafe { spe_gang_context_destroy(gang) }, 0);
}

#[test]
fn nosched_context_requires_root() {
    let context = unsafe { spe_context_create(SPE_NOSCHED, ptr::null_mut()) };
    if unsafe { libc::geteuid() } == 0 {
        drop(Context::owning(context));
    } else {
        assert_null(context, libc::EPERM);
    }
}

/// A context's number follows from its address, which the next context may get again.
#[test]
fn destroyed_context_leaves_no_folder() {
    for _ in 0..50 {
        let context = Context::new(SPE_MAP_PS);
        assert_eq!(context.local_store(0, 4), [0; 4]);
        context.set_local_store(0, &[1; 4]);
    }
}

/// A proxy command by the file waits until a thread runs the context.
#[test]
fn proxy_command_waits_for_run() {
    let context = Context::new(0);
    let mut there = Aligned::<16>::new();
    there.0 = [5; 16];
    let pointer = there.ea() as usize;
    let queued = AtomicBool::new(false);
    let give = || {
        let ea = ptr::with_exposed_provenance_mut(pointer);
        let got = unsafe { spe_mfcio_get(context.pointer(), 0x8000, ea, 16, 2, 0, 0) };
        queued.store(true, SeqCst);
        got
    };
    // Meanwhile its tag is in use and not complete, and asking for it does not wait.
    let ask = || {
        let mut status = u32::MAX;
        let status_ptr = &raw mut status;
        let read = unsafe {
            spe_mfcio_tag_status_read(context.pointer(), 0, SPE_TAG_IMMEDIATE, status_ptr)
        };
        (read, status)
    };
    let got = elsewhere(give, || {
        std::thread::sleep(std::time::Duration::from_millis(50));
        assert!(!queued.load(SeqCst));
        assert_eq!(elsewhere(ask, || ()), (0, 0));
        context.while_it_runs(|| {
            while !queued.load(SeqCst) {
                std::thread::yield_now();
            }
        });
    });
    assert_eq!(got, 0);
    let mut status = 0;
    for (behavior, tags) in [(SPE_TAG_ALL, 4), (SPE_TAG_IMMEDIATE, 0)] {
        let read =
            unsafe { spe_mfcio_tag_status_read(context.pointer(), 0, behavior, &raw mut status) };
        assert_eq!((read, status), (0, tags));
    }
    assert_eq!(context.local_store(0x8000, 16), [5; 16]);
}

extern "C" fn ignore(_: i32) {}

/// Calls `body` on another thread, to which signals are sent until it returns. The program has a
/// handler for it that does nothing.
fn interrupted(body: impl FnOnce() -> (i32, i32) + Send) -> (i32, i32) {
    let signal = libc::SIGUSR2;
    unsafe {
        let mut action = std::mem::MaybeUninit::<libc::sigaction>::zeroed().assume_init();
        action.sa_sigaction = ignore as *const () as usize;
        assert_eq!(libc::sigaction(signal, &raw const action, ptr::null_mut()), 0);
    }
    let (sender, thread) = std::sync::mpsc::channel();
    let (over, ended) = std::sync::mpsc::channel();
    let has_returned = &AtomicBool::new(false);
    let wait = move || {
        sender.send(unsafe { libc::pthread_self() }).unwrap();
        let result = body();
        has_returned.store(true, SeqCst);
        // The thread must not end while it may still be sent a signal.
        ended.recv().unwrap();
        result
    };
    elsewhere(wait, || {
        let thread = thread.recv().unwrap();
        // It may not wait yet when the first one comes.
        while !has_returned.load(SeqCst) {
            assert_eq!(unsafe { libc::pthread_kill(thread, signal) }, 0);
            std::thread::sleep(std::time::Duration::from_millis(10));
        }
        over.send(()).unwrap();
    })
}

#[test]
fn signal_ends_wait_for_mailbox() {
    let context = Context::new(0);
    let result = interrupted(|| {
        let mut word = 0;
        let read = unsafe {
            spe_out_intr_mbox_read(context.pointer(), &raw mut word, 1, SPE_MBOX_ALL_BLOCKING)
        };
        (read, crate::support::last_errno())
    });
    assert_eq!(result, (-1, libc::EIO));
}

#[test]
fn signal_ends_event_wait_with_timeout() {
    let (count, _) = interrupted(|| unsafe {
        let handler = spe_event_handler_create();
        let mut unit =
            SpeEventUnit { events: 0, spe: ptr::null_mut(), data: SpeEventData { u64: 0 } };
        let count = spe_event_wait(handler, &raw mut unit, 1, 3_600_000);
        (count, spe_event_handler_destroy(handler))
    });
    assert_eq!(count, 0);
}
