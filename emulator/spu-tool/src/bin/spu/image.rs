//! Reads the program's file.

use std::fs;
use std::path::Path;

use object::elf::{EM_386, EM_AARCH64, EM_ARM, EM_PPC, EM_PPC64, EM_X86_64, ET_REL};
use spu_emulator::elf::{ElfError, Image};

use crate::asm;
use crate::failure::Failure;

pub fn read_file(path: &Path) -> Result<Vec<u8>, Failure> {
    fs::read(path).map_err(Failure::file(path))
}

/// Reads a program, or makes one of an assembly source.
pub fn read(path: &Path) -> Result<Vec<u8>, Failure> {
    let bytes = read_file(path)?;
    if !asm::is_source(path) {
        return Ok(bytes);
    }
    let made = asm::program(path, &bytes)?;
    Ok(made.unwrap_or(bytes))
}

pub fn parse<'data>(path: &Path, bytes: &'data [u8]) -> Result<Image<'data>, Failure> {
    Image::parse(bytes).map_err(|error| refused(path, bytes, error))
}

/// The file is no SPU program for this reason.
pub fn refused(path: &Path, bytes: &[u8], error: ElfError) -> Failure {
    Failure::bad_elf(format!("{}: {error}{}", path.display(), advice(path, bytes, &error)))
}

/// What to do with a file that is no SPU program.
fn advice(path: &Path, bytes: &[u8], error: &ElfError) -> String {
    let (path, stem) = (path.display(), path.with_extension(""));
    let stem = stem.display();
    match error {
        ElfError::NotElf if !bytes.is_empty() && !bytes.contains(&0) => {
            let link = format!("spu-elf-ld {stem}.o -o {stem}.elf");
            format!(
                ", but text. Assembly is first made a program: spu-elf-as {path} -o {stem}.o && {link}"
            )
        }
        ElfError::Type(kind) if *kind == ET_REL.0 => format!(
            ": it is an object. A program has _start, too, and is linked: spu-elf-ld {path} -o \
             {stem}.elf. spu time and spu schedule take objects"
        ),
        ElfError::Identification { .. } | ElfError::Machine(_) => match machine(bytes) {
            Some(name) => format!(": it is for {name}, and not for the SPU"),
            None => String::new(),
        },
        _ => String::new(),
    }
}

/// The machine of an ELF file for another one than the SPU.
fn machine(bytes: &[u8]) -> Option<&'static str> {
    const DATA: usize = 5;
    const BIG_ENDIAN: u8 = 2;
    const MACHINE: std::ops::Range<usize> = 18..20;
    let field = <[u8; 2]>::try_from(bytes.get(MACHINE)?).ok()?;
    let number = match bytes[DATA] {
        BIG_ENDIAN => u16::from_be_bytes(field),
        _ => u16::from_le_bytes(field),
    };
    let names = [
        (EM_386.0, "32-bit x86"),
        (EM_X86_64.0, "x86-64"),
        (EM_ARM.0, "32-bit ARM"),
        (EM_AARCH64.0, "AArch64"),
        (EM_PPC.0, "32-bit PowerPC, as PPE programs are"),
        (EM_PPC64.0, "64-bit PowerPC, as PPE programs are"),
    ];
    let (_, name) = names.into_iter().find(|(machine, _)| *machine == number)?;
    Some(name)
}
