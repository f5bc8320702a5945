//! Measures how many instructions a second of processor time run, interpreted and compiled. The
//! figures are recorded, not checked.
//!
//! Each loop is a mix of one kind of instruction, a counter and a branch. A figure is the best of
//! several runs, because other activity on the host can only slow a run down.

#![expect(clippy::print_stdout, reason = "a benchmark has nothing to lose but its output")]

use spu_emulator::channel::Channels;
use spu_emulator::compiled::{Runner, Translations};
use spu_emulator::interp::{Quad, Spu};
use spu_emulator::local_store::LocalStore;
use spu_emulator::stop::{Stop, Stopped};
use spu_isa::{Instruction, Op};

const ROUNDS: u32 = 1_000_000;
const RUNS: u32 = 12;
const COUNTER: u8 = 2;

/// Channels for loops that use none.
struct Unused;

impl Channels for Unused {
    fn read(&mut self, _: u8) -> Result<u32, Stop> {
        Err(Stop::Requested)
    }
    fn write(&mut self, _: u8, _: u32) -> Result<(), Stop> {
        Err(Stop::Requested)
    }
    fn count(&mut self, _: u8) -> Result<u32, Stop> {
        Err(Stop::Requested)
    }
}

fn measure(name: &str, body: &[Instruction], registers: impl Fn(u32) -> u32) {
    let local_store = LocalStore::new();
    let back = -4 * (body.len() as i32 + 1);
    let count = Instruction::new(Op::Ai, [COUNTER, COUNTER, 0, 0], -1);
    let branch = Instruction::new(Op::Brnz, [COUNTER, 0, 0, 0], back);
    let stop = Instruction::new(Op::Stop, [0; 4], 0);
    let code = body.iter().chain([&count, &branch, &stop]);
    for (address, instruction) in (0u32..).step_by(4).zip(code) {
        local_store.write(address, &instruction.encode().to_be_bytes());
    }
    let registers: Vec<_> = (16..128u8)
        .map(|number| {
            let lane = |lane| registers(u32::from(number) * 4 + lane as u32);
            (number, Quad(std::array::from_fn(lane)))
        })
        .collect();
    let fresh = || {
        let mut spu = Spu::new();
        for &(number, value) in &registers {
            spu.set_register(number, value);
        }
        spu
    };
    let interpreted = rate(name, &mut fresh(), |spu| spu.run(&local_store, &mut Unused));
    print!("| {name} | {interpreted:.0}");
    if let Some(translations) = Translations::new(false, false) {
        let mut runner = Runner::new(&translations);
        let compiled = rate(name, &mut fresh(), |spu| {
            let stopped = runner.run(spu, &local_store, &mut Unused, u64::MAX);
            stopped.expect("the program ends")
        });
        print!(" | {compiled:.0} | {:.1}", compiled / interpreted);
    }
    println!(" |");
}

/// The seconds that the processor has spent on this thread.
fn processor_time() -> f64 {
    let mut time = libc::timespec { tv_sec: 0, tv_nsec: 0 };
    // SAFETY: the call fills `time`, which outlives it.
    let failed = unsafe { libc::clock_gettime(libc::CLOCK_THREAD_CPUTIME_ID, &raw mut time) };
    assert_eq!(failed, 0, "the host has no clock of a thread");
    time.tv_sec as f64 + time.tv_nsec as f64 / 1e9
}

/// Million instructions a second.
fn rate(name: &str, spu: &mut Spu, mut run: impl FnMut(&mut Spu) -> Stopped) -> f64 {
    let mut best = f64::INFINITY;
    for _ in 0..RUNS {
        spu.set_pc(0);
        spu.set_register(COUNTER, Quad::splat(ROUNDS));
        let start = processor_time();
        let stopped = run(spu);
        best = best.min(processor_time() - start);
        assert_eq!(stopped.reason, Stop::Signal(0), "{name}: {stopped}");
    }
    spu.executed() as f64 / f64::from(RUNS) / best / 1e6
}

fn main() {
    use Op::*;
    println!("| loop | interpreted | compiled | times as fast |");
    println!("|---|---|---|---|");
    let r = Instruction::new;
    let near_one = |n: u32| 0x3f80_0000 + n * 0x1_2345;
    let integer = [
        r(A, [20, 16, 17, 0], 0),
        r(Shli, [21, 20, 0, 0], 3),
        r(Xor, [22, 21, 18, 0], 0),
        r(Cgt, [23, 22, 19, 0], 0),
        r(Selb, [24, 22, 18, 23], 0),
        r(Rotmi, [16, 24, 0, 0], -5),
        r(Sf, [17, 16, 24, 0], 0),
        r(Andi, [19, 17, 0, 0], 0x1ff),
    ];
    measure("integer", &integer, |n| n.wrapping_mul(0x9e37_79b9));
    let chain = [
        r(Fma, [20, 16, 17, 18], 0),
        r(Fm, [21, 20, 17, 0], 0),
        r(Fa, [22, 21, 18, 0], 0),
        r(Fs, [23, 22, 19, 0], 0),
        r(Fnms, [24, 23, 17, 22], 0),
        r(Fcgt, [25, 24, 23, 0], 0),
        r(Selb, [26, 24, 23, 25], 0),
        r(Fms, [27, 26, 18, 20], 0),
    ];
    measure("float, one chain", &chain, near_one);
    let float = [
        r(Fma, [20, 16, 17, 18], 0),
        r(Fm, [21, 16, 19, 0], 0),
        r(Fa, [22, 17, 18, 0], 0),
        r(Fs, [23, 18, 19, 0], 0),
        r(Fnms, [24, 20, 21, 22], 0),
        r(Fcgt, [25, 23, 16, 0], 0),
        r(Selb, [26, 20, 21, 25], 0),
        r(Fms, [27, 21, 22, 23], 0),
    ];
    measure("float", &float, near_one);
    let junk = |n: u32| n.wrapping_mul(0x9e37_79b9) | 0x7f80_0000;
    measure("float, extremes", &float, junk);
    let estimates = [
        r(Frest, [20, 16, 0, 0], 0),
        r(Fi, [21, 16, 20, 0], 0),
        r(Fnms, [22, 21, 16, 17], 0),
        r(Fma, [23, 22, 21, 21], 0),
        r(Frsqest, [24, 18, 0, 0], 0),
        r(Fi, [25, 18, 24, 0], 0),
    ];
    measure("estimates", &estimates, near_one);
    let convert = [
        r(Csflt, [20, 16, 0, 0], 8),
        r(Fcgt, [21, 20, 17, 0], 0),
        r(Cuflt, [22, 17, 0, 0], 24),
        r(Fceq, [23, 22, 20, 0], 0),
        r(Cflts, [24, 20, 0, 0], 4),
        r(Fcmgt, [25, 22, 20, 0], 0),
        r(Cfltu, [26, 22, 0, 0], 4),
    ];
    measure("convert, compare", &convert, |n| n.wrapping_mul(0x9e37_79b9));
    let memory = [
        r(Lqd, [20, 3, 0, 0], 0x400),
        r(Lqd, [21, 3, 0, 0], 0x410),
        r(A, [22, 20, 21, 0], 0),
        r(Stqd, [22, 3, 0, 0], 0x800),
        r(Lqx, [23, 3, 4, 0], 0),
        r(Stqx, [23, 3, 5, 0], 0),
        r(Ai, [3, 3, 0, 0], 16),
        r(Andi, [3, 3, 0, 0], 0x1f0),
    ];
    measure("load, store", &memory, |n| n);
    let scalar = [
        r(Lqd, [20, 3, 0, 0], 0x400),
        r(Rotqby, [21, 20, 3, 0], 0),
        r(Ai, [22, 21, 0, 0], 1),
        r(Cwd, [23, 3, 0, 0], 4),
        r(Shufb, [24, 22, 20, 23], 0),
        r(Stqd, [24, 3, 0, 0], 0x400),
    ];
    measure("scalar in memory", &scalar, |n| n);
    let shuffle = [
        r(Shufb, [20, 16, 17, 18], 0),
        r(Rotqbyi, [21, 20, 0, 0], 5),
        r(Shufb, [22, 21, 17, 19], 0),
        r(Shlqbyi, [23, 22, 0, 0], 3),
    ];
    measure("bytes shuffled", &shuffle, |n| n.wrapping_mul(0x0b07_0301) & 0x1f1f_1f1f);
    let branchy = [
        r(Ai, [20, 20, 0, 0], 1),
        r(Andi, [21, COUNTER, 0, 0], 3),
        r(Brz, [21, 0, 0, 0], 8),
        r(Ai, [22, 22, 0, 0], 1),
        r(Andi, [23, COUNTER, 0, 0], 4),
        r(Brnz, [23, 0, 0, 0], 8),
        r(Ai, [24, 24, 0, 0], 1),
        r(Ceqi, [25, 21, 0, 0], 2),
        r(Brhnz, [25, 0, 0, 0], 8),
        r(Br, [0, 0, 0, 0], 4),
    ];
    measure("branches", &branchy, |n| n);
    let double =
        [r(Dfa, [20, 16, 17, 0], 0), r(Dfm, [21, 20, 18, 0], 0), r(Dfma, [20, 16, 21, 0], 0)];
    measure("double", &double, near_one);
}
