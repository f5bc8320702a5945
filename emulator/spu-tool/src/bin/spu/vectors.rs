//! `spu vectors`: writes test vectors of instructions.

use std::fs::{self, File};
use std::io::{BufWriter, Write as _};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::Args;
use spu_isa::{Op, Row};
use spu_tool::vectors::{Generator, binary_header, to_binary};

use crate::failure::Failure;

/// Write test vectors of instructions, for other emulators and recompilers
///
/// For each instruction, DIR gets NAME.jsonl, one vector a line, and NAME.bin, the same in a
/// compact binary form. A vector has the registers, local store and FPSCR before and after the
/// instruction, the next address, the cycles alone and in a pair, and the source of these figures.
/// The format and loaders in C and Python are in examples/vectors.
#[derive(Args, Debug)]
#[command(after_help = "Examples:
  spu vectors --out vectors
  spu vectors --out vectors --instruction fma --count 100000 --seed 7")]
pub struct Arguments {
    /// Folder for the files; it is created if there is none
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
    /// Only this instruction, such as shufb
    #[arg(long, value_name = "NAME", value_parser = instruction)]
    instruction: Option<Op>,
    /// Vectors of each instruction
    #[arg(long, value_name = "N", default_value_t = 1000,
        value_parser = clap::value_parser!(u32).range(1..=10_000_000))]
    count: u32,
    /// Another number gives other vectors, the same number always the same
    #[arg(long, value_name = "N", default_value_t = 0)]
    seed: u64,
}

fn instruction(name: &str) -> Result<Op, String> {
    Op::of_mnemonic(name).ok_or_else(|| "no instruction of the SPU has this name".to_owned())
}

/// Runs the subcommand.
pub fn run(arguments: &Arguments) -> Result<ExitCode, Failure> {
    let Arguments { out, instruction, count, .. } = arguments;
    fs::create_dir_all(out).map_err(Failure::file(out))?;
    let rows = Op::rows().iter().filter(|row| instruction.is_none_or(|op| op == row.op));
    for row in rows {
        write(arguments, row)?;
    }
    let written = match instruction {
        Some(op) => op.row().mnemonic.to_owned(),
        None => format!("each of {} instructions", Op::rows().len()),
    };
    messages::print!("{}: {count} vectors of {written}", out.display());
    Ok(ExitCode::SUCCESS)
}

/// Writes both files of an instruction.
fn write(arguments: &Arguments, row: &Row) -> Result<(), Failure> {
    let [lines, binary] =
        ["jsonl", "bin"].map(|ending| arguments.out.join(format!("{}.{ending}", row.mnemonic)));
    let create = |path: &Path| File::create(path).map(BufWriter::new).map_err(Failure::file(path));
    let (mut line_file, mut binary_file) = (create(&lines)?, create(&binary)?);
    let vectors = Generator::new(row.op, arguments.seed).take(arguments.count as usize);
    let mut bytes = binary_header(arguments.count);
    for vector in vectors {
        bytes.extend(to_binary(&vector));
        binary_file.write_all(&bytes).map_err(Failure::file(&binary))?;
        bytes.clear();
        let line = serde_json::to_string(&vector)?;
        writeln!(line_file, "{line}").map_err(Failure::file(&lines))?;
    }
    line_file.flush().map_err(Failure::file(&lines))?;
    binary_file.flush().map_err(Failure::file(&binary))
}
