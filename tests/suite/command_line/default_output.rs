//! `cellray render` without options for the picture's file and the messages.

use crate::command_line::support::text;
use crate::prelude::*;

/// Runs `cellray render` in a folder. Returns the exit code and the messages.
fn render(folder: &Path, arguments: &[&str]) -> (Option<i32>, String) {
    let output = Command::new(env!("CARGO_BIN_EXE_cellray"))
        .arg("render")
        .args(arguments)
        .args(["--size", "64x36"])
        .current_dir(folder)
        .output()
        .unwrap();
    assert!(output.stdout.is_empty());
    (output.status.code(), text(&output.stderr))
}

/// A folder, and a scene in it.
fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let scenes = folder.path().join("scenes");
    fs::create_dir(&scenes).unwrap();
    let scene = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes/paper13.nff");
    fs::copy(scene, scenes.join("paper13.nff")).unwrap();
    folder
}

fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).unwrap();
    let names = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap());
    let mut names: Vec<_> = names.filter(|name| name != "scenes").collect();
    names.sort();
    names
}

#[test]
fn picture_has_scene_name_and_is_reported() {
    let folder = folder();
    let scene = "scenes/paper13.nff";
    let (code, said) = render(folder.path(), &[scene]);
    assert_eq!(code, Some(0), "{said}");
    assert!(said.starts_with("cellray: paper13.png: 64x36, "), "{said}");
    assert!(said.contains(" rays in ") && said.contains("frames/s"), "{said}");
    assert_eq!(said.lines().count(), 1, "{said}");
    // Its own picture is replaced, and a message reports that.
    let (code, said) = render(folder.path(), &[scene]);
    assert_eq!(code, Some(0), "{said}");
    assert!(said.starts_with("cellray: paper13.png, replaced: 64x36, "), "{said}");
    let (code, said) = render(folder.path(), &["sphereflake:1"]);
    assert_eq!(code, Some(0), "{said}");
    assert_eq!(names(folder.path()), ["paper13.png", "sphereflake-1.png"]);
}

#[test]
fn picture_of_other_program_is_replaced_only_by_name() {
    let folder = folder();
    let own = folder.path().join("paper13.png");
    let foreign = image::RgbImage::new(3, 2);
    foreign.save(&own).unwrap();
    let scene = "scenes/paper13.nff";
    let (code, said) = render(folder.path(), &[scene]);
    assert_eq!(code, Some(1), "{said}");
    for part in ["paper13.png exists", "--out paper13.png", "--out none"] {
        assert!(said.contains(part), "no {part:?} in {said}");
    }
    assert_eq!(image::open(&own).unwrap().into_rgb8(), foreign);
    let (code, said) = render(folder.path(), &[scene, "--out", "paper13.png"]);
    assert_eq!(code, Some(0), "{said}");
    assert!(said.contains("paper13.png, replaced"), "{said}");
    assert_eq!(image::open(&own).unwrap().width(), 64);
}

#[test]
fn no_picture_is_written_without_request() {
    let folder = folder();
    let page = ["--inspect", "page.html"];
    for options in [&["--out", "none"][..], &["--out", "none", "--corners"]] {
        let arguments = [&["scenes/paper13.nff"], options].concat();
        let (code, said) = render(folder.path(), &arguments);
        assert_eq!(code, Some(0), "{said}");
        assert!(said.starts_with("cellray: no picture: 6"), "{said}");
        assert!(names(folder.path()).is_empty());
    }
    let (code, said) = render(folder.path(), &[&["scenes/paper13.nff"], &page[..]].concat());
    assert_eq!(code, Some(0), "{said}");
    assert_eq!(names(folder.path()), ["page.html"]);
}

#[test]
fn statistics_are_printed_on_request() {
    let folder = folder();
    for option in ["--verbose", "-v"] {
        let arguments = ["scenes/paper13.nff", "--spus", "3", option];
        let (code, said) = render(folder.path(), &arguments);
        assert_eq!(code, Some(0), "{said}");
        for part in ["tests: ", "tiles: ", "SPUs: ", "SPU 2: ", "frame loop: "] {
            let line = format!("\ncellray: {part}");
            assert_eq!(said.matches(&line).count(), 1, "{part:?} in {said}");
        }
        assert_eq!(said.matches("64x36").count(), 1, "{said}");
    }
}
