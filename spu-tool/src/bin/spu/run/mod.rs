//! `spu run`: runs one SPU program on an emulated SPE with a test bench around it.

mod arguments;
mod bench;
mod error;
mod machine;
mod mailboxes;
mod map;
mod options;
mod output;
mod sandbox;
mod sleep;
mod statistics;
mod status;
mod trace;

use std::process::ExitCode;

use crate::failure::Failure;
use crate::image;
use machine::Machine;
pub use options::Options;

/// Runs the program to its end and returns the exit status. The output that the options ask for is
/// written however the program ends.
pub fn run(options: &Options) -> Result<ExitCode, Failure> {
    if let Some(root) = &options.root {
        sandbox::prepare(root)?;
    }
    let bytes = image::read(&options.program)?;
    let image = image::parse(&options.program, &bytes)?;
    let mut machine = Machine::new(options, &bytes, &image)?;
    let end = machine.run(options, &image)?;
    machine.dump(options)?;
    Ok(end.tell(&image, machine.local_store()))
}
