//! Runs the example and checks its picture, and its message without a path for the picture.

use std::process::Command;

#[test]
fn log_has_rings() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("still_life.png");
    let status = Command::new(env!("CARGO_BIN_EXE_shader-example")).arg(&path).status().unwrap();
    assert!(status.success());
    let picture = image::open(path).unwrap().into_rgb8();
    assert_eq!((picture.width(), picture.height()), (640, 480));
    // Across the front of the log, from its edge to the glass.
    let row: Vec<_> = (185..300).map(|x| picture.get_pixel(x, 300).0).collect();
    assert!(row.iter().all(|[red, green, blue]| red > green && green > blue));
    let bright: Vec<bool> = row.iter().map(|[red, ..]| *red > 150).collect();
    let edges = bright.windows(2).filter(|pair| pair[0] != pair[1]).count();
    assert!(edges >= 5, "{edges} edges of rings: {row:?}");
}

#[test]
fn missing_path_is_an_error() {
    let output = Command::new(env!("CARGO_BIN_EXE_shader-example")).output().unwrap();
    assert!(!output.status.success());
    let error = String::from_utf8_lossy(&output.stderr);
    assert!(error.contains("usage: shader-example PICTURE.png"), "{error}");
}
