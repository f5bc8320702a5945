//! Machines in simulated time, programs for them, and disturbances by the host.

use std::sync::atomic::{AtomicBool, AtomicU64, Ordering::SeqCst};
use std::sync::{Arc, mpsc};
use std::thread::{self, JoinHandle};
use std::time::Duration;

pub use crate::program::assemble;
use spu_emulator::elf::Image;
use spu_emulator::interp::{Quad, Spu};
use spu_emulator::machine;
use spu_emulator::memory::{Access, MainMemory, RegisteredMemory};
use spu_emulator::simulated::{Method, Report, Simulation, SimulationOptions, SpeReport, Timing};
use spu_emulator::spe::{Config, Spe};
use spu_emulator::stop::{Stop, Stopped};

pub const BASE: u64 = 0x3_4000_0000;
pub const MEMORY: usize = 1 << 20;
/// How long a program may take on a host that is busy with other things. It only ends a test that
/// hangs.
pub const TIMEOUT: Duration = Duration::from_secs(600);

pub struct Machine {
    pub memory: Arc<RegisteredMemory>,
    machine: Arc<machine::Machine>,
}

impl Machine {
    pub fn new() -> Self {
        Self::with(Timing::default())
    }

    /// A machine with other latencies and rates than the console's.
    pub fn with(timing: Timing) -> Self {
        Self::simulated_with(timing, SimulationOptions::default())
    }

    /// A machine that counts its cycles with this method.
    pub fn counting(method: Method) -> Self {
        let options = SimulationOptions { profile: false, method, ..SimulationOptions::default() };
        Self::simulated_with(Timing::default(), options)
    }

    /// A machine that records timelines.
    pub fn recording() -> Self {
        let options = SimulationOptions { timeline: true, ..SimulationOptions::default() };
        Self::simulated_with(Timing::default(), options)
    }

    /// A machine that records nothing, with other options.
    pub fn with_options(options: SimulationOptions) -> Self {
        Self::simulated_with(Timing::default(), options)
    }

    fn simulated_with(timing: Timing, options: SimulationOptions) -> Self {
        let memory = Arc::new(RegisteredMemory::new());
        memory.register(BASE, vec![0; MEMORY], Access::ReadWrite).unwrap();
        let machine = machine::Machine::simulated_with(memory.clone(), timing, options);
        Self { memory, machine }
    }

    /// An SPE with a program that will be run soon, and the program's entry.
    pub fn loaded(&self, image: &[u8]) -> (Arc<Spe>, u32) {
        let spe = Spe::new(&self.machine, Config::default());
        (Arc::clone(&spe), Self::load(&spe, image))
    }

    /// Loads a program that will be run soon. Returns its entry.
    pub fn load(spe: &Spe, image: &[u8]) -> u32 {
        let image = Image::parse(image).unwrap();
        image.load(spe.local_store(), 0);
        spe.expect_run();
        image.entry()
    }

    pub fn simulation(&self) -> &Arc<Simulation> {
        self.machine.simulation().unwrap()
    }

    pub fn report(&self) -> Report {
        self.simulation().report()
    }

    pub fn depart(&self) {
        self.simulation().depart();
    }

    pub fn word(&self, offset: u64) -> u32 {
        let mut bytes = [0; 4];
        self.memory.read(BASE + offset, &mut bytes).unwrap();
        u32::from_be_bytes(bytes)
    }

    /// Runs one program on `count` SPEs at once, each to its stop. Returns their figures. `$4` is
    /// the SPE's number.
    pub fn run_all(&self, count: u32, source: &str) -> Vec<SpeReport> {
        let image = assemble(source);
        let spes: Vec<_> = (0..count).map(|_| self.loaded(&image)).collect();
        let running: Vec<_> = (0..)
            .zip(&spes)
            .map(|(number, (spe, entry))| start(spe, *entry, number, Duration::ZERO))
            .collect();
        self.depart();
        for one in running {
            one.end();
        }
        self.report().spes
    }
}

/// A program that runs on its own thread.
pub struct Running {
    spe: Arc<Spe>,
    ended: mpsc::Receiver<Stopped>,
}

/// Runs a program after a delay of the host.
pub fn start(spe: &Arc<Spe>, entry: u32, number: u32, delay: Duration) -> Running {
    let (sender, ended) = mpsc::channel();
    let runner = Arc::clone(spe);
    thread::spawn(move || {
        thread::sleep(delay);
        let stopped = runner.run_prepared(entry, |spu: &mut Spu| {
            spu.set_register(2, Quad::scalar((BASE >> 32) as u32));
            spu.set_register(3, Quad::scalar(BASE as u32));
            spu.set_register(4, Quad::scalar(number));
        });
        // A test that has failed no longer receives.
        let _ = sender.send(stopped);
    });
    Running { spe: Arc::clone(spe), ended }
}

impl Running {
    /// Whether it obeys a stop request.
    pub fn stopped(self) -> bool {
        let stopped = self.ended.recv_timeout(TIMEOUT);
        stopped.is_ok_and(|stopped| stopped.reason == Stop::Requested)
    }

    /// Waits for the stop, which must be a `stop` instruction.
    pub fn end(self) {
        let stopped = self.ended.recv_timeout(TIMEOUT).unwrap_or_else(|_| {
            self.spe.request_stop();
            panic!("the program did not end by itself")
        });
        assert!(matches!(stopped.reason, Stop::Signal(_)), "{stopped}");
    }
}

/// Word 0 of a register.
pub fn register(spe: &Spe, number: u8) -> u32 {
    spe.with_spu(|spu| spu.register(number).preferred())
}

/// Delays of the host that differ in every run.
pub struct Disturbance(AtomicU64);

impl Disturbance {
    pub fn new(seed: u64) -> Self {
        Self(AtomicU64::new(seed))
    }

    /// A delay of up to some milliseconds.
    pub fn delay(&self) -> Duration {
        let mixed = self.0.fetch_add(0x9e37_79b9_7f4a_7c15, SeqCst);
        let mixed = (mixed ^ mixed >> 29).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        Duration::from_micros((mixed >> 32) % 4000)
    }

    pub fn sleep(&self) {
        thread::sleep(self.delay());
    }
}

/// Threads that compete for the host's processors.
pub struct Load {
    over: Arc<AtomicBool>,
    threads: Vec<JoinHandle<()>>,
}

impl Load {
    pub fn new(threads: usize) -> Self {
        let over = Arc::new(AtomicBool::new(false));
        let spin = || {
            let over = Arc::clone(&over);
            thread::spawn(move || while !over.load(SeqCst) {})
        };
        let threads = (0..threads).map(|_| spin()).collect();
        Self { over, threads }
    }
}

impl Drop for Load {
    fn drop(&mut self) {
        self.over.store(true, SeqCst);
        for thread in self.threads.drain(..) {
            thread.join().unwrap();
        }
    }
}
