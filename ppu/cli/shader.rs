//! `cellray shader build`: shaders of one's own in an SPU program.

use std::fs;
use std::path::{Path, PathBuf};

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
    /// Assemble one shader into an object, which `spu time` and `spu schedule` take
    Assemble {
        /// Source in SPU assembly
        #[arg(value_name = "F.s")]
        source: PathBuf,
        /// Object to write [default: the source's name with .o, in this folder]
        #[arg(long, value_name = "F.o")]
        out: Option<PathBuf>,
    },
}

pub fn run(arguments: &Arguments) -> Outcome {
    match &arguments.command {
        Command::Build { sources, out } => build(sources, out.as_deref()),
        Command::Assemble { source, out } => {
            let out = named(source, out.as_deref(), "o");
            Ok(spu_build::assemble_shader(source, &out)?)
        }
    }
}

fn build(sources: &[PathBuf], out: Option<&Path>) -> Outcome {
    let image = spu_build::tracer_with(sources)?;
    let shaders = Program::from_image(&image)?.shaders()?;
    let out = named(&sources[0], out, "elf");
    fs::write(&out, &image).map_err(|error| format!("{}: {error}", out.display()))?;
    talk::say!("cellray: {}: shaders {}", out.display(), shaders.join(", "));
    Ok(())
}

/// The file to write: as asked for, or after the source, in this folder.
fn named(source: &Path, out: Option<&Path>, extension: &str) -> PathBuf {
    let stem = Path::new(source.file_stem().unwrap_or_default());
    out.map_or_else(|| stem.with_extension(extension), Path::to_path_buf)
}
