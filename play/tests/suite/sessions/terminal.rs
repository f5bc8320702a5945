//! What ends, stops or confuses a program on a terminal, and how the terminal is left.

use std::fs;
use std::os::unix::process::ExitStatusExt as _;
use std::process::Command;

use super::pty::{self, Pty};
use super::{GAME, SCENE, in_a_long_frame, in_terminal};

const HALF: char = '\u{2580}';

/// The screen is a file, keys are the terminal's.
fn on_framebuffer(device: &str) -> Pty {
    let mut command = super::program();
    command.args(["play", GAME, "--display", "fb", "--device", device]);
    command.args(["--size", "64x36"]);
    let pty = Pty::start(command, 80, 24);
    pty.wait_until_taken(true);
    pty
}

#[test]
fn terminal_hangup_ends_session() {
    let folder = tempfile::tempdir().expect("a folder");
    // The second time there is no signal of it.
    for trap in ["", "trap '' HUP; "] {
        let messages = folder.path().join("messages");
        let script = format!("{trap}exec \"$0\" view \"$1\" --display terminal 2>\"$2\"");
        let mut command = Command::new("sh");
        command.args(["-c", &script, env!("CARGO_BIN_EXE_cellray-play"), SCENE]).arg(&messages);
        let mut pty = Pty::start(command, 64, 24);
        pty.wait_for(&HALF.to_string());
        pty.hang_up();
        assert_eq!(pty.end().code(), Some(128 + libc::SIGHUP), "{trap}");
        let messages = fs::read_to_string(messages).expect("the messages");
        assert!(messages.contains("ended by signal 1"), "{messages}");
    }
}

#[test]
fn partial_event_does_not_block() {
    let folder = tempfile::tempdir().expect("a folder");
    // Alt and a bracket; a letter of Latin-1.
    for (number, typed) in [&b"\x1b["[..], b"\xe9"].into_iter().enumerate() {
        let mut pty = in_terminal(&folder.path().join(number.to_string()));
        pty.wait_for(&HALF.to_string());
        // The program reads all of it together, and the help shows that it has.
        pty.type_in([b"h", typed].concat());
        pty.wait_until_shown("turn the camera", true);
        pty.resize(100, 40);
        pty.wait_for("\x1b[40;");
        pty::signal(pty.process(), libc::SIGTERM);
        assert_eq!(pty.end().code(), Some(128 + libc::SIGTERM), "{typed:?}");
        pty.assert_restored();
    }
}

#[test]
fn terminal_is_restored_after_any_end() {
    let folder = tempfile::tempdir().expect("a folder");
    let (hangup, interrupt, term) = (libc::SIGHUP, libc::SIGINT, libc::SIGTERM);
    for (number, signals) in [
        &[hangup, term][..],
        &[hangup, interrupt],
        &[libc::SIGUSR1],
        &[libc::SIGALRM],
        &[libc::SIGABRT],
        &[libc::SIGSEGV],
    ]
    .into_iter()
    .enumerate()
    {
        let mut pty = in_a_long_frame(&folder.path().join(number.to_string()));
        for &signal in signals {
            pty::signal(pty.process(), signal);
        }
        let status = pty.end();
        assert!(status.signal().is_some_and(|it| signals.contains(&it)), "{signals:?}: {status}");
        pty.assert_restored();
    }
}

#[test]
fn stopped_program_releases_and_reacquires_terminal() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut pty = in_terminal(&folder.path().join("session"));
    pty.wait_for(&HALF.to_string());
    pty::signal(pty.process(), libc::SIGTSTP);
    pty.wait_until_taken(false);
    pty.wait_for("\x1b[?1049l");
    pty.assert_restored();
    pty.wait_until_stopped();
    let shown = pty.seen().matches(HALF).count();
    pty::signal(pty.process(), libc::SIGCONT);
    pty.wait_until_taken(true);
    // All of it is drawn again.
    pty.wait_until(|seen| seen.matches(HALF).count() >= shown + 64 * 23);
    pty.type_in("q");
    assert_eq!(pty.end().code(), Some(0));
    pty.assert_restored();
}

#[test]
fn briefly_resized_terminal_is_redrawn() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut pty = in_terminal(&folder.path().join("session"));
    pty.wait_for(&HALF.to_string());
    let shown = pty.seen().matches(HALF).count();
    // Between two frames.
    pty::signal(pty.process(), libc::SIGSTOP);
    pty.resize(40, 10);
    pty.resize(64, 24);
    pty::signal(pty.process(), libc::SIGCONT);
    pty.wait_until(|seen| seen.matches(HALF).count() >= shown + 64 * 23);
    pty.type_in("q");
    assert_eq!(pty.end().code(), Some(0));
}

#[test]
fn mouse_moves_and_keys_held_at_focus_loss_are_pressed_again() {
    let folder = tempfile::tempdir().expect("a folder");
    let record = folder.path().join("session");
    let mut pty = in_terminal(&record);
    pty.wait_for(&HALF.to_string());
    // No button is held.
    pty.type_in("\x1b[<35;10;5M\x1b[<35;12;4M");
    // Of the kitty protocol: a pressed and released, b pressed; the focus goes and comes; b
    // pressed.
    pty.type_in("\x1b[97;1:1u\x1b[97;1:3u\x1b[98;1:1u\x1b[O\x1b[I\x1b[98;1:1u\x1b[98;1:3u");
    pty.wait_until_stepped();
    pty.type_in("q");
    assert_eq!(pty.end().code(), Some(0));
    let recorded = fs::read_to_string(&record).expect("a recording");
    let count = |text: &str| recorded.matches(text).count();
    assert_eq!(count("\"mouse-motion\":{\"by\":[16.0,-16.0]}"), 1, "{recorded}");
    assert_eq!(count("\"key\":\"b\",\"down\":true"), 2, "{recorded}");
    assert_eq!(count("focus-lost"), 1, "{recorded}");
}

#[test]
fn ctrl_c_ends_framebuffer_session_and_restores_terminal() {
    let folder = tempfile::tempdir().expect("a folder");
    let device = folder.path().join("fb");
    let mut pty = on_framebuffer(device.to_str().expect("text"));
    pty.type_in("\x03");
    assert_eq!(pty.end().code(), Some(128 + libc::SIGINT));
    assert!(!pty.is_taken(), "{:?}", pty.seen());
}

#[test]
fn truncated_framebuffer_file_is_named_and_terminal_restored() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("fb");
    let device = path.to_str().expect("text");
    let mut pty = on_framebuffer(device);
    pty.wait_for("stride");
    let file = fs::OpenOptions::new().write(true).open(&path);
    let file = file.expect("the file");
    // By a byte: what is in the same page of memory can still be written to.
    let length = file.metadata().expect("its length").len();
    file.set_len(length - 1).expect("a shorter file");
    assert_eq!(pty.end().code(), Some(1), "{:?}", pty.seen());
    assert!(pty.seen().contains(device), "{:?}", pty.seen());
    assert!(!pty.is_taken());
}

#[test]
fn terminal_shows_keys_and_pause() {
    let folder = tempfile::tempdir().expect("a folder");
    let record = folder.path().join("session");
    let mut pty = in_terminal(&record);
    pty.wait_until_shown("H lists the keys", true);
    pty.wait_until_shown("frames/s", false);
    pty.type_in("\x1bOP");
    pty.wait_until_shown("frames/s", true);
    pty.press('h');
    pty.wait_until_shown("turn the camera", true);
    // The keys of the player come after the game's.
    pty.wait_until_shown("take a picture", true);
    pty.press('h');
    pty.press('p');
    pty.wait_until_shown("Paused", true);
    // Neither of them reaches the game, nor what is typed in a pause.
    for key in ['b', 'p', 'c'] {
        pty.press(key);
    }
    pty.wait_until_stepped();
    pty.type_in("q");
    assert_eq!(pty.end().code(), Some(0));
    let recorded = fs::read_to_string(&record).expect("a recording");
    let has = |key: &str| recorded.contains(&format!("\"key\":\"{key}\",\"down\":true"));
    assert_eq!(["h", "p", "b", "c"].map(has), [false, false, false, true]);
    let replay = record.to_str().expect("text");
    super::good(&["view", SCENE, "--display", "none", "--replay", replay]);
}

#[test]
fn framebuffer_without_text_equals_traced_picture() {
    let folder = tempfile::tempdir().expect("a folder");
    let picture = |more: &[&str]| {
        let path = folder.path().join(more.len().to_string());
        let device = path.to_str().expect("text");
        let view = ["view", SCENE, "--size", "240x136", "--frames", "3"];
        let display = ["--display", "fb", "--device", device];
        super::good(&[&view[..], &display, more].concat());
        fs::read(&path).expect("a framebuffer")
    };
    let (with, without) = (picture(&[]), picture(&["--no-overlay"]));
    let out = folder.path().join("f-%d.png");
    let out = out.to_str().expect("text");
    // A framebuffer's pictures have one sample a pixel unless more are requested.
    let one = ["--antialias", "1"];
    let view = ["view", SCENE, "--size", "240x136", "--frames", "1"];
    super::good(&[&view[..], &one, &["--out", out]].concat());
    let traced = image::open(folder.path().join("f-0.png")).expect("a picture");
    let traced = traced.to_rgb8();
    let shown = without.chunks_exact(4).map(|pixel| &pixel[1..]);
    assert!(shown.eq(traced.as_raw().chunks_exact(3)));
    // The text covers less than half of the picture.
    let same = with.iter().zip(&without).filter(|(with, without)| with == without);
    let same = same.count();
    assert!(same < with.len() && 2 * same > with.len(), "{same}");
}

#[test]
fn picture_width_is_terminal_width_or_default() {
    let folder = tempfile::tempdir().expect("a folder");
    let picture = folder.path().join("p.png");
    image::RgbImage::new(200, 20).save(&picture).expect("written");
    // A terminal that doesn't report its size, as over a serial line, has none.
    for (size, columns) in [((40, 10), 40), ((0, 0), 80)] {
        let mut command = super::program();
        command.arg("show").arg(&picture);
        let mut pty = Pty::start(command, size.0, size.1);
        assert_eq!(pty.end().code(), Some(0), "{}", pty.seen());
        let seen = pty.seen();
        let line = seen.lines().next().expect("a line");
        assert_eq!(line.matches(HALF).count(), columns, "{size:?}");
    }
}

#[test]
fn signals_and_ctrl_c_restore_terminal() {
    let folder = tempfile::tempdir().expect("a folder");
    for (number, signal) in
        [libc::SIGTERM, libc::SIGINT, libc::SIGHUP, libc::SIGQUIT].into_iter().enumerate()
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
fn second_signal_ends_at_once_and_restores_terminal() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut pty = in_a_long_frame(&folder.path().join("session"));
    for signal in [libc::SIGINT, libc::SIGTERM] {
        pty::signal(pty.process(), signal);
    }
    let status = pty.end();
    let signal = std::os::unix::process::ExitStatusExt::signal(&status);
    assert!([Some(libc::SIGINT), Some(libc::SIGTERM)].contains(&signal), "{status}");
    pty.assert_restored();
}

#[test]
fn terminal_size_is_followed() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut pty = in_terminal(&folder.path().join("session"));
    pty.wait_for("\u{2580}");
    assert!(!pty.seen().contains("\x1b[40;"));
    pty.resize(100, 40);
    pty.wait_for("\x1b[40;");
    pty.type_in("q");
    assert_eq!(pty.end().code(), Some(0));
}
