//! `spu asm`: the assembler.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::Args;
use spu_assembler::{Errors, Program};

use crate::failure::Failure;
use crate::image;

/// Assemble an SPU source without the SPU binutils
///
/// The bytes and relocations are those of spu-elf-as. Sources with macros, conditions, repetitions
/// or included files need spu-elf-as. `spu run`, `spu debug` and `spu dump` take a source with
/// _start, and `spu time` any source, as it is.
#[derive(Args)]
#[command(after_help = "Examples:
  spu asm kernel.s                   writes the object kernel.o
  spu asm --program main.s -o main   writes a program, linked from address 0 on")]
pub struct Arguments {
    /// Assembly source
    source: PathBuf,
    /// File for the result; the default is the source's name with .o, or with .elf for a program
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    /// Write a program instead of an object. It may not need other files
    #[arg(long)]
    program: bool,
}

/// Runs the subcommand.
pub fn run(arguments: &Arguments) -> Result<ExitCode, Failure> {
    let path = &arguments.source;
    let bytes = image::read_file(path)?;
    let program = assemble(path, &bytes)?;
    let (bytes, extension) = match arguments.program {
        true => (program.link(0)?.elf(), "elf"),
        false => (program.elf(), "o"),
    };
    let output = arguments.output.clone().unwrap_or_else(|| path.with_extension(extension));
    if output == *path {
        return Err(Failure::new(format!("{} is the source", output.display())));
    }
    fs::write(&output, bytes).map_err(Failure::file(&output))?;
    Ok(ExitCode::SUCCESS)
}

/// Whether a file's name is that of an assembly source.
pub fn is_source(path: &Path) -> bool {
    path.extension().is_some_and(|extension| extension == "s")
}

/// Assembles a source, and prints warnings.
pub fn assemble(path: &Path, source: &[u8]) -> Result<Program, Errors> {
    let name = path.display().to_string();
    let program = spu_assembler::assemble(&name, &String::from_utf8_lossy(source))?;
    for warning in &program.warnings {
        messages::print!("{warning}");
    }
    Ok(program)
}

/// The program that a source with `_start` makes. Nothing for other sources, and for those that
/// only the SPU binutils can assemble.
pub fn program(path: &Path, source: &[u8]) -> Result<Option<Vec<u8>>, Errors> {
    match assemble(path, source) {
        Ok(program) if program.symbols.iter().any(|symbol| symbol.name == "_start") => {
            Ok(Some(program.link(0)?.elf()))
        }
        Err(errors) if !errors.uses_macros => Err(errors),
        _ => Ok(None),
    }
}
