//! Runs the command line and expects success or failure.

use crate::prelude::*;
use std::process::Output;

/// A view, and a white material.
pub const VIEW: &str = "v\nfrom 0 0 9\nat 0 0 0\nup 0 1 0\nangle 40\nhither 1\nresolution 32 24\n\
                    f 1 1 1 1 0 0 0 1\n";

/// Runs cellray in the repository's folder.
pub fn cellray(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_cellray"))
        .args(arguments)
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .output()
        .unwrap()
}

/// Converts output to text.
pub fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

/// Runs cellray, which must succeed. Returns standard output and standard error.
pub fn good(arguments: &[&str]) -> (String, String) {
    let output = cellray(arguments);
    let (out, err) = (text(&output.stdout), text(&output.stderr));
    assert!(output.status.success(), "{arguments:?}: {err}");
    (out, err)
}

/// Runs cellray, which must fail, write nothing to standard output and print all `parts`.
pub fn bad(arguments: &[&str], parts: &[&str]) {
    let output = cellray(arguments);
    let err = text(&output.stderr);
    assert!(!output.status.success(), "{arguments:?} succeeded");
    assert!(output.status.code().is_some(), "{arguments:?} died: {err}");
    assert!(output.stdout.is_empty(), "{arguments:?}: {}", text(&output.stdout));
    assert!(!err.contains("panicked"), "{err}");
    for part in parts {
        assert!(err.contains(part), "{arguments:?}: no {part:?} in: {err}");
    }
}

/// The pixels of a picture, whose file has its settings, too.
pub fn pixels(picture: &Path) -> RgbImage {
    image::open(picture).unwrap().into_rgb8()
}

/// Renders a scene, which must fail, print all `parts` and leave no picture.
pub fn bad_scene(scene: &str, parts: &[&str]) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("bad.nff");
    fs::write(&path, scene).unwrap();
    let picture = folder.path().join("picture.png");
    bad(&["render", path.to_str().unwrap(), "--out", picture.to_str().unwrap()], parts);
    assert!(!picture.exists(), "a picture of {scene:?}");
}
