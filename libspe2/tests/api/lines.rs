//! Lines of main memory: they are transferred whole, and a reservation is of a line and not of its
//! address.

use std::ptr;

use spe2::mailbox::{spe_in_mbox_write, spe_out_intr_mbox_read, spe_out_mbox_read};
use spe2::types::SPE_DEFAULT_ENTRY;

use crate::support::{Aligned, Context, elsewhere};

/// Puts lines of ones and lines of zeros to argp in turn, until a word arrives. Reports when it has
/// begun.
const ALTERNATE: &str = "
        ori     $2,$4,0
        rotqbyi $3,$4,4
        ila     $5,0x10000
        il      $6,SIZE/16
        il      $7,-1
fill:   stqd    $7,0($5)
        ai      $5,$5,16
        ai      $6,$6,-1
        brnz    $6,fill
        wrch    $ch28,$7
again:  command PUT, 0x10000, $3, SIZE, 1
        wait_tags 2
        command PUT, 0x18000, $3, SIZE, 1
        wait_tags 2
        rchcnt  $8,$ch29
        brz     $8,again
        stop    0x2000
";

/// Gets the lines at argp 100000 times. Reports how many lines were of several values, and how
/// often the first one had changed.
const COMPARE: &str = "
        ori     $2,$4,0
        rotqbyi $3,$4,4
        ila     $5,100000
        il      $7,0
        il      $20,0
        il      $21,0
get:    command GET, 0x10000, $3, SIZE, 1
        wait_tags 2
        ila     $8,0x10000
        il      $9,SIZE/128
        lqd     $10,0($8)
        ceq     $22,$10,$21
        ori     $21,$10,0
        ai      $20,$20,1
        a       $20,$20,$22
line:   lqd     $10,0($8)
        rotqbyi $11,$10,4
        xor     $12,$10,$11
        .irp    at,16,32,48,64,80,96,112
        lqd     $13,\\at($8)
        xor     $13,$13,$10
        or      $12,$12,$13
        .endr
        orx     $12,$12
        ceqi    $12,$12,0
        ai      $7,$7,1
        a       $7,$7,$12
        ai      $8,$8,128
        ai      $9,$9,-1
        brnz    $9,line
        ai      $5,$5,-1
        brnz    $5,get
        wrch    $ch28,$7
        wrch    $ch30,$20
        stop    0x2000
";

/// The word that the context has sent, when it has sent it.
fn word(context: &Context) -> u32 {
    let mut word = 0;
    while unsafe { spe_out_mbox_read(context.pointer(), &raw mut word, 1) } != 1 {
        std::thread::yield_now();
    }
    word
}

#[test]
fn lines_are_put_and_got_whole() {
    for size in [128, 256, 2048] {
        let mut lines = Aligned::<2048>::new();
        let ea = lines.ea();
        let of = |source| Context::with_program(&format!("        .set SIZE,{size}\n{source}"));
        let (putter, getter) = (of(ALTERNATE), of(COMPARE));
        let run = |context: &Context| context.run_from(SPE_DEFAULT_ENTRY, 0, ea, 0).returned;
        let counts = elsewhere(
            || {
                std::thread::scope(|scope| {
                    let putting = scope.spawn(|| run(&putter));
                    word(&putter);
                    let got = run(&getter);
                    let mut enough = 0;
                    let written =
                        unsafe { spe_in_mbox_write(putter.pointer(), &raw mut enough, 1, 1) };
                    let mut changes = 0;
                    let read =
                        unsafe { spe_out_intr_mbox_read(getter.pointer(), &raw mut changes, 1, 1) };
                    assert_eq!((got, written, read), (0, 1, 1));
                    assert_eq!(putting.join().unwrap(), 0);
                    (word(&getter), changes)
                })
            },
            || (),
        );
        let (torn, changes) = counts;
        assert_eq!(torn, 0, "torn lines, in 100000 transfers of {size} bytes");
        assert!(changes > 0, "nothing was put meanwhile");
    }
}

/// Two addresses of a page that is mapped twice, and those of a page of other memory.
struct Pages {
    twice: [u64; 2],
    other: u64,
}

const PAGE: usize = 4096;

fn address(mapping: *mut libc::c_void) -> u64 {
    assert_ne!(mapping, libc::MAP_FAILED);
    mapping.expose_provenance() as u64
}

/// A file in memory. The second mapping has another offset than the first.
fn file() -> Pages {
    let map = |length, file, offset| {
        let access = libc::PROT_READ | libc::PROT_WRITE;
        let shared = libc::MAP_SHARED;
        address(unsafe { libc::mmap(ptr::null_mut(), length, access, shared, file, offset) })
    };
    let file = || {
        let file = unsafe { libc::syscall(libc::SYS_memfd_create, c"twice".as_ptr(), 0) };
        let file = file as i32;
        assert_eq!(unsafe { libc::ftruncate(file, 2 * PAGE as libc::off_t) }, 0);
        file
    };
    let (one, other) = (file(), file());
    let pages = Pages {
        twice: [map(2 * PAGE, one, 0) + PAGE as u64, map(PAGE, one, PAGE as libc::off_t)],
        other: map(PAGE, other, PAGE as libc::off_t),
    };
    for file in [one, other] {
        assert_eq!(unsafe { libc::close(file) }, 0);
    }
    pages
}

/// A segment of System V.
fn segment() -> Pages {
    let segment = || unsafe { libc::shmget(libc::IPC_PRIVATE, PAGE, 0o600) };
    let attach = |segment| address(unsafe { libc::shmat(segment, ptr::null(), 0) });
    let (one, other) = (segment(), segment());
    let pages = Pages { twice: [attach(one), attach(one)], other: attach(other) };
    for segment in [one, other] {
        let removed = unsafe { libc::shmctl(segment, libc::IPC_RMID, ptr::null_mut()) };
        assert_eq!(removed, 0);
    }
    pages
}

/// Reserves the line at argp, reports it, and waits for a word. Then reports whether an event is
/// pending, and the status of a conditional put.
const HOLD: &str = "
        ori     $2,$4,0
        rotqbyi $3,$4,4
        set_channel 1, 0x400
        command GETLLAR, 0x10000, $3, 128, 0
        rdch    $10,$ch27
        wrch    $ch28,$10
        rdch    $11,$ch29
        rchcnt  $12,$ch0
        command PUTLLC, 0x10000, $3, 128, 0
        rdch    $13,$ch27
        shli    $12,$12,4
        or      $12,$12,$13
        wrch    $ch28,$12
        stop    0x2000
";

/// The holder of the line at one address learns when a command is given for another address: in bit
/// 4 whether its reservation is lost by an event, in bit 0 whether it is lost at the put.
fn after(command: &str, held: u64, written: u64) -> u32 {
    let holder = Context::with_program(HOLD);
    let writer = format!("ori $2,$4,0\n rotqbyi $3,$4,4\n {command}\n stop 0x2000\n");
    let writer = Context::with_program(&writer);
    let run = |context: &Context, ea| context.run_from(SPE_DEFAULT_ENTRY, 0, ea, 0).returned;
    elsewhere(
        || {
            std::thread::scope(|scope| {
                let holding = scope.spawn(|| run(&holder, held));
                assert_eq!(word(&holder), 4);
                let wrote = run(&writer, written);
                let mut go_on = 0;
                let sent = unsafe { spe_in_mbox_write(holder.pointer(), &raw mut go_on, 1, 1) };
                assert_eq!((wrote, sent, holding.join().unwrap()), (0, 1, 0));
                word(&holder)
            })
        },
        || (),
    )
}

/// All commands write the bytes that are there already. So the reservation is lost by the write,
/// and not because the line has changed.
#[test]
fn reservation_is_lost_by_write_to_any_alias() {
    const KEPT: u32 = 0;
    const LOST: u32 = 0x11;
    for Pages { twice, other } in [file(), segment()] {
        for command in [
            "command PUT, 0x10000, $3, 16, 0\n wait_tags 1",
            "command PUT, 0x10000, $3, 256, 0\n wait_tags 1",
            "command PUTLLUC, 0x10000, $3, 128, 0\n rdch $10,$ch27",
            "command PUTQLLUC, 0x10000, $3, 128, 0\n wait_tags 1",
            "command GETLLAR, 0x10000, $3, 128, 0\n rdch $10,$ch27
             command PUTLLC, 0x10000, $3, 128, 0\n rdch $11,$ch27",
        ] {
            for (held, written, expected) in [
                (twice[0] + 128, twice[0] + 128, LOST),
                (twice[0] + 128, twice[1] + 128, LOST),
                (twice[1] + 128, twice[0] + 128, LOST),
                (twice[0] + 128, twice[1] + 256, KEPT),
                (twice[0] + 128, other + 128, KEPT),
            ] {
                let found = after(command, held, written);
                assert_eq!(found, expected, "{command}: {held:#x}, {written:#x}");
            }
        }
        let long = "command PUT, 0x10000, $3, 0x1000, 0\n wait_tags 1";
        assert_eq!(after(long, twice[0] + 0xf80, twice[1]), LOST);
    }
}
