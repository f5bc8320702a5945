//! `cellray info`: what this program has to work with.

use std::path::{Path, PathBuf};

use cellray::formulation::{SPHERES, TRIANGLES};
use cellray::framebuffer::Device;
use cellray::spe::{self, Program};
use cellray::work::layout;
use clap::Args;

use super::Outcome;

/// Show the libspe2 that answers, its SPEs, and the framebuffer.
#[derive(Args)]
pub struct Arguments {
    /// Framebuffer device to look at
    #[arg(long, default_value = "/dev/fb0", value_name = "PATH")]
    device: PathBuf,
}

pub fn run(arguments: &Arguments) -> Outcome {
    let library = spe::library_path();
    let library = library
        .as_deref()
        .map_or("unknown".into(), Path::to_string_lossy);
    println!("libspe2      {library}");
    println!("SPEs         {}", spe::usable_spes()?);
    println!(
        "SPU program  {} bytes of ELF",
        Program::tracer().image().len()
    );
    println!(
        "intersects   by {} of: {}; {}",
        Program::tracer().formulations()?.name(),
        names(SPHERES.iter().map(|sphere| sphere.name)),
        names(TRIANGLES.iter().map(|triangle| triangle.name)),
    );
    println!("work unit    version {}", layout::VERSION);
    match Device::inspect(&arguments.device) {
        Ok(line) => println!("framebuffer  {line}"),
        Err(error) => println!("framebuffer  none: {error}"),
    }
    Ok(())
}

fn names<'a>(names: impl Iterator<Item = &'a str>) -> String {
    names.collect::<Vec<_>>().join(", ")
}
