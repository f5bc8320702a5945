//! The profile agrees with the account, and each cycle is charged to the right instruction.
//!
//! Provenance: `model`. The figures are derived by hand in the comments next to them.

use std::fs;
use std::sync::Arc;
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant};

use spu_emulator::elf::Image;
use spu_emulator::interp::{Quad, Spu};
use spu_emulator::machine;
use spu_emulator::memory::{Access, RegisteredMemory};
use spu_emulator::profile::{ProgramId, Tally};
use spu_emulator::simulated::{CYCLES_PER_SECOND, Report, SimulationOptions, Timing};
use spu_emulator::spe::{Config, Spe};
use spu_emulator::stop::{Stop, Stopped};
use spu_isa::timing::Cause;
use spu_reports::ProfileFile;
use spu_reports::views::{FunctionFigures, View, ViewError};
use spu_scheduler::code::Code;

/// A dual pair, a dependence, a mispredicted branch, commands that the program waits for, atomic
/// lines, and a decrementer whose event interrupts a loop.
const BUSY: &str = "
        ila     $5,200
        .balign 8
work:   fa      $21,$21,$22
        lnop
        ai      $5,$5,-1
        brnz    $5,work
        command GET, 0x10000, $3, 16384, 3
        wait_tags 1<<3
take:   command GETLLAR, 0x10000, $3, 128, 0
        rdch    $12,$ch27
        lqa     $15,0x10000
        ai      $16,$15,1
        stqa    $16,0x10000
        command PUTLLC, 0x10000, $3, 128, 0
        rdch    $12,$ch27
        brnz    $12,take
        dfa     $21,$21,$22
        sync
        il      $6,10
        wrch    $ch7,$6
        set_channel 1, 0x20
        rdch    $7,$ch0
        stop    0x2000
";

const BASE: u64 = 0x3_4000_0000;
/// How long a program may take on a host that is busy with other things.
const PATIENCE: Duration = Duration::from_secs(600);

/// The ELF image of a program. `_start` is put before the source.
fn assemble(source: &str) -> Vec<u8> {
    let folder = tempfile::tempdir().unwrap();
    fs::read(spu_build::for_tests::build_instructions(source, folder.path())).unwrap()
}

struct Machine(Arc<machine::Machine>);

impl Machine {
    /// A machine that may keep a profile.
    fn new(profile: bool) -> Self {
        let memory = Arc::new(RegisteredMemory::new());
        memory.register(BASE, vec![0; 1 << 20], Access::ReadWrite).unwrap();
        let options = SimulationOptions { profile, ..SimulationOptions::default() };
        Self(machine::Machine::simulated_with(memory, Timing::default(), options))
    }

    /// An SPE with a loaded program that will run soon, and its entry point.
    fn loaded(&self, image: &[u8]) -> (Arc<Spe>, u32) {
        let spe = Spe::new(&self.0, Config::default());
        (Arc::clone(&spe), Self::load(&spe, image))
    }

    /// Loads a program that will run soon, and returns its entry point.
    fn load(spe: &Spe, image: &[u8]) -> u32 {
        spe.profile_as(ProgramId::of(image));
        let image = Image::parse(image).unwrap();
        image.load(spe.local_store(), 0);
        spe.expect_run();
        image.entry()
    }

    fn profile(&self) -> Option<ProfileFile> {
        let spes = self.0.simulation().unwrap().profile()?;
        Some(ProfileFile::new(CYCLES_PER_SECOND, &spes))
    }

    fn report(&self) -> Report {
        self.0.simulation().unwrap().report()
    }

    fn depart(&self) {
        self.0.simulation().unwrap().depart();
    }
}

/// A program that runs on a thread of its own.
struct Running(JoinHandle<Stopped>, Arc<Spe>);

fn start(spe: &Arc<Spe>, entry: u32) -> Running {
    let runner = Arc::clone(spe);
    let run = move || {
        runner.run_prepared(entry, |spu: &mut Spu| {
            spu.set_register(2, Quad::scalar((BASE >> 32) as u32));
            spu.set_register(3, Quad::scalar(BASE as u32));
        })
    };
    Running(thread::spawn(run), Arc::clone(spe))
}

impl Running {
    /// Waits for the stop, which must be a `stop` instruction.
    fn end(self) {
        let Self(thread, spe) = self;
        let deadline = Instant::now() + PATIENCE;
        while !thread.is_finished() {
            if Instant::now() > deadline {
                spe.request_stop();
                panic!("the program did not end by itself");
            }
            thread::sleep(Duration::from_millis(1));
        }
        let stopped = thread.join().unwrap();
        assert!(matches!(stopped.reason, Stop::Signal(_)), "{stopped}");
    }
}

fn run(machine: &Machine, spe: &Arc<Spe>, entry: u32) {
    let running = start(spe, entry);
    machine.depart();
    running.end();
}

/// Compares the profile with the accounts, and the file with the profile from which it was
/// written.
fn check(machine: &Machine) -> ProfileFile {
    let profile = machine.profile().unwrap();
    let spes = machine.report().spes;
    assert_eq!(profile.cycles().count(), spes.len());
    for (number, (spe, cycles)) in spes.iter().zip(profile.cycles()).enumerate() {
        let tally = profile.tally(number);
        assert_eq!(cycles, spe.account.cycles());
        assert_eq!(tally.cycles(), cycles);
        assert_eq!(tally.issued, spe.account.instructions());
        assert_eq!(tally.joined, spe.account.dual());
        assert_eq!(&tally.stalls, spe.account.stalls());
    }
    let text = serde_json::to_vec(&profile).unwrap();
    assert_eq!(ProfileFile::parse(&text).unwrap(), profile);
    profile
}

#[test]
fn every_cycle_of_the_account_is_charged_once() {
    let machine = Machine::new(true);
    let image = assemble(BUSY);
    let spes: Vec<_> = (0..3).map(|_| machine.loaded(&image)).collect();
    let running: Vec<_> = spes.iter().map(|(spe, entry)| start(spe, *entry)).collect();
    machine.depart();
    for one in running {
        one.end();
    }
    let profile = check(&machine);
    let used = |cause| (0..3).map(|spe| profile.tally(spe).stalls.of(cause)).sum::<u64>();
    // The program has all of these causes, so the sums above test each of them.
    for cause in
        [Cause::BranchMiss, Cause::Channel, Cause::Dma, Cause::DoubleStall, Cause::Synchronise]
    {
        assert!(used(cause) > 0, "{cause}");
    }
}

#[test]
fn a_machine_keeps_a_profile_only_if_it_is_to() {
    let machine = Machine::new(false);
    let (spe, entry) = machine.loaded(&assemble(BUSY));
    run(&machine, &spe, entry);
    assert!(machine.profile().is_none());
}

/// A function's instructions as in the view's JSON: name of the operation, issued, joined, cycles,
/// stalls.
fn rows(view: &View<'_>, function: &FunctionFigures) -> Vec<(String, [u64; 3], String)> {
    let json: serde_json::Value = serde_json::from_str(&view.json(Some(function))).unwrap();
    let rows = json["functions"][0]["instructions"].as_array().unwrap();
    rows.iter()
        .map(|row| {
            let total = &row["total"];
            let of = |name: &str| total[name].as_u64().unwrap();
            let text = row["text"].as_str().unwrap();
            let name = text.split('\t').next().unwrap().to_owned();
            let figures = [of("issued"), of("joined"), of("cycles")];
            (name, figures, total["stalls"].to_string())
        })
        .collect()
}

#[test]
fn cycles_are_charged_to_whom_they_wait_for() {
    let source = "
        .type   work,@function
work:   il      $5,10
        rchcnt  $7,$ch29
next:   fa      $21,$21,$22
        lnop
        ai      $5,$5,-1
        brnz    $5,next
        rdch    $6,$ch29
        lnop
        stop    0x2000
        .size   work,.-work
";
    let machine = Machine::new(true);
    let image = assemble(source);
    let (spe, entry) = machine.loaded(&image);
    let running = start(&spe, entry);
    // The program reaches its mailbox long before the mailbox has a word.
    assert!(spe.write_inbound(1, None));
    machine.depart();
    running.end();
    let profile = check(&machine);
    let code = Code::parse(&image).unwrap();
    let view = View::new(&code, &image, &profile).unwrap();
    let work = view.function("work").unwrap();
    assert_eq!(work.calls, 1);
    assert_eq!(work.tally, view.total());
    let rows = rows(&view, &work);
    let slept = machine.report().spes[0].waits.mailbox;
    let expected = [
        // Both pipes issue: the second instruction costs nothing.
        ("il", [1, 0, 1], "{}".into()),
        ("rchcnt", [1, 1, 0], "{}".into()),
        // Each pass costs 1 for each of fa, ai and brnz, 1 because brnz waits for ai's result, and
        // 18 for the miss. fa waits for nothing, because its result is ready after 6 cycles.
        ("fa", [10, 0, 10], "{}".into()),
        ("lnop", [10, 10, 0], "{}".into()),
        ("ai", [10, 0, 10], "{}".into()),
        // Nine of ten branches are taken.
        ("brnz", [10, 0, 10 + 10 + 9 * 18], r#"{"branch miss":162,"operand of FX2":10}"#.into()),
        ("rdch", [1, 0, 1 + slept], stall(Cause::Channel, slept)),
        ("lnop", [1, 0, 1], "{}".into()),
        ("stop", [1, 0, 1], "{}".into()),
    ];
    let expected = expected.map(|(name, figures, stalls)| (name.to_owned(), figures, stalls));
    assert_eq!(rows, expected);
}

fn stall(cause: Cause, cycles: u64) -> String {
    match cycles {
        0 => "{}".into(),
        cycles => format!("{{\"{cause}\":{cycles}}}"),
    }
}

#[test]
fn programs_one_after_the_other_have_profiles_of_their_own() {
    let one = assemble("        il $5,1\n        stop 0x2000\n");
    let other = assemble("        il $5,2\n        il $6,3\n        stop 0x2000\n");
    let third = assemble("        stop 0x2001\n");
    let machine = Machine::new(true);
    let (spe, entry) = machine.loaded(&one);
    run(&machine, &spe, entry);
    for image in [&other, &one] {
        let entry = Machine::load(&spe, image);
        run(&machine, &spe, entry);
    }
    let profile = check(&machine);
    let total = |image: &[u8]| -> Result<Tally, ViewError> {
        let code = Code::parse(image).unwrap();
        Ok(View::new(&code, image, &profile)?.total())
    };
    // il and stop are a pair. A program that starts again charges a miss to its first instruction,
    // not to the stop before it.
    assert_eq!(total(&one).unwrap().issued, 4);
    assert_eq!(total(&one).unwrap().cycles(), 2 + 18);
    assert_eq!(total(&other).unwrap().issued, 3);
    assert_eq!(total(&other).unwrap().cycles(), 3 + 18);
    let refused = total(&third).unwrap_err().to_string();
    assert!(refused.contains("is not in the profile"), "{refused}");
    assert_eq!(profile.tally(0).stalls.of(Cause::BranchMiss), 36);
}
