//! Tests a game's build script in the way that cargo runs it: its standard output and standard
//! error.
//!
//! This program has a `main` of its own, because it runs itself as the build script.

use std::fs;
use std::path::Path;
use std::process::{Command, ExitCode, Output};

/// In the process that acts as the build script, the folder of shaders.
const SHADERS: &str = "TESTED_SHADERS";

fn main() -> ExitCode {
    if let Some(shaders) = std::env::var_os(SHADERS) {
        return spu_build::embed("tracer.elf", || spu_build::tracer()?.folder(shaders.as_ref()));
    }
    valid_shader_is_built_and_watched();
    shader_error_is_the_only_output();
    missing_tools_error_explains_installation();
    ExitCode::SUCCESS
}

/// The build script, with a shader that contains this instruction.
fn script(folder: &Path, instruction: &str) -> Command {
    let shader = format!(
        "        .include \"macros.inc\"\n        .include \"shader.inc\"\n\nshader own\n        {instruction}\n        \
         bi      $lr\nendshader own\n"
    );
    fs::write(folder.join("own.s"), shader).unwrap();
    let mut script = Command::new(std::env::current_exe().unwrap());
    script.env(SHADERS, folder).env("OUT_DIR", folder.join("out"));
    script
}

fn valid_shader_is_built_and_watched() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let output = script(folder, "nop").output().unwrap();
    let (out, err) = texts(&output);
    assert!(output.status.success() && err.is_empty(), "{err}");
    assert!(folder.join("out/tracer.elf").is_file());
    let lines: Vec<_> = out.lines().collect();
    for path in [folder.join("own.s"), folder.to_path_buf()] {
        let line = format!("cargo:rerun-if-changed={}", path.display());
        assert!(lines.contains(&&*line), "no {line} in {out}");
    }
    assert!(lines.contains(&"cargo:rerun-if-env-changed=SPU_AS"), "{out}");
}

fn shader_error_is_the_only_output() {
    let folder = tempfile::tempdir().unwrap();
    let output = script(folder.path(), "bogus   $3").output().unwrap();
    let (out, err) = texts(&output);
    assert_eq!(output.status.code(), Some(1), "{err}");
    assert_eq!(out, "");
    let found = |line: &str| line.contains("own.s:5: Error") && line.contains("bogus");
    assert!(err.lines().any(found), "{err}");
}

fn missing_tools_error_explains_installation() {
    let folder = tempfile::tempdir().unwrap();
    let output =
        script(folder.path(), "nop").env("SPU_AS", "/nonexistent/spu-as").output().unwrap();
    let (out, err) = texts(&output);
    assert_eq!(output.status.code(), Some(1), "{err}");
    assert_eq!(out, "");
    for part in ["--target=spu-elf", "binutils-source", "SPU_AS", "SPU_LD"] {
        assert!(err.contains(part), "no {part} in {err}");
    }
}

fn texts(output: &Output) -> (String, String) {
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    (text(&output.stdout), text(&output.stderr))
}
