//! `cellray sphereflake`: writes a generated scene as a file.

use cellray::choices::whole;
use clap::Args;

use super::Outcome;

/// Write a sphereflake as an NFF scene to standard output.
#[derive(Args)]
pub struct Arguments {
    /// Levels below the first sphere: 0 makes one sphere, 4 the 7381 of the Standard Procedural
    /// Databases
    #[arg(allow_negative_numbers = true, value_parser = whole::<u32>(0..=u64::from(u32::MAX)))]
    level: u32,
}

pub fn run(arguments: &Arguments) -> Outcome {
    let scene = scenes::sphereflake::generate(arguments.level)?;
    Ok(messages::write_data_with(|out| write!(out, "{scene}"))?)
}
