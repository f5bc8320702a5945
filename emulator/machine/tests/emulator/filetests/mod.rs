//! Runs the tests of the machine that are written as text: each program, on every engine, against
//! one expectation. `README.md` beside this file describes the format.

mod format;

use crate::machine::support::{BASE, MEMORY, TIMEOUT, load};
use crate::program::assemble;
use format::{Case, Item, Moment, Value};
use spu_emulator::engine::Engine;
use spu_emulator::interp::Quad;
use spu_emulator::machine::Machine;
use spu_emulator::memory::{Access, MainMemory, RegisteredMemory};
use spu_emulator::mfc::Policy;
use spu_emulator::signal::SignalRegister;
use spu_emulator::simulated::{SimulationOptions, Timing};
use spu_emulator::spe::{Config, Spe};
use spu_emulator::stop::Stopped;
use std::fmt::Write;
use std::sync::{Arc, mpsc};
use std::thread;
use std::time::Instant;

/// A way to run a program. `Timed` counts cycles, in which data moves at once.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Way {
    Host(Engine, Policy),
    Timed(Engine),
}

const WAYS: [Way; 9] = [
    Way::Host(Engine::Interpreter, Policy::AtOnce),
    Way::Host(Engine::Interpreter, Policy::AtLast),
    Way::Host(Engine::Compiler, Policy::AtOnce),
    Way::Host(Engine::Compiler, Policy::AtLast),
    Way::Host(Engine::Check, Policy::AtOnce),
    Way::Host(Engine::Check, Policy::AtLast),
    Way::Timed(Engine::Interpreter),
    Way::Timed(Engine::Compiler),
    Way::Timed(Engine::Check),
];

impl Way {
    fn moment(self) -> Moment {
        match self {
            Self::Host(_, Policy::AtOnce) => Moment::Once,
            Self::Host(_, Policy::AtLast) => Moment::Last,
            Self::Timed(_) => Moment::Timed,
        }
    }

    fn machine(self, memory: Arc<RegisteredMemory>) -> Arc<Machine> {
        let (Self::Host(engine, _) | Self::Timed(engine)) = self;
        let machine = match self {
            Self::Host(..) => Machine::with_engine(memory, engine),
            Self::Timed(_) => {
                let options = SimulationOptions { engine, ..SimulationOptions::default() };
                Machine::simulated_with(memory, Timing::default(), options)
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

/// A machine with one SPE that a test's program has been loaded into.
struct Stage {
    memory: Arc<RegisteredMemory>,
    machine: Arc<Machine>,
    spe: Arc<Spe>,
    entry: u32,
}

impl Stage {
    fn new(case: &Case, image: &[u8], way: Way) -> Self {
        let memory = Arc::new(RegisteredMemory::new());
        memory.register(BASE, vec![0; MEMORY], Access::ReadWrite).unwrap();
        let machine = way.machine(memory.clone());
        let policy = if let Way::Host(_, policy) = way { policy } else { Policy::AtOnce };
        let spe = Spe::new(&machine, Config { policy, ..Config::default() });
        let entry = load(&spe, image);
        let stage = Self { memory, machine, spe, entry };
        for item in &case.given {
            stage.prepare(item);
        }
        stage
    }

    fn prepare(&self, item: &Item) {
        match item {
            Item::LocalStore(at, value) => self.spe.local_store().write(*at, &value.bytes),
            Item::Main(at, value) => self.memory.write(BASE + at, &value.bytes).unwrap(),
            Item::Inbound(words) => {
                for &word in words {
                    assert!(self.spe.write_inbound(word, Some(Instant::now())), "four words fit");
                }
            }
            Item::Signal(register, word) => {
                let registers = [SignalRegister::One, SignalRegister::Two];
                self.spe.signal(registers[register - 1], *word);
            }
            Item::ReadOnly(at) => {
                self.memory.register(BASE + at, vec![0; 256], Access::ReadOnly).unwrap();
            }
            Item::Mapped(at) => {
                let store = self.spe.local_store().clone();
                self.memory.register_local_store(BASE + at, store).unwrap();
                self.spe.map_local_store(BASE + at);
            }
            // The run sets registers. The format lets nothing else be given.
            Item::Register(..) | Item::Outbound(_) | Item::Stop(_) | Item::Cycles(_) => {}
        }
    }

    fn run(&self, case: &Case) -> Option<Stopped> {
        let mut registers =
            vec![(2, Quad::scalar((BASE >> 32) as u32)), (3, Quad::scalar(BASE as u32))];
        for item in &case.given {
            if let Item::Register(number, value) = item {
                registers.push((*number, value.quad()));
            }
        }
        let (sender, ended) = mpsc::channel();
        let (spe, entry) = (Arc::clone(&self.spe), self.entry);
        self.spe.expect_run();
        thread::spawn(move || {
            let stopped = spe.run_prepared(entry, |spu| {
                for (number, value) in registers {
                    spu.set_register(number, value);
                }
            });
            // A test that has failed no longer receives.
            let _ = sender.send(stopped);
        });
        if let Some(simulation) = self.machine.simulation() {
            simulation.depart();
        }
        ended.recv_timeout(TIMEOUT).ok()
    }

    /// What came in place of what was expected, if it is something else.
    fn differs(&self, item: &Item, stopped: &Stopped) -> Option<String> {
        let bytes = |value: &Value, came: Vec<u8>| {
            let at = came.iter().zip(&value.bytes).position(|(came, wanted)| came != wanted)?;
            let end = came.len().min(at + 16);
            Some(format!("{:02x?} from byte {at:#x}", &came[at..end]))
        };
        match item {
            Item::Register(number, value) => {
                let came = self.spe.with_spu(|spu| spu.register(*number));
                let same = if value.bytes.len() == 4 {
                    came.bytes()[..4] == value.bytes[..]
                } else {
                    came.bytes()[..] == value.bytes[..]
                };
                (!same).then(|| format!("{:08x?}", came.0))
            }
            Item::LocalStore(at, value) => {
                let mut came = vec![0; value.bytes.len()];
                self.spe.local_store().read(*at, &mut came);
                bytes(value, came)
            }
            Item::Main(at, value) => {
                let mut came = vec![0; value.bytes.len()];
                self.memory.read(BASE + at, &mut came).unwrap();
                bytes(value, came)
            }
            Item::Outbound(word) => {
                let came = self.spe.read_outbound(Some(Instant::now()));
                (came != Some(*word)).then(|| format!("{came:x?}"))
            }
            Item::Stop(text) => {
                let came = stopped.to_string();
                (!text.iter().all(|part| came.contains(part))).then_some(came)
            }
            Item::Cycles(cycles) => {
                let came = self.machine.simulation().map(|simulation| simulation.report());
                let came = came.map_or(0, |report| report.spes[0].account.cycles());
                (came != *cycles).then(|| came.to_string())
            }
            Item::Inbound(_) | Item::Signal(..) | Item::ReadOnly(_) | Item::Mapped(_) => None,
        }
    }
}

/// Runs a file's tests, and reports all that fail.
fn check(file: &str, text: &str) {
    let cases = format::parse(file, text);
    let (mut failures, mut compared) = (String::new(), 0);
    for case in &cases {
        let image = assemble(&case.code);
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
                stage.spe.request_stop();
                fail(case.line, "an end", "none: it was stopped");
                continue;
            };
            for expected in &case.expected {
                if expected.moment.is_none_or(|only| only == moment) {
                    compared += 1;
                    if let Some(came) = stage.differs(&expected.item, &stopped) {
                        fail(expected.line, &expected.text, &came);
                    }
                }
            }
            if let Some((address, difference)) = stage.spe.difference() {
                fail(case.line, "no difference", &format!("{difference} at {address:#x}"));
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

files!(atomics, channels, dma, errors, events, lists, ordering);
