//! `cellray shader build`: shaders of one's own in an SPU program.

use std::fs;
use std::path::PathBuf;

use cellray::spe::Program;
use clap::{Args, Subcommand};

use super::Outcome;

/// Build shaders of your own into an SPU program.
#[derive(Args)]
pub struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Assemble shaders and link them with the tracer; needs an SPU assembler
    Build {
        /// Sources in SPU assembly; docs/shaders.md has the rules
        #[arg(value_name = "F.s", required = true)]
        sources: Vec<PathBuf>,
        /// SPU program to write [default: the first source's name with .elf, in this folder]
        #[arg(long, value_name = "F.elf")]
        out: Option<PathBuf>,
    },
}

pub fn run(arguments: &Arguments) -> Outcome {
    let Command::Build { sources, out } = &arguments.command;
    let image = spu_build::tracer_with(sources)?;
    let shaders = Program::from_image(&image)?.shaders()?;
    let stem = sources[0].file_stem().unwrap_or_default();
    let out = out
        .clone()
        .unwrap_or_else(|| PathBuf::from(stem).with_extension("elf"));
    fs::write(&out, &image).map_err(|error| format!("{}: {error}", out.display()))?;
    eprintln!("cellray: {}: shaders {}", out.display(), shaders.join(", "));
    Ok(())
}
