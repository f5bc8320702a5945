//! Checks `docs/spu-programming.md`: its sources do what it describes, in the cycles that it gives.

use std::fs;
use std::path::{Path, PathBuf};

use spu_build::{Image, Tools};

use crate::support::Bench;

const DOCUMENT: &str = include_str!("../../../../docs/spu-programming.md");

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// Builds the program that calls this version of `dot`, and the object of `dot`.
fn build(bench: &Bench, name: &str, dot: &str) -> (PathBuf, PathBuf) {
    let main = root().join("examples/spu/main.s");
    let source = bench.write(&format!("{name}.s"), dot);
    let (object, image) = (bench.path(&format!("{name}.o")), bench.path(&format!("{name}.elf")));
    let tools = Tools::find().unwrap();
    tools.assemble(&[], &[], &object, &source).unwrap();
    Image::new(&root().join("linker/spu.ld"))
        .source(&main)
        .source(&source)
        .build(&tools, &bench.path(&format!("{name}-objects")), &image)
        .unwrap();
    (image, object)
}

/// Returns the cycles of a run, after checking its result.
fn cycles(bench: &Bench, image: &Path) -> u32 {
    let image = image.to_str().unwrap();
    let run = bench.spu(&["run", "--dump-regs", "--timing", image]);
    assert_eq!(run.status, 0, "{}", run.error);
    let result = "$3    00000028 00000028 00000028 00000028";
    assert!(run.error.contains(result) && DOCUMENT.contains(result), "{}", run.error);
    let line = run.error.lines().find(|line| line.starts_with("cycles"));
    line.unwrap().rsplit(' ').next().unwrap().parse().unwrap()
}

#[test]
fn the_documents_cycles_are_the_models() {
    let bench = Bench::new();
    let mut found = Vec::new();
    for name in ["dot", "dot4"] {
        let source = fs::read_to_string(root().join(format!("examples/spu/{name}.s"))).unwrap();
        let (image, object) = build(&bench, name, &source);
        found.push(cycles(&bench, &image));
        let plain = bench.path(&format!("{name}.s"));
        let scheduled = bench.spu(&["schedule".as_ref(), object.as_os_str(), plain.as_os_str()]);
        assert_eq!(scheduled.status, 0, "{}", scheduled.error);
        let (image, _) = build(&bench, &format!("{name}-scheduled"), &scheduled.output);
        found.push(cycles(&bench, &image));
    }
    let [plain, scheduled, four, both] = found[..] else {
        panic!("{found:?}");
    };
    for cycles in [plain, scheduled] {
        let line = format!("    cycles                                 {cycles}\n");
        assert!(DOCUMENT.contains(&line), "{cycles} cycles");
    }
    let sentence = format!("it takes {four} cycles, and scheduled {both},");
    assert!(DOCUMENT.contains(&sentence), "{sentence}");
}

#[test]
fn the_documents_sources_are_the_examples() {
    for name in ["main", "dot", "dot4"] {
        let source = fs::read_to_string(root().join(format!("examples/spu/{name}.s"))).unwrap();
        let heading = format!("`examples/spu/{name}.s`\n\n```asm\n");
        let shown = DOCUMENT.split(&heading).nth(1).unwrap();
        let shown = shown.split("```").next().unwrap();
        assert!(source.contains(shown), "{name}.s has no {shown}");
    }
}

#[test]
fn the_documents_listing_is_the_models() {
    let bench = Bench::new();
    let source = fs::read_to_string(root().join("examples/spu/dot.s")).unwrap();
    let (_, object) = build(&bench, "dot", &source);
    let timed = bench.spu(&["time", object.to_str().unwrap(), "--function", "dot"]);
    let line = "    31 cycles a pass, bound 6\n";
    assert!(timed.output.contains(line) && DOCUMENT.contains(line), "{}", timed.output);
}
