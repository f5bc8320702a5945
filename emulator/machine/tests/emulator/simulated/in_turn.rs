//! SPEs that run in turn on one thread: in simulated time they take the cycles that they take on
//! threads.

use std::sync::atomic::{AtomicU64, Ordering::Relaxed};

use spu_emulator::decrementer::Clock;

use crate::prelude::*;
use crate::support::base_registers;

/// Each SPE counts in a line that all share, by atomic commands, as SPUs take work units, and puts
/// what it got into main memory.
const COUNTERS: &str = "
        il      $20,200
again:  command GETLLAR, 0x2000, $3, 128, 0
        rdch    $12,$ch27
        lqa     $13,0x2000
        ai      $13,$13,1
        stqa    $13,0x2000
        command PUTLLC, 0x2000, $3, 128, 0
        rdch    $12,$ch27
        brnz    $12,again
        shli    $14,$13,7
        a       $14,$14,$3
        command PUT, 0x2000, $14, 128, 0
        wait_tags 1
        ai      $20,$20,-1
        brnz    $20,again
        stop    0x2000
";

const ECHO: &str = "
again:  rdch    $10,$ch29
        brz     $10,done
        ai      $10,$10,1
        wrch    $ch30,$10
        br      again
done:   stop    0x2000
";

/// A machine whose SPEs run in turn, in simulated time or without.
fn in_turn(simulated: bool) -> Machine {
    /// Ticks at each reading.
    struct Readings(AtomicU64);

    impl Clock for Readings {
        fn ticks(&self) -> u64 {
            self.0.fetch_add(1, Relaxed)
        }

        fn host_time(&self, _: u64) -> Duration {
            Duration::ZERO
        }
    }
    let options = SimulationOptions::default();
    Machine::made(|memory| match simulated {
        true => machine::Machine::simulated_in_turn(memory, Timing::default(), options),
        false => machine::Machine::in_turn(memory, Arc::new(Readings(AtomicU64::new(0)))),
    })
}

fn begin(machine: &Machine, source: &str, number: u32) -> Arc<Spe> {
    let (spe, entry) = machine.with_image(&assemble(source));
    spe.begin(entry, |spu: &mut Spu| {
        base_registers(spu);
        spu.set_register(4, Quad::scalar(number));
    });
    spe
}

/// The parts of a report that don't depend on when the PPE started the SPEs.
fn figures(report: &SpeReport) -> impl PartialEq + std::fmt::Debug + use<> {
    (report.account.clone(), report.waits, report.commands)
}

#[test]
fn they_take_the_cycles_of_threads() {
    const SPES: u32 = 6;
    let threads = Machine::simulated();
    let expected = threads.run_all(SPES, COUNTERS);
    let machine = in_turn(true);
    let spes: Vec<_> = (0..SPES).map(|number| begin(&machine, COUNTERS, number)).collect();
    // A call that waits for nothing else lets them run to their ends.
    let simulation = machine.simulation();
    let limit = Some(Duration::from_secs(1));
    assert_eq!(simulation.wait(simulation.new_key(), limit, || None::<()>), None);
    for spe in &spes {
        assert_eq!(spe.ended().unwrap().reason, Stop::Signal(0x2000));
    }
    assert_eq!((machine.word(0), threads.word(0)), (200 * SPES, 200 * SPES));
    let (mut taken, mut wanted) = (Vec::new(), Vec::new());
    taken.extend(simulation.report().spes.iter().map(figures));
    wanted.extend(expected.iter().map(figures));
    assert_eq!(taken, wanted);
}

#[test]
fn words_go_to_and_fro() {
    for simulated in [true, false] {
        let machine = in_turn(simulated);
        let spe = begin(&machine, ECHO, 0);
        let turns = machine.machine.turns().unwrap();
        let run = || while turns.go_on() {};
        for word in 1..=50 {
            assert!(spe.write_inbound(word, None));
            if !simulated {
                run();
            }
            assert_eq!(spe.read_outbound_interrupt(None), Some(word + 1));
        }
        assert!(spe.write_inbound(0, None));
        match machine.machine.simulation() {
            Some(simulation) => {
                let limit = Some(Duration::from_millis(1));
                simulation.wait(simulation.new_key(), limit, || None::<()>);
            }
            None => run(),
        }
        assert_eq!(spe.ended().unwrap().reason, Stop::Signal(0x2000));
    }
}

#[test]
fn waiting_for_nothing_ends() {
    let machine = in_turn(true);
    let spe = begin(&machine, ECHO, 0);
    // The SPU waits for mail, and nobody sends any.
    assert_eq!(spe.read_outbound_interrupt(None), None);
    assert!(spe.ended().is_none());
    spe.request_stop();
    assert_eq!(spe.read_outbound_interrupt(None), None);
    assert_eq!(spe.ended().unwrap().reason, Stop::Requested);
}

#[test]
fn without_simulated_time_all_get_their_turns() {
    let machine = in_turn(false);
    let spes: Vec<_> = (0..3).map(|number| begin(&machine, COUNTERS, number)).collect();
    let turns = machine.machine.turns().unwrap();
    turns.go_on();
    assert!(spes.iter().all(|spe| spe.with_spu(Spu::executed) > 0 && spe.ended().is_none()));
    while turns.go_on() {}
    assert!(spes.iter().all(|spe| spe.ended().is_some()));
    assert_eq!(machine.word(0), 600);
}
