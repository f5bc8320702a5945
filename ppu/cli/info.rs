//! `cellray info`: shows the libspe2, the SPEs and the framebuffer that this program uses.

use std::io::Write as _;
use std::path::{Path, PathBuf};

use cellray::framebuffer::Device;
use cellray::spe::{self, Program};
use clap::Args;
use protocol::formulation::{SPHERES, TRIANGLES};
use protocol::layout;

use super::Outcome;

/// Show the libspe2 in use, its SPEs, and the framebuffer.
#[derive(Args)]
pub struct Arguments {
    /// Framebuffer device to inspect
    #[arg(long, default_value = "/dev/fb0", value_name = "PATH")]
    device: PathBuf,
}

pub fn run(arguments: &Arguments) -> Outcome {
    let library = spe::library_path();
    let library = library
        .as_deref()
        .map_or("unknown".into(), Path::to_string_lossy);
    let program = Program::tracer();
    let mut out = std::io::stdout().lock();
    writeln!(out, "libspe2      {library}")?;
    writeln!(out, "SPEs         {}", spe::usable_spes()?)?;
    let bytes = program.image().len();
    writeln!(out, "SPU program  {bytes} bytes of ELF")?;
    writeln!(
        out,
        "intersects   by {} of: {}; {}",
        program.formulations()?.name(),
        names(SPHERES.iter().map(|sphere| sphere.name)),
        names(TRIANGLES.iter().map(|triangle| triangle.name)),
    )?;
    writeln!(out, "work unit    version {}", layout::VERSION)?;
    match Device::inspect(&arguments.device) {
        Ok(line) => writeln!(out, "framebuffer  {line}")?,
        Err(error) => writeln!(out, "framebuffer  none: {error}")?,
    }
    Ok(())
}

fn names<'a>(names: impl Iterator<Item = &'a str>) -> String {
    names.collect::<Vec<_>>().join(", ")
}
