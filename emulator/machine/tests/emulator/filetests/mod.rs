//! Runs the tests of the machine that are written as text: each program, on every engine, against
//! one expectation. `README.md` beside this file describes the format.

mod format;

use crate::prelude::*;
use crate::simulated::accounts;
use crate::support::{Running, load, start_prepared};
use format::{Case, Item, Moment, Value};
use spu_emulator::engine::Engine;
use spu_emulator::simulated::{Race, Use};
use std::fmt::Write;
use std::sync::Mutex;

/// A way to run a program. `Timed` counts cycles, in which data moves at once.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Way {
    Host(Engine, Policy),
    Timed(Engine, Method),
}

const WAYS: [Way; 10] = [
    Way::Host(Engine::Interpreter, Policy::AtOnce),
    Way::Host(Engine::Interpreter, Policy::AtLast),
    Way::Host(Engine::Compiler, Policy::AtOnce),
    Way::Host(Engine::Compiler, Policy::AtLast),
    Way::Host(Engine::Check, Policy::AtOnce),
    Way::Host(Engine::Check, Policy::AtLast),
    Way::Timed(Engine::Interpreter, Method::ByInstruction),
    Way::Timed(Engine::Interpreter, Method::Memoised),
    Way::Timed(Engine::Compiler, Method::Memoised),
    Way::Timed(Engine::Check, Method::Checked),
];

/// The ways in which races are watched for. The way before them counts the same cycles without.
const WATCHED: [Way; 3] = [WAYS[7], WAYS[8], WAYS[9]];

impl Way {
    fn moment(self) -> Moment {
        match self {
            Self::Host(_, Policy::AtOnce) => Moment::Once,
            Self::Host(_, Policy::AtLast) => Moment::Last,
            Self::Timed(..) => Moment::Timed,
        }
    }

    fn machine(self, memory: Arc<RegisteredMemory>) -> Arc<machine::Machine> {
        let (Self::Host(engine, _) | Self::Timed(engine, _)) = self;
        let machine = match self {
            Self::Host(..) => machine::Machine::with_engine(memory, engine),
            Self::Timed(_, method) => {
                let races = WATCHED.contains(&self);
                let options =
                    SimulationOptions { engine, method, races, ..SimulationOptions::default() };
                machine::Machine::simulated_with(memory, Timing::default(), options)
            }
        };
        // The programs are short. Their loops must be compiled all the same.
        machine.compile_after(1);
        if engine == Engine::Check {
            machine.optimize_at_once();
        }
        machine
    }
}

/// Where the local store of SPE n is mapped if there are several, and the distance between two.
const STORES: u64 = 0x3_5000_0000;
const APART: u64 = 1 << 20;

/// A machine with SPEs that a test's program has been loaded into.
struct Stage {
    machine: Machine,
    spes: Vec<(Arc<Spe>, u32)>,
    races: Arc<Mutex<Vec<Race>>>,
}

impl Stage {
    fn new(case: &Case, image: &[u8], way: Way) -> Self {
        let machine = Machine::made(|memory| way.machine(memory));
        let policy = if let Way::Host(_, policy) = way { policy } else { Policy::AtOnce };
        let races: Arc<Mutex<Vec<Race>>> = Arc::default();
        if let Some(simulation) = machine.machine.simulation() {
            let found = Arc::clone(&races);
            simulation.on_race(move |race| found.lock().unwrap().push(*race));
            if case.spes > 1 {
                simulation.serialise();
            }
        }
        let spe = |number: u64| {
            let spe = machine.spe(Config { policy, ..Config::default() });
            if case.spes > 1 {
                map(&machine, &spe, STORES + number * APART);
                spe.map_signal(SignalRegister::One, BASE + 16 * number);
            }
            let entry = load(&spe, image);
            (spe, entry)
        };
        let spes = (0..case.spes).map(spe).collect();
        let stage = Self { machine, spes, races };
        for item in &case.given {
            stage.prepare(item);
        }
        stage
    }

    fn prepare(&self, item: &Item) {
        let (spe, _) = &self.spes[0];
        match item {
            Item::LocalStore(at, value) => spe.local_store().write(*at, &value.bytes),
            Item::Main(at, value) => self.machine.write(*at, &value.bytes),
            Item::Inbound(words) => {
                for &word in words {
                    assert!(spe.write_inbound(word, Some(Instant::now())), "four words fit");
                }
            }
            Item::Signal(register, word) => {
                let registers = [SignalRegister::One, SignalRegister::Two];
                spe.signal(registers[register - 1], *word);
            }
            Item::ReadOnly(at) => {
                let memory = &self.machine.memory;
                memory.register(BASE + at, vec![0; 256], Access::ReadOnly).unwrap();
            }
            Item::Mapped(at) => map(&self.machine, spe, BASE + at),
            // The run sets registers. The format lets nothing else be given.
            _ => {}
        }
    }

    /// The stops of all SPEs, if all end by themselves.
    fn run(&self, case: &Case) -> Option<Vec<Stopped>> {
        let registers: Vec<(u8, Quad)> = case.given.iter().filter_map(Item::register).collect();
        let start = |(number, (spe, entry)): (u32, &(Arc<Spe>, u32))| {
            let registers = registers.clone();
            start_prepared(spe, *entry, Duration::ZERO, move |spu| {
                spu.set_register(4, Quad::scalar(number));
                for (number, value) in registers {
                    spu.set_register(number, value);
                }
            })
        };
        let running: Vec<Running> = (0..).zip(&self.spes).map(start).collect();
        if let Some(simulation) = self.machine.machine.simulation() {
            simulation.depart();
        }
        running.into_iter().map(Running::wait_or_end).collect()
    }

    fn figures(&self) -> Vec<SpeReport> {
        let simulation = self.machine.machine.simulation();
        simulation.map_or_else(Vec::new, |simulation| simulation.report().spes)
    }

    /// What came in place of what was expected, if it is something else.
    fn differs(&self, number: usize, item: &Item, stopped: &Stopped) -> Option<String> {
        let (spe, _) = &self.spes[number];
        let bytes = |value: &Value, came: Vec<u8>| {
            let at = came.iter().zip(&value.bytes).position(|(came, wanted)| came != wanted)?;
            let end = came.len().min(at + 16);
            Some(format!("{:02x?} from byte {at:#x}", &came[at..end]))
        };
        match item {
            Item::Register(number, value) => {
                let came = spe.with_spu(|spu| spu.register(*number));
                let same = came.bytes()[..value.bytes.len()] == value.bytes[..];
                (!same).then(|| format!("{:08x?}", came.0))
            }
            Item::LocalStore(at, value) => {
                let mut came = vec![0; value.bytes.len()];
                spe.local_store().read(*at, &mut came);
                bytes(value, came)
            }
            Item::Main(at, value) => bytes(value, self.machine.read(*at, value.bytes.len())),
            Item::Outbound(word) => {
                let came = spe.read_outbound(Some(Instant::now()));
                (came != Some(*word)).then(|| format!("{came:x?}"))
            }
            Item::Stop(text) => {
                let came = stopped.to_string();
                (!text.iter().all(|part| came.contains(part))).then_some(came)
            }
            Item::Figure(name, value) => {
                let figure = figure(self.figures().get(number)?, name).expect(name);
                (figure != *value).then(|| figure.to_string())
            }
            Item::Races(races) => {
                let came: Vec<String> = self.races.lock().unwrap().iter().map(place).collect();
                (self.watches() && came != *races).then(|| came.join(","))
            }
            Item::RaceText(text) => {
                let races = self.races.lock().unwrap();
                let came = races.first().map_or(String::new(), Race::to_string);
                (self.watches() && !text.iter().all(|part| came.contains(part))).then_some(came)
            }
            Item::Inbound(_) | Item::Signal(..) | Item::ReadOnly(_) | Item::Mapped(_) => None,
        }
    }

    fn watches(&self) -> bool {
        let simulation = self.machine.machine.simulation();
        simulation.is_some_and(|simulation| simulation.options().races)
    }
}

fn map(machine: &Machine, spe: &Spe, ea: u64) {
    let store = Arc::clone(spe.local_store());
    machine.memory.register_local_store(ea, store).unwrap();
    spe.map_local_store(ea);
}

/// A figure of simulated time by the name of its field.
fn figure(report: &SpeReport, name: &str) -> Option<u64> {
    let SpeReport { account, waits, commands, stopped, .. } = report;
    Some(match name {
        "cycles" => account.cycles(),
        "stopped" => *stopped,
        "waits.tag" => waits.tag,
        "waits.event" => waits.event,
        "waits.list" => waits.list,
        "waits.atomic" => waits.atomic,
        "waits.queue" => waits.queue,
        "commands.queued" => commands.queued,
        "commands.atomic" => commands.atomic,
        "commands.bytes_in" => commands.bytes_in,
        _ => return None,
    })
}

/// What uses local store in a race, and where.
fn place(race: &Race) -> String {
    let by = match race.by {
        Use::Load => "load".to_owned(),
        Use::Store => "store".to_owned(),
        Use::Command(opcode) => format!("{opcode:#x}"),
    };
    format!("{by}@{:#x}", race.address)
}

/// Runs a file's tests, and reports all that fail.
fn check(file: &str, text: &str) {
    let cases = format::parse(file, text);
    let (mut failures, mut compared) = (String::new(), 0);
    for case in &cases {
        let image = assemble(&case.code);
        let mut counted: Option<Vec<SpeReport>> = None;
        for way in WAYS {
            let moment = way.moment();
            if case.only.is_some_and(|only| only != moment) {
                continue;
            }
            let mut fail = |line: usize, what: &str, came: &str| {
                let place = format!("{file}:{line}: {} on {way:?}", case.name);
                writeln!(failures, "{place}\n  expected: {what}\n      came: {came}").unwrap();
            };
            let stage = Stage::new(case, &image, way);
            let Some(stopped) = stage.run(case) else {
                fail(case.line, "an end", "none: it was stopped");
                continue;
            };
            for expected in &case.expected {
                if expected.moment.is_none_or(|only| only == moment) {
                    compared += 1;
                    let spe = expected.spe;
                    if let Some(came) = stage.differs(spe, &expected.item, &stopped[spe]) {
                        fail(expected.line, &expected.text, &came);
                    }
                }
            }
            let differences = stage.spes.iter().filter_map(|(spe, _)| spe.difference());
            for (address, difference) in differences {
                fail(case.line, "no difference", &format!("{difference} at {address:#x}"));
            }
            if moment == Moment::Timed {
                let figures = stage.figures();
                figures.iter().for_each(accounts::check);
                let first = counted.get_or_insert_with(|| figures.clone());
                if figures != *first {
                    fail(case.line, &format!("{first:?}"), &format!("{figures:?}"));
                }
            }
        }
    }
    assert!(failures.is_empty(), "\n{failures}");
    assert!(compared > 0, "{file} expects nothing");
}

macro_rules! files {
    ($($name:ident),*) => {$(
        #[test]
        fn $name() {
            let file = concat!(stringify!($name), ".spu");
            check(file, include_str!(concat!(stringify!($name), ".spu")));
        }
    )*};
}

files!(atomics, channels, dma, errors, events, lists, ordering, races, spes, time);
