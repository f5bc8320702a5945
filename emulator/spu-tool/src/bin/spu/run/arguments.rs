//! The program's arguments, in registers and in main memory.

use std::os::unix::ffi::OsStrExt as _;

use spu_emulator::interp::Quad;
use spu_emulator::local_store::SIZE;
use spu_emulator::memory::{Access, RegisteredMemory};

use super::map::ARGUMENTS_EA;
use super::options::{Options, Register, Start};
use crate::failure::Failure;

/// The handle that libspe2 passes to a program. Any number except 0 will do.
const SPE_ID: u64 = 1;
/// The largest size in bytes of the arguments that elfspe's start code copies: one transfer, so
/// that enough memory remains for the program.
const MAX_SIZE: usize = 16 << 10;
const QUADWORD: usize = 16;

/// Puts the arguments into memory and returns the registers from $3 on.
pub fn prepare(options: &Options, memory: &RegisteredMemory) -> Result<Vec<Quad>, Failure> {
    if !options.registers.is_empty() {
        let quad = |register: &Register| match *register {
            Register::Word(word) => Quad::scalar(word),
            Register::Doubleword(value) => Quad::from_doublewords([value, 0]),
        };
        return Ok(options.registers.iter().map(quad).collect());
    }
    let program = options.program.as_os_str();
    let strings: Vec<Vec<u8>> = std::iter::once(program)
        .chain(options.arguments.iter().map(AsRef::as_ref))
        .map(|text| [text.as_bytes(), &[0]].concat())
        .collect();
    let (block, registers) = match options.start {
        Start::Spe => vector_of_addresses(&strings),
        Start::Elfspe => copy_for_local_store(&strings)?,
    };
    let registered = memory.register(ARGUMENTS_EA, block, Access::ReadWrite);
    registered.map_err(Failure::of("the arguments"))?;
    Ok(registers)
}

/// 64-bit effective addresses with a 0 after the last, followed by the strings.
fn vector_of_addresses(strings: &[Vec<u8>]) -> (Vec<u8>, Vec<Quad>) {
    const POINTER: usize = 8;
    let mut text: Vec<u8> = Vec::new();
    let mut block = Vec::new();
    let texts = ARGUMENTS_EA + ((strings.len() + 1) * POINTER) as u64;
    for string in strings {
        block.extend((texts + text.len() as u64).to_be_bytes());
        text.extend(string);
    }
    block.extend([0; POINTER]);
    block.extend(text);
    block.resize(block.len().next_multiple_of(QUADWORD), 0);
    let quad = |value| Quad::from_doublewords([value, 0]);
    (block, vec![quad(SPE_ID), quad(ARGUMENTS_EA), Quad::ZERO])
}

/// The data that crt2.o copies to the top of local store: 32-bit addresses in local store with a 0
/// after the last, followed by the strings. $4 holds the destination, the source and the size.
fn copy_for_local_store(strings: &[Vec<u8>]) -> Result<(Vec<u8>, Vec<Quad>), Failure> {
    const POINTER: usize = 4;
    let texts = (strings.len() + 1) * POINTER;
    let size = texts + strings.iter().map(Vec::len).sum::<usize>();
    let size = size.next_multiple_of(QUADWORD);
    if size > MAX_SIZE {
        let message = format!("the arguments take {size} bytes; they don't fit into local store");
        return Err(Failure::new(message));
    }
    let address = SIZE - size as u32;
    let mut text: Vec<u8> = Vec::new();
    let mut block = Vec::new();
    for string in strings {
        block.extend((address + (texts + text.len()) as u32).to_be_bytes());
        text.extend(string);
    }
    block.extend([0; POINTER]);
    block.extend(text);
    block.resize(size, 0);
    let [high, low] = [(ARGUMENTS_EA >> 32) as u32, ARGUMENTS_EA as u32];
    let registers = vec![
        Quad::scalar(strings.len() as u32),
        Quad([address, high, low, size as u32]),
        Quad::ZERO,
    ];
    Ok((block, registers))
}
