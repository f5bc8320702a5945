//! Calls one kernel as a hostile caller would.
//!
//! Every register that the ABI lets a caller leave anything in holds junk, also the words of scalar
//! arguments beyond the preferred one; registers that the kernel must keep hold marks; buffers lie
//! between guards; local store that is nobody's is full of a `stop` that nobody else uses. What a
//! kernel breaks of that is reported by name.

use cellray::spe::Program;
use oracle::twin::Single;
use rand::{RngCore as _, SeedableRng as _};
use rand_chacha::ChaCha8Rng;
use spu_emulator::channel::NoChannels;
use spu_emulator::elf::Image;
use spu_emulator::interp::{Quad, Spu};
use spu_emulator::local_store::{LocalStore, SIZE};
use spu_emulator::stop::Stop;
use zerocopy::big_endian::F32;
use zerocopy::{FromBytes, Immutable, IntoBytes};

/// Where a kernel returns to.
const RETURN: u16 = 0x1fff;
/// What a program that lost its way runs into.
const LOST: u16 = 0x1ffe;
/// Top of the stack: below it the arena, above it nothing.
const STACK: u32 = 0x3f000;
const RETURN_ADDRESS: u32 = 0x3f800;
const ARENA: u32 = 0x34000;
const GUARD: usize = 64;
const GUARD_BYTE: u8 = 0xa5;
const LIMIT: u64 = 10_000_000;

/// Seed of the random inputs: `CELLRAY_SEED`, else always the same.
pub fn random() -> ChaCha8Rng {
    let seed = std::env::var("CELLRAY_SEED")
        .ok()
        .and_then(|text| text.parse().ok())
        .unwrap_or(2026);
    println!("CELLRAY_SEED={seed}");
    ChaCha8Rng::seed_from_u64(seed)
}

/// Holds a kernel to the number after `Error` in its header: what its author promises.
pub fn keeps_stated_error(source: &str, worst: f64) {
    let line = source
        .lines()
        .find_map(|line| line.strip_prefix("#   Error "))
        .expect("the kernel's header states its error");
    let stated: f64 = line
        .split_whitespace()
        .find_map(|word| word.parse().ok())
        .expect("the stated error has a number");
    println!("worst error {worst:.6}, stated {stated}");
    assert!(worst <= stated, "error {worst}, stated {stated}");
}

/// A single of a record from its bits, whatever the host makes of them.
pub fn single(bits: Single) -> F32 {
    F32::from_bytes(bits.to_be_bytes())
}

/// The bits of a record's single.
pub fn bits(single: F32) -> Single {
    u32::from_be_bytes(single.to_bytes())
}

/// A place in local store that the kernel was given.
#[derive(Clone, Copy)]
pub struct Place {
    pub address: u32,
    size: usize,
}

/// The SPU program in an emulated local store.
pub struct Bench {
    store: LocalStore,
    image: Image<'static>,
    spu: Spu,
    places: Vec<Place>,
    free: u32,
    junk: ChaCha8Rng,
}

impl Bench {
    pub fn new() -> Self {
        let image = Image::parse(Program::tracer().image()).expect("our own program");
        Self {
            store: LocalStore::new(),
            image,
            spu: Spu::new(),
            places: Vec::new(),
            free: 0,
            junk: ChaCha8Rng::seed_from_u64(1),
        }
    }

    /// Empties the arena and puts a fresh program into local store.
    pub fn reset(&mut self) {
        let lost: Vec<u8> = u32::from(LOST).to_be_bytes().repeat(SIZE as usize / 4);
        self.store.write(0, &lost);
        self.image.load(&self.store, 0);
        self.store
            .write(RETURN_ADDRESS, &u32::from(RETURN).to_be_bytes());
        self.places.clear();
        self.free = ARENA;
    }

    /// A buffer with guards around it.
    pub fn place(&mut self, bytes: &[u8]) -> Place {
        let place = Place {
            address: self.free + GUARD as u32,
            size: bytes.len(),
        };
        self.store.write(self.free, &[GUARD_BYTE; GUARD]);
        self.store.write(place.address, bytes);
        self.store
            .write(place.address + place.size as u32, &[GUARD_BYTE; GUARD]);
        self.free = (place.address + place.size as u32).next_multiple_of(128) + GUARD as u32;
        self.free = self.free.next_multiple_of(128);
        assert!(self.free < STACK - 0x1000, "the arena is full");
        self.places.push(place);
        place
    }

    /// A buffer of junk for a kernel to write into.
    pub fn junk<T: FromBytes + IntoBytes + Immutable>(&mut self) -> Place {
        let mut bytes = vec![0; size_of::<T>()];
        self.junk.fill_bytes(&mut bytes);
        self.place(&bytes)
    }

    /// A record as it stands in local store now.
    pub fn read<T: FromBytes + IntoBytes>(&self, place: Place) -> T {
        assert_eq!(place.size, size_of::<T>());
        let mut record = T::new_zeroed();
        self.store.read(place.address, record.as_mut_bytes());
        record
    }

    /// Calls a kernel with words in the preferred slots of `$3` on; returns the instructions it took.
    pub fn call(&mut self, kernel: &str, arguments: &[u32]) -> u64 {
        for register in &mut self.spu.registers {
            *register = Quad(std::array::from_fn(|_| self.junk.next_u32()));
        }
        self.spu.registers[0].0[0] = RETURN_ADDRESS;
        self.spu.registers[1] = Quad::splat(STACK);
        for (register, argument) in self.spu.registers[3..].iter_mut().zip(arguments) {
            register.0[0] = *argument;
        }
        let before = self.spu.registers;
        let executed = self.spu.executed();
        self.spu.set_pc(
            self.image
                .symbol(kernel)
                .unwrap_or_else(|| panic!("no kernel {kernel}")),
        );
        let stopped = self
            .spu
            .run_limited(&self.store, &mut NoChannels, LIMIT)
            .unwrap_or_else(|| panic!("{kernel} does not come to an end"));
        assert_eq!(stopped.reason, Stop::Signal(RETURN), "{kernel}: {stopped}");

        for number in std::iter::once(1).chain(80..128) {
            let (found, kept) = (self.spu.registers[number], before[number]);
            assert_eq!(found, kept, "{kernel} lost ${number}, which it must keep");
        }
        for place in &self.places {
            for (side, address) in [
                ("before", place.address - GUARD as u32),
                ("after", place.address + place.size as u32),
            ] {
                let mut guard = [0; GUARD];
                self.store.read(address, &mut guard);
                assert!(
                    guard.iter().all(|byte| *byte == GUARD_BYTE),
                    "{kernel} wrote {side} the buffer at {:#x}",
                    place.address
                );
            }
        }
        self.spu.executed() - executed
    }
}

#[test]
fn the_harness_sees_a_kernel_that_loses_its_way() {
    let mut bench = Bench::new();
    bench.reset();
    let lost = std::panic::catch_unwind(move || bench.call("frame", &[]));
    assert!(lost.is_err(), "data was run as a kernel");
}
