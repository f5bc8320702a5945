//! Functions that assemble programs, and machines that run them.

use std::sync::mpsc::TryRecvError;
use std::sync::{Arc, mpsc};
use std::thread;
use std::time::{Duration, Instant};

pub use crate::program::assemble;
use spu_emulator::elf::Image;
use spu_emulator::interp::{Quad, Spu};
use spu_emulator::machine;
use spu_emulator::memory::{Access, MainMemory, RegisteredMemory};
use spu_emulator::mfc::Policy;
use spu_emulator::spe::{Config, Spe};
use spu_emulator::stop::{Stop, Stopped};

/// How long a program may take on a host that is busy with other things. It only ends a test that
/// hangs.
pub const TIMEOUT: Duration = Duration::from_secs(600);

/// Address of the main memory of every machine in these tests.
pub const BASE: u64 = 0x3_4000_0000;
pub const MEMORY: usize = 256 * 1024;

pub struct Machine {
    pub memory: Arc<RegisteredMemory>,
    machine: Arc<machine::Machine>,
}

impl Machine {
    /// A machine with 256 KB of main memory at [`BASE`], all 0.
    pub fn new() -> Self {
        let memory = Arc::new(RegisteredMemory::new());
        memory.register(BASE, vec![0; MEMORY], Access::ReadWrite).unwrap();
        let machine = machine::Machine::new(memory.clone());
        Self { memory, machine }
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
}

pub fn load(spe: &Spe, image: &[u8]) -> u32 {
    let image = Image::parse(image).unwrap();
    image.load(spe.local_store(), 0);
    image.entry()
}

/// Sets the registers that the programs expect: $2 and $3 are the two halves of [`BASE`].
pub fn base_registers(spu: &mut Spu) {
    spu.set_register(2, Quad::scalar((BASE >> 32) as u32));
    spu.set_register(3, Quad::scalar(BASE as u32));
}

/// A program that runs on its own thread.
pub struct Running {
    spe: Arc<Spe>,
    ended: mpsc::Receiver<Stopped>,
}

pub fn start(spe: &Arc<Spe>, entry: u32) -> Running {
    let (sender, ended) = mpsc::channel();
    let runner = Arc::clone(spe);
    thread::spawn(move || {
        let stopped = runner.run_prepared(entry, base_registers);
        // A test that has failed no longer receives.
        let _ = sender.send(stopped);
    });
    Running { spe: Arc::clone(spe), ended }
}

impl Running {
    pub fn wait(self) -> Stopped {
        self.ended.recv_timeout(TIMEOUT).unwrap_or_else(|_| {
            self.spe.request_stop();
            let stopped = self.ended.recv_timeout(TIMEOUT);
            panic!("the program did not end by itself: {stopped:?}")
        })
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
        self.comes_to(|| {
            let mut word = [0; 4];
            self.spe.local_store().read(address, &mut word);
            word != [0; 4]
        })
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
