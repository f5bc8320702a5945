//! Multiplies matrices of 64x64 singles on an SPU: `C += A * B`, by the kernel that `build.rs`
//! writes.

use std::error::Error;

use cellray::SharedMemory;
use cellray::spe::{Context, Outcome, Program};

const IMAGE: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/matrix.elf"));

/// Rows, and columns.
pub const SIDE: usize = 64;
const WORDS: usize = SIDE * SIDE;
const CONTROL: usize = 3 * WORDS * 4;
/// Cycles in a tick of the decrementer.
const CYCLES_PER_TICK: f64 = 40.0;

/// What a run gave.
pub struct Product {
    /// C, row by row.
    pub c: Vec<f32>,
    /// Cycles of one multiplication.
    pub cycles: f64,
}

/// Adds `a * b` to `c`, `times` times. All have [`SIDE`] rows of [`SIDE`] columns.
///
/// # Errors
///
/// Fails if libspe2 does.
///
/// # Panics
///
/// A matrix has another size, or `times` is 0.
pub fn multiply(a: &[f32], b: &[f32], c: &[f32], times: u32) -> Result<Product, Box<dyn Error>> {
    assert!(times > 0 && [a, b, c].iter().all(|matrix| matrix.len() == WORDS));
    let mut memory = SharedMemory::new(CONTROL + 128);
    for (number, matrix) in [a, b, c].into_iter().enumerate() {
        let bytes: Vec<u8> = matrix.iter().flat_map(|x| x.to_be_bytes()).collect();
        memory.write(number * WORDS * 4, &bytes);
    }
    memory.write(CONTROL, &times.to_be_bytes());
    let context = Context::create()?;
    context.load(&Program::from_image(IMAGE)?)?;
    let ended = context.run(memory.address() as usize);
    if ended.outcome != Outcome::Exit(0) {
        return Err(ended.to_string().into());
    }
    let mut bytes = vec![0; WORDS * 4];
    memory.read(2 * WORDS * 4, &mut bytes);
    let single = |bytes: &[u8]| f32::from_be_bytes([bytes[0], bytes[1], bytes[2], bytes[3]]);
    let ticks = f64::from(memory.peek_word(CONTROL));
    Ok(Product {
        c: bytes.chunks_exact(4).map(single).collect(),
        cycles: ticks * CYCLES_PER_TICK / f64::from(times),
    })
}

/// A matrix of numbers from -1 to 1, different for each seed.
#[must_use]
pub fn example(seed: u32) -> Vec<f32> {
    let mut state = seed;
    (0..WORDS)
        .map(|_| {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (state >> 8) as f32 / (1 << 23) as f32 - 1.0
        })
        .collect()
}
