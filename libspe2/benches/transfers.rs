//! Measures the processor time that the emulated MFC takes for a transfer, in the memory of this
//! process. The figures are recorded, not checked.
//!
//! A figure is the minimum of several runs, because other activity on the host can only slow a run
//! down. It counts the time of all threads, so it does not show how long they waited for each
//! other; the time that passed, in the second column, does.

#![expect(clippy::print_stdout, reason = "a benchmark has nothing to lose but its output")]
#![expect(
    clippy::undocumented_unsafe_blocks,
    reason = "each block calls the C API with pointers that are valid until the run ends"
)]

#[path = "../tests/api/support.rs"]
#[expect(dead_code, reason = "the tests use all of it")]
mod support;

use std::mem::MaybeUninit;
use std::thread;
use std::time::{Duration, Instant};

use spe2::types::SPE_DEFAULT_ENTRY;

use support::{Aligned, Context};

const RUNS: u32 = 7;

/// Does a command $5 times. The effective address is argp, the number of times is envp.
const LOOP: &str = "
        ori     $2,$4,0
        rotqbyi $3,$4,4
        rotqbyi $5,$5,4
        cwd     $14,0($15)
";

fn plain(opcode: &str, size: u32) -> String {
    format!(
        "{LOOP}
again:  command {opcode}, 0x10000, $3, {size}, 1
        wait_tags 2
        ai      $5,$5,-1
        brnz    $5,again
        stop    0x2000"
    )
}

/// Puts of 64 rows of 256 bytes: a tile of a picture that is 1280 pixels wide.
fn rows() -> String {
    format!(
        "{LOOP}
        ila     $20,0x8000
        il      $21,64
        il      $22,256
        il      $28,5120
        cwd     $23,0($15)
        cwd     $24,4($15)
        ori     $25,$3,0
        il      $26,0
list:   shufb   $26,$22,$26,$23
        shufb   $26,$25,$26,$24
        lqd     $29,0($20)
        cdd     $30,0($20)
        shufb   $29,$26,$29,$30
        stqd    $29,0($20)
        ai      $20,$20,8
        a       $25,$25,$28
        ai      $21,$21,-1
        brnz    $21,list
        ila     $31,0x8000
again:  command PUTL, 0x10000, $31, 64*8, 1
        wait_tags 2
        ai      $5,$5,-1
        brnz    $5,again
        stop    0x2000"
    )
}

/// Adds 1 to a word of a line.
fn count() -> String {
    format!(
        "{LOOP}
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
        stop    0x2000"
    )
}

fn processor_time() -> Duration {
    let mut usage = MaybeUninit::<libc::rusage>::zeroed();
    let usage = unsafe {
        assert_eq!(libc::getrusage(libc::RUSAGE_SELF, usage.as_mut_ptr()), 0);
        usage.assume_init()
    };
    let of = |time: libc::timeval| {
        Duration::from_secs(time.tv_sec as u64) + Duration::from_micros(time.tv_usec as u64)
    };
    of(usage.ru_utime) + of(usage.ru_stime)
}

/// Nanoseconds of processor time and of time for one command. The SPEs' addresses are `apart`.
fn measure(program: &str, spes: usize, apart: usize, times: u32, memory: u64) -> (f64, f64) {
    let contexts: Vec<_> = (0..spes).map(|_| Context::with_program(program)).collect();
    let run = || {
        let (processor, start) = (processor_time(), Instant::now());
        thread::scope(|scope| {
            for (context, ea) in contexts.iter().zip((memory..).step_by(apart.max(1))) {
                let ea = if apart == 0 { memory } else { ea };
                let times = times / spes as u32;
                scope.spawn(move || context.run_from(SPE_DEFAULT_ENTRY, 0, ea, u64::from(times)));
            }
        });
        let each = |time: Duration| time.as_secs_f64() * 1e9 / f64::from(times);
        (each(processor_time() - processor), each(start.elapsed()))
    };
    let min = |a: (f64, f64), b: (f64, f64)| (a.0.min(b.0), a.1.min(b.1));
    (0..RUNS).map(|_| run()).fold((f64::MAX, f64::MAX), min)
}

fn main() {
    let mut memory = Aligned::<{ 8 << 20 }>::new();
    let ea = memory.ea();
    println!("ns of processor time, ns that pass: for a command");
    for (name, program, spes, apart, times) in [
        ("get of 128 bytes, one SPE", plain("GET", 128), 1, 0, 60_000),
        ("put of 128 bytes, one SPE", plain("PUT", 128), 1, 0, 60_000),
        ("get of 16 KB, one SPE", plain("GET", 16384), 1, 0, 12_000),
        ("put of 16 KB, one SPE", plain("PUT", 16384), 1, 0, 12_000),
        ("put of 64 rows, one SPE", rows(), 1, 0, 6_000),
        ("getllar and putllc, one SPE", count(), 1, 0, 30_000),
        ("get of 128 bytes, six SPEs, the same", plain("GET", 128), 6, 0, 60_000),
        ("put of 128 bytes, six SPEs, each its own", plain("PUT", 128), 6, 0x4000, 60_000),
        ("put of 128 bytes, six SPEs, the same", plain("PUT", 128), 6, 0, 60_000),
        ("get of 16 KB, six SPEs, the same", plain("GET", 16384), 6, 0, 12_000),
        ("put of 16 KB, six SPEs, each its own", plain("PUT", 16384), 6, 0x4000, 12_000),
        ("put of 64 rows, six SPEs, side by side", rows(), 6, 256, 6_000),
        ("getllar and putllc, six SPEs, the same", count(), 6, 0, 30_000),
    ] {
        let (processor, passed) = measure(&program, spes, apart, times, ea);
        println!("{name:42} {processor:9.0} {passed:9.0}");
    }
}
