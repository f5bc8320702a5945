//! What happens if nobody takes what is printed.

use std::fs::{self, File};
use std::io::{self, Read as _};
use std::process::{Command, Stdio};

use super::support::text;

const SCENE: &str = "scenes/paper16.nff";

fn program() -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_cellray"));
    command.current_dir(env!("CARGO_MANIFEST_DIR"));
    command
}

/// A pipe whose reader has gone.
fn closed_pipe() -> Stdio {
    let (reader, writer) = io::pipe().unwrap();
    drop(reader);
    writer.into()
}

fn full_disk() -> Stdio {
    File::options()
        .write(true)
        .open("/dev/full")
        .unwrap()
        .into()
}

#[test]
fn a_message_that_nobody_reads_costs_no_picture() {
    let folder = tempfile::tempdir().unwrap();
    let picture = folder.path().join("p.png");
    let numbered = folder.path().join("p-%d.png");
    for errors in [closed_pipe, full_disk] {
        for out in [&picture, &numbered] {
            let mut render = program();
            render.args(["render", SCENE, "--size", "64x48", "--frames", "1", "--out"]);
            let status = render.arg(out).stderr(errors()).status().unwrap();
            assert_eq!(status.code(), Some(0), "{}", out.display());
        }
        for name in ["p.png", "p-0.png"] {
            let path = folder.path().join(name);
            assert_eq!(image::open(&path).unwrap().width(), 64, "{name}");
            fs::remove_file(path).unwrap();
        }
        // An error that can't be told is still told by the status.
        let mut wrong = program();
        wrong.args(["render", "no/such.nff"]);
        let status = wrong.stderr(errors()).status().unwrap();
        assert_eq!(status.code(), Some(1));
    }
}

#[test]
fn data_whose_reader_has_gone_ends_quietly() {
    let stats = ["render", SCENE, "--size", "64x48", "--stats", "-"];
    for arguments in [&["sphereflake", "5"][..], &["info"], &stats] {
        let mut command = program();
        command.args(arguments).stdout(closed_pipe());
        let output = command.stderr(Stdio::piped()).output().unwrap();
        let said = text(&output.stderr);
        assert_eq!(output.status.code(), Some(0), "{arguments:?}: {said}");
        assert!(!said.contains("error"), "{arguments:?}: {said}");
    }
}

#[test]
fn data_that_can_not_be_written_is_an_error() {
    let stats = ["render", SCENE, "--size", "64x48", "--stats", "-"];
    for arguments in [&["sphereflake", "2"][..], &["info"], &stats] {
        let mut command = program();
        command.args(arguments).stdout(full_disk());
        let output = command.stderr(Stdio::piped()).output().unwrap();
        let said = text(&output.stderr);
        assert_eq!(output.status.code(), Some(1), "{arguments:?}: {said}");
        assert!(said.contains("standard output"), "{arguments:?}: {said}");
    }
}

#[test]
fn a_reader_that_has_enough_gets_the_first_lines() {
    let mut command = program();
    let mut generator = command
        .args(["sphereflake", "5"])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let mut first = [0; 2];
    let mut out = generator.stdout.take().unwrap();
    out.read_exact(&mut first).unwrap();
    drop(out);
    let output = generator.wait_with_output().unwrap();
    assert_eq!(output.status.code(), Some(0));
    assert_eq!(text(&output.stderr), "");
}
