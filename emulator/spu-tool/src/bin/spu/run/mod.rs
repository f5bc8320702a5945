//! `spu run`: runs one SPU program on an emulated SPE with a test bench around it.

mod arguments;
mod bench;
mod machine;
mod mailboxes;
mod map;
mod options;
mod output;
mod program;
mod sandbox;
mod sleep;
mod statistics;
mod status;
mod trace;

use std::process::ExitCode;

use spu_emulator::elf::Image;

use crate::failure::Failure;
use crate::image;
pub use machine::Machine;
pub use options::Options;

/// Runs the program to its end and returns the exit status. The output that the options ask for is
/// written however the program ends.
pub fn run(options: &Options) -> Result<ExitCode, Failure> {
    with_program(options, |machine, image| {
        let end = machine.run(options, image)?;
        machine.dump(options)?;
        Ok(end.report(image, machine.local_store()))
    })
}

/// Loads the program that the options name, for `work`.
pub fn with_program<T>(
    options: &Options,
    work: impl FnOnce(&mut Machine, &Image<'_>) -> Result<T, Failure>,
) -> Result<T, Failure> {
    if let Some(root) = &options.root {
        sandbox::prepare(root)?;
    }
    let bytes = program::read(options)?;
    let image = image::parse(&options.program, &bytes)?;
    let mut machine = Machine::new(options, &bytes, &image)?;
    work(&mut machine, &image)
}
