//! `spu time` as a command: output, exit status, messages.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use crate::report::folder;

fn kept(file: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/kept").join(file);
    fs::read_to_string(path).unwrap()
}

/// Builds `source` as `saxpy.s` in a new folder, which contains the result as `program`.
fn build(source: &str) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let sources = folder.path().join("sources");
    fs::create_dir(&sources).unwrap();
    fs::write(sources.join("saxpy.s"), source).unwrap();
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../linker/spu.ld");
    let built = spu_build::Tools::find().and_then(|tools| {
        let image = spu_build::Image::from_folder(&sources, &script)?;
        let objects = folder.path().join("objects");
        image.build(&tools, &objects, &folder.path().join("program"))
    });
    if let Err(error) = built {
        panic!("{error}\n(ci/setup installs the SPU binutils)");
    }
    folder
}

fn saxpy() -> String {
    fs::read_to_string(folder("saxpy").join("saxpy.s")).unwrap()
}

fn time(within: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_spu"))
        .arg("time")
        .args(arguments)
        .current_dir(within)
        .output()
        .unwrap()
}

fn out(output: &Output) -> String {
    String::from_utf8(output.stdout.clone()).unwrap()
}

fn stderr(output: &Output) -> String {
    String::from_utf8(output.stderr.clone()).unwrap()
}

#[test]
fn the_listing_and_the_json_go_to_standard_output() {
    let built = build(&saxpy());
    let listing = time(built.path(), &["program"]);
    assert!(listing.status.success());
    let expected = kept("saxpy.txt");
    assert_eq!(out(&listing), expected);
    assert_eq!(stderr(&listing), "");
    let json = time(built.path(), &["--json", "--function", "saxpy", "program"]);
    let expected = kept("saxpy.json");
    assert_eq!(out(&json), expected);
}

#[test]
fn the_page_goes_to_its_file_and_its_size_is_told() {
    let built = build(&saxpy().replace("loop", "\"a<b>&c\""));
    let output = time(built.path(), &["--html", "page.html", "program"]);
    assert!(output.status.success(), "{}", stderr(&output));
    assert_eq!(out(&output), "");
    let page = fs::read_to_string(built.path().join("page.html")).unwrap();
    assert_eq!(stderr(&output), format!("page.html: {} bytes\n", page.len()));
    assert!(page.contains("a&lt;b&gt;&amp;c:"), "{page}");
    let nowhere = time(built.path(), &["--html", "nowhere/page.html", "program"]);
    assert!(stderr(&nowhere).contains("nowhere/page.html: "));
    assert!(!nowhere.status.success());
}

#[test]
fn switches_reach_the_model() {
    // Without its hint, a pass of nine cycles has a miss: 18 more cycles, or 19.
    let unhinted = saxpy().replace("hbrr back,loop", "lnop");
    let built = build(&unhinted);
    let plain = out(&time(built.path(), &["program"]));
    assert!(plain.contains("27 cycles a pass"), "{plain}");
    let switched = out(&time(built.path(), &["--miss-cycles", "19", "program"]));
    assert!(switched.contains("28 cycles a pass"), "{switched}");
    let machine = built.path().join("machine.toml");
    fs::write(&machine, "[pipelines]\nmiss_cycles = 30\n").unwrap();
    let described = out(&time(built.path(), &["--machine", "machine.toml", "program"]));
    assert!(described.contains("39 cycles a pass"), "{described}");
    fs::write(&machine, "[pipelines]\n\nmiss = 30\n").unwrap();
    let wrong = time(built.path(), &["--machine", "machine.toml", "program"]);
    let wrong = stderr(&wrong);
    for part in ["machine.toml", "line 3", "`miss`"] {
        assert!(wrong.contains(part), "{wrong}");
    }
}

#[test]
fn right_notes_are_status_0_and_wrong_ones_1() {
    let built = build(&saxpy());
    for sources in [&[][..], &["sources/saxpy.s"]] {
        let right = time(built.path(), &[&["--check", "program"], sources].concat());
        assert_eq!(right.status.code(), Some(0), "{}", stderr(&right));
        assert_eq!(out(&right), "");
        assert_eq!(stderr(&right), "25 notes, 0 differ from the model\n");
    }
    let built = build(&saxpy().replace("# 6o", "# 5e"));
    let wrong = time(built.path(), &["--check", "program", "sources/saxpy.s"]);
    assert_eq!(wrong.status.code(), Some(1));
    assert_eq!(out(&wrong), "sources/saxpy.s:45: note 5e, model 6o\n");
    assert_eq!(stderr(&wrong), "25 notes, 1 differ from the model\n");
}

#[test]
fn errors_name_file_and_fault() {
    let built = build(&saxpy());
    fs::write(built.path().join("text"), "no program").unwrap();
    fs::write(built.path().join("other.s"), " nop # 0e").unwrap();
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
        let output = time(within.path(), arguments);
        let status = output.status.code();
        assert!(status.is_some_and(|code| code > 1), "{arguments:?}: {status:?}");
        assert!(stderr(&output).contains(expected), "{}", stderr(&output));
        assert_eq!(out(&output), "");
    }
}
