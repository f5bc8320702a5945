//! New games and new shaders, as a newcomer creates them.

use std::fs;
use std::process::Command;

use super::support::{bad, good, pixels, text};

const STRIPES: &str = "examples/tutorial/shaders/stripes.s";

#[test]
fn a_new_game_is_a_crate_that_cargo_takes() {
    let folder = tempfile::tempdir().unwrap();
    let game = folder.path().join("my-game");
    let path = game.to_str().unwrap();
    good(&["new", path, "--path", "."]);
    let metadata = Command::new(env!("CARGO"))
        .args([
            "metadata",
            "--no-deps",
            "--format-version",
            "1",
            "--manifest-path",
        ])
        .arg(game.join("Cargo.toml"))
        .output()
        .unwrap();
    assert!(metadata.status.success(), "{}", text(&metadata.stderr));
    let metadata: serde_json::Value = serde_json::from_slice(&metadata.stdout).unwrap();
    let package = &metadata["packages"][0];
    assert_eq!(package["name"], "my-game");
    let root = fs::canonicalize(".").unwrap();
    for (name, path) in [
        ("cellray", root.clone()),
        ("cellray-play", root.join("play")),
    ] {
        let dependencies = package["dependencies"].as_array().unwrap();
        let found = dependencies.iter().find(|found| found["name"] == name);
        assert_eq!(found.unwrap()["path"], path.to_str().unwrap());
    }
    bad(&["new", path, "--path", "."], &["my-game", "exists"]);
}

#[test]
fn a_new_game_may_come_from_git() {
    let folder = tempfile::tempdir().unwrap();
    let game = folder.path().join("game");
    good(&[
        "new",
        game.to_str().unwrap(),
        "--git",
        "https://example.org/cellray",
    ]);
    let manifest = fs::read_to_string(game.join("Cargo.toml")).unwrap();
    assert!(manifest.contains(r#"cellray-play = { git = "https://example.org/cellray" }"#));
}

#[test]
fn a_new_game_needs_a_name_and_sources() {
    let folder = tempfile::tempdir().unwrap();
    let name = folder.path().join("2d");
    bad(&["new", name.to_str().unwrap()], &["2d: a package's name"]);
    let game = folder.path().join("game");
    let empty = folder.path().to_str().unwrap();
    bad(
        &["new", game.to_str().unwrap(), "--path", empty],
        &["sources are not there"],
    );
    assert!(!game.exists());
}

#[test]
fn a_shader_is_tried_with_and_without_a_program() {
    let folder = tempfile::tempdir().unwrap();
    let file = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let scene = file("striped.nff");
    fs::write(
        &scene,
        "v\nfrom 0 0 5\nat 0 0 0\nup 0 1 0\nangle 40\nhither 0\nresolution 64 36\nl 1 2 3\n\
         f 1 0.5 0.2 0.8 0 1 0 1\n#cellray shader stripes 1.6 0.9\ns 0 0 0 1\n",
    )
    .unwrap();
    let (program, built, linked) = (file("stripes.elf"), file("built.png"), file("linked.png"));
    let (_, stderr) = good(&["shader", "build", STRIPES, "--out", &program]);
    assert!(stderr.contains("stripes"), "{stderr}");
    good(&["render", &scene, "--program", &program, "--out", &built]);
    good(&["render", &scene, "--shader", STRIPES, "--out", &linked]);
    assert_eq!(pixels(built.as_ref()), pixels(linked.as_ref()));
    bad(
        &["render", &scene, "--out", &file("without.png")],
        &["stripes"],
    );
}

#[test]
fn a_shader_that_is_wrong_is_told_by_its_line() {
    let folder = tempfile::tempdir().unwrap();
    let wrong = folder.path().join("wrong.s");
    fs::write(&wrong, "        nop\n        add $3,$3,$4\n").unwrap();
    bad(
        &["shader", "build", wrong.to_str().unwrap()],
        &["wrong.s:2:"],
    );
    bad(&["shader", "build", "no-such.s"], &["no-such.s"]);
}
