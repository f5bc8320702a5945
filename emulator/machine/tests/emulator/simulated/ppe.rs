//! PPE threads as actors: mails, polls, sleeps, and threads that never come back.

use std::sync::{Barrier, mpsc};

use spu_emulator::simulated::{PpeFigures, ticks};

use super::disturbance::{Disturbance, Load};
use crate::prelude::*;
use crate::support::{TIMEOUT, start_later};

const PPE_CALL_CYCLES: u64 = PpeFigures::CONSOLE.call_cycles;
const PPE_WAKE_CYCLES: u64 = PpeFigures::CONSOLE.wake_cycles;

/// Keeps the time at which the last mail came in $6, and sends each mail back.
const ECHO: &str = "
        il      $6,-1
        wrch    $ch7,$6
again:  rdch    $5,$ch29
        brz     $5,over
        rdch    $6,$ch8
        wrch    $ch28,$5
        br      again
over:   stop    0x2000
";

#[test]
fn mails_come_one_call_after_the_other() {
    let machine = Machine::simulated();
    let image = assemble(ECHO);
    let spes: Vec<_> = (0..6).map(|_| machine.with_image(&image)).collect();
    let running: Vec<_> = spes.iter().map(|(spe, entry)| start(spe, *entry)).collect();
    let settle = Some(Duration::from_micros(100));
    let key = machine.simulation().new_key();
    assert!(machine.simulation().wait(key, settle, || None::<()>).is_none());
    for (spe, _) in &spes {
        spe.write_inbound(1, None);
    }
    for (spe, _) in &spes {
        assert_eq!(spe.read_outbound(None), Some(1));
        spe.write_inbound(0, None);
    }
    machine.depart();
    for one in running {
        one.end();
    }
    let times: Vec<u32> = spes.iter().map(|(spe, _)| register(spe, 6)).collect();
    for pair in times.windows(2) {
        let between = u64::from(pair[0].wrapping_sub(pair[1]));
        assert!(between.abs_diff(ticks(PPE_CALL_CYCLES)) <= 1, "{times:?}");
    }
}

#[test]
fn a_thread_that_looks_again_and_again_sees_the_same_in_every_run() {
    let image = assemble(
        "
        ila     $6,40000
work:   ai      $6,$6,-1
        brnz    $6,work
        wrch    $ch28,$6
        stop    0x2000
",
    );
    let looks = |disturbance: &Disturbance| {
        let machine = Machine::simulated();
        let (spe, entry) = machine.with_image(&image);
        let running = start_later(&spe, entry, 0, disturbance.delay());
        let mut looks = 0;
        while spe.outbound_waiting() == 0 {
            looks += 1;
            if looks % 64 == 0 {
                disturbance.sleep();
            }
        }
        assert_eq!(spe.read_outbound(None), Some(0));
        machine.depart();
        running.end();
        (looks, machine.report().spes)
    };
    let first = looks(&Disturbance::new(1));
    // 40,000 passes of about 21 cycles, in steps of a call.
    assert!((450..600).contains(&first.0), "{}", first.0);
    let _load = Load::new(2);
    assert_eq!(looks(&Disturbance::new(2)), first);
}

#[test]
fn a_limit_is_simulated_time() {
    let machine = Machine::simulated();
    let image = assemble("        br _start\n");
    let (spe, entry) = machine.with_image(&image);
    let running = start(&spe, entry);
    let key = machine.simulation().new_key();
    let limit = Duration::from_millis(1);
    assert!(machine.simulation().wait(key, Some(limit), || None::<()>).is_none());
    let now = || Some(Instant::now());
    let accepted = (0..9).take_while(|word| spe.write_inbound(*word, now()));
    assert_eq!(accepted.count(), 4);
    spe.request_stop();
    machine.depart();
    assert_eq!(running.wait().reason, Stop::Requested);
    // Three million cycles passed while it ran. How soon it notices the request depends on the
    // host.
    assert!(machine.report().spes[0].clock >= 3_192_000);
}

#[test]
fn a_sleeper_that_is_left_alone_lets_the_hosts_time_pass_too() {
    let machine = Machine::simulated();
    let key = machine.simulation().new_key();
    let limit = Duration::from_millis(50);
    let start = Instant::now();
    assert!(machine.simulation().wait(key, Some(limit), || None::<()>).is_none());
    assert!(start.elapsed() >= limit);
}

#[test]
fn absent_threads_delay_others_briefly() {
    let machine = Machine::simulated();
    let image = assemble(ECHO);
    let (spe, entry) = machine.with_image(&image);
    let running = start(&spe, entry);
    // This thread sends a mail, and then sleeps until the program has ended, which waits for it.
    spe.write_inbound(0, None);
    running.end();
    assert!(machine.report().timeouts >= 1);
}

#[test]
fn a_thread_that_ran_one_spe_and_then_waits_for_another_is_given_up() {
    // SPE 0 issues in pairs, which takes much time on the host. SPE 1 stalls most of the time, so
    // it is far ahead, and waits to act when SPE 0 stops.
    let image = assemble(
        "
        brnz    $4,act
        ila     $6,20000
work:
        .rept   64
        nop
        lnop
        .endr
        ai      $6,$6,-1
        brnz    $6,work
        stop    0x2000
act:    ila     $6,60000
delay:  dfa     $7,$7,$7
        dfa     $7,$7,$7
        ai      $6,$6,-1
        brnz    $6,delay
        wrch    $ch28,$6
        stop    0x2000
",
    );
    let machine = Machine::simulated();
    let spes = [machine.with_image(&image), machine.with_image(&image)];
    let later = start_later(&spes[1].0, spes[1].1, 1, Duration::ZERO);
    let (done, finished) = mpsc::channel();
    thread::spawn(move || {
        let (spe, entry) = &spes[0];
        spe.run(*entry);
        later.end();
        done.send(()).unwrap();
    });
    machine.depart();
    finished.recv_timeout(2 * TIMEOUT).unwrap();
    let clocks: Vec<u64> = machine.report().spes.iter().map(|spe| spe.clock).collect();
    assert!(clocks[1] > clocks[0] + PPE_WAKE_CYCLES, "{clocks:?}");
}

#[test]
fn an_spe_that_is_loaded_and_never_run_holds_nobody_up_for_good() {
    let machine = Machine::simulated();
    let image = assemble(ECHO);
    let never_run = machine.with_image(&image);
    let (spe, entry) = machine.with_image(&image);
    let running = start(&spe, entry);
    spe.write_inbound(5, None);
    assert_eq!(spe.read_outbound(None), Some(5));
    spe.write_inbound(0, None);
    machine.depart();
    running.end();
    drop(never_run);
}

#[test]
fn several_ppe_threads_and_a_full_mailbox() {
    let machine = Machine::simulated();
    let image = assemble(
        "
        ila     $5,4000
again:  rdch    $6,$ch29
        a       $7,$7,$6
        ai      $5,$5,-1
        brnz    $5,again
        stop    0x2000
",
    );
    let (spe, entry) = machine.with_image(&image);
    let running = start(&spe, entry);
    let ready = Arc::new(Barrier::new(4));
    let (done, finished) = mpsc::channel();
    for _ in 0..4 {
        let (spe, ready, done) = (Arc::clone(&spe), Arc::clone(&ready), done.clone());
        thread::spawn(move || {
            ready.wait();
            for _ in 0..1000 {
                assert!(spe.write_inbound(3, None));
            }
            done.send(()).unwrap();
        });
    }
    machine.depart();
    for _ in 0..4 {
        finished.recv_timeout(TIMEOUT).unwrap();
    }
    running.end();
    assert_eq!(register(&spe, 7), 12_000);
}
