//! Tests programs that a compiler could get wrong: they change their code, never end, fault, or
//! stop in the middle.

use std::sync::atomic::{AtomicBool, Ordering::SeqCst};

use crate::prelude::*;
use spu_emulator::channel::{Channels, NoChannels};
use spu_emulator::compiled::{Runner, Translations};
use spu_emulator::engine::Engine;
use spu_emulator::machine::Machine;

/// A number of iterations above the compile threshold.
const ROUNDS: u32 = 1000;

fn word(op: Op, [rt, ra, rb]: [u8; 3], immediate: i32) -> u32 {
    let rc = 0;
    let branch_distance = 0;
    let i = Instruction { op, rt, ra, rb, rc, branch_distance, immediate };
    i.encode()
}

fn load(local_store: &LocalStore, address: u32, code: &[u32]) {
    for (address, word) in (address..).step_by(4).zip(code) {
        local_store.write(address, &word.to_be_bytes());
    }
}

fn translations() -> Arc<Translations> {
    Translations::new(false, false).expect("the hosts of the tests have a compiler")
}

fn runner() -> Runner {
    Runner::new(&translations())
}

/// Runs the code on both engines, and asserts that they agree on all visible state. Returns the
/// stop, the SPU, and how many instructions ran in compiled code.
fn compare_engines(code: &[u32], prepare: impl Fn(&mut Spu, &LocalStore)) -> (Stopped, Spu, u64) {
    let run = |run: &mut dyn FnMut(&mut Spu, &LocalStore) -> Stopped| {
        let local_store = LocalStore::new();
        load(&local_store, 0, code);
        let mut spu = Spu::new();
        prepare(&mut spu, &local_store);
        let stopped = run(&mut spu, &local_store);
        (stopped, spu, local_store)
    };
    let (expected, interpreted, one) = run(&mut |spu, ls| spu.run(ls, &mut NoChannels));
    let mut runner = runner();
    let (stopped, spu, other) = run(&mut |spu, ls| {
        let stopped = runner.run(spu, ls, &mut NoChannels, u64::MAX);
        stopped.expect("there is no limit")
    });
    assert_eq!(stopped, expected);
    assert_eq!(spu.executed(), interpreted.executed());
    assert_eq!(spu.registers, interpreted.registers);
    assert_eq!(spu.fpscr, interpreted.fpscr);
    for address in (0..0x4000).step_by(16) {
        let (one, other) = (one.load_quadword(address), other.load_quadword(address));
        assert_eq!(one, other, "local store at {address:#x}");
    }
    (stopped, spu, runner.compiled())
}

/// A loop that runs `body` `count` times, and then a stop. $2 is the counter, and is 0 after the
/// loop.
fn counted_loop(body: &[u32], count: u32, stop: i32) -> Vec<u32> {
    let mut code = vec![word(Op::Ila, [2, 0, 0], count as i32)];
    code.extend(body);
    code.push(word(Op::Ai, [2, 2, 0], -1));
    let back = -4 * (body.len() as i32 + 1);
    code.push(word(Op::Brnz, [2, 0, 0], back));
    code.push(word(Op::Stop, [0; 3], stop));
    code
}

#[test]
fn a_loop_runs_compiled() {
    let code = counted_loop(&[word(Op::Ai, [3, 3, 0], 3)], ROUNDS, 7);
    let (stopped, spu, compiled) = compare_engines(&code, |_, _| ());
    assert_eq!((stopped.reason, stopped.pc), (Stop::Signal(7), 16));
    assert_eq!(spu.register(3), Quad::splat(3 * ROUNDS));
    assert!(compiled > 2 * u64::from(ROUNDS), "{compiled}");
}

#[test]
fn a_halt_in_a_compiled_loop_is_where_it_was() {
    let body = [
        word(Op::Ai, [3, 3, 0], 1),
        word(Op::Stqa, [3, 0, 0], 0x1000),
        word(Op::Heqi, [0, 3, 0], 500),
        word(Op::Ai, [4, 4, 0], 1),
    ];
    let code = counted_loop(&body, ROUNDS, 0);
    let (stopped, spu, compiled) = compare_engines(&code, |_, _| ());
    assert_eq!((stopped.reason, stopped.pc, stopped.npc), (Stop::Halt, 12, 16));
    assert_eq!(spu.register(4), Quad::splat(499));
    assert!(compiled > 1000, "{compiled}");
}

#[test]
fn an_invalid_word_behind_a_compiled_loop_is_where_it_was() {
    const INVALID: u32 = 0xffe0_0000;
    let mut code = counted_loop(&[word(Op::Ai, [3, 3, 0], 1)], ROUNDS, 0);
    code.pop();
    code.push(word(Op::Lnop, [0; 3], 0));
    code.push(word(Op::Nop, [0; 3], 0));
    let invalid =
        (0..=u32::MAX >> 21).map(|op| op << 21).find(|&word| Instruction::decode(word).is_none());
    code.push(invalid.unwrap_or(INVALID));
    let (stopped, _, _) = compare_engines(&code, |_, _| ());
    assert_eq!(stopped.pc, 4 * (code.len() as u32 - 1));
    assert!(matches!(stopped.reason, Stop::InvalidInstruction(_)));
}

/// A loop that replaces some of its instructions in each iteration, before or after the store.
#[test]
fn self_modifying_code_is_recompiled() {
    for distance in [-2, 1, 2] {
        // $10 alternates between two quadwords of code. $11 holds their difference.
        let body = [
            word(Op::Ai, [3, 3, 0], 1),
            word(Op::Ai, [3, 3, 0], 2),
            word(Op::Ai, [3, 3, 0], 3),
            word(Op::Stqr, [10, 0, 0], distance * 16 - 12),
            word(Op::Xor, [10, 10, 11], 0),
            word(Op::Nop, [0; 3], 0),
            word(Op::Lnop, [0; 3], 0),
            word(Op::Nop, [0; 3], 0),
            word(Op::Ai, [3, 3, 0], 4),
            word(Op::Ai, [3, 3, 0], 5),
            word(Op::Ai, [3, 3, 0], 6),
            word(Op::Ai, [3, 3, 0], 7),
        ];
        let mut code = vec![word(Op::Br, [0; 3], 64); 1];
        code.resize(16, word(Op::Nop, [0; 3], 0));
        code.extend(counted_loop(&body, ROUNDS, 0));
        let additions = [11, 12, 13, 14].map(|n| word(Op::Ai, [3, 3, 0], n));
        let others = [21, 22, 23, 24].map(|n| word(Op::Ai, [3, 3, 0], n));
        compare_engines(&code, |spu, _| {
            spu.set_register(10, Quad(additions));
            spu.set_register(11, Quad(std::array::from_fn(|n| additions[n] ^ others[n])));
        });
    }
}

/// Every limit ends a run after exactly that many instructions.
#[test]
fn limits_are_exact() {
    let body = [
        word(Op::Ai, [3, 3, 0], 1),
        word(Op::Fa, [4, 5, 6], 0),
        word(Op::Brnz, [3, 0, 0], 8),
        word(Op::Nop, [0; 3], 0),
        word(Op::Stqa, [3, 0, 0], 0x1000),
    ];
    let code = counted_loop(&body, ROUNDS * 100, 0);
    let stores = [LocalStore::new(), LocalStore::new()];
    for store in &stores {
        load(store, 0, &code);
    }
    let (mut one, mut other) = (Spu::new(), Spu::new());
    let mut runner = runner();
    for limit in (1..60).chain([1000, 20_000, 20_001, 50_000]).chain(1..60) {
        let expected = one.run_limited(&stores[0], &mut NoChannels, limit);
        let stopped = runner.run(&mut other, &stores[1], &mut NoChannels, limit);
        assert_eq!((stopped, other.pc()), (expected, one.pc()), "limit {limit}");
        assert_eq!(other.executed(), one.executed(), "limit {limit}");
        assert_eq!(other.registers, one.registers, "limit {limit}");
    }
    assert!(runner.compiled() > 50_000, "{}", runner.compiled());
}

/// Channels whose writes replace code in local store, as DMA does.
struct CodeWriter<'a>(&'a LocalStore);

impl Channels for CodeWriter<'_> {
    fn read(&mut self, channel: u8) -> Result<u32, Stop> {
        Err(Stop::InvalidChannel(channel, ChannelAccess::Read))
    }
    fn write(&mut self, _: u8, value: u32) -> Result<(), Stop> {
        load(self.0, 0x1000, &[word(Op::Ai, [3, 3, 0], value as i32 & 0x1ff)]);
        Ok(())
    }
    fn count(&mut self, _: u8) -> Result<u32, Stop> {
        Ok(1)
    }
}

#[test]
fn code_replaced_by_a_channel_write_runs_at_once() {
    // Calls a function that is replaced each time the counter is a multiple of 64.
    let body = [
        word(Op::Andi, [4, 2, 0], 63),
        word(Op::Brnz, [4, 0, 0], 8),
        word(Op::Wrch, [2, 21, 0], 0),
        word(Op::Brasl, [0, 0, 0], 0x1000),
        word(Op::Nop, [0; 3], 0),
    ];
    let code = counted_loop(&body, 8 * ROUNDS, 0);
    let function = [word(Op::Ai, [3, 3, 0], 1), word(Op::Bi, [0; 3], 0)];
    let mut results = Vec::new();
    let mut runner = runner();
    for compiled in [false, true] {
        let local_store = LocalStore::new();
        load(&local_store, 0, &code);
        load(&local_store, 0x1000, &function);
        let mut spu = Spu::new();
        let mut channels = CodeWriter(&local_store);
        let stopped = if compiled {
            runner.run(&mut spu, &local_store, &mut channels, u64::MAX)
        } else {
            Some(spu.run(&local_store, &mut channels))
        };
        results.push((stopped, spu.registers, spu.executed()));
    }
    assert_eq!(results[0], results[1]);
    assert!(runner.compiled() > u64::from(ROUNDS), "{}", runner.compiled());
}

/// A compiled loop notices when another thread stores into its code.
#[test]
fn code_written_by_others_ends_a_loop() {
    let machine = Machine::with_engine(Arc::new(RegisteredMemory::new()), Engine::Compiler);
    let spe = Spe::new(&machine, Config::default());
    load(
        spe.local_store(),
        0,
        &[word(Op::Ai, [3, 3, 0], 1), word(Op::Ai, [4, 4, 0], 1), word(Op::Br, [0; 3], -8)],
    );
    let running = Arc::clone(&spe);
    let thread = thread::spawn(move || running.run(0));
    thread::sleep(Duration::from_millis(50));
    load(spe.local_store(), 4, &[word(Op::Stop, [0; 3], 0x123)]);
    let stopped = thread.join().expect("the SPU's thread ends");
    assert_eq!((stopped.reason, stopped.pc), (Stop::Signal(0x123), 4));
}

#[test]
fn a_stop_request_ends_an_endless_loop() {
    let machine = Machine::with_engine(Arc::new(RegisteredMemory::new()), Engine::Compiler);
    let spe = Spe::new(&machine, Config::default());
    load(spe.local_store(), 0, &[word(Op::Ai, [3, 3, 0], 1), word(Op::Br, [0; 3], -4)]);
    let ended = Arc::new(AtomicBool::new(false));
    let (running, end) = (Arc::clone(&spe), Arc::clone(&ended));
    let thread = thread::spawn(move || {
        let stopped = running.run(0);
        end.store(true, SeqCst);
        stopped
    });
    thread::sleep(Duration::from_millis(50));
    assert!(!ended.load(SeqCst));
    spe.request_stop();
    let stopped = thread.join().expect("the SPU's thread ends");
    assert_eq!(stopped.reason, Stop::Requested);
    assert!(stopped.pc < 8);
}

#[test]
fn spes_share_translations() {
    let code = counted_loop(&[word(Op::Ai, [3, 3, 0], 3)], ROUNDS, 7);
    let translations = translations();
    for _ in 0..3 {
        let local_store = LocalStore::new();
        load(&local_store, 0, &code);
        let mut runner = Runner::new(&translations);
        let stopped = runner.run(&mut Spu::new(), &local_store, &mut NoChannels, u64::MAX);
        assert_eq!(stopped.map(|stopped| stopped.pc), Some(16));
        assert!(runner.compiled() > u64::from(ROUNDS));
        assert_eq!(translations.units(), 1);
    }
}

/// A number of iterations after which a loop of three instructions is optimized. Its units have
/// several iterations each.
const HOT_ROUNDS: u32 = 260_000;

/// Runs a loop that becomes hot.
fn run_hot_loop(translations: &Arc<Translations>) {
    let code = counted_loop(&[word(Op::Ai, [3, 3, 0], 3)], HOT_ROUNDS, 7);
    let local_store = LocalStore::new();
    load(&local_store, 0, &code);
    let (mut runner, mut spu) = (Runner::new(translations), Spu::new());
    let stopped = runner.run(&mut spu, &local_store, &mut NoChannels, u64::MAX);
    assert_eq!(stopped.map(|stopped| stopped.pc), Some(16));
    assert_eq!(spu.register(3), Quad::splat(3 * HOT_ROUNDS));
}

#[test]
fn a_hot_loop_is_optimized() {
    let translations = translations();
    run_hot_loop(&translations);
    assert_eq!(translations.units(), 2);
}

#[test]
fn a_thread_optimizes_in_the_background() {
    let translations = translations();
    translations.optimize_in_background();
    run_hot_loop(&translations);
    let start = Instant::now();
    while translations.units() < 2 {
        assert!(start.elapsed() < Duration::from_secs(600), "nothing was optimized");
        thread::sleep(Duration::from_millis(1));
    }
    run_hot_loop(&translations);
    assert_eq!(translations.units(), 2);
}

/// A loop whose idle lanes hold special numbers in every iteration. It soon runs in doubles.
#[test]
fn a_loop_of_specials_stays_compiled() {
    let body = [
        word(Op::Fa, [20, 16, 17], 0),
        word(Op::Fm, [21, 16, 18], 0),
        word(Op::Fs, [22, 20, 21], 0),
    ];
    let code = counted_loop(&body, 10 * ROUNDS, 0);
    let (_, spu, compiled) = compare_engines(&code, |spu, _| {
        spu.set_register(16, Quad([0x7fff_ffff, 0x3f80_0000, 0x7fff_ffff, 1]));
        spu.set_register(17, Quad([0x7fff_ffff, 0x4000_0000, 0, 0x8000_0000]));
        spu.set_register(18, Quad([0x4000_0000, 0x0080_0000, 0, 0]));
    });
    assert!(compiled > spu.executed() * 9 / 10, "{compiled} of {}", spu.executed());
}

/// A loop that has special numbers in one of 16 iterations. Its unit stays, and a slower one stands
/// in for these iterations.
#[test]
fn a_loop_of_few_specials_stays_compiled() {
    const ONE: u32 = 0x3f80_0000;
    const EXPONENT: u32 = 0x7f80_0000;
    let mut body = vec![
        word(Op::Andi, [4, 2, 0], 15),
        word(Op::Ceqi, [4, 4, 0], 0),
        word(Op::And, [5, 4, 6], 0),
        word(Op::Or, [5, 5, 7], 0),
        word(Op::Fm, [8, 5, 7], 0),
        word(Op::A, [3, 3, 8], 0),
    ];
    // So long that it is not unrolled.
    body.extend((0..20).map(|n| word(Op::Ai, [20 + n, 20 + n, 0], 1)));
    let code = counted_loop(&body, 10 * ROUNDS, 0);
    let (_, spu, compiled) = compare_engines(&code, |spu, _| {
        spu.set_register(6, Quad::splat(EXPONENT));
        spu.set_register(7, Quad::splat(ONE));
    });
    assert!(compiled > spu.executed() * 96 / 100, "{compiled} of {}", spu.executed());
}

/// The compiler does not see that both registers have the same address. The unit fails at first,
/// and the one that replaces it stores before it loads.
#[test]
fn a_loop_that_loads_what_it_has_stored_stays_compiled() {
    let body = [
        word(Op::Ai, [3, 3, 0], 1),
        word(Op::Stqd, [3, 4, 0], 0),
        word(Op::Lqd, [6, 5, 0], 0),
        word(Op::A, [7, 7, 6], 0),
    ];
    let count = 10 * ROUNDS;
    let code = counted_loop(&body, count, 0);
    let (_, spu, compiled) = compare_engines(&code, |spu, _| {
        spu.registers[4] = Quad::splat(0x2000);
        spu.registers[5] = Quad::splat(0x2000);
    });
    assert_eq!(spu.register(7), Quad::splat(count * (count + 1) / 2));
    assert!(compiled > u64::from(5 * count), "{compiled}");
}

#[test]
fn the_check_finds_nothing() {
    let body = [
        word(Op::Fa, [20, 16, 17], 0),
        word(Op::Stqa, [20, 0, 0], 0x2000),
        word(Op::Lqa, [21, 0, 0], 0x2000),
        word(Op::Frest, [22, 21, 0], 0),
    ];
    let code = counted_loop(&body, ROUNDS, 0);
    let machine = Machine::with_engine(Arc::new(RegisteredMemory::new()), Engine::Check);
    let spe = Spe::new(&machine, Config::default());
    load(spe.local_store(), 0, &code);
    let stopped = spe.run(0);
    assert_eq!(stopped.reason, Stop::Signal(0));
    assert_eq!(machine.difference(), None);
}
