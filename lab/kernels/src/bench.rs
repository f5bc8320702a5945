//! Calls one kernel as a hostile caller would.
//!
//! Every register that a caller may leave undefined by the ABI holds junk, and so do the words of
//! scalar arguments outside the preferred slot. Registers that the kernel must preserve hold known
//! values. Buffers have guards around them. The rest of local store is filled with a `stop` that
//! nothing else uses. If a kernel breaks one of these rules, the bench reports which one.
//!
//! A kernel is called in both images from the same state, and both must leave the same state.
//! Every check of the plain version is therefore valid for the scheduled one.

use std::time::{Duration, Instant};

use rand::{RngCore as _, SeedableRng as _};
use rand_chacha::ChaCha8Rng;
use spu_emulator::channel::NoChannels;
use spu_emulator::elf::Image;
use spu_emulator::interp::{Observer, Quad, Spu};
use spu_emulator::local_store::{LocalStore, SIZE};
use spu_emulator::stop::Stop;
use zerocopy::{FromBytes, Immutable, IntoBytes};

use crate::set::Kernels;
use crate::source::Source;
use crate::time::{Time, Watch};

/// The stop code to which a kernel returns.
const RETURN: u16 = 0x1fff;
/// The stop code that a program runs into if it leaves its code.
const LOST: u16 = 0x1ffe;
/// The top of the stack. Nothing is above it.
const STACK: u32 = 0x3ff00;
/// The end of the arena: `depth_place` in `image/start.s`. Behind it are the kernels for depth
/// shading, boxes, height fields, colours, textures, meshes, refitted and built meshes, objects.
const ARENA_END: u32 = 0x27900;
/// The end of the arena for the kernels for cuts, which are there: `cuts_place`. Buffers of other
/// kernels may take their place.
const CUTS: u32 = 0x25f80;
/// The address of the `stop` that a kernel returns to.
pub(crate) const RETURN_ADDRESS: u32 = 0x3ff80;
/// The beginning of the arena, after the other kernels.
const ARENA: u32 = 0x1d900;
const GUARD: usize = 64;
const GUARD_BYTE: u8 = 0xa5;
const LIMIT: u64 = 10_000_000;

/// A generator of random inputs. Its seed is `CELLRAY_SEED`, or else always the same.
#[must_use]
#[expect(
    clippy::print_stdout,
    reason = "the test harness shows this output if a test fails, and only then"
)]
pub fn random() -> ChaCha8Rng {
    let seed =
        std::env::var("CELLRAY_SEED").ok().and_then(|text| text.parse().ok()).unwrap_or(SEED);
    println!("CELLRAY_SEED={seed}");
    ChaCha8Rng::seed_from_u64(seed)
}

/// The seed for results that must be reproducible.
pub const SEED: u64 = 2026;

/// The version of a kernel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Version {
    /// Plain, as written by hand.
    Plain,
    /// Scheduled for the two pipes.
    Scheduled,
}

/// A buffer in local store that is passed to the kernel.
#[derive(Clone, Copy, Debug)]
pub struct Place {
    /// Its address.
    pub address: u32,
    pub(crate) size: usize,
}

impl Place {
    /// Its first bytes.
    #[must_use]
    pub fn first(self, size: usize) -> Self {
        Self { size: size.min(self.size), ..self }
    }
}

/// The result of a call.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Returned {
    /// The preferred word of `$3`.
    pub value: u32,
    /// The number of instructions that the plain version executed.
    pub instructions: u64,
}

/// The kernels of one version in an emulated local store.
struct Machine {
    store: LocalStore,
    image: Image<'static>,
    spu: Spu,
}

impl Machine {
    fn new(image: &'static [u8]) -> Self {
        Self {
            store: LocalStore::new(),
            image: Image::parse(image).expect("the image is an SPU program"),
            spu: Spu::new(),
        }
    }

    /// Fills unused local store, and loads the kernels.
    fn load(&self) {
        self.fill_with_stops(0, SIZE);
        self.image.load(&self.store, 0);
        self.store.write(RETURN_ADDRESS, &u32::from(RETURN).to_be_bytes());
    }

    /// Fills local store from `start` to `end` with the `stop` that no program should run into.
    fn fill_with_stops(&self, start: u32, end: u32) {
        let words = (end - start) as usize / 4;
        let lost = u32::from(LOST).to_be_bytes().repeat(words);
        self.store.write(start, &lost);
    }

    fn run(&mut self, kernel: &str, registers: &[Quad; 128], observer: &mut impl Observer) -> u64 {
        self.spu.registers = *registers;
        let entry = self.image.symbol(kernel).unwrap_or_else(|| panic!("no kernel {kernel}"));
        self.spu.set_pc(entry);
        let executed = self.spu.executed();
        let stopped = self
            .spu
            .run_observed(&self.store, &mut NoChannels, LIMIT, observer)
            .unwrap_or_else(|| panic!("{kernel} does not end"));
        assert_eq!(stopped.reason, Stop::Signal(RETURN), "{kernel}: {stopped}");
        for number in std::iter::once(1).chain(80..128) {
            let (found, kept) = (self.spu.registers[number], registers[number]);
            assert_eq!(found, kept, "{kernel} lost ${number}, which it must keep");
        }
        // Without the `stop` that it returned to.
        self.spu.executed() - executed - 1
    }

    /// The arena up to `end`, which is the end of the last buffer.
    fn arena(&self, end: u32) -> Vec<u8> {
        let mut bytes = vec![0; (end - ARENA) as usize];
        self.store.read(ARENA, &mut bytes);
        bytes
    }
}

/// Both versions of the kernels, and the buffers for the next call.
pub struct Bench {
    sources: Vec<Source>,
    plain: Machine,
    scheduled: Machine,
    places: Vec<Place>,
    free: u32,
    junk: ChaCha8Rng,
}

impl Default for Bench {
    fn default() -> Self {
        Self::new()
    }
}

impl Bench {
    /// A bench with an empty arena for [`Kernels::here`].
    ///
    /// # Panics
    ///
    /// Panics if there are no kernels. Callers that can work without them check [`Kernels::here`]
    /// first.
    #[must_use]
    pub fn new() -> Self {
        let kernels = Kernels::here().unwrap_or_else(|error| panic!("{error}"));
        Self::of(kernels.clone())
    }

    /// A bench for any kernels.
    ///
    /// # Panics
    ///
    /// Panics if an image is not an SPU program.
    #[must_use]
    pub fn of(kernels: Kernels) -> Self {
        let bench = Self {
            sources: kernels.sources,
            plain: Machine::new(kernels.plain),
            scheduled: Machine::new(kernels.scheduled),
            places: Vec::new(),
            free: ARENA,
            junk: ChaCha8Rng::seed_from_u64(1),
        };
        for machine in [&bench.plain, &bench.scheduled] {
            for segment in machine.image.segments() {
                let end = segment.address + segment.memory_size;
                let is_free = end <= ARENA || segment.address >= CUTS;
                assert!(
                    is_free,
                    "the kernels reach into the arena: {:#x} to {end:#x}",
                    segment.address
                );
            }
            machine.load();
        }
        bench
    }

    /// Empties the arena.
    pub fn reset(&mut self) {
        for machine in [&self.plain, &self.scheduled] {
            machine.fill_with_stops(ARENA, self.free);
            if self.free > CUTS {
                machine.image.load(&machine.store, 0);
            }
        }
        self.places.clear();
        self.free = ARENA;
    }

    /// Adds a buffer with guards around it.
    pub fn place(&mut self, bytes: &[u8]) -> Place {
        let place = Place { address: self.free + GUARD as u32, size: bytes.len() };
        let end = place.address + place.size as u32;
        self.free = (end + GUARD as u32).next_multiple_of(128);
        assert!(self.free <= ARENA_END, "the arena is full");
        if self.free > CUTS {
            for machine in [&self.plain, &self.scheduled] {
                machine.fill_with_stops(place.address - GUARD as u32, self.free);
            }
        }
        for store in [&self.plain.store, &self.scheduled.store] {
            store.write(place.address - GUARD as u32, &[GUARD_BYTE; GUARD]);
            store.write(place.address, bytes);
            store.write(end, &[GUARD_BYTE; GUARD]);
        }
        self.places.push(place);
        place
    }

    /// Adds a buffer of junk for a kernel to write to.
    pub fn junk<T: FromBytes + IntoBytes + Immutable>(&mut self) -> Place {
        let mut bytes = vec![0; size_of::<T>()];
        self.junk.fill_bytes(&mut bytes);
        self.place(&bytes)
    }

    /// Reads a record from local store.
    ///
    /// # Panics
    ///
    /// Panics if the buffer does not have the record's size.
    #[must_use]
    pub fn read<T: FromBytes + IntoBytes>(&self, place: Place) -> T {
        assert_eq!(place.size, size_of::<T>());
        let mut record = T::new_zeroed();
        self.plain.store.read(place.address, record.as_mut_bytes());
        record
    }

    /// Reads all records of a buffer from local store.
    ///
    /// # Panics
    ///
    /// Panics if the buffer does not hold a whole number of records.
    #[must_use]
    pub fn read_all<T: FromBytes + IntoBytes>(&self, place: Place) -> Vec<T> {
        assert_eq!(place.size % size_of::<T>(), 0);
        let starts = (place.address..).step_by(size_of::<T>());
        let records = starts.take(place.size / size_of::<T>()).map(|start| {
            let mut record = T::new_zeroed();
            self.plain.store.read(start, record.as_mut_bytes());
            record
        });
        records.collect()
    }

    /// Reads the records of the list that begins in a buffer and ends at an address.
    ///
    /// # Panics
    ///
    /// Panics if the address is not a possible end of such a list.
    #[must_use]
    pub fn read_list<T: FromBytes + IntoBytes>(&self, buffer: Place, end: u32) -> Vec<T> {
        let mut list = self.read_all(buffer);
        let bytes = end.wrapping_sub(buffer.address) as usize;
        let ends = bytes <= buffer.size && bytes.is_multiple_of(size_of::<T>());
        assert!(ends, "no list ends at {end:#x}");
        list.truncate(bytes / size_of::<T>());
        list
    }

    /// All words of `$3` after the last call.
    #[must_use]
    pub fn returned_vector(&self) -> [u32; 4] {
        self.plain.spu.registers[3].0
    }

    /// The preferred slot of `$4` after the last call, for kernels that return two words.
    #[must_use]
    pub fn returned_second(&self) -> u32 {
        self.plain.spu.registers[4].0[0]
    }

    /// Calls a kernel with words in the preferred slots of `$3` and the following registers.
    ///
    /// # Panics
    ///
    /// Panics if the kernel breaks a rule of the ABI, writes outside its buffers or does not
    /// return, or if its versions disagree.
    pub fn call(&mut self, kernel: &str, arguments: &[u32]) -> Returned {
        let mut sources = self.sources.iter();
        let source = *sources
            .find(|source| source.name == kernel)
            .unwrap_or_else(|| panic!("no kernel {kernel}"));
        let registers = self.registers(arguments);
        let instructions = self.plain.run(kernel, &registers, &mut ());
        let value = self.plain.spu.registers[3].0[0];
        self.check_guards(kernel);
        self.scheduled.run(kernel, &registers, &mut ());
        self.compare(&source);
        Returned { value, instructions }
    }

    /// Times a call of one version without the checks. The memory that it writes is not restored.
    ///
    /// # Panics
    ///
    /// Panics if the kernel does not return.
    pub fn time(&mut self, version: Version, kernel: &str, arguments: &[u32]) -> Time {
        let registers = self.registers(arguments);
        let machine = match version {
            Version::Plain => &mut self.plain,
            Version::Scheduled => &mut self.scheduled,
        };
        let mut watch = Watch::default();
        machine.run(kernel, &registers, &mut watch);
        watch.time()
    }

    /// Runs one version of a kernel without the checks, and measures the host's time for its
    /// instructions. The memory that it writes is not restored.
    ///
    /// # Panics
    ///
    /// Panics if the kernel does not return.
    pub fn host_time(&mut self, version: Version, kernel: &str, arguments: &[u32]) -> Duration {
        let registers = self.registers(arguments);
        let machine = match version {
            Version::Plain => &mut self.plain,
            Version::Scheduled => &mut self.scheduled,
        };
        let start = Instant::now();
        machine.run(kernel, &registers, &mut ());
        start.elapsed()
    }

    /// Registers with junk except for the arguments, the stack pointer and the return address.
    fn registers(&mut self, arguments: &[u32]) -> [Quad; 128] {
        let mut registers = [Quad::ZERO; 128];
        for register in &mut registers {
            *register = Quad(std::array::from_fn(|_| self.junk.next_u32()));
        }
        registers[0].0[0] = RETURN_ADDRESS;
        registers[1] = Quad::splat(STACK);
        for (register, argument) in registers[3..].iter_mut().zip(arguments) {
            register.0[0] = *argument;
        }
        registers
    }

    fn check_guards(&self, kernel: &str) {
        for place in &self.places {
            for (side, address) in [
                ("before", place.address - GUARD as u32),
                ("after", place.address + place.size as u32),
            ] {
                let mut guard = [0; GUARD];
                self.plain.store.read(address, &mut guard);
                assert!(
                    guard.iter().all(|byte| *byte == GUARD_BYTE),
                    "{kernel} wrote {side} the buffer at {:#x}",
                    place.address
                );
            }
        }
    }

    /// Compares the results of the scheduled version with those of the plain one.
    fn compare(&self, source: &Source) {
        let kernel = source.name;
        let (plain, scheduled) = (self.plain.arena(self.free), self.scheduled.arena(self.free));
        if plain != scheduled {
            let mut bytes = plain.iter().zip(&scheduled);
            let offset = bytes.position(|(p, s)| p != s).expect("they differ");
            panic!(
                "{kernel}: plain and scheduled differ at {:#x}: {:02x} and {:02x}",
                ARENA as usize + offset,
                plain[offset],
                scheduled[offset]
            );
        }
        let words = source.header().map_or(0, |header| header.returned_words());
        let [plain, scheduled] =
            [&self.plain, &self.scheduled].map(|machine| &machine.spu.registers[3].0[..words]);
        assert_eq!(plain, scheduled, "{kernel}: plain and scheduled return");
    }
}
