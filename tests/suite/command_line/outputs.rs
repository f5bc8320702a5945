//! Where output goes: pictures to files, pipes and devices; and what happens if nobody takes what
//! is printed.

use std::ffi::OsStr;
use std::fs::File;
use std::io::{self, Read as _};
use std::os::unix::ffi::OsStrExt as _;
use std::process::Stdio;

use image::ImageFormat;

use super::support::{bad, cellray, good, text};
use crate::prelude::*;

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
    File::options().write(true).open("/dev/full").unwrap().into()
}

#[test]
fn unread_message_does_not_lose_picture() {
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
        // An error that can't be printed still sets the exit code.
        let mut wrong = program();
        wrong.args(["render", "no/such.nff"]);
        let status = wrong.stderr(errors()).status().unwrap();
        assert_eq!(status.code(), Some(1));
    }
}

#[test]
fn closed_pipe_ends_without_error() {
    let stats = ["render", SCENE, "--size", "64x48", "--out", "none", "--stats", "-"];
    let picture = ["render", SCENE, "--size", "64x48", "--out", "-"];
    for arguments in [&["sphereflake", "5"][..], &["info"], &stats, &picture] {
        let mut command = program();
        command.args(arguments).stdout(closed_pipe());
        let output = command.stderr(Stdio::piped()).output().unwrap();
        let said = text(&output.stderr);
        assert_eq!(output.status.code(), Some(0), "{arguments:?}: {said}");
        assert!(!said.contains("error"), "{arguments:?}: {said}");
    }
}

#[test]
fn unwritable_data_is_an_error() {
    let stats = ["render", SCENE, "--size", "64x48", "--out", "none", "--stats", "-"];
    let picture = ["render", SCENE, "--size", "64x48", "--out", "-"];
    for arguments in [&["sphereflake", "2"][..], &["info"], &stats, &picture] {
        let mut command = program();
        command.args(arguments).stdout(full_disk());
        let output = command.stderr(Stdio::piped()).output().unwrap();
        let said = text(&output.stderr);
        assert_eq!(output.status.code(), Some(1), "{arguments:?}: {said}");
        assert!(said.contains("standard output"), "{arguments:?}: {said}");
    }
}

#[test]
fn early_closing_reader_gets_first_lines() {
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

#[test]
fn picture_goes_to_standard_output_alone() {
    let arguments = ["render", SCENE, "--size", "64x48", "--out", "-"];
    for more in [&[][..], &["--corners"]] {
        let output = cellray(&[&arguments[..], more].concat());
        assert!(output.status.success(), "{}", text(&output.stderr));
        let picture = image::load_from_memory_with_format(&output.stdout, ImageFormat::Png);
        assert_eq!(picture.unwrap().height(), 48);
    }
    assert!(!Path::new(env!("CARGO_MANIFEST_DIR")).join("-").exists());
    for more in [&["--stats", "-"][..], &["--frames", "2"], &["--watch"]] {
        bad(&[&arguments[..], more].concat(), &["--out -"]);
    }
}

#[test]
fn extension_selects_format() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let render = |out: &str| {
        ["render", SCENE, "--size", "64x48", "--out"]
            .map(str::to_owned)
            .into_iter()
            .chain([out.to_owned()])
            .collect::<Vec<_>>()
    };
    let arguments = render(&path("p.jpg"));
    good(&arguments.iter().map(String::as_str).collect::<Vec<_>>());
    let bytes = fs::read(path("p.jpg")).unwrap();
    assert_eq!(image::guess_format(&bytes).unwrap(), ImageFormat::Jpeg);
    for name in ["p.gif", "p-%d.bmp", "p.png~"] {
        let arguments = render(&path(name));
        let arguments: Vec<_> = arguments.iter().map(String::as_str).collect();
        bad(&arguments, &[".png, .jpg or .jpeg"]);
        bad(&[&arguments[..], &["--inspect", &path("page.html")]].concat(), &[]);
    }
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
}

#[test]
fn output_may_be_a_device() {
    good(&["render", SCENE, "--size", "64x48", "--out", "/dev/null"]);
    bad(&["render", SCENE, "--size", "64x48", "--out", "/dev/full"], &["/dev/full"]);
}

#[test]
fn numbered_pictures_may_have_any_name() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join(OsStr::from_bytes(b"\xe4-%03d.png"));
    let mut render = program();
    render.args(["render", SCENE, "--size", "64x48", "--frames", "1..3"]);
    let output = render.arg("--out").arg(out).output().unwrap();
    assert!(output.status.success(), "{}", text(&output.stderr));
    let names = fs::read_dir(folder.path()).unwrap();
    let mut names: Vec<_> = names.map(|entry| entry.unwrap().file_name()).collect();
    names.sort();
    let expected = [&b"\xe4-001.png"[..], b"\xe4-002.png"];
    assert_eq!(names, expected.map(OsStr::from_bytes));
}

#[test]
fn ground_too_large_for_its_shadows_is_noted() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("ground.nff");
    let scene = |radius: u32| {
        format!(
            "v\nfrom 0 3 9\nat 0 1 0\nup 0 1 0\nangle 40\nhither 1\nresolution 32 24\nl 5 9 5\n\
             f 1 1 1 1 0 0 0 1\ns 0 1 0 1\ns 0 -{radius} 0 {radius}\n"
        )
    };
    let name = file.to_str().unwrap();
    let frame = folder.path().join("fb");
    let on_framebuffer = ["fb", name, "--size", "32x24", "--device", frame.to_str().unwrap()];
    for (radius, is_noted) in [(1_000_000, true), (1000, false)] {
        fs::write(&file, scene(radius)).unwrap();
        for arguments in [&["render", name, "--out", "none"][..], &on_framebuffer] {
            let (_, said) = good(arguments);
            let note = format!("cellray: note: {name}:11: rays leave this sphere 0.47");
            assert_eq!(said.contains(&note), is_noted, "{said}");
            assert_eq!(said.contains("in line 10, 2 across"), is_noted, "{said}");
        }
        // Depth shading has no shadows.
        let (_, said) = good(&["render", name, "--model", "depth", "--out", "none"]);
        assert!(!said.contains("rays leave"), "{said}");
    }
}
