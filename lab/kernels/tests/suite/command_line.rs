//! Tests the program `kernels` from outside.

use std::fs;
use std::process::{Command, Output};

fn kernels(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_kernels"))
        .args(arguments)
        .output()
        .expect("the program starts")
}

fn text(bytes: &[u8]) -> &str {
    std::str::from_utf8(bytes).expect("text")
}

#[test]
fn prints_the_table_of_the_kernels_that_are_named() {
    let output = kernels(&["measure", "any_sphere_r16"]);
    assert!(output.status.success());
    let table = text(&output.stdout);
    assert!(table.contains("| any_sphere_r16 "), "{table}");
    assert!(!table.contains("| isect_sphere_r1 "), "{table}");
}

#[test]
fn measure_prints_json() {
    let output = kernels(&["measure", "isect_sphere_r16", "--json"]);
    assert!(output.status.success());
    let json: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
    let kernel = &json[0];
    assert_eq!(kernel["kernel"], "isect_sphere_r16");
    assert_eq!(kernel["file"], "lab/spu/isect/isect_sphere_r16.s");
    assert_eq!(kernel["cases"][0]["case"], "all miss");
    let cycles = kernel["cases"][0]["plain"]["call"]["cycles"].as_u64();
    // Sixteen rays take at least 21 even-pipe instructions for each row of four.
    assert!(cycles.is_some_and(|cycles| cycles > 84), "{cycles:?}");
    assert!(kernel["error"].as_f64().is_some_and(|error| error > 0.0));
}

#[test]
fn unknown_kernel_lists_existing_kernels() {
    let output = kernels(&["measure", "isect_cube_r16"]);
    assert!(!output.status.success());
    let error = text(&output.stderr);
    assert!(error.contains("no kernel isect_cube_r16"), "{error}");
    assert!(error.contains("isect_sphere_r16"), "{error}");
}

#[test]
fn finds_a_document_stale() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("kernels.md");
    let path = file.to_str().expect("a name");
    let markers = format!("{}\n{}\n", kernels::document::BEGIN, kernels::document::END);
    fs::write(&file, markers).expect("a file");
    // Only one kernel, because all of them take a minute.
    let stale = kernels(&["measure", "any_sphere_r16", "--check", path]);
    assert!(!stale.status.success());
    assert!(text(&stale.stderr).contains("stale at line 2"));
    let written = kernels(&["measure", "any_sphere_r16", "--write", path]);
    assert!(written.status.success());
    let table = fs::read_to_string(&file).expect("the file");
    assert!(table.contains("| any_sphere_r16 "), "{table}");
    assert!(kernels(&["measure", "any_sphere_r16", "--check", path]).status.success());
    assert!(!kernels(&["measure", "any_sphere_r16", "--check", path, "--json"]).status.success());
}

#[test]
fn shows_schedules_of_the_kernels_that_there_are() {
    let output = kernels(&["show", "isect_cube_r16"]);
    assert!(!output.status.success());
    assert!(text(&output.stderr).contains("no kernel isect_cube_r16"));
    let output = kernels(&["show", "pack_r16"]);
    assert!(output.status.success());
    assert!(text(&output.stdout).contains("function pack_r16"));
    assert!(text(&output.stdout).contains("# 0e "), "the notes of cycles and pipes");
}

#[test]
fn builds_a_program_of_other_formulations() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("stable.elf");
    let path = file.to_str().expect("a name");
    let output = kernels(&["image", "--sphere", "stable", "--out", path]);
    assert!(output.status.success(), "{}", text(&output.stderr));
    let program = cellray::spe::Program::from_file(&file).expect("a program");
    let formulations = program.formulations().expect("formulations");
    assert_eq!(formulations.names(), ["stable", "stable", "stable", "watertight"]);
}
