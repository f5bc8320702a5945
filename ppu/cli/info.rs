//! `cellray info`: shows the libspe2, the SPEs and the framebuffer that this program uses.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use clap::Args;
use protocol::formulation::Formulations;
use protocol::layout;

use super::Outcome;
use crate::framebuffer::Device;
use crate::spe::{self, Program};

/// Show the libspe2 in use, its SPEs, and the framebuffer.
#[derive(Args)]
pub struct Arguments {
    /// Framebuffer device to inspect
    #[arg(long, default_value = "/dev/fb0", value_name = "PATH")]
    device: PathBuf,
}

pub fn run(arguments: &Arguments) -> Outcome {
    let library = spe::library_path();
    let library = library.as_deref().map_or("unknown".into(), Path::to_string_lossy);
    let program = Program::tracer();
    let mut out = String::new();
    writeln!(out, "libspe2      {library}")?;
    writeln!(out, "SPEs         {}", spe::usable_spes()?)?;
    let bytes = program.image().len();
    writeln!(out, "SPU program  {bytes} bytes of ELF")?;
    let [_, others @ ..] = Formulations::shipped();
    let others = others.map(|formulations| formulations.named_sphere().name);
    writeln!(
        out,
        "intersects   by {}; with --sphere also by {}",
        program.formulations()?.name(),
        others.join(", "),
    )?;
    writeln!(
        out,
        "             Programs for other formulations are built in cellray's repository, by"
    )?;
    writeln!(
        out,
        "             cargo run --release --bin kernels -- image --sphere NAME --out NAME.elf,"
    )?;
    writeln!(out, "             and used with --program NAME.elf.")?;
    writeln!(out, "work unit    version {}", layout::VERSION)?;
    match Device::inspect(&arguments.device) {
        Ok(line) => writeln!(out, "framebuffer  {line}")?,
        Err(error) => writeln!(out, "framebuffer  none: {error}")?,
    }
    Ok(messages::write_data(out)?)
}
