//! `cellray-play` as its users meet it: pictures, recordings, a terminal, signals, bad input.

mod pty;
mod terminal;

use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::thread;
use std::time::{Duration, Instant};

use cellray::Settings;
use cellray::framebuffer::{Framebuffer, Geometry, Memory, NumberedPath};
use cellray::game::{
    FixedSteps, Frame, Game, NoInput, Pictures, RealTime, Session, Start, World, WorldError,
};
use pty::Pty;

const SCENE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../scenes/paper16.nff");
const WHITTED: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../scenes/still-life.nff");
const GAME: &str = "screensaver";
/// How long pictures may take to come, on a machine that is busy with other things.
const PATIENCE: Duration = Duration::from_secs(600);

fn program() -> Command {
    let mut program = Command::new(env!("CARGO_BIN_EXE_cellray-play"));
    for variable in ["DISPLAY", "WAYLAND_DISPLAY", "WAYLAND_SOCKET"] {
        program.env_remove(variable);
    }
    program
}

fn run(arguments: &[&str]) -> Output {
    program().args(arguments).output().expect("the program")
}

fn good(arguments: &[&str]) -> String {
    let output = run(arguments);
    let messages = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(output.status.success(), "{arguments:?}: {messages}");
    messages
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
fn picture_ranges_equal_one_run_and_resume() {
    let [whole, parts] = [(); 2].map(|()| tempfile::tempdir().expect("a folder"));
    let messages = pictures(whole.path(), "0..12", &[]);
    assert!(messages.contains("12 picture(s) written, 0 existed already"), "{messages}");
    let expected = files(whole.path());
    assert_eq!(expected.len(), 12);
    assert!(expected.windows(2).all(|pair| pair[0].1 != pair[1].1), "nothing moves");

    pictures(parts.path(), "7..12", &[]);
    fs::remove_file(parts.path().join("f-00009.png")).expect("a picture");
    let untouched = parts.path().join("f-00008.png");
    let before = fs::metadata(&untouched).and_then(|data| data.modified()).expect("a time");
    let messages = pictures(parts.path(), "0..12", &[]);
    assert!(messages.contains("8 picture(s) written, 4 existed already"), "{messages}");
    assert!(files(parts.path()) == expected);
    let after = fs::metadata(&untouched).and_then(|data| data.modified()).expect("a time");
    assert_eq!(before, after);

    let other = tempfile::tempdir().expect("a folder");
    pictures(other.path(), "0..12", &["--seed", "7"]);
    assert!(files(other.path()) != expected, "the seed plays no part");
}

/// The program, where files have no more than 576 blocks of 512 bytes: enough for an emulated SPU's
/// local store, and too little for a picture of 1920x1080.
fn on_a_full_disk() -> Command {
    let mut command = Command::new("sh");
    command
        .args(["-c", "ulimit -f 576; exec \"$0\" \"$@\""])
        .arg(env!("CARGO_BIN_EXE_cellray-play"));
    command
}

#[test]
fn full_disk_names_picture_and_leaves_no_partial_file() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("f-%05d.png");
    let output = on_a_full_disk()
        .args(["view", SCENE, "--size", "1920x1080", "--frames", "3", "--out"])
        .arg(&out)
        .output()
        .expect("the program");
    let messages = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{messages}");
    assert!(messages.contains("f-00000.png") && messages.contains("too large"), "{messages}");
    assert_eq!(files(folder.path()), []);
}

#[test]
fn signals_end_sequence_between_pictures() {
    [libc::SIGTERM, libc::SIGINT].into_iter().for_each(ends_pictures);
}

fn ends_pictures(signal: i32) {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("f-%05d.png");
    let mut child = program()
        .args(["play", GAME, "--size", "64x36", "--frames", "1000000", "--out"])
        .arg(&out)
        .stderr(std::process::Stdio::piped())
        .spawn()
        .expect("the program");
    let begun = Instant::now();
    // A picture has another name while it is written, so nothing is read yet.
    while fs::read_dir(&folder).expect("a folder").count() < 3 {
        assert!(begun.elapsed() < PATIENCE, "no pictures");
        thread::sleep(Duration::from_millis(20));
    }
    pty::signal(child.id(), signal);
    let status = child.wait().expect("its end");
    assert_eq!(status.code(), Some(128 + signal));
    for (name, _) in files(folder.path()) {
        let picture = image::open(folder.path().join(&name));
        assert!(picture.is_ok(), "{name:?}: {:?}", picture.err());
    }
}

#[test]
fn bad_input_is_an_error() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("there");
    fs::write(&file, "something").expect("a file");
    let there = file.to_str().expect("text");
    for (arguments, words) in [
        (&["play", "chess", "--display", "none"][..], "no game \"chess\"; there are: billiards"),
        (
            &["play", "biliards", "--display", "none"],
            "no game \"biliards\"; did you mean \"billiards\"?",
        ),
        (&["view", "none.nff", "--display", "none"], "none.nff"),
        (&["play", GAME, "--frames", "3..3"], "3..3"),
        (&["play", GAME, "--frames", "x"], "A..B"),
        (&["play", GAME, "--size", "-5x10"], "'-5x10' for '--size <WxH>'"),
        (&["play", GAME, "--frames", "-1..2"], "'-1..2' for '--frames <A..B>'"),
        (&["play", GAME, "--seed", "-1"], "'-1' for '--seed <N>'"),
        (&["play", GAME, "--fps", "-1"], "'-1' for '--fps <N>'"),
        (&["view", "none.nff", "--spus", "-1"], "'-1' for '--spus <N>'"),
        (&["view", "none.nff", "--ray-depth", "-1"], "'-1' for '--ray-depth <N>'"),
        (&["view", "none.nff", "--timeout", "-1"], "'-1' for '--timeout <S>'"),
        (&["play", GAME, "--frames", "0..2", "--out", "f.png"], "%05d"),
        (&["play", GAME, "--out", "f-%d.png"], "--frames"),
        (&["play", GAME, "--display", "none"], "--frames"),
        (&["play", GAME, "--display", "none", "--frames", "2..3"], "frame 0"),
        (&["play", GAME, "--display", "fb", "--device", "/dev/null"], "/dev/null"),
        (&["play", GAME, "--display", "terminal"], "terminal"),
        (&["play", GAME, "--display", "window"], "window"),
        (&["play", GAME], "--display fb"),
        (&["play", GAME, "--display", "none", "--frames", "1", "--record", there], there),
        (&["play", GAME, "--display", "none", "--replay", there], there),
        (&["play", GAME, "--display", "none", "--frames", "1", "--spus", "0"], "0 SPUs"),
        (&["play", GAME, "--timeout", "18446744073709551615"], "86400"),
        (&["play", GAME, "--timeout", "0"], "86400"),
    ] {
        let messages = bad(arguments);
        assert!(messages.contains(words), "{arguments:?}: {messages}");
        assert!(!messages.contains("panicked"), "{messages}");
    }
    assert_eq!(fs::read(&file).expect("still there"), b"something");
}

#[test]
fn missing_display_server_is_named_without_source_positions() {
    let folder = tempfile::tempdir().expect("a folder");
    for (variable, value) in [
        ("DISPLAY", ":4242"),
        ("DISPLAY", "no such display"),
        ("WAYLAND_DISPLAY", "wayland-4242"),
        ("WAYLAND_SOCKET", "4242"),
        ("WAYLAND_SOCKET", "no number"),
    ] {
        let output = program()
            .env(variable, value)
            .env("XDG_RUNTIME_DIR", folder.path())
            .args(["view", SCENE])
            .output()
            .expect("the program");
        let messages = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(1), "{messages}");
        let begin = format!("cellray-play: error: no window: {variable}={value}: ");
        assert!(
            messages.starts_with(&begin) && messages.contains("--display terminal"),
            "{messages}"
        );
        for word in [".rs:", "panicked", ".cargo"] {
            assert!(!messages.contains(word), "{messages}");
        }
    }
}

#[test]
fn games_are_listed() {
    let output = run(&["play"]);
    let list = String::from_utf8_lossy(&output.stdout);
    assert!(output.status.success() && list.contains(GAME) && list.contains("billiards"), "{list}");
}

#[test]
fn game_names_ignore_case() {
    let name = GAME.to_uppercase();
    good(&["play", &name, "--size", "64x36", "--display", "none", "--frames", "1"]);
}

#[test]
fn file_replaces_framebuffer() {
    let folder = tempfile::tempdir().expect("a folder");
    let fb = folder.path().join("fb");
    let device = fb.to_str().expect("text");
    let messages = good(&[
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
    assert!(messages.contains("2 frame(s)"), "{messages}");
    let bytes = fs::read(&fb).expect("a framebuffer");
    assert!(bytes.len() >= 64 * 36 * 4 && bytes.iter().any(|&byte| byte > 100));
}

/// A session in a terminal, recorded.
fn in_terminal(record: &Path) -> Pty {
    let mut command = program();
    command.args(["view", SCENE, "--display", "terminal", "--size", "64x48", "--record"]);
    command.arg(record).env("COLORTERM", "truecolor").env("TERM", "xterm-256color");
    Pty::start(command, 64, 24)
}

/// A session in a terminal that is tracing its first frame, and would take minutes for it. So the
/// frame loop doesn't come round while signals come.
fn in_a_long_frame(record: &Path) -> Pty {
    let mut command = program();
    command
        .args(["view", WHITTED, "--model", "whitted", "--display", "terminal"])
        .args(["--size", "3840x2160", "--antialias", "16", "--spus", "1"])
        .arg("--record")
        .arg(record)
        .env("TERM", "xterm-256color");
    let mut pty = Pty::start(command, 64, 24);
    pty.wait_for("tracing ...");
    pty
}

#[test]
fn terminal_session_shows_colours_and_is_replayed() {
    let folder = tempfile::tempdir().expect("a folder");
    let record = folder.path().join("session");
    let mut pty = in_terminal(&record);
    pty.wait_for("\u{2580}");
    assert!(pty.is_taken(), "keys come line by line");
    assert!(pty.seen().contains("\x1b[38;2;") && pty.seen().contains("\x1b[48;2;"));
    // Statistics come after the first picture.
    pty.type_in("\x1bOP");
    pty.wait_for("SPUs");
    // The arrow turns the eye, so the picture changes.
    let shown = pty.seen().matches('\u{2580}').count();
    pty.type_in("\x1b[C");
    pty.wait_until(|seen| seen.matches('\u{2580}').count() > shown + 20);
    pty.type_in("q");
    assert_eq!(pty.end().code(), Some(0));
    pty.assert_restored();
    assert!(pty.seen().contains("frame(s)"), "the report comes after the picture");

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
    assert!(one.first().map(|file| &file.1) != one.last().map(|file| &file.1), "the eye moved");
    // Of another game it is none.
    let record = record.to_str().expect("text");
    let messages = bad(&["play", GAME, "--display", "none", "--replay", record]);
    assert!(messages.contains("paper16"), "{messages}");
}

#[test]
fn recording_on_full_disk_is_an_error() {
    let folder = tempfile::tempdir().expect("a folder");
    let record = folder.path().join("session");
    let output = on_a_full_disk()
        .args(["play", GAME, "--display", "none", "--size", "16x16"])
        .args(["--frames", "1000000", "--record"])
        .arg(&record)
        .output()
        .expect("the program");
    let messages = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{messages}");
    let name = record.to_str().expect("text");
    assert!(messages.contains(name) && messages.contains("too large"), "{messages}");
}

/// A writer that fails once it has taken this many bytes.
struct Limited(usize);

impl io::Write for Limited {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let left = self.0.checked_sub(bytes.len());
        self.0 = left.ok_or(io::ErrorKind::StorageFull)?;
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

struct Still;

impl Game for Still {
    fn set_up(&mut self, _: &mut World, _: &Start) -> Result<(), WorldError> {
        Ok(())
    }

    fn update(&mut self, _: &mut World, _: &Frame<'_>) -> Result<(), WorldError> {
        Ok(())
    }
}

/// A session whose recording has at most `capacity` bytes.
fn recorded(capacity: usize, framebuffer: Box<dyn Framebuffer>) -> Session<Still> {
    let session = Session::start(Still, Settings::default(), framebuffer).expect("a session");
    session.record_to(Box::new(io::BufWriter::new(Limited(capacity))))
}

#[test]
fn incomplete_recording_is_an_error() {
    let size = Geometry::new(16, 16).expect("a size");
    let memory = || Box::new(Memory::new(size).expect("memory"));
    let folder = tempfile::tempdir().expect("a folder");
    let paths = NumberedPath::new(folder.path().join("f-%d.png"));
    let pictures = Pictures::new(paths.expect("a path"));
    let mut clock = FixedSteps(Duration::from_millis(40));
    for (capacity, fits) in [(0, false), (1000, true)] {
        let mut session = recorded(capacity, memory());
        let is_over = session.run(Some(3), &mut clock, &mut NoInput).is_ok();
        assert_eq!(is_over, fits, "{capacity}");
        let mut session = recorded(capacity, memory());
        let frames = "0..3".parse().expect("frames");
        let made = pictures.write(&mut session, frames, &mut clock, &mut NoInput);
        assert_eq!(made.is_ok(), fits, "{capacity}");
    }
}

#[test]
fn timeout_may_exceed_maximum_duration() {
    let memory = Memory::new(Geometry::new(16, 16).expect("a size")).expect("memory");
    let settings = Settings { timeout: Duration::MAX, ..Settings::default() };
    let mut session = Session::start(Still, settings, Box::new(memory)).expect("a session");
    let mut clock = RealTime::default();
    let report = session.run(Some(2), &mut clock, &mut NoInput);
    assert_eq!(report.expect("frames").frames, 2);
}

#[test]
fn last_recorded_frame_has_world_checksum() {
    let folder = tempfile::tempdir().expect("a folder");
    let record = folder.path().join("session");
    let name = record.to_str().expect("text");
    let none = ["play", GAME, "--display", "none", "--size", "16x16"];
    good(&[&none[..], &["--frames", "19", "--record", name]].concat());
    let text = fs::read_to_string(&record).expect("a recording");
    let checked = |line: &&str| line.contains("\"world\"");
    assert_eq!((text.lines().count(), text.lines().filter(checked).count()), (20, 3));
    let last = text.lines().last().expect("a line");
    assert!(last.contains("\"world\""), "{last}");
    let messages = good(&[&none[..], &["--replay", name]].concat());
    assert!(messages.contains("19 frame(s)"), "{messages}");

    let (rest, checksum) = last.rsplit_once("\"world\":").expect("a checksum");
    let other = match checksum {
        "\"0000000000000000\"}" => "1",
        _ => "0000000000000000",
    };
    let other = format!("{rest}\"world\":\"{other}\"}}");
    fs::write(&record, text.replace(last, &other)).expect("a file");
    let messages = bad(&[&none[..], &["--replay", name]].concat());
    assert!(messages.contains("frame 18: the world differs"), "{messages}");
}

#[test]
fn full_disk_is_an_error_and_earlier_pictures_stay() {
    let folder = tempfile::tempdir().expect("a folder");
    let earlier = folder.path().join("paper16-nff-0001.png");
    fs::write(&earlier, "an earlier picture").expect("a file");
    let mut command = on_a_full_disk();
    command
        .args(["view", SCENE, "--display", "terminal"])
        .args(["--size", "1920x1080", "--screenshots"])
        .arg(folder.path())
        .env("TERM", "xterm-256color");
    let mut pty = Pty::start(command, 64, 24);
    pty.wait_for("\u{2580}");
    pty.type_in(F12);
    pty.type_in("q");
    assert_eq!(pty.end().code(), Some(0));
    // It is said when the terminal shows text again.
    let seen = pty.seen();
    let messages = seen.split("\x1b[?1049l").last().unwrap_or_default();
    assert!(messages.contains("no picture: ") && messages.contains("too large"), "{messages}");
    let kept = (PathBuf::from("paper16-nff-0001.png"), b"an earlier picture".to_vec());
    assert_eq!(files(folder.path()), [kept]);
}

/// F12 is pressed and released, by the kitty protocol.
const F12: &str = "\x1b[24;1:1~\x1b[24;1:3~";

#[test]
fn live_pictures_equal_replayed_pictures() {
    let folder = tempfile::tempdir().expect("a folder");
    let [shots, again] = ["shots", "again"].map(|name| folder.path().join(name));
    for path in [&shots, &again] {
        fs::create_dir(path).expect("a folder");
    }
    let record = folder.path().join("session");
    let mut command = program();
    command
        .args(["play", GAME, "--display", "terminal", "--size", "64x48"])
        .arg("--screenshots")
        .arg(&shots)
        .arg("--record")
        .arg(&record)
        .env("TERM", "xterm-256color");
    let mut pty = Pty::start(command, 64, 24);
    // What moves is drawn at each frame, from its first changed character on.
    for number in 1..=3 {
        let shown = pty.seen().len();
        pty.wait_until(|seen| seen.len() > shown + 20_000);
        pty.type_in(F12);
        // An empty file keeps the name until the picture is written.
        let shot = shots.join(format!("{GAME}-{number:04}.png"));
        pty.wait_until(|_| fs::metadata(&shot).is_ok_and(|file| file.len() > 0));
    }
    pty.type_in("q");
    assert_eq!(pty.end().code(), Some(0));

    good(&[
        "play",
        GAME,
        "--size",
        "64x48",
        "--frames",
        "100000",
        "--replay",
        record.to_str().expect("text"),
        "--out",
        again.join("f-%05d.png").to_str().expect("text"),
    ]);
    let replayed = files(&again);
    assert!(replayed.len() >= 3, "{}", replayed.len());
    let place = |(name, picture): &(PathBuf, Vec<u8>)| {
        let place = replayed.iter().position(|(_, frame)| frame == picture);
        place.unwrap_or_else(|| panic!("{name:?} is not among {} frames", replayed.len()))
    };
    let places: Vec<_> = files(&shots).iter().map(place).collect();
    assert!(places.is_sorted_by(|a, b| a < b), "{places:?}");
}

#[test]
fn closed_output_succeeds_and_full_output_fails() {
    let mut sh = Command::new("sh");
    let program = env!("CARGO_BIN_EXE_cellray-play");
    let closed = ["-c", "exec 3>&1; { \"$0\" play; echo $? >&3; } | :"];
    let output = sh.args(closed).arg(program).output().expect("the program");
    assert_eq!(String::from_utf8_lossy(&output.stdout), "0\n");
    let mut sh = Command::new("sh");
    let full = ["-c", "\"$0\" play >/dev/full"];
    let output = sh.args(full).arg(program).output().expect("the program");
    let messages = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{messages}");
    assert!(messages.contains("standard output: "), "{messages}");
    let mut sh = Command::new("sh");
    let session = "exec \"$0\" play \"$1\" --display none --frames 2 --size 16x16 2>/dev/full";
    let status = sh.args(["-c", session, program, GAME]).status();
    assert_eq!(status.expect("the program").code(), Some(0));
}

#[test]
fn framebuffer_takes_keys_with_redirected_messages() {
    let folder = tempfile::tempdir().expect("a folder");
    let [fb, log] = ["fb", "log"].map(|name| folder.path().join(name));
    let mut command = Command::new("sh");
    let session = "exec \"$0\" view \"$1\" --display fb --device \"$2\" --size 64x36 >\"$3\"";
    command.args(["-c", session, env!("CARGO_BIN_EXE_cellray-play"), SCENE]).args([&fb, &log]);
    let mut pty = Pty::start(command, 64, 24);
    pty.wait_until_taken(true);
    pty.type_in("q");
    assert_eq!(pty.end().code(), Some(0));
    assert!(!pty.is_taken() && pty.seen().contains(" rays in "), "{}", pty.seen());
    assert_eq!(fs::read(&log).expect("a file"), b"");
}
