//! `cellray-bench mesh-cache`: plots of how many blocks of a mesh an SPU caches.

use std::fs;
use std::path::PathBuf;
use std::process::ExitCode;

use accuracy::mesh_cache;
use accuracy::plots::{self, Format};
use clap::Args;

use super::Outcome;

/// Draw how many blocks of a mesh an SPU caches against frames a second and bytes a ray
#[derive(Args)]
pub struct Arguments {
    /// The table that `ci/measure cache` printed, or a document with it
    table: PathBuf,
    /// The folder for cache-frames.svg and cache-bytes.svg
    #[arg(long, default_value = "docs/meshes", value_name = "DIR")]
    out: PathBuf,
}

pub fn run(arguments: &Arguments) -> Outcome {
    let name = arguments.table.display();
    let text = fs::read_to_string(&arguments.table).map_err(|error| format!("{name}: {error}"))?;
    let rows = mesh_cache::rows(&text).map_err(|error| format!("{name}: {error}"))?;
    plots::write(&plots::mesh_cache(&rows), &arguments.out, "cache-", &[Format::Svg])?;
    Ok(ExitCode::SUCCESS)
}
