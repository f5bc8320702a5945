//! The steered ball: its pictures compared with the reference, with recordings as input.

use std::fmt::Write as _;
use std::fs;
use std::path::Path;

use oracle::whitted::{Options, trace};
use oracle::{Comparison, Picture};

use crate::program::{SIZE, STEER, frames, good, path, pictures, run};

/// The pearls: their positions and colours.
const PEARLS: [([f64; 2], &str); 5] = [
    ([-3.8, 2.2], "0.95 0.25 0.2"),
    ([-3.2, -3.0], "0.95 0.75 0.2"),
    ([1.2, -4.2], "0.3 0.75 0.35"),
    ([4.0, -1.6], "0.2 0.6 0.95"),
    ([2.8, 3.2], "0.75 0.35 0.9"),
];

/// Compares a picture with the expected scene: the ball's position and colour, and the pearls that
/// are left.
fn compare(picture: &Path, ball: [f64; 3], colour: &str, pearls: &[usize]) -> Comparison {
    let [x, y, z] = ball;
    let mut text = format!(
        "v\nfrom 0 5.2 11.2\nat 0 0.2 0.4\nup 0 1 0\nangle 40\nhither 0\nresolution 160 90\n\
         b 0.16 0.2 0.34\n#cellray ambient 0.25 0.25 0.25\nl -7 12 8 1 0.92 0.8\n\
         f 0.8 0.72 0.6 0.5 0.5 60 0 1\n#cellray shader checker 0.1 0.12 0.25 1.25\np 4\n-5 0 5\n5 0 5\n5 0 -5\n-5 0 -5\n\
         f {colour} 0.7 0.3 20 0 1\ns {x} {y} {z} 1\n"
    );
    for &number in pearls {
        let ([x, z], colour) = PEARLS[number];
        writeln!(text, "f {colour} 0.7 0.3 20 0 1\ns {x} 0.5 {z} 0.5").unwrap();
    }
    let scene = scenes::parse(text.as_bytes(), "steer", &scenes::Limits::default()).unwrap();
    let (reference, _) = trace(&scene, SIZE.0, SIZE.1, &Options::default()).unwrap();
    let picture = Picture::read_png(picture).unwrap();
    oracle::compare(&picture, &reference).unwrap()
}

fn is_right(comparison: Comparison) {
    assert_eq!(comparison.wrong_off_silhouette, 0, "{comparison:?}");
    assert!(comparison.wrong_fraction <= 0.005, "{comparison:?}");
}

/// A recording in which keys go down (`+`) and up (`-`) before frames of 40 ms each.
fn recording(folder: &Path, frames: u32, keys: &[(u32, &str)]) {
    let mut text = String::from(
        "{\"format\":\"cellray recording\",\"version\":1,\"game\":\"steer\",\"seed\":0,\"size\":[160,90]}\n",
    );
    for frame in 0..frames {
        let step = if frame == 0 { 0 } else { 40_000_000 };
        let events: Vec<_> = keys
            .iter()
            .filter(|(at, _)| *at == frame)
            .map(|(_, key)| {
                let (sign, name) = key.split_at(1);
                format!("{{\"key\":{{\"key\":\"{name}\",\"down\":{}}}}}", sign == "+")
            })
            .collect();
        writeln!(text, "{{\"step\":{step},\"events\":[{}]}}", events.join(",")).unwrap();
    }
    fs::write(folder.join("session"), text).unwrap();
}

const REPLAY: [&str; 2] = ["--replay", "session"];

#[test]
fn first_picture_equals_reference() {
    let folder = tempfile::tempdir().unwrap();
    pictures(STEER, folder.path(), "0..2", &[]);
    let first = path(folder.path(), 0);
    is_right(compare(&first, [0.0, 1.0, 0.0], "0.9 0.9 0.9", &[0, 1, 2, 3, 4]));
    assert!(fs::read(&first).unwrap() == fs::read(path(folder.path(), 1)).unwrap());
    // The comparison works: it detects a missing pearl.
    let other = compare(&first, [0.0, 1.0, 0.0], "0.9 0.9 0.9", &[0, 1, 2, 3]);
    assert!(other.wrong_off_silhouette > 20, "{other:?}");
}

#[test]
fn keys_roll_ball_and_pearl_gives_its_colour() {
    let folder = tempfile::tempdir().unwrap();
    recording(folder.path(), 121, &[(1, "+right"), (60, "-right"), (60, "+up")]);
    for frames in ["59..60", "120..121"] {
        pictures(STEER, folder.path(), frames, &REPLAY);
    }
    let right = path(folder.path(), 59);
    is_right(compare(&right, [4.0, 1.0, 0.0], "0.9 0.9 0.9", &[0, 1, 2, 3, 4]));
    let far = path(folder.path(), 120);
    is_right(compare(&far, [4.0, 1.0, -4.0], "0.2 0.6 0.95", &[0, 1, 2, 4]));
}

#[test]
fn space_key_makes_ball_jump() {
    let folder = tempfile::tempdir().unwrap();
    recording(folder.path(), 40, &[(1, "+space")]);
    for frames in ["6..7", "39..40"] {
        pictures(STEER, folder.path(), frames, &REPLAY);
    }
    // The speed is 8 at first, and 0.8 less in every further frame.
    let height: f64 = 1.0 + (0..6).map(|frame| 0.04 * (8.0 - 0.8 * f64::from(frame))).sum::<f64>();
    let all = [0, 1, 2, 3, 4];
    is_right(compare(&path(folder.path(), 6), [0.0, height, 0.0], "0.9 0.9 0.9", &all));
    is_right(compare(&path(folder.path(), 39), [0.0, 1.0, 0.0], "0.9 0.9 0.9", &all));
}

#[test]
fn still_picture_is_traced_once() {
    let folder = tempfile::tempdir().unwrap();
    let stderr =
        good(STEER, folder.path(), &["--display", "none", "--frames", "30", "--size", "160x90"]);
    assert_eq!(frames(&stderr), 30);
    assert!(stderr.contains("30 frame(s), 1 traced"), "{stderr}");
}

#[test]
fn session_is_replayed() {
    let folder = tempfile::tempdir().unwrap();
    pictures(STEER, folder.path(), "0..3", &["--record", "session"]);
    let before = fs::read(path(folder.path(), 2)).unwrap();
    fs::remove_file(path(folder.path(), 2)).unwrap();
    // The run ends when the recording does.
    let stderr = pictures(STEER, folder.path(), "2..100", &REPLAY);
    assert!(stderr.contains("1 picture(s) written"), "{stderr}");
    assert!(fs::read(path(folder.path(), 2)).unwrap() == before);
    // A recording is never overwritten.
    let arguments = ["--display", "none", "--frames", "1", "--record", "session"];
    let output = run(STEER, folder.path(), &arguments);
    assert!(!output.status.success());
}

#[test]
fn replayed_game_is_won() {
    let folder = tempfile::tempdir().unwrap();
    let recorded = concat!(env!("CARGO_MANIFEST_DIR"), "/played.session");
    let arguments = ["--display", "none", "--size", "64x36", "--replay", recorded];
    let stderr = good(STEER, folder.path(), &arguments);
    let lines = fs::read_to_string(recorded).unwrap().lines().count();
    // One line is the session's. The session ended by itself with the last pearl.
    assert_eq!(frames(&stderr) as usize + 1, lines);
}
