//! `spu dump`: shows the parts of an SPU program.

mod listing;
mod map;

use std::path::PathBuf;
use std::process::ExitCode;

use clap::Args;

use crate::failure::Failure;
use crate::image::{parse, read, refused};
use map::Map;

const EXAMPLES: &str = "\
Examples:
  spu dump program.elf           entry, local store, notes, disassembly
  spu dump --map program.elf     without the disassembly
  spu dump program.elf | less";

/// Show an SPU program: entry point, map of local store, notes, disassembly
///
/// Labels come from the symbols and source lines from the line table, if the file has them.
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub struct Options {
    /// SPU ELF executable
    program: PathBuf,
    /// Show only the entry point, map and notes
    #[arg(long)]
    map: bool,
}

pub fn dump(options: &Options) -> Result<ExitCode, Failure> {
    let bytes = read(&options.program)?;
    let image = parse(&options.program, &bytes)?;
    let map = Map::of(&bytes).map_err(|error| refused(&options.program, &bytes, error))?;
    let mut text = format!("entry  {}\n", image.place(image.entry()));
    map.write(&mut text);
    if !options.map {
        let listed = listing::write(&bytes, &image, &mut text);
        listed.map_err(Failure::file(&options.program))?;
    }
    messages::write_data(text)?;
    Ok(ExitCode::SUCCESS)
}
