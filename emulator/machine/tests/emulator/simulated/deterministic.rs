//! Tests that cycle counts are the same in every run, however the host behaves, and with both
//! methods of counting.

use spu_emulator::memory::MainMemory;
use spu_emulator::simulated::MemoryFigures;

use super::disturbance::{Disturbance, Load};
use crate::prelude::*;
use crate::support::start_later;

const LOCAL_STORE_LATENCY: u64 = MemoryFigures::CONSOLE.local_store_latency;

const SPES: usize = 6;

/// A program that behaves as the ray tracer does. It sleeps until a frame comes and takes tiles
/// from a shared counter until none is left. It works on each tile for a time that depends on the
/// tile, moves data in and out under two tags, and sends its count.
const TRACER: &str = "
        ila     $5,0
        cwd     $14,0($13)
frame:  rdch    $10,$ch29
        brz     $10,over
        rdch    $11,$ch8
tile:   command GETLLAR, 0x10000, $3, 128, 0
        rdch    $12,$ch27
        lqa     $15,0x10000
        ai      $16,$15,1
        shufb   $16,$16,$15,$14
        stqa    $16,0x10000
        command PUTLLC, 0x10000, $3, 128, 0
        rdch    $12,$ch27
        brnz    $12,tile
        clgti   $17,$15,40
        brnz    $17,reply
        ai      $5,$5,1
        # The tile's data, from its own place.
        shli    $18,$15,12
        a       $18,$18,$3
        ila     $19,0x1000
        a       $18,$18,$19
        command GET, 0x11000, $18, 4096, 1
        wait_tags 2
        # 37 rounds for each unit of (tile & 15) + 1.
        andi    $20,$15,15
        ai      $20,$20,1
        mpyi    $20,$20,37
work:   fa      $21,$21,$22
        ai      $20,$20,-1
        brnz    $20,work
        command PUT, 0x11000, $18, 4096, 2
        br      tile
reply:  wait_tags 6
        wrch    $ch30,$5
        br      frame
over:   stop    0x2000
";

/// Three frames on six SPEs. Returns the figures, and the counts that the SPEs sent.
fn trace(
    image: &[u8],
    disturbance: &Disturbance,
    method: Method,
) -> (Vec<SpeReport>, Vec<Vec<u32>>) {
    let machine = Machine::counting(method);
    let mut spes: Vec<(Arc<Spe>, u32)> = Vec::new();
    let mut running = Vec::new();
    for number in 0..SPES {
        disturbance.sleep();
        let (spe, entry) = machine.with_image(image);
        running.push(start_later(&spe, entry, number as u32, disturbance.delay()));
        spes.push((spe, entry));
    }
    let mut replies = Vec::new();
    for _ in 0..3 {
        machine.memory.write(BASE, &[0; 128]).unwrap();
        for (spe, _) in &spes {
            disturbance.sleep();
            assert!(spe.write_inbound(1, None));
        }
        let reply = |(spe, _): &(Arc<Spe>, u32)| {
            disturbance.sleep();
            spe.read_outbound_interrupt(None).unwrap()
        };
        replies.push(spes.iter().map(reply).collect());
        // Each SPE notices by itself that no tile is left.
        assert_eq!(machine.word(0), 41 + SPES as u32);
    }
    for (spe, _) in &spes {
        assert!(spe.write_inbound(0, None));
    }
    machine.depart();
    for one in running {
        one.end();
    }
    (machine.report().spes, replies)
}

#[test]
fn a_tracer_gives_the_same_counts_under_load_and_delays() {
    let image = assemble(TRACER);
    let calm = trace(&image, &Disturbance::new(1), Method::ByInstruction);
    for spe in &calm.0 {
        assert!(spe.account.instructions() > 1000);
        assert!(spe.waits.mailbox > 0 && spe.waits.tag > 0 && spe.waits.atomic > 0);
    }
    let tiles: u32 = calm.1.last().unwrap().iter().sum();
    assert_eq!(tiles, 3 * 41);
    for seed in 2..6 {
        let disturbed = trace(&image, &Disturbance::new(seed), Method::Memoised);
        assert_eq!(disturbed, calm, "seed {seed}");
    }
    let _load = Load::new(6);
    for seed in 6..8 {
        let disturbed = trace(&image, &Disturbance::new(seed), Method::Memoised);
        assert_eq!(disturbed, calm, "seed {seed}");
    }
}

/// Each SPE increments the counter as fast as it can. The one that loses a race tries again.
const CONTEND: &str = "
        cwd     $14,0($13)
        ila     $5,100
again:  command GETLLAR, 0x10000, $3, 128, 0
        rdch    $12,$ch27
        lqa     $15,0x10000
        ai      $16,$15,1
        shufb   $16,$16,$15,$14
        stqa    $16,0x10000
        command PUTLLC, 0x10000, $3, 128, 0
        rdch    $12,$ch27
        a       $6,$6,$12
        brnz    $12,again
        ai      $5,$5,-1
        brnz    $5,again
        stop    0x2000
";

#[test]
fn contended_line_has_same_winners_in_every_run() {
    let contend = |method| {
        let machine = Machine::counting(method);
        let spes = machine.run_all(SPES as u32, CONTEND);
        assert_eq!(machine.word(0), 600);
        spes
    };
    let first = contend(Method::ByInstruction);
    let alone = Machine::simulated().run_all(1, CONTEND);
    // An SPE that loses a race needs additional commands.
    assert!(first.iter().all(|spe| spe.commands.atomic >= 200));
    assert!(first.iter().map(|spe| spe.commands.atomic).sum::<u64>() > 1200);
    assert_eq!(alone[0].commands.atomic, 200);
    assert!(first[0].clock > 2 * alone[0].clock);
    for _ in 0..5 {
        assert_eq!(contend(Method::Memoised), first);
    }
}

/// Each SPE puts its count to lines that all share, by a command and by a list, and adds up what it
/// finds in one of them. It waits for each put only before it changes the put's bytes.
const SHARE: &str = "
        ila     $5,150
        a       $6,$3,$4
        ila     $7,0x12000
        ilhu    $9,0
        iohl    $9,16
again:  wait_tags 2
        a       $8,$5,$4
        stqa    $8,0x10000
        command PUT, 0x10000, $3, 16, 1
        andi    $20,$8,15
        ai      $20,$20,3
work:   fa      $21,$21,$22
        ai      $20,$20,-1
        brnz    $20,work
        wait_tags 4
        stqa    $8,0x11000
        stqa    $9,0x12000
        ai      $10,$3,128
        cwd     $11,4($13)
        lqa     $12,0x12000
        shufb   $12,$10,$12,$11
        stqa    $12,0x12000
        command PUTL, 0x11000, $7, 8, 2
        andi    $20,$5,3
        brnz    $20,next
        command GET, 0x13000, $3, 256, 3
        wait_tags 8
        lqa     $12,0x13000
        a       $30,$30,$12
        lqa     $12,0x13080
        a       $30,$30,$12
next:   ai      $5,$5,-1
        brnz    $5,again
        stop    0x2000
";

/// With a timeline each put waits for its turn, so this compares both ways.
#[test]
fn asynchronous_puts_complete_in_turn() {
    let share = |machine: Machine| {
        let image = assemble(SHARE);
        let spes: Vec<_> = (0..SPES).map(|_| machine.with_image(&image)).collect();
        let figures = machine.run_together(&spes);
        let sums: Vec<_> = spes.iter().map(|(spe, _)| register(spe, 30)).collect();
        (figures, sums)
    };
    let timeline = SimulationOptions { timeline: true, ..SimulationOptions::default() };
    let waiting = share(Machine::simulated_with(Timing::default(), timeline));
    assert!(waiting.0.iter().all(|spe| spe.commands.queued > 300));
    assert!(waiting.1.windows(2).any(|pair| pair[0] != pair[1]));
    let _load = Load::new(3);
    for _ in 0..5 {
        assert_eq!(share(Machine::simulated()), waiting);
    }
}

/// SPE 0 counts until it finds a word that SPE 1 puts into its local store after a while. It
/// learns of the word in no other way.
const WATCH: &str = "
        brnz    $4,sender
look:   ai      $5,$5,1
        lqa     $6,0x10000
        brz     $6,look
        stop    0x2000
sender: ila     $6,30000
delay:  ai      $6,$6,-1
        brnz    $6,delay
        ila     $7,1
        stqa    $7,0x11000
        il      $8,0
        iohl    $8,0
        ilhu    $8,0x5001
        command PUT, 0x11000, $8, 16, 3
        wait_tags 1<<3
        stop    0x2000
";
/// The address at which the local store of SPE 0 is mapped: 0x10000 above is at 0x50010000.
const STORE_EA: u64 = 0x3_5000_0000;

fn watch(image: &[u8], disturbance: &Disturbance, method: Method) -> (u32, Vec<SpeReport>) {
    let machine = Machine::counting(method);
    let (watcher, entry) = machine.with_image(image);
    let (sender, _) = machine.with_image(image);
    let store = Arc::clone(watcher.local_store());
    machine.memory.register_local_store(STORE_EA, store).unwrap();
    watcher.map_local_store(STORE_EA);
    machine.simulation().serialise();
    let first = start_later(&watcher, entry, 0, disturbance.delay());
    let second = start_later(&sender, entry, 1, disturbance.delay());
    machine.depart();
    first.end();
    second.end();
    (register(&watcher, 5), machine.report().spes)
}

#[test]
fn a_local_store_that_others_write_is_seen_at_the_same_time_in_every_run() {
    let image = assemble(WATCH);
    let first = watch(&image, &Disturbance::new(1), Method::ByInstruction);
    assert!(first.0 > 1000);
    let _load = Load::new(2);
    for seed in 2..6 {
        let disturbed = watch(&image, &Disturbance::new(seed), Method::Memoised);
        assert_eq!(disturbed, first);
    }
}

/// SPEs in a ring: each waits for a signal, then sends one to the next.
const RING: &str = "
        ila     $5,50
        shli    $7,$4,4
        a       $3,$3,$7
        stqa    $4,0x10000
next:   rdch    $6,$ch3
        command SNDSIG, 0x10000, $3, 4, 0
        wait_tags 1
        ai      $5,$5,-1
        brnz    $5,next
        stop    0x2000
";

#[test]
fn signals_go_round_and_take_their_time() {
    let image = assemble(RING);
    let ring = |method| {
        let machine = Machine::counting(method);
        let spes: Vec<_> = (0..SPES).map(|_| machine.with_image(&image)).collect();
        for (number, (spe, _)) in (0_u64..).zip(&spes) {
            // SPE n sends to the address at which the register of SPE n + 1 is mapped.
            let sender = (number + SPES as u64 - 1) % SPES as u64;
            spe.map_signal(SignalRegister::One, BASE + sender * 16);
        }
        spes[0].0.signal(SignalRegister::One, 7);
        machine.run_together(&spes);
        machine.report()
    };
    let first = ring(Method::Memoised);
    let hops = SPES as u64 * 50;
    let clock = first.clock();
    assert!(clock > hops * LOCAL_STORE_LATENCY, "{clock}");
    assert!(clock < hops * LOCAL_STORE_LATENCY * 3 + 100_000, "{clock}");
    assert_eq!(ring(Method::ByInstruction).spes, first.spes);
}
