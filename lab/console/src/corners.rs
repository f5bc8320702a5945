//! The instructions whose results `docs/emulator.md` calls open or fair, run on an SPU.

use std::fmt;
use std::sync::mpsc;
use std::thread;
use std::time::{Duration, Instant};

use cellray::SharedMemory;
use cellray::spe::{Context, Outcome, Program};

use crate::Failure;

const IMAGE: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/corners.elf"));

/// The emulator's results, one a line: the list of facts that a console can correct.
pub const FACTS: &str = include_str!("../corners.txt");

// The layout of `spu/corners.s`.
const COUNT: usize = 128;
const RESULT_BYTES: usize = 32;
const NAME_BYTES: usize = 64;
const NAMES_AT: usize = COUNT * RESULT_BYTES;
const BYTES: usize = NAMES_AT + COUNT * NAME_BYTES;

/// A result of an SPU.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Corner {
    name: String,
    value: [u32; 4],
    flags: [u32; 4],
}

impl fmt::Display for Corner {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:", self.name)?;
        self.value.iter().try_for_each(|word| write!(f, " {word:08x}"))?;
        write!(f, ", FPSCR")?;
        self.flags.iter().try_for_each(|word| write!(f, " {word:08x}"))
    }
}

/// Runs all corners on an SPU.
///
/// # Errors
/// libspe2 fails, or the program ends otherwise than it should.
pub fn run() -> Result<Vec<Corner>, Failure> {
    run_in(&loaded()?)
}

/// A context that has the program.
fn loaded() -> Result<Context, Failure> {
    let context = Context::create()?;
    context.load(&Program::from_image(IMAGE)?)?;
    Ok(context)
}

fn run_in(context: &Context) -> Result<Vec<Corner>, Failure> {
    let results = SharedMemory::new(BYTES);
    let ended = context.run(results.address() as usize);
    if ended.outcome != Outcome::Exit(0) {
        return Err(ended.to_string().into());
    }
    let mut bytes = [0; BYTES];
    results.read(0, &mut bytes);
    let quad = |at: usize| {
        let word = |at: usize| u32::from_be_bytes([0, 1, 2, 3].map(|byte| bytes[at + byte]));
        [0, 4, 8, 12].map(|offset| word(at + offset))
    };
    let corners = (0..COUNT).map_while(|number| {
        let name = &bytes[NAMES_AT + number * NAME_BYTES..][..NAME_BYTES];
        let name: Vec<u8> = name.iter().copied().take_while(|byte| *byte != 0).collect();
        let at = number * RESULT_BYTES;
        (!name.is_empty()).then(|| Corner {
            name: String::from_utf8_lossy(&name).into_owned(),
            value: quad(at),
            flags: quad(at + 16),
        })
    });
    Ok(corners.collect())
}

/// Runs all corners on this many SPUs at once. An SPU that has not ended after `limit` gets an
/// error; its thread goes on, and the process should end.
#[must_use]
pub fn on_each(spus: u32, limit: Duration) -> Vec<Result<Vec<Corner>, String>> {
    let (sender, receiver) = mpsc::channel();
    for number in 0..spus as usize {
        let sender = sender.clone();
        // Created in the order of their numbers.
        let context = loaded().map_err(|error| error.to_string());
        thread::spawn(move || {
            let result =
                context.and_then(|context| run_in(&context).map_err(|error| error.to_string()));
            // Nobody listens any more after the limit.
            let _ = sender.send((number, result));
        });
    }
    let seconds = limit.as_secs_f64();
    let hung = |number| Err(format!("SPU {number} hangs: it has not ended within {seconds} s"));
    let mut results: Vec<_> = (0..spus).map(hung).collect();
    let until = Instant::now() + limit;
    for _ in 0..spus {
        let left = until.saturating_duration_since(Instant::now());
        let Ok((number, result)) = receiver.recv_timeout(left) else {
            break;
        };
        results[number] = result.map_err(|error| format!("SPU {number}: {error}"));
    }
    results
}
