//! Typing errors and misremembered names: the messages suggest the right ones.

use crate::command_line::support::{bad, good};

const SCENE: &str = "scenes/paper13.nff";

#[test]
fn numbered_frames_require_number_in_pattern() {
    for (out, name) in [
        (&["--out", "f.png"][..], "--out 'f-%05d.png'"),
        (&["--out", "a.b/f.jpg"], "--out 'a.b/f-%05d.jpg'"),
        (&["--out", "none"], "--out 'paper13-%05d.png'"),
        (&[], "--out 'paper13-%05d.png'"),
    ] {
        let arguments = ["render", SCENE, "--frames", "0..3"];
        let parts = ["--frames 0..3 writes numbered pictures", name, "--frames 3 "];
        bad(&[&arguments[..], out].concat(), &parts);
    }
}

#[test]
fn unknown_generated_scenes_are_refused() {
    for (name, parts) in [
        ("sphereflake", &["sphereflake: this scene needs a level, as in sphereflake:2"][..]),
        ("tetra", &["as in tetra:3"]),
        ("terrain", &["as in terrain:5"]),
        ("sphereflake:", &["is not a whole number from 0 to 6, as in sphereflake:2"]),
        ("sphereflake:-1", &["`-1` is not a whole number from 0 to 6"]),
        ("sphereflake:7", &["5380840 spheres", "the largest level is 6"]),
        ("sphereflake:99", &["over 10^38 spheres", "the largest level is 6"]),
        ("tetra:x", &["`x` is not a whole number from 0 to 9, as in tetra:3"]),
        ("tetra:10", &["the largest level is 9"]),
        ("terrain:12", &["not a whole number from 0 to 11"]),
        ("gears:31", &["the largest size is 30"]),
        ("gears:0", &["gears size `0` is not a whole number from 1"]),
        ("mount:8", &["sizes up to 7"]),
        ("spherflake:2", &["did you mean sphereflake:2?"]),
        ("sphereflaek", &["did you mean sphereflake:2?"]),
        ("Gears", &["did you mean gears?"]),
        ("tea-pot:4", &["did you mean teapot:4?"]),
        ("terain", &["did you mean terrain:5?"]),
        (
            "nothing-like-it",
            &["there is no such file; scenes without a file are sphereflake:2, tetra:3, gears"],
        ),
    ] {
        bad(&["render", name], parts);
    }
}

#[test]
fn missing_scene_files_are_refused() {
    for (name, meant) in [
        ("scenes/whitted61.nff", "did you mean scenes/whitted16.nff?"),
        ("scenes/whitted16", "did you mean scenes/whitted16.nff?"),
        ("scenes/Still-Life.nff", "did you mean scenes/still-life.nff?"),
        ("scenes/chess.gltf", "did you mean scenes/chess.glb?"),
        ("scenes/nothing-like-it.nff", "nothing-like-it.nff: there is no such file\n"),
        ("no/such/folder.nff", "no/such/folder.nff: there is no such file\n"),
    ] {
        bad(&["render", name], &[meant]);
    }
}

#[test]
fn out_of_range_numbers_are_refused() {
    for (option, value, range) in [
        ("--timeout", "-1", "1 to 86400"),
        ("--timeout", "0", "1 to 86400"),
        ("--timeout", "1.5", "1 to 86400"),
        ("--spus", "six", "0\n"),
        ("--ray-depth", "17", "1 to 16"),
        ("--contrast", "256", "0 to 255"),
        ("--turn", "-1", "0\n"),
        ("--fps", "0", "1 to 1000"),
    ] {
        let message = format!("it is not a whole number from {range}");
        bad(&["render", SCENE, option, value], &[option, value, &message]);
    }
}

#[test]
fn similar_words_are_suggested() {
    for (arguments, meant) in [
        (&["rendr", SCENE][..], "'render'"),
        (&["paly", "billiards"], "'play'"),
        (&["render", SCENE, "--qualty", "fast"], "'--quality'"),
        (&["render", SCENE, "--color", "srgb"], "'--colour'"),
        (&["render", SCENE, "--model", "whited"], "'whitted'"),
        (&["render", SCENE, "--sphere", "newtn2"], "'newton2'"),
    ] {
        bad(arguments, &["tip: a similar ", meant]);
    }
}

#[test]
fn formulation_with_quality_is_refused() {
    let render = |options: &[&str]| {
        let arguments = ["render", SCENE, "--size", "64x36", "--out", "none"];
        good(&[&arguments[..], options].concat()).1
    };
    let note = "note: spheres are intersected by --sphere paper, which replaces the formulation of --quality fast";
    let said = render(&["--quality", "fast", "--sphere", "paper"]);
    assert!(said.contains(note), "{said}");
    for options in [&["--sphere", "paper"][..], &["--quality", "fast"]] {
        assert!(!render(options).contains("note"), "{options:?}");
    }
    bad(
        &["render", SCENE, "--quality", "exact", "--sphere", "newton2"],
        &["intersects spheres by newton2", "perpendicular, interpolated, double, paper"],
    );
}

/// Whoever waits for a long trace learns before it that the picture has no place.
#[test]
fn missing_folder_is_reported_before_tracing() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("gone/p.png");
    let missing = format!("there is no folder {}", folder.path().join("gone").display());
    // Without SPUs no frame can be begun.
    let arguments = ["render", SCENE, "--spus", "0", "--out", out.to_str().unwrap()];
    bad(&arguments, &["gone/p.png", &missing]);
}
