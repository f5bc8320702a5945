//! `cellray sphereflake`: writes a generated scene as a file.

use clap::Args;

use super::Outcome;

/// Write a sphereflake as an NFF scene to standard output.
#[derive(Args)]
pub struct Arguments {
    /// Levels below the first sphere: 0 makes one sphere, 4 the 7381 of the Standard Procedural
    /// Databases
    #[arg(allow_negative_numbers = true)]
    level: u32,
}

pub fn run(arguments: &Arguments) -> Outcome {
    let scene = nff::sphereflake::generate(arguments.level)?;
    Ok(talk::print_with(|out| write!(out, "{scene}"))?)
}
