//! Contexts, gangs, mailboxes, signals, areas, machine information, callbacks.

use std::ptr;

use spe2::callback::{
    spe_callback_handler_deregister, spe_callback_handler_query, spe_callback_handler_register,
};
use spe2::context::{
    spe_context_create, spe_context_create_affinity, spe_context_destroy, spe_gang_context_create,
    spe_gang_context_destroy, spe_ls_area_get, spe_ls_size_get, spe_ps_area_get,
};
use spe2::mailbox::{
    spe_in_mbox_status, spe_in_mbox_write, spe_mssync_start, spe_mssync_status,
    spe_out_intr_mbox_read, spe_out_intr_mbox_status, spe_out_mbox_read, spe_out_mbox_status,
    spe_signal_write,
};
use spe2::types::{
    SPE_AFFINITY_MEMORY, SPE_CALLBACK_NEW, SPE_CALLBACK_UPDATE, SPE_CFG_SIGNOTIFY1_OR, SPE_ISOLATE,
    SPE_ISOLATE_EMULATE, SPE_MBOX_ALL_BLOCKING, SPE_MBOX_ANY_BLOCKING, SPE_MBOX_ANY_NONBLOCKING,
    SPE_SIG_NOTIFY_REG_1, SPE_SIG_NOTIFY_REG_2,
};

use crate::support::{Context, assert_fails, assert_null, elsewhere, last_errno};

#[test]
fn null_handles_are_esrch() {
    let none = ptr::null_mut();
    let mut word = 0;
    unsafe {
        assert_fails(spe_context_destroy(none), libc::ESRCH);
        assert_fails(spe_gang_context_destroy(ptr::null_mut()), libc::ESRCH);
        assert_null(spe_context_create_affinity(0, none, ptr::null_mut()), libc::ESRCH);
        assert_null(spe_ls_area_get(none), libc::ESRCH);
        assert_fails(spe_ls_size_get(none), libc::ESRCH);
        assert_null(spe_ps_area_get(none, 0), libc::ESRCH);
        assert_fails(spe_out_mbox_read(none, &raw mut word, 1), libc::ESRCH);
        assert_fails(spe_out_mbox_status(none), libc::ESRCH);
        assert_fails(spe_in_mbox_write(none, &raw mut word, 1, 1), libc::ESRCH);
        assert_fails(spe_in_mbox_status(none), libc::ESRCH);
        assert_fails(spe_out_intr_mbox_read(none, &raw mut word, 1, 1), libc::ESRCH);
        assert_fails(spe_out_intr_mbox_status(none), libc::ESRCH);
        assert_fails(spe_signal_write(none, 1, 0), libc::ESRCH);
        assert_fails(spe_mssync_start(none), libc::ESRCH);
        assert_fails(spe_mssync_status(none), libc::ESRCH);
    }
}

#[test]
fn flags_unsupported_on_playstation_3_are_refused() {
    let cases = [
        (SPE_ISOLATE, libc::ENODEV),
        (SPE_ISOLATE_EMULATE, libc::EINVAL),
        (SPE_AFFINITY_MEMORY, libc::EINVAL),
        (1, libc::EINVAL),
    ];
    for (flags, errno) in cases {
        assert_null(unsafe { spe_context_create(flags, ptr::null_mut()) }, errno);
    }
}

#[test]
fn gangs_hold_contexts_but_place_none() {
    let gang = unsafe { spe_gang_context_create(0) };
    assert!(!gang.is_null());
    let plain = Context::owning(unsafe { spe_context_create(0, gang) });
    let second = Context::owning(unsafe { spe_context_create_affinity(0, ptr::null_mut(), gang) });
    assert_ne!(plain.pointer(), second.pointer());
    unsafe {
        assert_null(spe_context_create_affinity(0, plain.pointer(), gang), libc::EINVAL);
        assert_null(
            spe_context_create_affinity(SPE_AFFINITY_MEMORY, ptr::null_mut(), gang),
            libc::EINVAL,
        );
        assert_eq!(spe_gang_context_destroy(gang), 0);
    }
}

#[test]
fn areas() {
    let context = Context::new(0);
    unsafe {
        assert_eq!(spe_ls_size_get(context.pointer()), 262_144);
        for area in 0..5 {
            assert_null(spe_ps_area_get(context.pointer(), area), libc::EACCES);
        }
        assert_null(spe_ps_area_get(context.pointer(), 5), libc::EINVAL);
    }
    assert!(context.local_store(0, 262_144).iter().all(|&byte| byte == 0));
    context.set_local_store(0x3fff0, &[1, 2, 3]);
    assert_eq!(context.local_store(0x3fff0, 4), [1, 2, 3, 0]);
}

#[test]
fn inbound_mailbox_fills_before_first_run() {
    let context = Context::new(0);
    let mut words = [1, 2, 3, 4, 5, 6];
    let data = words.as_mut_ptr();
    unsafe {
        assert_eq!(spe_in_mbox_status(context.pointer()), 4);
        assert_eq!(spe_in_mbox_write(context.pointer(), data, 1, SPE_MBOX_ALL_BLOCKING), 1);
        assert_eq!(spe_in_mbox_write(context.pointer(), data, 6, SPE_MBOX_ANY_BLOCKING), 3);
        assert_eq!(spe_in_mbox_write(context.pointer(), data, 6, SPE_MBOX_ANY_NONBLOCKING), 0);
        assert_eq!(last_errno(), 0);
        assert_eq!(spe_in_mbox_status(context.pointer()), 0);
        assert_eq!(spe_out_mbox_status(context.pointer()), 0);
        assert_eq!(spe_out_intr_mbox_status(context.pointer()), 0);
        assert_eq!(spe_out_mbox_read(context.pointer(), data, 1), 0);
        assert_eq!(spe_out_intr_mbox_read(context.pointer(), data, 1, SPE_MBOX_ANY_NONBLOCKING), 0);
    }
}

#[test]
fn mailbox_arguments() {
    let context = Context::new(0);
    let mut word = 0;
    let data = &raw mut word;
    let none = ptr::null_mut();
    unsafe {
        assert_fails(spe_out_mbox_read(context.pointer(), none, 1), libc::EINVAL);
        assert_fails(spe_out_mbox_read(context.pointer(), data, 0), libc::EINVAL);
        assert_fails(spe_out_mbox_read(context.pointer(), data, -1), libc::EINVAL);
        assert_fails(spe_in_mbox_write(context.pointer(), none, 1, 1), libc::EINVAL);
        assert_fails(spe_in_mbox_write(context.pointer(), data, 0, 1), libc::EINVAL);
        for behavior in [0, 4, u32::MAX] {
            assert_fails(spe_in_mbox_write(context.pointer(), data, 1, behavior), libc::EINVAL);
            assert_fails(
                spe_out_intr_mbox_read(context.pointer(), data, 1, behavior),
                libc::EINVAL,
            );
        }
        assert_fails(spe_signal_write(context.pointer(), 0, 1), libc::EINVAL);
        assert_fails(spe_signal_write(context.pointer(), 3, 1), libc::EINVAL);
        assert_fails(spe_mssync_start(context.pointer()), libc::EINVAL);
        assert_fails(spe_mssync_status(context.pointer()), libc::EINVAL);
    }
}

/// Sends every word back, through the two outbound mailboxes in turn, until it reads a 0.
const ECHO: &str = "
again:  rdch    $10,$ch29
        wrch    $ch28,$10
        wrch    $ch30,$10
        brnz    $10,again
        stop    0x2000
";

#[test]
fn blocking_mailbox_calls_transfer_all_words() {
    const COUNT: usize = 200;
    let context = Context::with_program(ECHO);
    let words: Vec<u32> = (0..COUNT as u32).rev().collect();
    let stop = elsewhere(
        || context.run(),
        || {
            std::thread::scope(|scope| {
                scope.spawn(|| {
                    let mut data = words.clone();
                    let sent = unsafe {
                        spe_in_mbox_write(
                            context.pointer(),
                            data.as_mut_ptr(),
                            COUNT as i32,
                            SPE_MBOX_ALL_BLOCKING,
                        )
                    };
                    assert_eq!(sent, COUNT as i32);
                });
                scope.spawn(|| {
                    let mut seen = vec![0; COUNT];
                    let half = (COUNT / 2) as i32;
                    let mut read = unsafe {
                        spe_out_intr_mbox_read(
                            context.pointer(),
                            seen.as_mut_ptr(),
                            half,
                            SPE_MBOX_ALL_BLOCKING,
                        )
                    };
                    assert_eq!(read, half);
                    while read < COUNT as i32 {
                        let more = unsafe {
                            spe_out_intr_mbox_read(
                                context.pointer(),
                                seen.as_mut_ptr().add(read as usize),
                                COUNT as i32 - read,
                                SPE_MBOX_ANY_BLOCKING,
                            )
                        };
                        assert!(more >= 1);
                        read += more;
                    }
                    assert_eq!(seen, words);
                });
                let mut seen = Vec::new();
                while seen.len() < COUNT {
                    let mut word = 0;
                    if unsafe { spe_out_mbox_read(context.pointer(), &raw mut word, 1) } == 1 {
                        seen.push(word);
                    } else {
                        std::thread::yield_now();
                    }
                }
                assert_eq!(seen, words);
            });
        },
    );
    assert_eq!(stop.returned, 0);
}

#[test]
fn signals_by_register_and_mode() {
    let context = Context::new(SPE_CFG_SIGNOTIFY1_OR);
    context.load(
        "
        rdch    $10,$ch3
        stqa    $10,0x8000
        rdch    $10,$ch4
        stqa    $10,0x8010
        stop    0x2000
",
    );
    unsafe {
        for register in [SPE_SIG_NOTIFY_REG_1, SPE_SIG_NOTIFY_REG_2] {
            assert_eq!(spe_signal_write(context.pointer(), register, 0x10), 0);
            assert_eq!(spe_signal_write(context.pointer(), register, 0x01), 0);
        }
    }
    assert_eq!(elsewhere(|| context.run(), || ()).returned, 0);
    assert_eq!(context.local_store(0x8000, 4), [0, 0, 0, 0x11]);
    assert_eq!(context.local_store(0x8010, 4), [0, 0, 0, 0x01]);
}

unsafe extern "C" fn any_handler(_: *mut libc::c_void, _: u32) -> i32 {
    0
}

#[test]
fn callback_slots() {
    let handler = any_handler as *mut libc::c_void;
    let register = |number, mode| unsafe { spe_callback_handler_register(handler, number, mode) };
    let register_null =
        |number, mode| unsafe { spe_callback_handler_register(ptr::null_mut(), number, mode) };
    let deregister = |number| unsafe { spe_callback_handler_deregister(number) };
    let query = |number| unsafe { spe_callback_handler_query(number) };
    assert_fails(register(256, SPE_CALLBACK_NEW), libc::EINVAL);
    assert_fails(register(3, SPE_CALLBACK_NEW), libc::EACCES);
    assert_fails(register(200, 3), libc::EINVAL);
    assert_fails(register(200, SPE_CALLBACK_UPDATE), libc::ESRCH);
    assert_fails(register_null(200, SPE_CALLBACK_NEW), libc::EINVAL);
    assert_null(query(200), libc::ESRCH);
    assert_null(query(256), libc::EINVAL);
    assert_fails(deregister(200), libc::ESRCH);
    assert_fails(deregister(3), libc::EACCES);
    assert_fails(deregister(256), libc::EINVAL);
    // The library's own handlers can be found and replaced, but not removed.
    for number in [0, 1, 5] {
        let own = query(number);
        assert!(!own.is_null(), "{number}");
        assert_fails(register(number, SPE_CALLBACK_NEW), libc::EACCES);
    }
    assert_fails(deregister(0), libc::EACCES);
    for number in [2, 3, 4] {
        assert_null(query(number), libc::ESRCH);
        assert_fails(register(number, SPE_CALLBACK_UPDATE), libc::ESRCH);
    }
    assert_eq!(register(200, SPE_CALLBACK_NEW), 0);
    assert_fails(register(200, SPE_CALLBACK_NEW), libc::EACCES);
    assert_fails(register_null(200, SPE_CALLBACK_UPDATE), libc::EINVAL);
    assert_eq!(register(200, SPE_CALLBACK_UPDATE), 0);
    assert_eq!(query(200), handler);
    assert_eq!(deregister(200), 0);
    assert_null(query(200), libc::ESRCH);
}
