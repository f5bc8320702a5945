//! `spu time` as a command: output, exit status, messages.

use std::fs;
use std::path::Path;

use spu_build::for_tests::build_source;

use super::support::{Bench, Outcome};
use crate::report::folder;

fn kept(file: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/kept").join(file);
    fs::read_to_string(path).unwrap()
}

/// Builds `source` as `sources/saxpy.s` in a new folder, which contains the result as `program`.
fn build(source: &str) -> Bench {
    let bench = Bench::new();
    let _ = build_source(source, "saxpy", bench.folder.path(), &[]);
    bench
}

fn saxpy() -> String {
    fs::read_to_string(folder("saxpy").join("saxpy.s")).unwrap()
}

fn time(within: &Bench, arguments: &[&str]) -> Outcome {
    within.spu(&[&["time"], arguments].concat())
}

#[test]
fn the_listing_and_the_json_go_to_standard_output() {
    let built = build(&saxpy());
    let listing = time(&built, &["program"]);
    assert_eq!(listing.status, 0);
    let expected = kept("saxpy.txt");
    assert_eq!(listing.output, expected);
    assert_eq!(listing.error, "");
    let json = time(&built, &["--json", "--function", "saxpy", "program"]);
    let expected = kept("saxpy.json");
    assert_eq!(json.output, expected);
}

#[test]
fn the_page_goes_to_its_file_and_its_size_is_told() {
    let built = build(&saxpy().replace("loop", "\"a<b>&c\""));
    let output = time(&built, &["--html", "page.html", "program"]);
    assert_eq!(output.status, 0, "{}", output.error);
    assert_eq!(output.output, "");
    let page = built.read("page.html");
    assert_eq!(output.error, format!("page.html: {} bytes\n", page.len()));
    assert!(page.contains("a&lt;b&gt;&amp;c:"), "{page}");
    let nowhere = time(&built, &["--html", "nowhere/page.html", "program"]);
    assert!(nowhere.error.contains("nowhere/page.html: "));
    assert_ne!(nowhere.status, 0);
}

#[test]
fn switches_reach_the_model() {
    // Without its hint, a pass of nine cycles has a miss: 18 more cycles, or 19.
    let unhinted = saxpy().replace("hbrr back,loop", "lnop");
    let built = build(&unhinted);
    let plain = time(&built, &["program"]).output;
    assert!(plain.contains("27 cycles a pass"), "{plain}");
    let switched = time(&built, &["--miss-cycles", "19", "program"]).output;
    assert!(switched.contains("28 cycles a pass"), "{switched}");
    built.write("machine.toml", "[pipelines]\nmiss_cycles = 30\n");
    let described = time(&built, &["--machine", "machine.toml", "program"]).output;
    assert!(described.contains("39 cycles a pass"), "{described}");
    built.write("machine.toml", "[pipelines]\n\nmiss = 30\n");
    let wrong = time(&built, &["--machine", "machine.toml", "program"]).error;
    for part in ["machine.toml", "line 3", "`miss`"] {
        assert!(wrong.contains(part), "{wrong}");
    }
}

#[test]
fn right_notes_are_status_0_and_wrong_ones_1() {
    let built = build(&saxpy());
    for sources in [&[][..], &["sources/saxpy.s"]] {
        let right = time(&built, &[&["--check", "program"], sources].concat());
        assert_eq!(right.status, 0, "{}", right.error);
        assert_eq!(right.output, "");
        assert_eq!(right.error, "25 notes, 0 differ from the model\n");
    }
    let built = build(&saxpy().replace("# 6o", "# 5e"));
    let wrong = time(&built, &["--check", "program", "sources/saxpy.s"]);
    assert_eq!(wrong.status, 1);
    assert_eq!(wrong.output, "sources/saxpy.s:45: note 5e, model 6o\n");
    assert_eq!(wrong.error, "25 notes, 1 differ from the model\n");
}

#[test]
fn errors_name_file_and_fault() {
    let built = build(&saxpy());
    built.write("text", "no program");
    built.write("other.s", " nop # 0e");
    let bare = build("        .globl _start\n_start: stop\n");
    for (within, arguments, expected) in [
        (&built, &["nothing"][..], "nothing: "),
        (&built, &["text"], "text: not an ELF file"),
        (&built, &["program", "--function", "x"], "no function x; it has saxpy"),
        (&built, &["--check", "program", "other.s"], "other.s: the line table"),
        (&built, &["--check", "program", "none.s"], "none.s: "),
        (&bare, &["--check", "program"], "saxpy.s: the file has no schedule note"),
        (&built, &["program", "sources/saxpy.s"], "--check"),
        (&built, &["program", "--miss-cycles", "17"], "17"),
    ] {
        let output = time(within, arguments);
        assert!(output.status > 1, "{arguments:?}: {}", output.status);
        assert!(output.error.contains(expected), "{}", output.error);
        assert_eq!(output.output, "");
    }
}
