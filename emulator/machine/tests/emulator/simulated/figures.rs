//! Timing with other values than the console's: each value changes the cycles that it should.
//! A value that delays the start of a transfer is a multiple of the slots of ports and of memory,
//! because a transfer waits for the next slot.

use crate::prelude::*;
use spu_emulator::simulated::{MemoryFigures, PpeFigures};
use spu_isa::timing::{Cause, Rules};

/// A line from main memory, an atomic command, and ten branches without hints, of which nine are
/// taken.
const PROGRAM: &str = "
        command GET, 0x10000, $3, 128, 3
        wait_tags 1<<3
        command GETLLAR, 0x10000, $3, 128, 0
        rdch    $12,$ch27
        il      $5,10
again:  ai      $5,$5,-1
        brnz    $5,again
        stop    0x2000
";

fn time(timing: Timing) -> SpeReport {
    Machine::simulated_with(timing, SimulationOptions::default()).run_all(1, PROGRAM).remove(0)
}

#[test]
fn the_default_is_the_console() {
    let timing = Timing::default();
    assert_eq!(timing.rules, Rules::default());
    assert_eq!(timing.memory, MemoryFigures::CONSOLE);
    assert_eq!(timing.ppe, PpeFigures::CONSOLE);
    assert_eq!(
        Machine::simulated_with(timing, SimulationOptions::default()).simulation().timing(),
        &timing
    );
    assert_eq!(time(timing), Machine::simulated().run_all(1, PROGRAM).remove(0));
}

#[test]
fn rules_of_the_pipelines() {
    let console = time(Timing::default());
    let mut timing = Timing::default();
    timing.rules.miss_cycles = 19;
    let slower = time(timing);
    let misses = |spe: &SpeReport| spe.account.waited(Cause::BranchMiss);
    assert_eq!(misses(&console), 9 * 18);
    assert_eq!(misses(&slower), 9 * 19);
    assert_eq!(slower.clock, console.clock + 9);
}

#[test]
fn figures_of_the_memory_system() {
    let console = time(Timing::default());
    let with = |change: fn(&mut MemoryFigures)| {
        let mut timing = Timing::default();
        change(&mut timing.memory);
        time(timing)
    };
    let latency = with(|memory| memory.get_latency += 100);
    assert_eq!(latency.waits.tag, console.waits.tag + 100);
    let command = with(|memory| memory.command_cycles += 17 * 173);
    assert_eq!(command.waits.tag, console.waits.tag + 17 * 173);
    let atomic = with(|memory| memory.atomic_latency += 50);
    assert_eq!(atomic.waits.atomic, console.waits.atomic + 50);
    assert_eq!(atomic.clock, console.clock + 50);
}

#[test]
fn figures_of_the_ppe() {
    let console = time(Timing::default());
    let mut timing = Timing::default();
    timing.ppe.run_cycles += 17 * 173;
    let later = time(timing);
    assert_eq!(later.stopped, console.stopped + 17 * 173);
    assert_eq!(later.account, console.account);
}

#[test]
#[should_panic(expected = "no line would ever arrive")]
fn zero_outstanding_lines_are_refused() {
    let mut timing = Timing::default();
    timing.memory.outstanding_lines = 0;
    Machine::simulated_with(timing, SimulationOptions::default());
}
