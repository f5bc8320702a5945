//! `cellray sphereflake`: writes a generated scene as a file.

use clap::Args;

use super::Outcome;
use crate::choices::whole;

/// Write a sphereflake as an NFF scene to standard output.
#[derive(Args)]
pub struct Arguments {
    /// Levels below the first sphere: 0 for one sphere, 4 for 7381 spheres as in SPD
    #[arg(allow_negative_numbers = true, value_parser = whole::<u32>(0..=u64::from(u32::MAX)))]
    level: u32,
}

pub fn run(arguments: &Arguments) -> Outcome {
    let scene = scenes::sphereflake::generate(arguments.level)?;
    Ok(messages::write_data_with(|out| write!(out, "{scene}"))?)
}
