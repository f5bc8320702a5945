//! Mailboxes and signals across threads, and stop requests.

use spu_emulator::signal::SignalMode;

use crate::prelude::*;
use crate::support::{at_once, load};

const ECHO: &str = "
again:  rdch    $10,$ch29
        brz     $10,done
        ai      $10,$10,1
        wrch    $ch28,$10
        br      again
done:   stop    0x2000
";

#[test]
fn words_go_to_and_fro() {
    let (spe, entry) = Machine::new().loaded(Policy::AtOnce, ECHO);
    let running = start(&spe, entry);
    for n in 1..=1000 {
        assert!(spe.write_inbound(n, soon()));
        assert_eq!(spe.read_outbound(soon()), Some(n + 1));
    }
    assert!(spe.write_inbound(0, soon()));
    assert_eq!(running.wait().reason, Stop::Signal(0x2000));
}

#[test]
fn a_full_mailbox_holds_its_writer_on_both_sides() {
    let (spe, entry) = Machine::new().loaded(Policy::AtOnce, ECHO);
    for n in 1..=4 {
        assert_eq!(spe.inbound_free(), 5 - n);
        assert!(spe.write_inbound(n as u32 * 10, at_once()));
    }
    assert!(!spe.write_inbound(50, at_once()));
    let running = start(&spe, entry);
    // The SPU sleeps with 11 in the outbound mailbox, and is about to write 21.
    assert!(running.sleeps());
    assert_eq!(spe.outbound_waiting(), 1);
    for n in 1..=4 {
        assert_eq!(spe.read_outbound(soon()), Some(n * 10 + 1));
    }
    assert_eq!(spe.read_outbound(at_once()), None);
    assert!(spe.write_inbound(0, soon()));
    running.wait();
}

#[test]
fn the_interrupt_mailbox_is_another_one() {
    let source = "
        set_channel 30, 7
        rchcnt  $10,$ch30
        rchcnt  $11,$ch28
        set_channel 30, 8
        stop    1
";
    let (spe, entry) = Machine::new().loaded(Policy::AtOnce, source);
    let running = start(&spe, entry);
    assert!(running.sleeps());
    assert_eq!(spe.read_outbound_interrupt(soon()), Some(7));
    assert_eq!(spe.read_outbound_interrupt(soon()), Some(8));
    assert_eq!(running.wait().reason, Stop::Signal(1));
    assert_eq!((register(&spe, 10), register(&spe, 11)), (0, 1));
}

#[test]
fn a_stop_request_wakes_a_sleeping_spu_which_goes_on_later() {
    let (spe, entry) = Machine::new().loaded(Policy::AtOnce, "rdch $10,$ch29\n stop 5\n");
    let running = start(&spe, entry);
    assert!(running.sleeps());
    spe.request_stop();
    let stopped = running.wait();
    assert_eq!((stopped.reason, stopped.npc), (Stop::Requested, entry));
    assert!(spe.write_inbound(77, at_once()));
    assert_eq!(run_to_stop(&spe, stopped.npc), 5);
    assert_eq!(register(&spe, 10), 77);
}

#[test]
fn a_stop_request_ends_a_loop_and_is_used_up() {
    let source = "il $10,1\n stqa $10,0x8000\n again: br again\n";
    let (spe, entry) = Machine::new().loaded(Policy::AtOnce, source);
    let running = start(&spe, entry);
    assert!(running.stores_to(0x8000));
    spe.request_stop();
    assert_eq!(running.wait().reason, Stop::Requested);
    // If the SPU is not running, a request ends the next run before its first instruction.
    spe.request_stop();
    spe.local_store().write(0x8000, &[0; 4]);
    assert_eq!(start(&spe, entry).wait().reason, Stop::Requested);
    let running = start(&spe, entry);
    assert!(running.stores_to(0x8000));
    spe.request_stop();
    running.wait();
}

#[test]
fn every_blocking_channel_is_left_by_a_stop_request() {
    // Outbound mailboxes are full at their second write. The list is never resumed.
    let sleeps = [
        "rdch $10,$ch0",
        "rdch $10,$ch3",
        "rdch $10,$ch4",
        "rdch $10,$ch24",
        "rdch $10,$ch25",
        "rdch $10,$ch27",
        "rdch $10,$ch29",
        "wrch $ch28,$10\n wrch $ch28,$10",
        "wrch $ch30,$10\n wrch $ch30,$10",
        "set_channel 22, 0\n set_channel 23, 1\n rdch $10,$ch24",
    ];
    for source in sleeps {
        for policy in [Policy::AtOnce, Policy::AtLast] {
            let (spe, entry) = Machine::new().loaded(policy, &format!("{source}\n stop 1\n"));
            let running = start(&spe, entry);
            assert!(running.sleeps(), "{source}");
            spe.request_stop();
            assert_eq!(running.wait().reason, Stop::Requested, "{source}");
        }
    }
}

#[test]
fn signals_replace_or_accumulate() {
    let machine = Machine::new();
    let spe = machine
        .spe(Config { signal_modes: [SignalMode::Or, SignalMode::Overwrite], ..Config::default() });
    let source = "
        rdch    $10,$ch3
        rdch    $11,$ch4
        rchcnt  $12,$ch3
        rdch    $13,$ch3
        stop    1
";
    let entry = load(&spe, &assemble(source));
    for register in [SignalRegister::One, SignalRegister::Two] {
        spe.signal(register, 0x0f);
        spe.signal(register, 0xf0);
    }
    let running = start(&spe, entry);
    assert!(running.sleeps());
    spe.signal(SignalRegister::One, 3);
    running.wait();
    let read = [10, 11, 12, 13].map(|n| register(&spe, n));
    assert_eq!(read, [0xff, 0xf0, 0, 3]);
}
