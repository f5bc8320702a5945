//! The binary form of vectors. The other form, lines of JSON, is that of [`Vector`] in serde.

use spu_emulator::interp::Quad;
use thiserror::Error;

use super::{Cycles, State, Truth, Value, Vector};

const MAGIC: &[u8; 8] = b"SPUVECT1";
/// The place of the FPSCR among the records. Lower ones are registers.
const FPSCR: u32 = 0x80;
/// Added to the address of a quadword of local store.
const LOCAL_STORE: u32 = 0x8000_0000;
/// The stop code of a vector that does not stop.
const NO_STOP: u32 = u32::MAX;
/// Flags: interrupts before, interrupts after, event.
const FLAGS: [u8; 3] = [1, 2, 4];
const TRUTHS: [Truth; 4] = [Truth::Architecture, Truth::Console, Truth::Fair, Truth::Open];

/// Why a file of vectors can't be read.
#[derive(Debug, Error, PartialEq, Eq)]
pub enum FormatError {
    /// The file does not begin as it must.
    #[error("the file does not begin with SPUVECT1 and a number of vectors")]
    Magic,
    /// The file ends within a vector.
    #[error("vector {0}: the file ends within it")]
    Truncated(u32),
    /// A field has a value without a meaning.
    #[error("vector {vector}: {field} can't be {value:#x}")]
    Field {
        /// The number of the vector.
        vector: u32,
        /// The name of the field.
        field: &'static str,
        /// Its value.
        value: u32,
    },
    /// There is something after the last vector.
    #[error("{0} bytes follow the last vector")]
    Longer(usize),
}

/// The beginning of a binary file with this number of vectors.
#[must_use]
pub fn binary_header(count: u32) -> Vec<u8> {
    [&MAGIC[..], &count.to_be_bytes()].concat()
}

/// A vector in the binary form, which has no name.
#[must_use]
pub fn to_binary(vector: &Vector) -> Vec<u8> {
    let Vector { truth, initial, after, stop, cycles, .. } = vector;
    let words = [initial.pc, after.pc, stop.unwrap_or(NO_STOP), initial.srr0, after.srr0];
    let mut bytes = words.map(u32::to_be_bytes).as_flattened().to_vec();
    bytes.extend([cycles.alone, cycles.pair].map(u16::to_be_bytes).as_flattened());
    let set = [initial.interrupts, after.interrupts, initial.event];
    let flags = FLAGS.iter().zip(set).map(|(flag, set)| flag * u8::from(set)).sum();
    let records = 1 + initial.regs.len() + initial.ram.len();
    bytes.extend([*truth as u8, cycles.truth as u8, flags, records as u8]);
    let mut record = |place: u32, before: Value, after: Value| {
        bytes.extend(place.to_be_bytes());
        bytes.extend([before, after].map(|value| value.0.bytes()).as_flattened());
    };
    record(FPSCR, initial.fpscr, after.fpscr);
    for (&(number, before), &(_, after)) in initial.regs.iter().zip(&after.regs) {
        record(u32::from(number), before, after);
    }
    for (&(address, before), &(_, after)) in initial.ram.iter().zip(&after.ram) {
        record(LOCAL_STORE | address, before, after);
    }
    bytes
}

/// Reads a binary file. The names of the vectors are empty.
///
/// # Errors
///
/// The bytes are not vectors.
pub fn from_binary(bytes: &[u8]) -> Result<Vec<Vector>, FormatError> {
    let rest = bytes.strip_prefix(MAGIC).ok_or(FormatError::Magic)?;
    let (count, mut rest) = rest.split_first_chunk().ok_or(FormatError::Magic)?;
    let vectors = (0..u32::from_be_bytes(*count)).map(|number| vector(number, &mut rest));
    let vectors = vectors.collect::<Result<Vec<_>, _>>()?;
    if rest.is_empty() { Ok(vectors) } else { Err(FormatError::Longer(rest.len())) }
}

/// Takes bytes from the rest of the file.
fn take<const N: usize>(number: u32, rest: &mut &[u8]) -> Result<[u8; N], FormatError> {
    let (taken, left) = rest.split_first_chunk().ok_or(FormatError::Truncated(number))?;
    *rest = left;
    Ok(*taken)
}

fn vector(number: u32, rest: &mut &[u8]) -> Result<Vector, FormatError> {
    let wrong = |field, value| FormatError::Field { vector: number, field, value };
    let truth = |field, value: u8| {
        let truth = TRUTHS.get(usize::from(value)).copied();
        truth.ok_or_else(|| wrong(field, u32::from(value)))
    };
    let mut word = || take(number, rest).map(u32::from_be_bytes);
    let [pc, next, stop, srr0, srr0_after] = [word()?, word()?, word()?, word()?, word()?];
    let cycles = word()?;
    let [of_result, of_cycles, flags, records] = take(number, rest)?;
    let [interrupts, interrupts_after, event] = FLAGS.map(|flag| flags & flag != 0);
    let mut initial = State { pc, srr0, interrupts, event, ..State::default() };
    let mut after =
        State { pc: next, srr0: srr0_after, interrupts: interrupts_after, ..initial.clone() };
    for _ in 0..records {
        let place = u32::from_be_bytes(take(number, rest)?);
        for state in [&mut initial, &mut after] {
            let value = Value(Quad::from_bytes(take(number, rest)?));
            match place {
                FPSCR => state.fpscr = value,
                LOCAL_STORE.. => state.ram.push((place - LOCAL_STORE, value)),
                0..FPSCR => state.regs.push((place as u8, value)),
                _ => return Err(wrong("the place of a record", place)),
            }
        }
    }
    Ok(Vector {
        name: String::new(),
        truth: truth("truth", of_result)?,
        initial,
        after,
        stop: (stop != NO_STOP).then_some(stop),
        cycles: Cycles {
            alone: (cycles >> 16) as u16,
            pair: cycles as u16,
            truth: truth("the truth of cycles", of_cycles)?,
        },
    })
}
