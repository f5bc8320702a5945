//! The account of cycles, and what a program can see of the time.

use std::time::Duration;

use spu_emulator::simulated::{MemoryFigures, PpeFigures, SpeReport, ticks};
use spu_isa::timing::Cause;

use super::support::{Machine, assemble, register, start};

const ATOMIC_LATENCY: u64 = MemoryFigures::CONSOLE.atomic_latency;
const COMMAND_CYCLES: u64 = MemoryFigures::CONSOLE.command_cycles;
const LINE_CYCLES: u64 = MemoryFigures::CONSOLE.get_line.cycles();
const MEMORY_LATENCY: u64 = MemoryFigures::CONSOLE.get_latency;
const PPE_CALL_CYCLES: u64 = PpeFigures::CONSOLE.call_cycles;
const PPE_RUN_CYCLES: u64 = PpeFigures::CONSOLE.run_cycles;

/// The properties of every SPE's figures.
fn check(spe: &SpeReport) {
    let account = &spe.account;
    assert_eq!(spe.stopped + account.cycles(), spe.clock);
    assert_eq!(account.single() + account.dual() + account.stalled(), account.cycles());
    assert_eq!(spe.busy() + spe.waits.total(), account.cycles());
    // The pipeline counts sleep in a channel as waiting for the channel or for the MFC.
    let slept = account.waited(Cause::Channel) + account.waited(Cause::Dma);
    assert_eq!(spe.waits.total(), slept);
}

#[test]
fn the_decrementer_counts_the_cycles() {
    // Two reads, 1,000,000 cycles of work apart. The loop has a dependent add (2) and a branch
    // that is taken without a hint (1 and 18). So a pass takes 21 cycles, less those that overlap.
    let source = "
        ila     $5,50000
        il      $6,-1
        wrch    $ch7,$6
        rdch    $7,$ch8
loop:   ai      $5,$5,-1
        brnz    $5,loop
        rdch    $8,$ch8
        sf      $9,$8,$7
        stop    0x2000
";
    let machine = Machine::new();
    let (spe, entry) = machine.loaded(&assemble(source));
    let running = start(&spe, entry, 0, Duration::ZERO);
    machine.depart();
    running.end();
    let figures = &machine.report().spes[0];
    check(figures);
    let cycles = figures.account.cycles();
    assert!(cycles > 50_000 * 20, "{cycles}");
    // The few instructions before the first read and after the second take less than two ticks.
    let counted = u64::from(register(&spe, 9));
    assert!(ticks(cycles) - counted <= 2, "{} {counted}", ticks(cycles));
    // 3.192 GHz against 79.8 MHz.
    let ratio = cycles as f64 / counted as f64;
    assert!((ratio - 40.0).abs() < 0.01, "{ratio}");
}

#[test]
fn one_line_takes_as_long_as_the_constants_say() {
    let source = "
        command GET, 0x10000, $3, 128, 3
        set_channel 22, 1<<3
        set_channel 23, 0
        rdch    $5,$ch24
        set_channel 23, 2
        rdch    $6,$ch24
        set_channel 23, 0
        rdch    $7,$ch24
        stop    0x2000
";
    let machine = Machine::new();
    let (spe, entry) = machine.loaded(&assemble(source));
    let running = start(&spe, entry, 0, Duration::ZERO);
    machine.depart();
    running.end();
    // A query at once finds it incomplete, and after the wait it is complete.
    let statuses = [5, 6, 7].map(|number| register(&spe, number));
    assert_eq!(statuses, [0, 8, 8]);
    let figures = &machine.report().spes[0];
    check(figures);
    let transfer = COMMAND_CYCLES + LINE_CYCLES + MEMORY_LATENCY;
    let waited = figures.waits.tag;
    // The program spends the cycles that it does not wait in instructions between command and
    // wait. The line waits for a slot of its port and one of memory.
    assert!(waited < transfer + 35 && waited > transfer - 100, "{waited}");
    assert_eq!(figures.stopped, PPE_CALL_CYCLES + PPE_RUN_CYCLES);
    assert_eq!((figures.commands.queued, figures.commands.bytes_in), (1, 128));
}

#[test]
fn tags_rooms_and_events_come_when_commands_are_complete() {
    // 16 commands fill the queue, and a 17th waits for the first. Then the program waits for the
    // event of the tag status.
    let source = "
        .rept   16
        command GET, 0x10000, $3, 16384, 3
        .endr
        rchcnt  $5,$ch21
        command GET, 0x10000, $3, 16384, 4
        set_channel 1, 1
        set_channel 22, 0x18
        set_channel 23, 2
        rchcnt  $6,$ch24
        rdch    $7,$ch0
        rchcnt  $8,$ch24
        rdch    $9,$ch24
        rchcnt  $10,$ch21
        stop    0x2000
";
    let machine = Machine::new();
    let (spe, entry) = machine.loaded(&assemble(source));
    let running = start(&spe, entry, 0, Duration::ZERO);
    machine.depart();
    running.end();
    let seen = [5, 6, 7, 8, 9, 10].map(|number| register(&spe, number));
    assert_eq!(seen, [0, 0, 1, 1, 0x18, 16]);
    let figures = &machine.report().spes[0];
    check(figures);
    let one = 128 * LINE_CYCLES;
    let waits = figures.waits;
    assert!(waits.queue > one / 2 && waits.queue < 2 * one, "{waits:?}");
    assert!(waits.event > 15 * one, "{waits:?}");
    assert_eq!(waits.tag, 0);
}

#[test]
fn atomic_commands_and_stalled_lists_take_their_time() {
    let source = "
        command GETLLAR, 0x10000, $3, 128, 0
        rchcnt  $5,$ch27
        rdch    $6,$ch27
        # A list of one element, 16 KB at the base, that stalls after it.
        ilhu    $11,0x8000
        iohl    $11,0x4000
        cwd     $12,4($13)
        shufb   $14,$3,$11,$12
        stqa    $14,0x12000
        ila     $16,0x12000
        command GETL, 0x14000, $16, 8, 5
        rchcnt  $7,$ch25
        rdch    $8,$ch25
        set_channel 26, 5
        wait_tags 1<<5
        stop    0x2000
";
    let machine = Machine::new();
    let (spe, entry) = machine.loaded(&assemble(source));
    let running = start(&spe, entry, 0, Duration::ZERO);
    machine.depart();
    running.end();
    let seen = [5, 6, 7, 8].map(|number| register(&spe, number));
    assert_eq!(seen, [0, 4, 0, 1 << 5]);
    let figures = &machine.report().spes[0];
    check(figures);
    let waits = figures.waits;
    assert!(waits.atomic < ATOMIC_LATENCY && waits.atomic > ATOMIC_LATENCY - 30, "{waits:?}");
    assert!(waits.list > 128 * LINE_CYCLES, "{waits:?}");
    assert_eq!((figures.commands.atomic, figures.commands.queued), (1, 1));
    assert_eq!(figures.commands.bytes_in, 16384);
}

#[test]
fn the_decrementers_event_comes_at_its_time() {
    let source = "
        set_channel 1, 0x20
        ila     $5,100000
        wrch    $ch7,$5
        rdch    $6,$ch0
        rdch    $7,$ch8
        stop    0x2000
";
    let machine = Machine::new();
    let (spe, entry) = machine.loaded(&assemble(source));
    let running = start(&spe, entry, 0, Duration::ZERO);
    machine.depart();
    running.end();
    assert_eq!(register(&spe, 6), 0x20);
    assert_eq!(register(&spe, 7), u32::MAX);
    let figures = &machine.report().spes[0];
    check(figures);
    let slept = ticks(figures.waits.event);
    assert!(slept.abs_diff(100_001) <= 2, "{slept}");
}

#[test]
fn every_account_adds_up_in_a_crowd() {
    let source = "
        ila     $5,20
        shli    $6,$4,14
        a       $6,$6,$3
again:  command GET, 0x10000, $6, 2048, 1
        command PUTF, 0x10000, $6, 1024, 1
        command GETLLAR, 0x11000, $3, 128, 0
        rdch    $7,$ch27
        wait_tags 2
        ai      $5,$5,-1
        brnz    $5,again
        rdch    $8,$ch29
        stop    0x2000
";
    let machine = Machine::new();
    let image = assemble(source);
    let spes: Vec<_> = (0..6).map(|_| machine.loaded(&image)).collect();
    let running: Vec<_> = (0..)
        .zip(&spes)
        .map(|(number, (spe, entry))| start(spe, *entry, number, Duration::ZERO))
        .collect();
    // After 300 ms of simulated time all of them sleep.
    let simulation = machine.simulation();
    let limit = Some(Duration::from_millis(300));
    let none = simulation.wait(simulation.new_key(), limit, || None::<()>);
    assert!(none.is_none());
    let earlier = machine.report();
    for (spe, _) in &spes {
        assert!(spe.write_inbound(9, None));
    }
    machine.depart();
    for one in running {
        one.end();
    }
    let report = machine.report();
    for (spe, earlier) in report.spes.iter().zip(&earlier.spes) {
        check(spe);
        check(earlier);
        assert!(spe.clock > earlier.clock);
        // They slept for all of those 300 ms, except during their work.
        assert!(spe.waits.mailbox > 955_000_000, "{:?}", spe.waits);
        assert!(spe.waits.tag > 0);
        assert_eq!(spe.commands.bytes_out, 20 * 1024);
        assert_eq!(spe.commands.bytes_in, 20 * 2048);
    }
}
