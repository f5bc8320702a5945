//! Races between an SPU and its own DMA commands: which are reported, and which are none.

use std::sync::{Arc, Mutex};

use spu_emulator::engine::Engine;
use spu_emulator::simulated::{Method, Race, SimulationOptions, SpeReport, Use};

use super::support::{Machine, assemble, start};

/// Each with every way to run and count.
const WAYS: [(Method, Engine); 4] = [
    (Method::ByInstruction, Engine::Interpreter),
    (Method::Memoised, Engine::Interpreter),
    (Method::Memoised, Engine::Compiler),
    (Method::Checked, Engine::Check),
];

fn run_with(image: &[u8], options: SimulationOptions) -> (Vec<Race>, SpeReport) {
    let machine = Machine::with_options(options);
    let races: Arc<Mutex<Vec<Race>>> = Arc::default();
    let found = Arc::clone(&races);
    let simulation = machine.simulation();
    simulation.on_race(move |race| found.lock().unwrap().push(*race));
    let (spe, entry) = machine.loaded(image);
    let running = start(&spe, entry, 0, std::time::Duration::ZERO);
    machine.depart();
    running.end();
    let races = races.lock().unwrap().clone();
    (races, machine.report().spes.remove(0))
}

/// The races of a program, which must be the same with every engine. The watch must not change its
/// cycles.
fn races(source: &str) -> Vec<Race> {
    let image = assemble(&format!("{source}\n        stop    0x2000"));
    let (none, unwatched) = run_with(&image, SimulationOptions::default());
    assert_eq!(none, []);
    let mut all = WAYS.map(|(method, engine)| {
        let options =
            SimulationOptions { races: true, method, engine, ..SimulationOptions::default() };
        let (races, report) = run_with(&image, options);
        assert_eq!(report, unwatched, "{method:?} {engine:?}");
        races
    });
    assert!(all.iter().all(|races| *races == all[0]), "{all:#?}");
    std::mem::take(&mut all[0])
}

/// What is used, and where.
fn uses(source: &str) -> Vec<(Use, u32)> {
    let uses = races(source);
    uses.iter().map(|race| (race.by, race.address)).collect()
}

const GET: u8 = 0x40;
const PUT: u8 = 0x20;

#[test]
fn a_load_that_does_not_wait_races() {
    let source = "
        command GET, 0x1000, $3, 128, 5
        lqa     $8,0x1010
        lqa     $8,0x1080
        wait_tags 0x20
        lqa     $8,0x1010";
    let races = races(source);
    assert_eq!(races.len(), 1, "{races:#?}");
    let race = races[0];
    assert_eq!((race.by, race.address), (Use::Load, 0x1010));
    let command = race.command;
    assert_eq!((command.opcode, command.tag, command.size), (GET, 5, 128));
    assert_eq!((command.lsa, command.ea), (0x1000, 0x3_4000_0000));
    assert_eq!(race.pc, command.pc + 4);
    let text = race.to_string();
    let parts = [
        "a load reads local store at 0x01010",
        "get still writes (128 bytes, local store 0x01000, effective address 0x340000000, tag 5)",
        "write 0x20 to MFC_WrTagMask and 2 to MFC_WrTagUpdate, and read MFC_RdTagStat.",
    ];
    assert!(parts.iter().all(|part| text.contains(part)), "{text}");
}

/// In simulated time the data has arrived long ago, but the program has no proof of it.
#[test]
fn time_alone_is_no_wait() {
    let late = "
        command GET, 0x1000, $3, 128, 5
        ila     $9,5000
1:      ai      $9,$9,-1
        brnz    $9,1b";
    let load = "lqa $8,0x1010";
    assert_eq!(uses(&format!("{late}\n{load}")), [(Use::Load, 0x1010)]);
    // The decrementer is no proof either.
    let decrementer = format!("{late}\nrdch $8,$ch8\n{load}");
    assert_eq!(uses(&decrementer), [(Use::Load, 0x1010)]);
    // The count of free places in the queue does.
    assert_eq!(uses(&format!("{late}\nrchcnt $8,$ch21\n{load}")), []);
}

#[test]
fn the_wrong_tag_is_no_wait() {
    let source = "
        command GET, 0x2000, $3, 16, 6
        wait_tags 0x40
        command GET, 0x1000, $3, 16384, 5
        wait_tags 0x40
        lqa     $8,0x1000";
    assert_eq!(uses(source), [(Use::Load, 0x1000)]);
}

#[test]
fn a_store_races_with_what_a_put_reads() {
    let put = "command PUT, 0x1004, $10, 4, 5";
    let source = |store: &str| {
        format!(
            "
        ai      $10,$3,4
        lqa     $8,0x1000
        {put}
        {store}
        wait_tags 0x20
        stqa    $10,0x1000"
        )
    };
    assert_eq!(
        uses(&source("stqa $10,0x1000")),
        [(Use::Store, 0x1007)],
        "the first byte that differs"
    );
    assert_eq!(uses(&source("lqa $8,0x1000")), [], "both read");
    // The other words of the quadword are replaced, and the one that is put is written as it was.
    let neighbours = "
        cwd     $9,0($1)
        shufb   $8,$10,$8,$9
        stqa    $8,0x1000";
    assert_eq!(uses(&source(neighbours)), []);
    assert_eq!(uses(&source("stqa $10,0x1010")), [], "another quadword");
}

#[test]
fn commands_race_unless_they_are_ordered() {
    let two = |order: &str, second: &str| {
        format!(
            "
        command GET, 0x1000, $3, 256, 5
        {order}
        command {second}
        wait_tags 0x60"
        )
    };
    let race = [(Use::Command(PUT), 0x1080)];
    assert_eq!(uses(&two("", "PUT, 0x1080, $3, 16, 5")), race);
    assert_eq!(uses(&two("", "PUTF, 0x1080, $3, 16, 5")), []);
    assert_eq!(uses(&two("", "PUTB, 0x1080, $3, 16, 5")), []);
    assert_eq!(
        uses(&two("", "PUTF, 0x1080, $3, 16, 6")),
        [(Use::Command(0x22), 0x1080)],
        "a fence is one of its tag"
    );
    let barrier = "command BARRIER, 0, $3, 0, 7";
    assert_eq!(uses(&two(barrier, "PUT, 0x1080, $3, 16, 6")), []);
    let barrier = "command GETB, 0x2000, $3, 16, 5";
    assert_eq!(uses(&two(barrier, "PUT, 0x1080, $3, 16, 5")), []);
    assert_eq!(uses(&two(barrier, "PUT, 0x1080, $3, 16, 6")), race);
    let fence = "command GETF, 0x2000, $3, 16, 5";
    assert_eq!(uses(&two(fence, "PUT, 0x1080, $3, 16, 5")), race);
    assert_eq!(uses(&two("", "PUT, 0x1100, $3, 16, 6")), [], "others");
    let puts = "
        command PUT, 0x1000, $3, 256, 5
        command PUT, 0x1000, $3, 256, 6
        wait_tags 0x60";
    assert_eq!(uses(puts), [], "both read");
    let over = "
        command PUT, 0x1000, $3, 256, 5
        command GET, 0x10f0, $3, 32, 6
        wait_tags 0x60";
    assert_eq!(uses(over), [(Use::Command(GET), 0x10f0)]);
}

#[test]
fn a_list_and_its_data_are_in_use() {
    let source = |access: &str| {
        format!(
            "
        .data
        .balign 16
list:   .long   16, 0x40000000, 0, 0x40000000
        .text
        ila     $11,list
        command GETL, 0x1000, $11, 16, 5
        {access}
        wait_tags 0x20"
        )
    };
    assert_eq!(uses(&source("")), []);
    assert_eq!(uses(&source("lqa $8,0x1000")), [(Use::Load, 0x1000)]);
    assert_eq!(uses(&source("lqa $8,0x1010")), [], "not in the list");
    assert_eq!(uses(&source("lqd $8,0($11)")), [], "both read the list");
    let stored = uses(&source("stqd $3,0($11)"));
    assert!(matches!(stored[..], [(Use::Store, _)]), "{stored:?}");
}

#[test]
fn an_atomic_command_is_complete_with_its_status() {
    let source = |wait: &str| {
        format!(
            "
        command GETLLAR, 0x1000, $3, 0, 0
        {wait}
        lqa     $8,0x1000
        rdch    $8,$ch27
        lqa     $8,0x1000"
        )
    };
    let found = races(&source(""));
    assert_eq!(found.len(), 1, "{found:#?}");
    assert!(found[0].command.is_atomic);
    let text = found[0].to_string();
    assert!(text.ends_with("First read MFC_RdAtomicStat."), "{text}");
    assert_eq!(uses(&source("rdch $9,$ch27\ncommand GETLLAR, 0x1080, $3, 0, 0")), []);
}

/// The loop is compiled long before the iteration that comes to the data in flight.
#[test]
fn compiled_code_finds_races() {
    let source = |accesses: &str| {
        format!(
            "
        command GET, 0x9000, $3, 16, 5
        ila     $9,0x4000
        ila     $10,0x1000
1:      {accesses}
        ai      $9,$9,16
        ai      $10,$10,-1
        brnz    $10,1b
        wait_tags 0x20"
        )
    };
    assert_eq!(uses(&source("lqd $8,0($9)")), [(Use::Load, 0x9000)]);
    assert_eq!(uses(&source("stqd $8,-16($9)")), [(Use::Store, 0x9000)]);
    let both = source("lqd $8,0($9)\nstqd $8,16($9)");
    assert_eq!(uses(&both), [(Use::Store, 0x9000), (Use::Load, 0x9000)]);
}

/// A put is timed by another thread when its turn comes. The mail that follows proves nothing
/// before it is complete, and everything after.
#[test]
fn a_put_races_until_it_is_complete() {
    let source = |delay: u32| {
        format!(
            "
        command PUT, 0x1000, $3, 16, 5
        ila     $9,{delay}
1:      ai      $9,$9,-1
        brnz    $9,1b
        rchcnt  $8,$ch28
        stqa    $3,0x1000
        wait_tags 0x20"
        )
    };
    assert_eq!(uses(&source(1)), [(Use::Store, 0x1000)]);
    assert_eq!(uses(&source(5000)), []);
}

#[test]
fn each_pair_of_instructions_is_told_once() {
    let source = "
        il      $9,50
1:      command GET, 0x1000, $3, 16, 5
        lqa     $8,0x1000
        lqa     $8,0x1000
        wait_tags 0x20
        ai      $9,$9,-1
        brnz    $9,1b";
    assert_eq!(uses(source), [(Use::Load, 0x1000); 2]);
}
