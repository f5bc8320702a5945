//! Numbered pictures in parts, as batch renderers request them.

use std::os::unix::process::ExitStatusExt as _;
use std::process::Stdio;
use std::time::Instant;

use crate::command_line::support::{bad, good, text};
use crate::prelude::*;

const SCENE: &str = "scenes/paper16.nff";
/// How long pictures may take to come, on a machine that is busy with other things.
const PATIENCE: Duration = Duration::from_secs(600);

fn pattern(folder: &Path) -> String {
    folder.join("f-%03d.png").to_str().unwrap().to_owned()
}

/// Renders pictures of the scene's frames: one turn in eight frames.
fn render(folder: &Path, frames: &str) -> String {
    let out = pattern(folder);
    let (_, stderr) = good(&[
        "render", SCENE, "--size", "64x36", "--turn", "8", "--frames", frames, "--out", &out,
    ]);
    stderr
}

fn files(folder: &Path) -> Vec<(PathBuf, Vec<u8>)> {
    let mut files: Vec<_> = fs::read_dir(folder)
        .unwrap()
        .map(|entry| {
            let path = entry.unwrap().path();
            (path.file_name().unwrap().into(), fs::read(&path).unwrap())
        })
        .collect();
    files.sort();
    files
}

#[test]
fn partial_runs_equal_one_run_and_keep_files() {
    let [whole, parts, still] = [(); 3].map(|()| tempfile::tempdir().unwrap());
    let stderr = render(whole.path(), "0..9");
    assert!(stderr.contains("9 picture(s) written, 0 existed already"), "{stderr}");
    let pictures = files(whole.path());
    assert_eq!(pictures.len(), 9);
    // The eye turns, and is back at the start after eight frames.
    let decoded = |index: usize| image::load_from_memory(&pictures[index].1).unwrap();
    for index in 0..8 {
        assert!(decoded(index) != decoded(index + 1), "{index}");
    }
    assert!(pictures[0].1 == pictures[8].1);

    render(parts.path(), "6..9");
    render(parts.path(), "0..2");
    fs::write(parts.path().join("f-003.png"), "kept").unwrap();
    let stderr = render(parts.path(), "0..9");
    assert!(stderr.contains("3 picture(s) written, 6 existed already"), "{stderr}");
    fs::remove_file(parts.path().join("f-003.png")).unwrap();
    render(parts.path(), "3..4");
    assert!(files(parts.path()) == pictures, "parts are others");

    // The first picture shows the scene unchanged.
    let picture = still.path().join("f-000.png");
    let picture = picture.to_str().unwrap();
    good(&["render", SCENE, "--size", "64x36", "--out", picture]);
    assert!(files(still.path())[0].1 == pictures[0].1);
}

#[test]
fn animation_plays_in_numbered_pictures() {
    let folder = tempfile::tempdir().unwrap();
    let out = pattern(folder.path());
    let small = ["render", "scenes/reef.glb", "--size", "64x36", "--fps", "2"];
    good(&[&small[..], &["--frames", "0..9", "--out", &out]].concat());
    let decoded = |(_, bytes): &(PathBuf, Vec<u8>)| image::load_from_memory(bytes).unwrap();
    let pictures: Vec<_> = files(folder.path()).iter().map(decoded).collect();
    // It lasts four seconds, and the eye stands still.
    assert!((0..8).all(|it| pictures[it] != pictures[it + 1]) && pictures[0] == pictures[8]);
    let last = folder.path().join("last.png");
    let last_picture = |options: &[&str]| {
        good(&[&small[..], options, &["--out", last.to_str().unwrap()]].concat());
        image::open(&last).unwrap()
    };
    assert!(last_picture(&[]) == pictures[0]);
    assert!(last_picture(&["--frames", "4"]) == pictures[3]);
    for picture in [&folder.path().join("f-003.png"), &last] {
        let settings = oracle::Settings::of_png(picture).unwrap();
        assert_eq!(settings.time(picture).unwrap(), Some(1.5));
        assert_eq!(settings.unknown(), [""; 0]);
    }
    for options in [&["--animation", "none"][..], &["--animation", "none", "--frames", "3"]] {
        assert!(last_picture(options) != pictures[0], "without an animation it has another form");
    }
    // The eye turns as well, if that is asked for.
    let out = last.with_file_name("t-%d.png");
    let turned = ["--turn", "8", "--frames", "8..9", "--out", out.to_str().unwrap()];
    good(&[&small[..], &turned].concat());
    assert!(image::open(out.with_file_name("t-8.png")).unwrap() == pictures[0]);
    let turned = ["--turn", "8", "--frames", "3..4", "--out", out.to_str().unwrap()];
    good(&[&small[..], &turned].concat());
    assert!(image::open(out.with_file_name("t-3.png")).unwrap() != pictures[3]);

    let expected = ["scenes/reef.glb: the file has no animation `run`; it has `swell`"];
    bad(&[&small[..], &["--animation", "run"]].concat(), &expected);
    let expected = ["the file has no animation `0`; it has none"];
    bad(&["render", SCENE, "--animation", "0"], &expected);
}

#[test]
fn full_disk_names_picture_and_leaves_no_partial_file() {
    let folder = tempfile::tempdir().unwrap();
    // In blocks of 512 bytes: this is enough for an emulated SPU's local store, but not for a
    // picture of this size.
    let output = Command::new("sh")
        .args(["-c", "ulimit -f 576; exec \"$0\" \"$@\""])
        .arg(env!("CARGO_BIN_EXE_cellray"))
        .args(["render", SCENE, "--size", "1920x1080", "--frames", "0..3", "--out"])
        .arg(pattern(folder.path()))
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .output()
        .unwrap();
    let stderr = text(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{stderr}");
    assert!(stderr.contains("f-000.png") && stderr.contains("too large"), "{stderr}");
    assert_eq!(files(folder.path()), []);
}

#[test]
fn signals_end_sequence_between_pictures() {
    for signal in [libc::SIGINT, libc::SIGTERM] {
        let folder = tempfile::tempdir().unwrap();
        // The process that starts the tests may ignore signals, and children inherit that.
        let mut child = Command::new("env")
            .arg("--default-signal")
            .arg(env!("CARGO_BIN_EXE_cellray"))
            .args(["render", SCENE, "--size", "64x36", "--frames", "0..1000000", "--out"])
            .arg(pattern(folder.path()))
            .current_dir(env!("CARGO_MANIFEST_DIR"))
            .stderr(Stdio::null())
            .spawn()
            .unwrap();
        let begun = Instant::now();
        // A picture has another name while it is written, so nothing is read yet.
        while fs::read_dir(folder.path()).unwrap().count() < 3 {
            assert!(begun.elapsed() < PATIENCE, "no pictures");
            std::thread::sleep(Duration::from_millis(20));
        }
        // SAFETY: the child was started by this test and has not been waited for.
        unsafe { libc::kill(child.id() as libc::pid_t, signal) };
        let status = child.wait().unwrap();
        assert_eq!(status.signal(), Some(signal), "{status}");
        for (name, _) in files(folder.path()) {
            image::open(folder.path().join(&name)).unwrap();
        }
    }
}

#[test]
fn invalid_sequence_options_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let out = pattern(folder.path());
    let refused = |more: &[&str], parts: &[&str]| {
        let mut arguments = vec!["render", SCENE];
        arguments.extend(more);
        bad(&arguments, parts);
        assert_eq!(files(folder.path()), []);
    };
    let one = folder.path().join("p.png");
    let one = one.to_str().unwrap();
    refused(&["--frames", "4..4", "--out", &out], &["4..4", "no frames"]);
    refused(&["--frames", "x", "--out", &out], &["--frames", "\"x\""]);
    refused(&["--frames", "2..4", "--out", one], &["%05d"]);
    refused(&["--frames", "2..4"], &["%05d"]);
    refused(&["--frames", "0", "--out", one], &["no frames"]);
    refused(&["--out", "f-%5d.png"], &["f-%5d.png", "%05d"]);
    refused(&["--corners", "--out", &out], &["--corners"]);
    refused(&["--turn=-1", "--out", &out], &["--turn"]);
}
