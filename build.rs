//! Embeds the SPU programs, one for each set of formulations that is shipped. They are built where
//! there is an SPU assembler; elsewhere those that come with the sources are taken. For the
//! console's target it also makes the libraries to link against, which have nothing but the names
//! of libspe2 and of the C library. Every switch is listed in `CONTRIBUTING.md`.

use std::env;
use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use protocol::formulation::Formulations;
use spu_build::{Script, Tools, prebuilt, script, stub, tracer};

type Outcome<T> = Result<T, Box<dyn std::error::Error>>;

fn main() -> ExitCode {
    script(build)
}

fn build(script: &mut Script) -> Outcome<()> {
    let out = PathBuf::from(env::var("OUT_DIR")?);
    script.watch(Path::new("build.rs"));

    script.watch_variable("CELLRAY_SPU_IMAGES");
    let images = match env::var_os("CELLRAY_SPU_IMAGES") {
        Some(ready) => ready_images(Path::new(&ready), script)?,
        None => match Tools::find() {
            Ok(tools) => spu_programs(&tools, &out, script)?,
            Err(no_tool) if Tools::are_named() => return Err(no_tool.into()),
            Err(no_tool) => prebuilt_images(no_tool, script)?,
        },
    };
    fs::write(out.join("images.rs"), table(&images)?)?;

    let glibc = env::var("CARGO_CFG_TARGET_ENV")? == "gnu";
    if env::var("CARGO_CFG_TARGET_ARCH")? == "powerpc64" && glibc {
        stubs(&out, script)?;
    }
    Ok(())
}

/// A program of each set of formulations, the standard one first.
type Images = Vec<(Formulations, PathBuf)>;

fn spu_programs(tools: &Tools, out: &Path, script: &mut Script) -> Outcome<Images> {
    let program = tracer()?;
    script.watch_image(&program)?;
    let work = out.join("objects");
    let objects = program.assemble(tools, &work)?;
    let mut images = Vec::new();
    for formulations in Formulations::shipped() {
        let image = out.join(prebuilt::file(&formulations));
        let program = program.clone().formulations(formulations);
        program.link(tools, &work, &objects, &image)?;
        images.push((formulations, image));
    }
    Ok(images)
}

/// The programs that come with the sources, for a machine without an SPU assembler. Sources that
/// have changed need one.
fn prebuilt_images(no_tool: spu_build::Error, script: &mut Script) -> Outcome<Images> {
    script.watch(Path::new("spu"));
    script.watch_image(&tracer()?)?;
    let folder = prebuilt::find().map_err(|stale| format!("{stale}\n{no_tool}"))?;
    ready_images(&folder, script)
}

/// The programs that an earlier build has left in its folder of output.
fn ready_images(folder: &Path, script: &mut Script) -> Outcome<Images> {
    let ready = |formulations| {
        let image = folder.join(prebuilt::file(&formulations));
        script.watch(&image);
        fs::metadata(&image).map_err(|error| format!("{}: {error}", image.display()))?;
        Ok((formulations, image))
    };
    Formulations::shipped().into_iter().map(ready).collect()
}

/// The programs as the elements of a Rust array.
fn table(images: &Images) -> Outcome<String> {
    let mut text = String::from("[\n");
    for (formulations, image) in images {
        writeln!(text, "({:?}, &Image(*include_bytes!({image:?}))),", formulations.names(),)?;
    }
    text.push_str("]\n");
    Ok(text)
}

/// Links the console's program, and whatever depends on this crate, against the names of libspe2
/// alone, so that no PS3 sysroot is needed, and against those of an old C library, so that an old
/// system runs it.
fn stubs(out: &Path, script: &mut Script) -> Outcome<()> {
    let compiler = stub::compiler(script);
    let folder = out.join("stub");
    fs::create_dir_all(&folder)?;
    stub::build(
        &compiler,
        "libspe2.so.2",
        &stub::names(stub::LIBSPE2),
        &folder.join("libspe2.so"),
    )?;
    stub::glibc::build(&compiler, &folder)?;
    script.add(format_args!("rustc-link-search=native={}", folder.display()));
    script.add("rustc-link-lib=dylib=spe2");
    Ok(())
}
