//! The ball: its pictures compared with the reference, and the length of its program.

use oracle::Picture;

use crate::program::{BALL, SIZE, frames, good, path, pictures};

#[test]
fn ball_position_equals_formula() {
    let folder = tempfile::tempdir().unwrap();
    pictures(BALL, folder.path(), "0..13", &[]);
    let mut seen = Vec::new();
    for frame in [0, 5, 12] {
        let part = f64::from(frame) / 25.0;
        let height = 16.0 * part * (1.0 - part) - 2.0;
        let scene = format!(
            "v\nfrom 0 0 10\nat 0 0 0\nup 0 1 0\nangle 40\nhither 0\nresolution 160 90\n\
             #cellray daylight\n\
             f 0.9 0.2 0.1 1 0 0 0 0\ns 0 {height} 0 1\n"
        );
        let scene = scenes::parse(scene.as_bytes(), "ball", &scenes::Limits::default()).unwrap();
        let options = oracle::whitted::Options::default();
        let (reference, _) = oracle::whitted::trace(&scene, SIZE.0, SIZE.1, &options).unwrap();
        let picture = Picture::read_png(&path(folder.path(), frame)).unwrap();
        let comparison = oracle::compare(&picture, &reference).unwrap();
        assert_eq!(comparison.wrong_off_silhouette, 0, "{frame}: {comparison:?}");
        assert!(comparison.wrong_pixels <= 2, "{frame}: {comparison:?}");
        seen.push(picture);
    }
    assert!(seen[0] != seen[1] && seen[1] != seen[2]);
}

#[test]
fn runs_without_display() {
    let folder = tempfile::tempdir().unwrap();
    let stderr = good(BALL, folder.path(), &["--display", "none", "--frames", "3"]);
    assert_eq!(frames(&stderr), 3);
}

#[test]
fn source_has_under_twenty_lines() {
    let source = include_str!("../../src/bin/ball.rs");
    let is_code = |line: &&str| !line.trim().is_empty() && !line.starts_with("//!");
    let lines = source.lines().filter(is_code).count();
    assert!((10..20).contains(&lines), "{lines} lines");
}
