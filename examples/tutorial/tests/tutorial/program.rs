//! Runs the tutorial's programs without a display.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

pub const BALL: &str = env!("CARGO_BIN_EXE_ball");
pub const STEER: &str = env!("CARGO_BIN_EXE_steer");
pub const STRIPES: &str = env!("CARGO_BIN_EXE_stripes");

/// The size of the pictures that are compared, in pixels.
pub const SIZE: (u32, u32) = (160, 90);

pub fn run(program: &str, folder: &Path, arguments: &[&str]) -> Output {
    Command::new(program)
        .args(arguments)
        .current_dir(folder)
        .env_remove("DISPLAY")
        .env_remove("WAYLAND_DISPLAY")
        .output()
        .unwrap()
}

/// The output of a run that must succeed.
pub fn good(program: &str, folder: &Path, arguments: &[&str]) -> String {
    let output = run(program, folder, arguments);
    let stderr = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(output.status.success(), "{program} {arguments:?}: {stderr}");
    stderr
}

/// Renders pictures of the frames A..B, of [`SIZE`], with one sample a pixel and linear light as
/// the reference has them.
pub fn pictures(program: &str, folder: &Path, frames: &str, more: &[&str]) -> String {
    let size = format!("{}x{}", SIZE.0, SIZE.1);
    let arguments = ["--size", &size, "--frames", frames, "--out", "f-%05d.png"];
    let plain = ["--antialias", "1", "--colour", "linear"];
    good(program, folder, &[&arguments, &plain[..], more].concat())
}

pub fn path(folder: &Path, frame: u32) -> PathBuf {
    folder.join(format!("f-{frame:05}.png"))
}

/// The number of frames in the report of a run.
pub fn frames(stderr: &str) -> u32 {
    let mut counts = stderr.lines().filter_map(|line| {
        let before = line.split_once(" frame(s)")?.0;
        before.rsplit(' ').next()?.parse().ok()
    });
    counts.next_back().unwrap_or_else(|| panic!("no frames: {stderr}"))
}
