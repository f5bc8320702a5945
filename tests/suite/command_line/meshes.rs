//! Mesh files on the command line.

use crate::command_line::support::{bad, good, pixels};
use crate::prelude::*;

const OBJ: &str = "mtllib gone.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";

/// Renders a small picture with options, and returns it with the messages.
fn render(options: &[&str]) -> (RgbImage, String) {
    let folder = tempfile::tempdir().unwrap();
    let [mesh, picture] = ["square.obj", "square.png"].map(|name| folder.path().join(name));
    fs::write(&mesh, OBJ).unwrap();
    let names = [&mesh, &picture].map(|path| path.to_str().unwrap());
    let arguments = ["render", names[0], "--size", "32x32", "--out", names[1]];
    let (_, messages) = good(&[&arguments[..], options].concat());
    (pixels(&picture), messages)
}

#[test]
fn mesh_is_rendered_with_notes_on_missing_parts() {
    let (_, messages) = render(&[]);
    assert!(messages.contains("note: "), "{messages}");
    assert!(messages.contains("gone.mtl"), "{messages}");
}

#[test]
fn view_can_be_replaced() {
    let (own, _) = render(&[]);
    let (above, _) = render(&["--from", "0.5,0.5,4", "--look-at", "0.5,0.5,-1"]);
    let (turned, _) = render(&["--from", "0.5,0.5,4", "--look-at", "0.5,0.5,0", "--up=1,1,0"]);
    let (narrow, _) = render(&["--angle", "20"]);
    assert!(own != above && above != turned && own != narrow);
    let back = ["--from", "0.5,0.5,-4", "--look-at", "0.5,0.5,0"];
    let (back, _) = render(&back);
    let (away, _) = render(&["--look-at", "100,0,0", "--from", "50,0,0"]);
    assert!(back != away, "the square is visible from both sides");
}

#[test]
fn bad_meshes_and_views_are_errors() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("bad.obj");
    fs::write(&path, OBJ.replace("f 1 2", "f 1 9")).unwrap();
    let name = path.to_str().unwrap();
    bad(&["render", name], &["bad.obj:6: a face has the vertex 9, but there are only 4"]);
    bad(&["render", "none.glb"], &["none.glb"]);
    for wrong in ["1,2", "1,2,3,4", "1,x,3", "1,2,nan", "1,2,3,x"] {
        let option = format!("--look-at={wrong}");
        bad(&["render", name, &option], &["--look-at", "three finite numbers"]);
    }
    let square = folder.path().join("square.obj");
    fs::write(&square, OBJ).unwrap();
    let name = square.to_str().unwrap();
    let same = ["render", name, "--from", "1,1,1", "--look-at", "1,1,1"];
    bad(&same, &["square.obj", "the same point"]);
}
