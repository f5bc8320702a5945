//! Reads the program's file.

use std::fs;
use std::path::Path;

use spu_emulator::elf::Image;
use spu_isa::{Instruction, Op, disassemble};

use crate::failure::Failure;

pub fn read(path: &Path) -> Result<Vec<u8>, Failure> {
    fs::read(path).map_err(Failure::file(path))
}

pub fn parse<'data>(path: &Path, bytes: &'data [u8]) -> Result<Image<'data>, Failure> {
    Image::parse(bytes).map_err(|error| Failure::Elf {
        path: path.to_path_buf(),
        error,
    })
}

/// `0x00104 <main+0x10>`: an address with its nearest symbol.
pub fn place(image: &Image<'_>, address: u32) -> String {
    let name = match image.nearest_symbol(address) {
        Some((name, 0)) => format!(" <{name}>"),
        Some((name, distance)) => format!(" <{name}+{distance:#x}>"),
        None => String::new(),
    };
    format!("{address:#07x}{name}")
}

/// An instruction's text. A stop includes its code, which objdump leaves out.
pub fn instruction_text(word: u32, address: u32) -> String {
    if let Some(Instruction {
        op: Op::Stop,
        immediate,
        ..
    }) = Instruction::decode(word)
    {
        return format!("stop {immediate:#06x}");
    }
    let text = disassemble(word, address).to_string();
    // The comment only repeats a constant from the operands.
    let text = text.split("\t#").next().unwrap_or(&text);
    text.replace('\t', " ")
}
