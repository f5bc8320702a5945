//! Programs that are assembled during the test, and machines that run them.

use std::fs;
use std::sync::mpsc;
use std::sync::mpsc::TryRecvError;

use crate::prelude::*;
use spu_emulator::elf::Image;
use spu_emulator::memory::MainMemory;
use spu_emulator::simulated::{Report, Simulation};

/// How long a program may take on a host that is busy with other things. It only ends a test that
/// hangs.
pub const TIMEOUT: Duration = Duration::from_secs(600);

/// Address of the main memory of every machine in these tests.
pub const BASE: u64 = 0x3_4000_0000;
pub const MEMORY: usize = 256 * 1024;

/// The ELF image of a program. `_start` is added before the source.
pub fn assemble(source: &str) -> Vec<u8> {
    let folder = tempfile::tempdir().unwrap();
    fs::read(spu_build::for_tests::build_instructions(source, folder.path())).unwrap()
}

pub struct Machine {
    pub memory: Arc<RegisteredMemory>,
    pub machine: Arc<machine::Machine>,
}

impl Machine {
    /// A machine in the host's time.
    pub fn new() -> Self {
        Self::made(|memory| machine::Machine::new(memory))
    }

    pub fn simulated() -> Self {
        Self::simulated_with(Timing::default(), SimulationOptions::default())
    }

    pub fn counting(method: Method) -> Self {
        let options = SimulationOptions { method, ..SimulationOptions::default() };
        Self::simulated_with(Timing::default(), options)
    }

    pub fn simulated_with(timing: Timing, options: SimulationOptions) -> Self {
        Self::made(|memory| machine::Machine::simulated_with(memory, timing, options))
    }

    /// A machine with 256 KB of main memory at [`BASE`], all 0.
    pub fn made(make: impl FnOnce(Arc<RegisteredMemory>) -> Arc<machine::Machine>) -> Self {
        let memory = Arc::new(RegisteredMemory::new());
        memory.register(BASE, vec![0; MEMORY], Access::ReadWrite).unwrap();
        Self { machine: make(memory.clone()), memory }
    }

    pub fn spe(&self, config: Config) -> Arc<Spe> {
        Spe::new(&self.machine, config)
    }

    /// An SPE with a program, and the program's entry.
    pub fn loaded(&self, policy: Policy, source: &str) -> (Arc<Spe>, u32) {
        let spe = self.spe(Config { policy, ..Config::default() });
        let entry = load(&spe, &assemble(source));
        (spe, entry)
    }

    /// The same for a program that has been assembled.
    pub fn with_image(&self, image: &[u8]) -> (Arc<Spe>, u32) {
        let spe = self.spe(Config::default());
        let entry = load(&spe, image);
        (spe, entry)
    }

    pub fn write(&self, offset: u64, bytes: &[u8]) {
        self.memory.write(BASE + offset, bytes).unwrap();
    }

    pub fn read(&self, offset: u64, length: usize) -> Vec<u8> {
        let mut bytes = vec![0; length];
        self.memory.read(BASE + offset, &mut bytes).unwrap();
        bytes
    }

    pub fn word(&self, offset: u64) -> u32 {
        u32::from_be_bytes(self.read(offset, 4).try_into().unwrap())
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

    /// Runs programs in simulated time, each to its stop. Returns their figures. `$4` is the SPE's
    /// number.
    pub fn run_together(&self, spes: &[(Arc<Spe>, u32)]) -> Vec<SpeReport> {
        let start = |(number, (spe, entry)): (u32, &(Arc<Spe>, u32))| {
            start_later(spe, *entry, number, Duration::ZERO)
        };
        let running: Vec<_> = (0..).zip(spes).map(start).collect();
        self.depart();
        for one in running {
            one.end();
        }
        self.report().spes
    }

    /// Runs one program on `count` SPEs at once.
    pub fn run_all(&self, count: u32, source: &str) -> Vec<SpeReport> {
        let image = assemble(source);
        let spes: Vec<_> = (0..count).map(|_| self.with_image(&image)).collect();
        self.run_together(&spes)
    }
}

/// Loads a program that will be run soon. Returns its entry.
pub fn load(spe: &Spe, image: &[u8]) -> u32 {
    let image = Image::parse(image).unwrap();
    image.load(spe.local_store(), 0);
    spe.expect_run();
    image.entry()
}

/// A program that runs on its own thread.
pub struct Running {
    spe: Arc<Spe>,
    ended: mpsc::Receiver<Stopped>,
}

pub fn start(spe: &Arc<Spe>, entry: u32) -> Running {
    start_later(spe, entry, 0, Duration::ZERO)
}

/// Starts a program with a number in `$4`, after a delay of the host.
pub fn start_later(spe: &Arc<Spe>, entry: u32, number: u32, delay: Duration) -> Running {
    start_prepared(spe, entry, delay, move |spu| spu.set_register(4, Quad::scalar(number)))
}

/// `$2` and `$3` are the two halves of [`BASE`]. `prepare` may set other registers.
pub fn start_prepared(
    spe: &Arc<Spe>,
    entry: u32,
    delay: Duration,
    prepare: impl FnOnce(&mut Spu) + Send + 'static,
) -> Running {
    let (sender, ended) = mpsc::channel();
    let runner = Arc::clone(spe);
    thread::spawn(move || {
        thread::sleep(delay);
        let stopped = runner.run_prepared(entry, |spu: &mut Spu| {
            base_registers(spu);
            prepare(spu);
        });
        // A test that has failed no longer receives.
        let _ = sender.send(stopped);
    });
    Running { spe: Arc::clone(spe), ended }
}

pub fn base_registers(spu: &mut Spu) {
    spu.set_register(2, Quad::scalar((BASE >> 32) as u32));
    spu.set_register(3, Quad::scalar(BASE as u32));
}

impl Running {
    pub fn wait(self) -> Stopped {
        self.wait_or_end().unwrap_or_else(|| panic!("the program did not end by itself"))
    }

    /// `None` if the program did not end by itself, and was stopped.
    pub fn wait_or_end(self) -> Option<Stopped> {
        let stopped = self.ended.recv_timeout(TIMEOUT).ok();
        if stopped.is_none() {
            self.spe.request_stop();
        }
        stopped
    }

    /// Waits for the stop, which must be a `stop` instruction.
    pub fn end(self) {
        let stopped = self.wait();
        assert!(matches!(stopped.reason, Stop::Signal(_)), "{stopped}");
    }

    /// The stop, if the program stops by itself within a moment.
    pub fn try_wait(&self) -> Option<Stopped> {
        self.ended.recv_timeout(Duration::from_millis(50)).ok()
    }

    /// Waits until the program sleeps in a channel. Returns `false` if it ends instead.
    pub fn sleeps(&self) -> bool {
        self.comes_to(|| self.spe.sleeps())
    }

    /// Waits until the program has stored to this address of its local store, where it found 0.
    /// Returns `false` if it ends instead.
    pub fn stores_to(&self, address: u32) -> bool {
        self.comes_to(|| self.spe.local_store().load_word(address) != 0)
    }

    /// Waits until the program, which runs on, `is_there`. Returns `false` if it ends instead.
    fn comes_to(&self, is_there: impl Fn() -> bool) -> bool {
        let begin = Instant::now();
        loop {
            if self.ended.try_recv() != Err(TryRecvError::Empty) {
                return false;
            }
            if is_there() {
                return true;
            }
            assert!(begin.elapsed() < TIMEOUT, "the program does not get there");
            thread::sleep(Duration::from_millis(1));
        }
    }
}

pub fn run(spe: &Arc<Spe>, entry: u32) -> Stopped {
    start(spe, entry).wait()
}

/// Runs to a `stop` instruction, and returns its code.
pub fn run_to_stop(spe: &Arc<Spe>, entry: u32) -> u16 {
    match run(spe, entry) {
        Stopped { reason: Stop::Signal(code), .. } => code,
        other => panic!("{other}"),
    }
}

pub fn soon() -> Option<Instant> {
    Some(Instant::now() + TIMEOUT)
}

pub fn at_once() -> Option<Instant> {
    Some(Instant::now())
}

/// Word 0 of a register.
pub fn register(spe: &Spe, number: u8) -> u32 {
    spe.with_spu(|spu| spu.register(number).preferred())
}
