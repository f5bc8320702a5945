//! DMA by the SPU and by proxy, in the memory of this process.

use std::ffi::c_void;
use std::ptr;

use spe2::mfc::{
    spe_mfcio_get, spe_mfcio_getb, spe_mfcio_getf, spe_mfcio_put, spe_mfcio_putb, spe_mfcio_putf,
    spe_mfcio_tag_status_read,
};
use spe2::types::{
    SPE_DEFAULT_ENTRY, SPE_RUNTIME_EXCEPTION, SPE_TAG_ALL, SPE_TAG_ANY, SPE_TAG_IMMEDIATE,
};

use crate::support::{Aligned, Context, assert_fails, elsewhere};

type Transfer =
    unsafe extern "C" fn(*mut spe2::types::SpeContext, u32, *mut c_void, u32, u32, u32, u32) -> i32;

const GETS: [Transfer; 3] = [spe_mfcio_get, spe_mfcio_getb, spe_mfcio_getf];
const PUTS: [Transfer; 3] = [spe_mfcio_put, spe_mfcio_putb, spe_mfcio_putf];

/// Gets 16 KB from argp, inverts the first quadword, and puts everything to envp.
const COPY: &str = "
        ori     $20,$4,0
        rotqbyi $21,$4,4
        ori     $22,$5,0
        rotqbyi $23,$5,4
        ori     $2,$20,0
        command GET, 0x10000, $21, 0x4000, 1
        wait_tags 2
        lqa     $24,0x10000
        nor     $24,$24,$24
        stqa    $24,0x10000
        ori     $2,$22,0
        command PUT, 0x10000, $23, 0x4000, 1
        wait_tags 2
        stop    0x2000
";

#[test]
fn spu_accesses_process_memory() {
    let mut from = Aligned::<0x4000>::new();
    let mut to = Aligned::<0x4000>::new();
    for (n, byte) in from.0.iter_mut().enumerate() {
        *byte = (n * 31 + n / 256) as u8;
    }
    let context = Context::with_program(COPY);
    let (argp, envp) = (from.ea(), to.ea());
    let run = || context.run_from(SPE_DEFAULT_ENTRY, 0, argp, envp);
    assert_eq!(elsewhere(run, || ()).returned, 0);
    for byte in &mut from.0[..16] {
        *byte = !*byte;
    }
    assert!(from.0 == to.0);
    // The same happens in an empty page and in an unmapped one.
    for (argp, envp) in [(0x1000, envp), (argp, 0x1000), (argp, u64::MAX - 0xffff)] {
        let run = || context.run_from(SPE_DEFAULT_ENTRY, 0, argp, envp);
        let stop = elsewhere(run, || ());
        assert_eq!((stop.reason, stop.code), (SPE_RUNTIME_EXCEPTION, 0x40));
    }
}

/// Copies from another context's local store by its mapped address, which is in argp.
#[test]
fn local_store_is_memory_of_this_process() {
    let other = Context::new(0);
    other.set_local_store(0x8000, &[7; 0x4000]);
    let area =
        unsafe { spe2::context::spe_ls_area_get(other.pointer()) }.expose_provenance() as u64;
    let context = Context::with_program(COPY);
    let run = || context.run_from(SPE_DEFAULT_ENTRY, 0, area + 0x8000, area + 0x20000);
    assert_eq!(elsewhere(run, || ()).returned, 0);
    assert_eq!(other.local_store(0x20000, 16), [!7; 16]);
    assert_eq!(other.local_store(0x20010, 0x3ff0), [7; 0x3ff0]);
}

/// Adds 1 to the first word of the line at argp, 2000 times.
const COUNT: &str = "
        ori     $2,$4,0
        rotqbyi $3,$4,4
        il      $5,2000
        cwd     $14,0($15)
again:  command GETLLAR, 0x10000, $3, 128, 0
        rdch    $10,$ch27
        lqa     $11,0x10000
        ai      $12,$11,1
        shufb   $11,$12,$11,$14
        stqa    $11,0x10000
        command PUTLLC, 0x10000, $3, 128, 0
        rdch    $10,$ch27
        brnz    $10,again
        ai      $5,$5,-1
        brnz    $5,again
        stop    0x2000
";

#[test]
fn spes_and_process_share_atomic_counter() {
    use std::sync::atomic::{AtomicU32, Ordering::SeqCst};
    let mut line = Aligned::<128>::new();
    let ea = line.ea();
    let contexts: Vec<Context> = (0..6).map(|_| Context::with_program(COUNT)).collect();
    let word = unsafe { AtomicU32::from_ptr(line.pointer().cast()) };
    let ran: Vec<i32> = elsewhere(
        || {
            std::thread::scope(|scope| {
                let running: Vec<_> = contexts
                    .iter()
                    .map(|context| {
                        let run = || context.run_from(SPE_DEFAULT_ENTRY, 0, ea, 0).returned;
                        scope.spawn(run)
                    })
                    .collect();
                running.into_iter().map(|run| run.join().unwrap()).collect()
            })
        },
        || {
            for _ in 0..2000 {
                let add = |value| Some(u32::to_be(u32::from_be(value) + 1));
                word.fetch_update(SeqCst, SeqCst, add).unwrap();
            }
        },
    );
    assert_eq!(ran, [0; 6]);
    assert_eq!(u32::from_be(word.load(SeqCst)), 14_000);
}

fn tag_status(context: &Context, behavior: u32) -> u32 {
    let mut status = !0;
    let read =
        unsafe { spe_mfcio_tag_status_read(context.pointer(), !0, behavior, &raw mut status) };
    assert_eq!(read, 0);
    status
}

#[test]
fn proxy_transfers() {
    let context = Context::new(0);
    let mut there = Aligned::<256>::new();
    context.while_it_runs(|| {
        for (get, put) in GETS.into_iter().zip(PUTS) {
            there.0.fill(3);
            let pointer = there.pointer();
            let got = unsafe { get(context.pointer(), 0x8000, pointer, 128, 1, 0, 0) };
            assert_eq!(got, 0);
            assert_eq!(tag_status(&context, SPE_TAG_ALL), 1 << 1);
            assert_eq!(context.local_store(0x8000, 128), [3; 128]);
            for (tag, half) in [(0, 128), (15, 192)] {
                let to = unsafe { pointer.byte_add(half) };
                let queued = unsafe { put(context.pointer(), 0x8000, to, 64, tag, 0, 0) };
                assert_eq!(queued, 0);
            }
            assert_eq!(tag_status(&context, SPE_TAG_ALL), 1 << 15 | 1);
            assert_eq!(there.0, [3; 256]);
        }
    });
    // Every tag has been reported.
    for behavior in [SPE_TAG_ALL, SPE_TAG_ANY, SPE_TAG_IMMEDIATE] {
        assert_eq!(tag_status(&context, behavior), 0);
    }
}

#[test]
fn proxy_arguments() {
    let context = Context::new(0);
    let mut there = Aligned::<16400>::new();
    let pointer = there.pointer();
    let mut status = 0;
    for transfer in GETS.into_iter().chain(PUTS) {
        let call = |ls, offset, size, tag, tid, rid| unsafe {
            transfer(context.pointer(), ls, pointer.byte_add(offset), size, tag, tid, rid)
        };
        assert_fails(call(0, 0, 16, 16, 0, 0), libc::EINVAL);
        assert_fails(call(0, 0, 16, 0, 256, 0), libc::EINVAL);
        assert_fails(call(0, 0, 16, 0, 0, 256), libc::EINVAL);
        assert_fails(call(0, 0, 16, 0, 1, 0), libc::EIO);
        assert_fails(call(0, 0, 16, 0, 0, 1), libc::EIO);
        assert_fails(call(0, 0, 16400, 0, 0, 0), libc::EIO);
        assert_fails(call(0, 0, 3, 0, 0, 0), libc::EIO);
        assert_fails(call(8, 8, 16, 0, 0, 0), libc::EIO);
        assert_fails(call(0, 4, 4, 0, 0, 0), libc::EIO);
        assert_fails(unsafe { transfer(ptr::null_mut(), 0, pointer, 16, 0, 0, 0) }, libc::ESRCH);
    }
    unsafe {
        let read = spe_mfcio_tag_status_read;
        assert_fails(read(context.pointer(), 0, 0, &raw mut status), libc::EINVAL);
        assert_fails(read(context.pointer(), 0, 4, &raw mut status), libc::EINVAL);
        assert_fails(read(context.pointer(), 0, SPE_TAG_ANY, ptr::null_mut()), libc::EINVAL);
        assert_fails(read(ptr::null_mut(), 0, SPE_TAG_ANY, &raw mut status), libc::ESRCH);
    }
}

#[test]
fn proxy_transfer_to_bad_address_ends_run() {
    let context = Context::with_program("rdch $10,$ch29\n stop 0x2000\n");
    let stop = elsewhere(
        || context.run(),
        || {
            let nowhere = ptr::without_provenance_mut(0x100);
            let queued = unsafe { spe_mfcio_get(context.pointer(), 0, nowhere, 16, 0, 0, 0) };
            assert_eq!(queued, 0);
        },
    );
    assert_eq!((stop.returned, stop.errno), (-1, libc::EIO));
    assert_eq!((stop.reason, stop.code), (SPE_RUNTIME_EXCEPTION, 0x40));
}
