//! Builds the kernels of the SPU program into two images without the program: all of them plain, and
//! each scheduled where it has a scheduled version. Embeds them and the sources' text.

use std::env;
use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use protocol::assembler;
use spu_build::{Image, Script, Tools, Version, script};

type Outcome<T> = Result<T, Box<dyn std::error::Error>>;

/// A kernel's sources.
struct Kernel {
    name: String,
    plain: PathBuf,
    scheduled: bool,
}

fn main() -> ExitCode {
    script(build)
}

fn build(script: &mut Script) -> Outcome<()> {
    let here = PathBuf::from(env::var("CARGO_MANIFEST_DIR")?);
    let out = PathBuf::from(env::var("OUT_DIR")?);
    let spu = here.join("../spu").canonicalize()?;
    script.watch(Path::new("build.rs"));
    script.watch(Path::new("../spu"));

    let generated = out.join("include");
    fs::create_dir_all(&generated)?;
    fs::write(generated.join(assembler::FILE), assembler::constants())?;

    let tools = Tools::find()?;
    let layout = here.join("../linker/spu.ld");
    for (name, version) in [("plain", Version::Plain), ("scheduled", Version::Scheduled)] {
        let image = Image::new(&layout)
            .folder(&here.join("image"))?
            .kernels(&spu, version)?
            .include(&spu.join("include"))
            .include(&generated);
        script.watch_image(&image)?;
        image.build(
            &tools,
            &out.join(format!("{name}-objects")),
            &out.join(format!("{name}.elf")),
        )?;
    }
    let kernels = kernels(&spu)?;
    fs::write(out.join("sources.rs"), table(&kernels, &spu)?)?;
    Ok(())
}

/// The kernels below `spu/plain`, by path.
fn kernels(spu: &Path) -> Outcome<Vec<Kernel>> {
    let plain = spu.join("plain");
    let mut kernels = Vec::new();
    for room in sorted(&plain)? {
        if !room.is_dir() {
            return Err(format!("{}: kernels lie in rooms", room.display()).into());
        }
        for file in sorted(&room)? {
            let name = file.file_stem().unwrap_or_default().to_string_lossy();
            let scheduled = spu.join(file.strip_prefix(&plain)?);
            kernels.push(Kernel {
                name: name.into_owned(),
                scheduled: scheduled.is_file(),
                plain: file,
            });
        }
    }
    Ok(kernels)
}

fn sorted(folder: &Path) -> Outcome<Vec<PathBuf>> {
    let mut entries = fs::read_dir(folder)
        .map_err(|error| format!("{}: {error}", folder.display()))?
        .map(|entry| entry.map(|entry| entry.path()))
        .collect::<Result<Vec<_>, _>>()?;
    entries.sort();
    Ok(entries)
}

/// The sources as the elements of a Rust array.
fn table(kernels: &[Kernel], spu: &Path) -> Outcome<String> {
    let mut text = String::from("[\n");
    for kernel in kernels {
        let file = Path::new("spu").join(kernel.plain.strip_prefix(spu)?);
        writeln!(
            text,
            "Source {{ name: {:?}, file: {:?}, text: include_str!({:?}), scheduled: {} }},",
            kernel.name, file, kernel.plain, kernel.scheduled
        )?;
    }
    text.push_str("]\n");
    Ok(text)
}
