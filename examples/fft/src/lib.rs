//! Complex Fourier transforms on SPUs: of 4096 numbers in the local store of one, and of 65,536 in
//! main memory by several.
//!
//! The large one follows the design of Chow, Fossum and Brokenshire: the numbers are a matrix whose
//! columns are transformed first and whose rows after that. Each of the two passes streams it
//! through the local stores, a batch of 16 columns at a time, while the batch before is stored and
//! the next one fetched. [`twin`] computes the same on the PPE, bit for bit.

pub mod document;
mod factors;
pub mod twin;

use std::thread;

use cellray::SharedMemory;
use cellray::spe::{Context, Outcome, Program, ProgramError, SpeError};

const IMAGE: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/fft.elf"));
/// Cycles in a tick of the decrementer.
const CYCLES_PER_TICK: f64 = 40.0;

/// Offsets in the SPUs' data, as `spu/main.s` has them.
const INPUT: usize = 0;
const OUTPUT: usize = 0x10_0000;
const FACTORS: usize = 0x18_0000;
const FINE: usize = 0x18_2000;
const COARSE: usize = 0x18_a000;
const ORDERS: usize = 0x19_2080;
const ORDER_BYTES: usize = 128;

/// Most SPUs that can share a transform: one for each batch.
pub const MAX_SPUS: u32 = 16;

/// Real and imaginary part.
pub type Complex = [f32; 2];

/// How many numbers are transformed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Size {
    /// 4096 in local store, by each SPU for itself.
    Small,
    /// 65,536 in main memory, by all SPUs together.
    Large,
}

impl Size {
    /// The numbers.
    #[must_use]
    pub fn numbers(self) -> usize {
        self.side() * self.side()
    }

    /// Rows, and columns, of the matrix.
    #[must_use]
    pub fn side(self) -> usize {
        match self {
            Self::Small => 64,
            Self::Large => 256,
        }
    }

    /// The operations that a transform is commonly counted as.
    #[must_use]
    pub fn operations(self) -> f64 {
        let numbers = self.numbers() as f64;
        5.0 * numbers * libm::log2(numbers)
    }
}

/// What a run gave.
#[derive(Debug)]
pub struct Transformed {
    /// The transform.
    pub output: Vec<Complex>,
    /// Cycles of one transform.
    pub cycles: f64,
}

/// Why there is no transform.
#[derive(Debug, thiserror::Error)]
pub enum FftError {
    /// libspe2 refused a call.
    #[error(transparent)]
    Spe(#[from] SpeError),
    /// The SPU program is damaged.
    #[error(transparent)]
    Program(#[from] ProgramError),
    /// An SPU ended otherwise than it should.
    #[error("SPU {number}: {ended}")]
    Ended {
        /// The SPU's number.
        number: usize,
        /// How it ended.
        ended: String,
    },
    /// DMA lists have only the low halves of addresses.
    #[error("the data at {0:#x} crosses a multiple of 4 GB, which a DMA list can't")]
    Crosses(u64),
}

/// Transforms `input` on `spus` SPUs, `times` times.
///
/// # Errors
///
/// Fails if libspe2 does.
///
/// # Panics
///
/// `input` has another size, `times` is 0, or `spus` is not 1 to [`MAX_SPUS`], or not 1 for the
/// small size.
pub fn transform(
    size: Size,
    input: &[Complex],
    spus: u32,
    times: u32,
) -> Result<Transformed, FftError> {
    assert!(input.len() == size.numbers() && times > 0);
    let most = if size == Size::Small { 1 } else { MAX_SPUS };
    assert!((1..=most).contains(&spus));
    let mut memory = SharedMemory::new(ORDERS + spus as usize * ORDER_BYTES);
    let address = memory.address();
    if address >> 32 != (address + ORDERS as u64) >> 32 {
        return Err(FftError::Crosses(address));
    }
    memory.write(INPUT, &factors::lines(input));
    memory.write(FACTORS, &factors::stage_bytes());
    memory.write(FINE, &factors::fine_bytes(size));
    memory.write(COARSE, &factors::coarse_bytes(size));
    let order = |number: u32| ORDERS + number as usize * ORDER_BYTES;
    let program = Program::from_image(IMAGE)?;
    let mut contexts = Vec::new();
    for number in 0..spus {
        let large = u32::from(size == Size::Large);
        let words = [large, times, number, spus, address as u32];
        let bytes: Vec<u8> = words.iter().flat_map(|word| word.to_be_bytes()).collect();
        memory.write(order(number), &bytes);
        let context = Context::create()?;
        context.load(&program)?;
        contexts.push(context);
    }
    // An SPU that waits for another one's would wait for ever if that is lost.
    let halt = || contexts.iter().for_each(|context| context.halt(&program));
    let run = |number: u32, context: &Context| {
        let ended = context.run(address as usize + order(number));
        if ended.outcome != Outcome::Exit(0) {
            halt();
        }
        ended
    };
    let run = &run;
    thread::scope(|scope| {
        let threads: Vec<_> = (0..)
            .zip(&contexts)
            .map(|(number, context)| scope.spawn(move || run(number, context)))
            .collect();
        let begun = contexts.iter().try_for_each(|context| context.mail([1]));
        if begun.is_err() {
            halt();
        }
        let mut lost = None;
        for (number, thread) in threads.into_iter().enumerate() {
            let Ok(ended) = thread.join() else {
                unreachable!("running a context does not panic");
            };
            let halted = matches!(ended.outcome, Outcome::Signal(_));
            if ended.outcome != Outcome::Exit(0) && (lost.is_none() || !halted) {
                let ended = ended.to_string();
                lost = Some(FftError::Ended { number, ended });
            }
        }
        begun?;
        lost.map_or(Ok(()), Err)
    })?;
    let mut bytes = vec![0; 8 * size.numbers()];
    memory.read(OUTPUT, &mut bytes);
    let ticks = memory.peek_word(order(0));
    Ok(Transformed {
        output: factors::numbers(&bytes),
        cycles: f64::from(ticks) * CYCLES_PER_TICK / f64::from(times),
    })
}

/// Numbers with parts from -1 to 1, different for each seed.
#[must_use]
pub fn example(size: Size, seed: u32) -> Vec<Complex> {
    let mut state = seed;
    let mut part = || {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (state >> 8) as f32 / (1 << 23) as f32 - 1.0
    };
    (0..size.numbers()).map(|_| [part(), part()]).collect()
}
