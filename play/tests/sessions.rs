//! `cellray-play` as its users meet it: pictures, recordings, a terminal, signals, bad input.

mod pty;
mod terminal;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::time::{Duration, Instant};

use pty::Pty;

const SCENE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../scenes/paper16.nff");
const GAME: &str = "screensaver";

fn program() -> Command {
    let mut program = Command::new(env!("CARGO_BIN_EXE_cellray-play"));
    program.env_remove("DISPLAY").env_remove("WAYLAND_DISPLAY");
    program
}

fn run(arguments: &[&str]) -> Output {
    program().args(arguments).output().expect("the program")
}

fn good(arguments: &[&str]) -> String {
    let output = run(arguments);
    let talk = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(output.status.success(), "{arguments:?}: {talk}");
    talk
}

fn bad(arguments: &[&str]) -> String {
    let output = run(arguments);
    assert!(!output.status.success(), "{arguments:?}");
    String::from_utf8_lossy(&output.stderr).into_owned()
}

/// Pictures of a game's frames, in a folder.
fn pictures(folder: &Path, frames: &str, more: &[&str]) -> String {
    let out = folder.join("f-%05d.png");
    let mut arguments = vec!["play", GAME, "--size", "64x36", "--frames", frames, "--out"];
    arguments.push(out.to_str().expect("text"));
    arguments.extend(more);
    good(&arguments)
}

fn files(folder: &Path) -> Vec<(PathBuf, Vec<u8>)> {
    let entries = fs::read_dir(folder).expect("a folder");
    let mut files: Vec<_> = entries
        .map(|entry| {
            let path = entry.expect("an entry").path();
            let bytes = fs::read(&path).expect("a file");
            (PathBuf::from(path.file_name().expect("a name")), bytes)
        })
        .collect();
    files.sort();
    files
}

#[test]
fn ranges_of_pictures_are_those_of_one_run_and_resumed() {
    let [whole, parts] = [(); 2].map(|()| tempfile::tempdir().expect("a folder"));
    let talk = pictures(whole.path(), "0..12", &[]);
    assert!(
        talk.contains("12 picture(s) written, 0 there already"),
        "{talk}"
    );
    let expected = files(whole.path());
    assert_eq!(expected.len(), 12);
    assert!(
        expected.windows(2).all(|pair| pair[0].1 != pair[1].1),
        "nothing moves"
    );

    pictures(parts.path(), "7..12", &[]);
    fs::remove_file(parts.path().join("f-00009.png")).expect("a picture");
    let untouched = parts.path().join("f-00008.png");
    let before = fs::metadata(&untouched)
        .and_then(|data| data.modified())
        .expect("a time");
    let talk = pictures(parts.path(), "0..12", &[]);
    assert!(
        talk.contains("8 picture(s) written, 4 there already"),
        "{talk}"
    );
    assert!(files(parts.path()) == expected);
    let after = fs::metadata(&untouched)
        .and_then(|data| data.modified())
        .expect("a time");
    assert_eq!(before, after);

    let other = tempfile::tempdir().expect("a folder");
    pictures(other.path(), "0..12", &["--seed", "7"]);
    assert!(files(other.path()) != expected, "the seed plays no part");
}

#[test]
fn a_full_disk_names_the_picture_and_leaves_no_part_of_it() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("f-%05d.png");
    // In blocks of 512 bytes: room for an emulated SPU's local store, and for no picture of this size.
    let output = Command::new("sh")
        .args(["-c", "ulimit -f 576; exec \"$0\" \"$@\""])
        .arg(env!("CARGO_BIN_EXE_cellray-play"))
        .args([
            "view",
            SCENE,
            "--size",
            "1920x1080",
            "--frames",
            "3",
            "--out",
        ])
        .arg(&out)
        .output()
        .expect("the program");
    let talk = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{talk}");
    assert!(
        talk.contains("f-00000.png") && talk.contains("too large"),
        "{talk}"
    );
    assert_eq!(files(folder.path()), []);
}

#[test]
fn sigterm_ends_pictures_between_two_of_them() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("f-%05d.png");
    let mut child = program()
        .args([
            "play", GAME, "--size", "64x36", "--frames", "1000000", "--out",
        ])
        .arg(&out)
        .stderr(std::process::Stdio::piped())
        .spawn()
        .expect("the program");
    let begun = Instant::now();
    while files(folder.path()).len() < 3 {
        assert!(begun.elapsed() < Duration::from_secs(60), "no pictures");
        std::thread::sleep(Duration::from_millis(20));
    }
    pty::signal(child.id(), libc::SIGTERM);
    let status = child.wait().expect("its end");
    assert_eq!(status.code(), Some(128 + libc::SIGTERM));
    for (name, _) in files(folder.path()) {
        let picture = image::open(folder.path().join(&name));
        assert!(picture.is_ok(), "{name:?}: {:?}", picture.err());
    }
}

#[test]
fn bad_input_is_told_of() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("there");
    fs::write(&file, "something").expect("a file");
    let there = file.to_str().expect("text");
    for (arguments, words) in [
        (&["play", "chess", "--display", "none"][..], "billiards"),
        (&["view", "none.nff", "--display", "none"], "none.nff"),
        (&["play", GAME, "--frames", "3..3"], "3..3"),
        (&["play", GAME, "--frames", "x"], "A..B"),
        (
            &["play", GAME, "--frames", "0..2", "--out", "f.png"],
            "%05d",
        ),
        (&["play", GAME, "--out", "f-%d.png"], "--frames"),
        (&["play", GAME, "--display", "none"], "--frames"),
        (
            &["play", GAME, "--display", "none", "--frames", "2..3"],
            "frame 0",
        ),
        (
            &["play", GAME, "--display", "fb", "--device", "/dev/null"],
            "/dev/null",
        ),
        (&["play", GAME, "--display", "terminal"], "terminal"),
        (&["play", GAME, "--display", "window"], "window"),
        (&["play", GAME], "--display fb"),
        (
            &[
                "play",
                GAME,
                "--display",
                "none",
                "--frames",
                "1",
                "--record",
                there,
            ],
            there,
        ),
        (
            &["play", GAME, "--display", "none", "--replay", there],
            there,
        ),
        (
            &[
                "play",
                GAME,
                "--display",
                "none",
                "--frames",
                "1",
                "--spus",
                "0",
            ],
            "0 SPUs",
        ),
    ] {
        let talk = bad(arguments);
        assert!(talk.contains(words), "{arguments:?}: {talk}");
        assert!(!talk.contains("panicked"), "{talk}");
    }
    assert_eq!(fs::read(&file).expect("still there"), b"something");
}

#[test]
fn games_are_listed() {
    let output = run(&["play"]);
    let list = String::from_utf8_lossy(&output.stdout);
    assert!(
        output.status.success() && list.contains(GAME) && list.contains("billiards"),
        "{list}"
    );
}

#[test]
fn a_file_takes_the_framebuffers_place() {
    let folder = tempfile::tempdir().expect("a folder");
    let fb = folder.path().join("fb");
    let device = fb.to_str().expect("text");
    let talk = good(&[
        "view",
        SCENE,
        "--display",
        "fb",
        "--device",
        device,
        "--size",
        "64x36",
        "--frames",
        "2",
    ]);
    assert!(talk.contains("2 frame(s)"), "{talk}");
    let bytes = fs::read(&fb).expect("a framebuffer");
    assert!(bytes.len() >= 64 * 36 * 4 && bytes.iter().any(|&byte| byte > 100));
}

/// A session in a terminal, recorded.
fn in_terminal(record: &Path) -> Pty {
    let mut command = program();
    command.args([
        "view",
        SCENE,
        "--display",
        "terminal",
        "--size",
        "64x48",
        "--record",
    ]);
    command
        .arg(record)
        .env("COLORTERM", "truecolor")
        .env("TERM", "xterm-256color");
    Pty::start(command, 64, 24)
}

#[test]
fn a_terminal_shows_colours_takes_keys_and_its_recording_is_played_back() {
    let folder = tempfile::tempdir().expect("a folder");
    let record = folder.path().join("session");
    let mut pty = in_terminal(&record);
    pty.wait_for("\u{2580}");
    assert!(pty.is_taken(), "keys come line by line");
    assert!(pty.seen().contains("\x1b[38;2;") && pty.seen().contains("\x1b[48;2;"));
    pty.wait_for("SPUs");
    // The arrow turns the eye, so the picture changes.
    let shown = pty.seen().matches('\u{2580}').count();
    pty.type_in("\x1b[C");
    pty.wait_until(|seen| seen.matches('\u{2580}').count() > shown + 20);
    pty.type_in("q");
    assert_eq!(pty.end().code(), Some(0));
    pty.assert_restored();
    assert!(
        pty.seen().contains("frame(s)"),
        "the report comes after the picture"
    );

    let recorded = fs::read_to_string(&record).expect("a recording");
    let key = "\"key\":\"right\",\"down\":true";
    assert!(recorded.contains(key), "{recorded}");
    assert!(!recorded.contains("\"key\":\"q\""));
    let [one, two] = [(); 2].map(|()| {
        let again = folder.path().join("again");
        let _ = fs::remove_dir_all(&again);
        fs::create_dir(&again).expect("a folder");
        let out = again.join("f-%05d.png");
        let record = record.to_str().expect("text");
        good(&[
            "view",
            SCENE,
            "--size",
            "64x48",
            "--frames",
            "100000",
            "--replay",
            record,
            "--out",
            out.to_str().expect("text"),
        ]);
        files(&again)
    });
    assert_eq!(one.len() + 1, recorded.lines().count());
    assert!(one == two);
    assert!(
        one.first().map(|file| &file.1) != one.last().map(|file| &file.1),
        "the eye moved"
    );
    // Of another game it is none.
    let record = record.to_str().expect("text");
    let talk = bad(&["play", GAME, "--display", "none", "--replay", record]);
    assert!(talk.contains("paper16"), "{talk}");
}

#[test]
fn signals_and_ctrl_c_put_the_terminal_back() {
    let folder = tempfile::tempdir().expect("a folder");
    for (number, signal) in [libc::SIGTERM, libc::SIGINT, libc::SIGHUP, libc::SIGQUIT]
        .into_iter()
        .enumerate()
    {
        let mut pty = in_terminal(&folder.path().join(number.to_string()));
        pty.wait_for("\u{2580}");
        pty::signal(pty.process(), signal);
        assert_eq!(pty.end().code(), Some(128 + signal));
        assert!(pty.seen().contains(&format!("ended by signal {signal}")));
        pty.assert_restored();
    }
    for (typed, status) in [("\x03", 130), ("\x04", 0)] {
        let mut pty = in_terminal(&folder.path().join(status.to_string() + "-typed"));
        pty.wait_for("\u{2580}");
        pty.type_in(typed);
        assert_eq!(pty.end().code(), Some(status));
        pty.assert_restored();
    }
}

#[test]
fn a_second_signal_ends_at_once_and_puts_the_terminal_back() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut pty = in_terminal(&folder.path().join("session"));
    pty.wait_for("\u{2580}");
    // Both are there when it goes on: the frame loop has no time to come round.
    for signal in [libc::SIGSTOP, libc::SIGINT, libc::SIGTERM, libc::SIGCONT] {
        pty::signal(pty.process(), signal);
    }
    let status = pty.end();
    let signal = std::os::unix::process::ExitStatusExt::signal(&status);
    assert!(
        [Some(libc::SIGINT), Some(libc::SIGTERM)].contains(&signal),
        "{status}"
    );
    pty.assert_restored();
}

#[test]
fn a_terminals_size_is_followed() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut pty = in_terminal(&folder.path().join("session"));
    pty.wait_for("\u{2580}");
    assert!(!pty.seen().contains("\x1b[40;"));
    pty.resize(100, 40);
    pty.wait_for("\x1b[40;");
    pty.type_in("q");
    assert_eq!(pty.end().code(), Some(0));
}
