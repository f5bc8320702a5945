//! The effects of environment variables. This is a separate program without the test harness,
//! because only a process without other threads may change its environment.

#![allow(clippy::print_stdout, reason = "a test has nothing to lose but its output")]

use std::env;
use std::ptr;

use spe2::context::{spe_context_create, spe_context_destroy, spe_ls_area_get};
use spe2::cpu_info::spe_cpu_info_get;
use spe2::mfc::{spe_mfcio_put, spe_mfcio_tag_status_read};
use spe2::types::SPE_TAG_IMMEDIATE;

#[repr(align(16))]
struct Quadword([u8; 16]);

fn set(name: &str, value: &str) {
    // SAFETY: this process has no other thread.
    unsafe { env::set_var(name, value) };
}

fn errno() -> Option<i32> {
    std::io::Error::last_os_error().raw_os_error()
}

fn spes() -> i32 {
    // SAFETY: the call takes no pointers.
    unsafe { spe_cpu_info_get(3, -1) }
}

/// Puts by proxy DMA. Returns the content of memory after the put, after reading the tag status,
/// and after reading it again.
fn put_and_look_twice() -> [u8; 3] {
    let mut there = Quadword([0; 16]);
    let pointer = there.0.as_mut_ptr();
    let mut status = 0;
    // SAFETY: the context lives to the end of the block, and `there` and `status` live longer.
    unsafe {
        let context = spe_context_create(0, ptr::null_mut());
        assert!(!context.is_null());
        spe_ls_area_get(context).cast::<u8>().write(1);
        let queued = spe_mfcio_put(context, 0, pointer.cast(), 16, 0, 0, 0);
        assert_eq!(queued, 0);
        let mut look = || {
            let read = spe_mfcio_tag_status_read(context, 1, SPE_TAG_IMMEDIATE, &raw mut status);
            assert_eq!(read, 0);
            status as u8
        };
        let seen = [pointer.read_volatile(), look(), look()];
        assert_eq!(spe_context_destroy(context), 0);
        assert_eq!(there.0[0], 1);
        seen
    }
}

/// Fails to create a context, and returns the errno.
fn refusal() -> Option<i32> {
    // SAFETY: a context needs no gang.
    let refused = unsafe { spe_context_create(0, ptr::null_mut()) };
    assert!(refused.is_null());
    errno()
}

fn main() {
    // A machine for tests has no SPEs. A wrong choice is refused each time, and none is made.
    for (backend, timing, expected) in [
        ("spufs", "0", libc::ENOSYS),
        ("spufs", "1", libc::EINVAL),
        ("hardware", "0", libc::EINVAL),
        ("", "0", libc::EINVAL),
    ] {
        set("LIBSPE2_BACKEND", backend);
        set("LIBSPE2_TIMING", timing);
        assert_eq!(refusal(), Some(expected), "{backend} {timing}");
    }
    set("LIBSPE2_BACKEND", "emulator");
    set("LIBSPE2_TIMING", "0");

    for (value, expected) in [("1", 1), ("16", 16), ("6", 6)] {
        set("LIBSPE2_SPES", value);
        assert_eq!(spes(), expected);
    }
    for value in ["0", "17", "-1", "six", ""] {
        set("LIBSPE2_SPES", value);
        assert_eq!((spes(), errno()), (-1, Some(libc::EINVAL)), "{value}");
    }

    // Values that don't exist are refused before there is a machine.
    for (engine, check) in [("fast", "0"), ("compiler", "yes"), ("interpreter", "1")] {
        set("LIBSPE2_ENGINE", engine);
        set("LIBSPE2_CHECK", check);
        assert_eq!(refusal(), Some(libc::EINVAL), "{engine} {check}");
    }
    set("LIBSPE2_ENGINE", "compiler");
    set("LIBSPE2_CHECK", "1");

    // With `at-once`, the data is in memory and reported at once. With `at-last`, it arrives later
    // and is reported by the second read.
    assert_eq!(put_and_look_twice(), [1, 1, 0]);
    set("LIBSPE2_MFC", "at-once");
    assert_eq!(put_and_look_twice(), [1, 1, 0]);
    set("LIBSPE2_MFC", "at-last");
    assert_eq!(put_and_look_twice(), [0, 0, 1]);
    set("LIBSPE2_MFC", "sometimes");
    assert_eq!(refusal(), Some(libc::EINVAL));
    println!("environment: ok");
}
