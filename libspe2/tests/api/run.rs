//! `spe_context_run`: stop reasons, initial registers, library calls.

use std::ptr;
use std::sync::atomic::{AtomicU32, Ordering::SeqCst};

use spe2::callback::{spe_callback_handler_deregister, spe_callback_handler_register};
use spe2::context::spe_ls_area_get;
use spe2::run::{spe_context_run, spe_stop_info_read};
use spe2::types::{
    SPE_CALLBACK_ERROR, SPE_CALLBACK_NEW, SPE_DEFAULT_ENTRY, SPE_EXIT, SPE_ISOLATION_ERROR,
    SPE_NO_CALLBACKS, SPE_RUN_USER_REGS, SPE_RUNTIME_ERROR, SPE_RUNTIME_EXCEPTION,
    SPE_STOP_AND_SIGNAL,
};

use crate::support::{Context, Stop, assert_fails, elsewhere, no_stop_info};

fn stop_of(source: &str) -> Stop {
    let context = Context::with_program(source);
    elsewhere(|| context.run(), || ())
}

fn expected(returned: i32, errno: i32, reason: u32, code: i32, status: i32) -> Stop {
    Stop { returned, errno, reason, code, status, entry: 4 }
}

#[test]
fn stop_codes_give_documented_results() {
    let cases = [
        ("stop 0x2000", expected(0, 0, SPE_EXIT, 0, 0x2000_0002)),
        ("stop 0x206b", expected(0, 0, SPE_EXIT, 107, 0x206b_0002)),
        ("stop 1", expected(1, 0, SPE_STOP_AND_SIGNAL, 1, 0x0001_0002)),
        ("stop 0x3ffe", expected(0x3ffe, 0, SPE_STOP_AND_SIGNAL, 0x3ffe, 0x3ffe_0002)),
        ("stop 0", expected(0, 0, SPE_STOP_AND_SIGNAL, 0, 2)),
        ("stop 0x2203", expected(-1, libc::EFAULT, SPE_ISOLATION_ERROR, 3, 0x2203_0002)),
        ("heqi $10,0", expected(-1, libc::EFAULT, SPE_RUNTIME_ERROR, 4, 4)),
        ("stop 0x21f0", expected(-1, libc::EFAULT, SPE_CALLBACK_ERROR, -1, 0x21f0_0002)),
    ];
    for (source, expected) in cases {
        assert_eq!(stop_of(source), expected, "{source}");
    }
    // The stop is not precise, so there is no next instruction.
    for (source, code) in [(".long 0x00800000", 0x20), ("rdch $10,$ch5", 0x40)] {
        let stop = stop_of(source);
        let entry = stop.entry;
        let expected = expected(-1, libc::EFAULT, SPE_RUNTIME_ERROR, code, code);
        assert_eq!(stop, Stop { entry, ..expected }, "{source}");
    }
}

#[test]
fn dma_errors_are_exceptions() {
    let cases = [
        ("command 0x40, 0x10000, $10, 24, 0", 0x0008),
        ("command 0x43, 0x10000, $10, 16, 0", 0x0800),
        ("command 0x40, 0x10000, $10, 16, 0", 0x0040),
        ("command 0x20, 0x10000, $10, 16, 0", 0x0040),
        ("command 0xd0, 0x10000, $10, 128, 0", 0x0040),
    ];
    for (command, event) in cases {
        let stop = stop_of(&format!("il $2,0\n il $10,0x400\n {command}\n stop 0x2000\n"));
        let entry = stop.entry;
        let expected = expected(-1, libc::EIO, SPE_RUNTIME_EXCEPTION, event, -1);
        assert_eq!(stop, Stop { entry, ..expected }, "{command}");
    }
}

#[test]
fn run_continues_at_stop_address() {
    let context = Context::with_program("stop 1\n stop 2\n stop 0x2003\n");
    let mut entry = SPE_DEFAULT_ENTRY;
    for expected in [1, 2, 3] {
        let stop = elsewhere(|| context.run_from(entry, 0, 0, 0), || ());
        assert_eq!(stop.code, expected);
        entry = stop.entry;
    }
    assert_eq!(entry, 12);
}

#[test]
fn load_complete_is_not_reported() {
    assert_eq!(stop_of("stop 0x2206\n stop 5\n").returned, 5);
}

const STORE_REGISTERS: &str = "
        stqa    $1,0x8010
        stqa    $2,0x8020
        stqa    $3,0x8030
        stqa    $4,0x8040
        stqa    $5,0x8050
        stqa    $6,0x8060
        stop    1
        stqa    $3,0x8030
        stop    2
";

fn doublewords(context: &Context, register: u32) -> [u64; 2] {
    let bytes = context.local_store(0x8000 + register * 16, 16);
    [0, 8].map(|at| u64::from_be_bytes(bytes[at..at + 8].try_into().unwrap()))
}

#[test]
fn start_registers() {
    let context = Context::with_program(STORE_REGISTERS);
    context.set_local_store(0x3fff0, &[0xee; 16]);
    // Programs of 32 bits have the lower halves.
    let pointer = |value: u64| value as usize as u64;
    let argp = pointer(0x1234_5678_9abc_def0);
    let envp = pointer(0xfedc_ba98_7654_3210);
    let run = |entry, argp| context.run_from(entry, 0, argp, envp);
    let stop = elsewhere(|| run(SPE_DEFAULT_ENTRY, argp), || ());
    assert_eq!(stop.returned, 1);
    let area = unsafe { spe_ls_area_get(context.pointer()) }.expose_provenance() as u64;
    let expected =
        [0x3fff0_u64 << 32, 0, context.pointer().expose_provenance() as u64, argp, envp, area];
    for (register, expected) in (1..).zip(expected) {
        assert_eq!(doublewords(&context, register), [expected, 0], "${register}");
    }
    // The back chain ends here.
    assert_eq!(context.local_store(0x3fff0, 16), [0; 16]);
    // Continuing at another address does not change the registers.
    let stop = elsewhere(|| run(stop.entry, 1), || ());
    assert_eq!(stop.returned, 2);
    assert_eq!(doublewords(&context, 3)[0], expected[2]);
}

#[test]
fn every_start_clears_environment() {
    let context = Context::with_program("stqa $2,0x8000\n il $2,7\n stop 0x2000\n");
    for _ in 0..2 {
        assert_eq!(elsewhere(|| context.run(), || ()).returned, 0);
        assert_eq!(context.local_store(0x8000, 16), [0; 16]);
    }
}

#[test]
fn user_registers() {
    let context = Context::with_program(STORE_REGISTERS);
    let registers: Vec<u8> = (0..48).collect();
    let argp = registers.as_ptr().expose_provenance() as u64;
    let run = |argp| context.run_from(SPE_DEFAULT_ENTRY, SPE_RUN_USER_REGS, argp, 0);
    assert_eq!(elsewhere(|| run(argp), || ()).returned, 1);
    assert_eq!(context.local_store(0x8030, 48), registers);
    let stop = elsewhere(|| run(8), || ());
    assert_eq!((stop.returned, stop.errno), (-1, libc::EFAULT));
}

#[test]
fn arguments() {
    let context = Context::with_program("stop 1");
    let mut entry = 0;
    let null = ptr::null_mut();
    unsafe {
        assert_fails(
            spe_context_run(null, &raw mut entry, 0, null.cast(), null.cast(), ptr::null_mut()),
            libc::ESRCH,
        );
        assert_fails(
            spe_context_run(
                context.pointer(),
                ptr::null_mut(),
                0,
                null.cast(),
                null.cast(),
                ptr::null_mut(),
            ),
            libc::EINVAL,
        );
        // Nobody has to read the stop record.
        entry = SPE_DEFAULT_ENTRY;
        let returned = spe_context_run(
            context.pointer(),
            &raw mut entry,
            0,
            null.cast(),
            null.cast(),
            ptr::null_mut(),
        );
        assert_eq!(returned, 1);
    }
}

static CALLED_WITH: AtomicU32 = AtomicU32::new(0);

/// Adds 1 to the word that the call points at, and fails if the result is 5.
unsafe extern "C" fn increment(ls_base: *mut libc::c_void, ls_address: u32) -> i32 {
    CALLED_WITH.store(ls_address, SeqCst);
    let bytes: *mut u8 = ls_base.cast();
    let word = |at: u32| unsafe { bytes.add(at as usize).cast::<[u8; 4]>() };
    let parameter = u32::from_be_bytes(unsafe { *word(ls_address) });
    let value = u32::from_be_bytes(unsafe { *word(parameter) }) + 1;
    unsafe { *word(parameter) = value.to_be_bytes() };
    if value == 5 { 55 } else { 0 }
}

#[test]
fn library_calls() {
    const NUMBER: u32 = 0xcc;
    let source = "
again:  stop    0x21cc
        .long   0x8000
        br      again
";
    let handler = increment as *mut libc::c_void;
    unsafe {
        assert_eq!(spe_callback_handler_register(handler, NUMBER, SPE_CALLBACK_NEW), 0);
    }
    let context = Context::with_program(source);
    let stop = elsewhere(|| context.run(), || ());
    let expected_stop = expected(-1, libc::EFAULT, SPE_CALLBACK_ERROR, 55, 0x21cc_0002);
    assert_eq!(stop, expected_stop);
    assert_eq!(context.local_store(0x8000, 4), [0, 0, 0, 5]);
    assert_eq!(CALLED_WITH.load(SeqCst), 4);
    // The handler is not called if the program asks for the stop itself.
    let run = || context.run_from(SPE_DEFAULT_ENTRY, SPE_NO_CALLBACKS, 0, 0);
    let stop = elsewhere(run, || ());
    assert_eq!((stop.returned, stop.reason), (0x21cc, SPE_STOP_AND_SIGNAL));
    unsafe { assert_eq!(spe_callback_handler_deregister(NUMBER), 0) };
}

#[test]
fn last_stop_can_be_read_once() {
    let context = Context::with_program("stop 0x2001");
    let mut info = no_stop_info();
    let read =
        |context: &Context, info: &mut _| unsafe { spe_stop_info_read(context.pointer(), info) };
    assert_fails(read(&context, &mut info), libc::EAGAIN);
    elsewhere(|| context.run(), || ());
    elsewhere(|| context.run(), || ());
    assert_eq!(read(&context, &mut info), 0);
    assert_eq!((info.stop_reason, info.spu_status), (1, 0x2001_0002));
    assert_eq!(unsafe { info.result.code }, 1);
    assert_fails(read(&context, &mut info), libc::EAGAIN);
    let without_events = Context::new(0);
    assert_fails(read(&without_events, &mut info), libc::ENOTSUP);
    assert_fails(unsafe { spe_stop_info_read(ptr::null_mut(), &raw mut info) }, libc::ESRCH);
}

#[test]
fn empty_local_store_stops_at_once() {
    let context = Context::new(0);
    let stop = elsewhere(|| context.run(), || ());
    assert_eq!((stop.returned, stop.reason), (0, SPE_STOP_AND_SIGNAL));
}
