//! Data that one SPE puts into another's local store: when the other's loads find it.

use std::sync::Arc;
use std::time::Duration;

use spu_emulator::signal::SignalRegister;
use spu_emulator::simulated::{MemoryFigures, Method, SpeReport};
use spu_emulator::spe::Spe;

use super::support::{BASE, Load, Machine, assemble, register, start};

const LOCAL_STORE_DELAY: u64 = MemoryFigures::CONSOLE.local_store_delay();

/// The address at which the local store of SPE n is mapped. They are 1 MB apart.
const STORES: u64 = 0x3_5000_0000;
const APART: u64 = 1 << 20;

/// Runs a program on two SPEs whose local stores are mapped. Both methods of counting must agree.
fn run(source: &str) -> ([Arc<Spe>; 2], Vec<SpeReport>) {
    let (_, by_instruction) = run_counting(source, Method::ByInstruction);
    let (spes, memoised) = run_counting(source, Method::Memoised);
    assert_eq!(memoised, by_instruction);
    (spes, memoised)
}

fn run_counting(source: &str, method: Method) -> ([Arc<Spe>; 2], Vec<SpeReport>) {
    let machine = Machine::counting(method);
    let image = assemble(source);
    machine.simulation().serialise();
    let spes = [0, 1].map(|number| {
        let (spe, entry) = machine.loaded(&image);
        let (ea, store) = (STORES + number * APART, Arc::clone(spe.local_store()));
        machine.memory.register_local_store(ea, store).unwrap();
        spe.map_local_store(ea);
        spe.map_signal(SignalRegister::One, BASE + 16 * number);
        (spe, entry)
    });
    let running = [0, 1].map(|number: u32| {
        let (spe, entry) = &spes[number as usize];
        start(spe, *entry, number, Duration::ZERO)
    });
    machine.depart();
    for one in running {
        one.end();
    }
    (spes.map(|(spe, _)| spe), machine.report().spes)
}

/// SPE 0 puts a number into the local store of SPE 1, which polls for it and puts it back. This
/// repeats for 50 numbers. $8 is the address of the other's 0x10000.
const PING_PONG: &str = "
        ilhu    $8,0x5001
        xori    $9,$4,1
        shli    $9,$9,20
        a       $8,$8,$9
        il      $10,1
        brnz    $4,look
send:   stqa    $10,0x11000
        command PUT, 0x11000, $8, 16, 3
        brz     $4,look
        ai      $10,$10,1
        ceqi    $12,$10,51
        brnz    $12,over
look:   lqa     $6,0x10000
        ceq     $7,$6,$10
        brz     $7,look
        brnz    $4,send
        ai      $10,$10,1
        ceqi    $12,$10,51
        brz     $12,send
over:   wait_tags 1<<3
        stop    0x2000
";
const HOPS: u64 = 100;

#[test]
fn a_put_is_found_by_polling_when_its_transfer_is_complete() {
    let (_, first) = run(PING_PONG);
    let hop = first[0].account.cycles() / HOPS;
    // The channel writes of the commands, and one and a half passes of the polling loop, are
    // added.
    assert!(hop >= LOCAL_STORE_DELAY, "{hop}");
    assert!(hop < LOCAL_STORE_DELAY + 100, "{hop}");
    let _load = Load::new(2);
    for _ in 0..3 {
        assert_eq!(run(PING_PONG).1, first);
    }
}

/// SPE 0 signals SPE 1, which sleeps until the signal comes and puts its number into the local
/// store of SPE 0. SPE 0 polls for it.
const ANSWERED: &str = "
        il      $10,1
        brnz    $4,asleep
        ai      $8,$3,16
ask:    stqa    $10,0x11000
        command SNDSIG, 0x11000, $8, 4, 4
look:   lqa     $6,0x10000
        ceq     $7,$6,$10
        brz     $7,look
        ai      $10,$10,1
        ceqi    $12,$10,51
        brz     $12,ask
        stop    0x2000
asleep: ilhu    $8,0x5001
again:  rdch    $10,$ch3
        stqa    $10,0x11000
        command PUT, 0x11000, $8, 16, 3
        ceqi    $12,$10,50
        brz     $12,again
        wait_tags 1<<3
        stop    0x2000
";

#[test]
fn the_answer_of_a_sleeper_is_found_when_its_transfer_is_complete() {
    let (_, spes) = run(ANSWERED);
    let round = spes[0].account.cycles() / 50;
    assert!(round >= 2 * LOCAL_STORE_DELAY, "{round}");
    assert!(round < 2 * LOCAL_STORE_DELAY + 150, "{round}");
}

/// SPE 0 sends 16 KB, which takes some 2300 cycles. SPE 1 reads the last quadword after some 800
/// cycles, and again after a multisource synchronisation.
const UNDER_WAY: &str = "
        brnz    $4,reader
        ilhu    $8,0x5011
        il      $7,1
        ila     $9,0x13ff0
        stqd    $7,0($9)
        command PUT, 0x10000, $8, 16384, 3
        wait_tags 1<<3
        stop    0x2000
reader: il      $6,40
delay:  ai      $6,$6,-1
        brnz    $6,delay
        lqa     $10,0x13ff0
        wrch    $ch9,$6
        lqa     $11,0x13ff0
        stop    0x2000
";

#[test]
fn a_multisource_synchronisation_waits_for_what_is_under_way() {
    let (spes, _) = run(UNDER_WAY);
    assert_eq!([10, 11].map(|number| register(&spes[1], number)), [0, 1]);
}

/// SPE 0 puts a number and fetches it back, with a fence between. SPE 1 only waits for the number.
const FENCED: &str = "
        brnz    $4,look
        ilhu    $8,0x5011
        il      $7,5
        stqa    $7,0x10000
        command PUT, 0x10000, $8, 16, 3
        command GETF, 0x11000, $8, 16, 3
        wait_tags 1<<3
        lqa     $10,0x11000
        stop    0x2000
look:   lqa     $10,0x10000
        brz     $10,look
        stop    0x2000
";

#[test]
fn a_fenced_get_finds_what_was_put_before_it() {
    let (spes, _) = run(FENCED);
    assert_eq!(spes.each_ref().map(|spe| register(spe, 10)), [5, 5]);
}

/// SPE 0 stops without waiting for its put. SPE 1 stopped long before.
const UNAWAITED: &str = "
        brnz    $4,over
        ila     $6,3000
delay:  ai      $6,$6,-1
        brnz    $6,delay
        ilhu    $8,0x5011
        il      $7,5
        stqa    $7,0x10000
        command PUT, 0x10000, $8, 16, 3
over:   stop    0x2000
";

#[test]
fn a_put_arrives_though_nobody_waits_for_it() {
    let (spes, _) = run(UNAWAITED);
    assert_eq!(spes[1].local_store().load_word(0x10000), 5);
}
