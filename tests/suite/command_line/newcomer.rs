//! New games and new shaders, as a newcomer creates them.

use std::collections::BTreeSet;

use super::support::{bad, good, pixels, text};
use crate::prelude::*;

const STRIPES: &str = "examples/tutorial/shaders/stripes.s";

#[test]
fn new_game_is_accepted_by_cargo() {
    let folder = tempfile::tempdir().unwrap();
    let game = folder.path().join("my-game");
    let path = game.to_str().unwrap();
    good(&["new", path, "--path", "."]);
    let metadata = Command::new(env!("CARGO"))
        .args(["metadata", "--no-deps", "--format-version", "1", "--manifest-path"])
        .arg(game.join("Cargo.toml"))
        .output()
        .unwrap();
    assert!(metadata.status.success(), "{}", text(&metadata.stderr));
    let metadata: serde_json::Value = serde_json::from_slice(&metadata.stdout).unwrap();
    let package = &metadata["packages"][0];
    assert_eq!(package["name"], "my-game");
    let root = fs::canonicalize(".").unwrap();
    for (name, path) in [("cellray", root.clone()), ("cellray-play", root.join("play"))] {
        let dependencies = package["dependencies"].as_array().unwrap();
        let found = dependencies.iter().find(|found| found["name"] == name);
        assert_eq!(found.unwrap()["path"], path.to_str().unwrap());
    }
    bad(&["new", path, "--path", "."], &["my-game", "exists"]);
}

/// A game is built of what cellray is tested with, and its profile names nothing else: cargo would
/// warn of it.
#[test]
fn new_game_has_versions_and_profile_of_workspace() {
    let folder = tempfile::tempdir().unwrap();
    let game = folder.path().join("game");
    good(&["new", game.to_str().unwrap(), "--path", "."]);
    let tree = Command::new(env!("CARGO"))
        .args(["tree", "--offline", "--prefix", "none", "--edges", "normal,build"])
        .arg("--manifest-path")
        .arg(game.join("Cargo.toml"))
        .output()
        .unwrap();
    assert!(tree.status.success(), "{}", text(&tree.stderr));
    let lock = fs::read_to_string("Cargo.lock").unwrap();
    let tree = text(&tree.stdout);
    let mut names = BTreeSet::new();
    for line in tree.lines().skip(1).filter(|line| !line.is_empty()) {
        let mut words = line.split(' ');
        let (name, version) = (words.next().unwrap(), words.next().unwrap());
        let version = version.trim_start_matches('v');
        let entry = format!("name = \"{name}\"\nversion = \"{version}\"\n");
        assert!(lock.contains(&entry), "{name} {version}");
        names.insert(name);
    }
    let profile = fs::read_to_string("ppu/cli/new/profile.toml").unwrap();
    let workspace = fs::read_to_string("Cargo.toml").unwrap();
    let (_, workspace) = workspace.split_once("[profile.release.package]").unwrap();
    let entries = profile.lines().filter_map(|line| line.split_once(" = { opt-level = "));
    let mut count = 0;
    for (name, level) in entries.filter(|(name, _)| *name != "\"*\"") {
        assert!(names.contains(name), "no game is built of {name}");
        let in_workspace = workspace
            .lines()
            .find_map(|line| line.strip_prefix(name)?.strip_prefix(" = { opt-level = "));
        // The workspace's own crates have the profile's level there.
        let expected = in_workspace.map_or("3", |level| &level[..1]);
        assert_eq!(&level[..1], expected, "{name}");
        count += 1;
    }
    assert!(count > 20, "{count}");
}

#[test]
fn new_game_may_depend_on_git() {
    let folder = tempfile::tempdir().unwrap();
    let game = folder.path().join("game");
    good(&["new", game.to_str().unwrap(), "--git", "https://example.org/cellray"]);
    let manifest = fs::read_to_string(game.join("Cargo.toml")).unwrap();
    assert!(manifest.contains(r#"cellray-play = { git = "https://example.org/cellray" }"#));
}

#[test]
fn new_game_requires_name_and_sources() {
    let folder = tempfile::tempdir().unwrap();
    let name = folder.path().join("2d");
    bad(&["new", name.to_str().unwrap()], &["2d: a package's name"]);
    let game = folder.path().join("game");
    let empty = folder.path().to_str().unwrap();
    bad(&["new", game.to_str().unwrap(), "--path", empty], &["sources are not there"]);
    assert!(!game.exists());
}

#[test]
fn shader_is_tested_with_and_without_program() {
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
    bad(&["render", &scene, "--out", &file("without.png")], &["stripes"]);
}

#[test]
fn invalid_shader_is_named_with_line() {
    let folder = tempfile::tempdir().unwrap();
    let wrong = folder.path().join("wrong.s");
    fs::write(&wrong, "        nop\n        add $3,$3,$4\n").unwrap();
    bad(&["shader", "build", wrong.to_str().unwrap()], &["wrong.s:2:"]);
    bad(&["shader", "build", "no-such.s"], &["no-such.s"]);
}

#[test]
fn shader_is_scheduled_in_game_folder() {
    let folder = tempfile::tempdir().unwrap();
    let game = folder.path().join("game");
    good(&["new", game.to_str().unwrap(), "--template", "stripes"]);
    let typed = |command: &str| {
        let words: Vec<&str> = command.split_whitespace().collect();
        let output = Command::new(env!("CARGO_BIN_EXE_cellray"))
            .args(&words[1..])
            .current_dir(&game)
            .output()
            .unwrap();
        let stderr = text(&output.stderr);
        assert!(output.status.success(), "{command}: {stderr}");
        stderr
    };
    // The tutorial's own command and its summary of the result.
    let tutorial = fs::read_to_string("docs/tutorial.md").unwrap();
    let mut lines = tutorial.lines().map(str::trim);
    let command = lines.find(|line| line.starts_with("cellray shader schedule"));
    let stderr = typed(command.unwrap());
    let summary = lines.find(|line| line.starts_with("cellray: shader_stripes:")).unwrap();
    assert!(stderr.lines().any(|line| line == summary), "{stderr}");
    // The rings are written by the macro `shader`, whose code the scheduler can't replace.
    let rings = "examples/shader/shaders/rings.s";
    let out = folder.path().join("rings.s");
    bad(
        &["shader", "schedule", rings, "-o", out.to_str().unwrap()],
        &["rings.s: no function", "shader_entry"],
    );
    assert!(!out.exists());

    // The schedule shades as the plain source does.
    fs::write(
        game.join("striped.nff"),
        "v\nfrom 0 0 5\nat 0 0 0\nup 0 1 0\nangle 40\nhither 0\nresolution 64 36\nl 1 2 3\n\
         f 1 0.5 0.2 0.8 0 1 0 1\n#cellray shader stripes 1.6 0.9\ns 0 0 0 1\n",
    )
    .unwrap();
    typed("cellray render striped.nff --shader shaders/stripes.s --out plain.png");
    typed("cellray render striped.nff --shader scheduled.s --check-shaders --out scheduled.png");
    let picture = |name| pixels(&game.join(name));
    assert_eq!(picture("plain.png"), picture("scheduled.png"));
}

#[test]
fn schedule_does_not_replace_its_plain_source() {
    let folder = tempfile::tempdir().unwrap();
    let source = folder.path().join("stripes.s");
    fs::copy(STRIPES, &source).unwrap();
    let path = source.to_str().unwrap();
    bad(
        &["shader", "schedule", path, "--out", path],
        &["stripes.s", "would replace its plain source"],
    );
    assert_eq!(fs::read(&source).unwrap(), fs::read(STRIPES).unwrap());
}

#[test]
fn shader_loop_report_has_cycles_of_a_pass() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("faster.s");
    let out = out.to_str().unwrap();
    let (_, stderr) = good(&["shader", "schedule", "examples/spu/dot.s", "-o", out]);
    assert!(stderr.contains("loop next: 31 cycles a pass, 6 scheduled"), "{stderr}");
    bad(&["shader", "schedule", "no-such.s", "-o", out], &["no-such.s"]);
}
