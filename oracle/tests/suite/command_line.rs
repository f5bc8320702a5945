//! The program `oracle` from outside.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use oracle::Picture;

/// Runs `oracle` in `folder`.
fn oracle(folder: &Path, arguments: &[&str]) -> Output {
    let program = env!("CARGO_BIN_EXE_oracle");
    Command::new(program)
        .args(arguments)
        .current_dir(folder)
        .output()
        .expect("oracle runs")
}

fn text(bytes: &[u8]) -> &str {
    str::from_utf8(bytes).expect("UTF-8")
}

/// A folder with a picture of the sphereflake, one byte of which is wrong by 5.
fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    let done = oracle(
        folder.path(),
        &[
            "render",
            "sphereflake:1",
            "--size",
            "64x48",
            "--out",
            "a.png",
        ],
    );
    assert!(done.status.success(), "{}", text(&done.stderr));
    assert!(done.stdout.is_empty());
    let file = folder.path().join("a.png");
    let mut picture = Picture::read_png(&file).expect("a PNG");
    assert_eq!((picture.width(), picture.height()), (64, 48));
    // The upper left corner shows the background, far from every sphere.
    assert_eq!(picture.pixels()[0], [20, 92, 192]);
    picture.pixels_mut()[0][2] -= 5;
    picture.write_png(&file).expect("written");
    folder
}

#[test]
fn a_comparison_as_json_has_exactly_its_fields() {
    let folder = folder();
    let done = oracle(
        folder.path(),
        &[
            "compare",
            "a.png",
            "sphereflake:1",
            "--json",
            "--diff",
            "d.png",
        ],
    );
    assert!(done.status.success(), "{}", text(&done.stderr));
    assert!(text(&done.stderr).contains("d.png: the difference, 16 times amplified"));
    assert!(
        text(&done.stderr)
            .contains("sphereflake:1:13: polygons are not drawn by depth shading (1 in this file)")
    );
    let found: serde_json::Value = serde_json::from_slice(&done.stdout).expect("JSON");
    let expected = serde_json::json!({
        "wrong_pixels": 1,
        "wrong_fraction": 1.0 / 3072.0,
        "wrong_off_silhouette": 1,
        "max_error": 5,
        "max_error_off_silhouette": 5,
        "mean_error": 5.0 / 9216.0,
    });
    assert_eq!(found, expected);
    let difference = Picture::read_png(&folder.path().join("d.png")).expect("a PNG");
    assert_eq!(difference.pixels()[0], [0, 0, 80]);
    assert!(
        difference.pixels()[1..]
            .iter()
            .all(|pixel| *pixel == [0; 3])
    );
}

#[test]
fn a_comparison_as_text() {
    let folder = folder();
    let done = oracle(folder.path(), &["compare", "a.png", "sphereflake:1"]);
    assert!(done.status.success());
    assert_eq!(
        text(&done.stdout),
        "wrong pixels   1 of 3072 (0.0326 %), 1 off silhouettes\n\
         largest error  5/255, 5/255 off silhouettes\n\
         mean error     0.0005/255\n"
    );
}

#[test]
fn errors_name_their_file_and_exit_1() {
    let folder = folder();
    fs::write(folder.path().join("bad.nff"), "v\nfrom 0 0 x\n").expect("written");
    fs::write(folder.path().join("bad.png"), "no PNG").expect("written");
    let grey = image::GrayImage::new(4, 4);
    grey.save(folder.path().join("grey.png")).expect("written");
    let cases: [(&[&str], &str); 8] = [
        (
            &["compare", "missing.png", "sphereflake:1"],
            "missing.png: ",
        ),
        (&["compare", "bad.png", "sphereflake:1"], "bad.png: "),
        (
            &["compare", "grey.png", "sphereflake:1"],
            "grey.png: the PNG has pixels of the kind L8",
        ),
        (
            &["compare", "a.png", "bad.nff"],
            "bad.nff:2: from z `x` is not a number",
        ),
        (&["compare", "a.png", "missing.nff"], "missing.nff: "),
        (
            &["compare", "a.png", "sphereflake:1", "--diff", "no/d.png"],
            "no/d.png: ",
        ),
        (
            &["render", "sphereflake:9", "--out", "b.png"],
            "435848050 spheres",
        ),
        (
            &["render", "tetra:12", "--out", "b.png"],
            "67108864 polygons",
        ),
    ];
    for (arguments, message) in cases {
        let done = oracle(folder.path(), arguments);
        assert_eq!(done.status.code(), Some(1), "{arguments:?}");
        assert!(done.stdout.is_empty(), "{arguments:?}");
        let said = text(&done.stderr);
        assert!(
            said.contains("oracle: ") && said.contains(message),
            "{arguments:?}: {said}"
        );
    }
}

#[test]
fn sizes_that_are_none_are_a_wrong_use() {
    let folder = tempfile::tempdir().expect("a folder");
    let form = "a size is written as WIDTHxHEIGHT";
    let limit = "each side must be 1 to 8192";
    for (size, message) in [
        ("64", form),
        ("64x", form),
        ("64x-1", form),
        ("-5x10", form),
        ("64x48x3", form),
        ("0x48", limit),
        ("8193x1", limit),
        ("16384x16384", limit),
        ("99999999999x1", limit),
    ] {
        let arguments = ["render", "sphereflake:1", "--size", size, "--out", "b.png"];
        let done = oracle(folder.path(), &arguments);
        assert_eq!(done.status.code(), Some(2), "{size}");
        let said = text(&done.stderr);
        assert!(
            said.contains("--size <WxH>") && said.contains(message),
            "{said}"
        );
    }
}

#[test]
fn the_help_has_examples() {
    let done = oracle(Path::new("."), &["--help"]);
    assert!(done.status.success());
    assert!(text(&done.stdout).contains("oracle compare frame.png scenes/paper16.nff"));
}

#[test]
fn whitteds_model_counts_its_rays_and_compares() {
    let folder = tempfile::tempdir().expect("a folder");
    let scene = ["sphereflake:1", "--model", "whitted", "--ray-depth", "3"];
    let size = ["--size", "64x48", "--out", "w.png", "--stats", "--corners"];
    let done = oracle(folder.path(), &[&["render"], &scene[..], &size].concat());
    assert!(done.status.success(), "{}", text(&done.stderr));
    // Everything is drawn, so nothing is told but the picture's name and share.
    assert_eq!(text(&done.stderr), "w.png: 64x48, objects cover 100.0 %\n");
    let found: serde_json::Value = serde_json::from_slice(&done.stdout).expect("JSON");
    let count = |name: &str| found[name].as_u64().expect("a count");
    assert_eq!(count("eye"), 65 * 49);
    assert_eq!(count("eye_hit"), count("eye"));
    assert_eq!(
        count("eye") + count("reflected") + count("refracted"),
        count("hit") + count("background")
    );
    assert!(count("shadow") > count("hit"));

    let compare = |options: &[&str]| {
        let arguments = [&["compare", "w.png", "--json"], &scene[..], options].concat();
        let done = oracle(folder.path(), &arguments);
        assert!(done.status.success(), "{}", text(&done.stderr));
        let found: serde_json::Value = serde_json::from_slice(&done.stdout).expect("JSON");
        found["wrong_pixels"].as_u64().expect("a count")
    };
    assert_eq!(compare(&["--corners"]), 0);
    assert!(compare(&[]) > 100);
}

#[test]
fn what_depth_shading_has_no_use_for_is_a_wrong_use() {
    let folder = tempfile::tempdir().expect("a folder");
    let base = ["render", "sphereflake:1", "--out", "b.png"];
    for option in [
        &["--stats"][..],
        &["--corners"],
        &["--fresnel"],
        &["--spd-rays"],
        &["--ray-depth", "3"],
    ] {
        let done = oracle(folder.path(), &[&base, option].concat());
        assert_eq!(done.status.code(), Some(2), "{option:?}");
        let message = format!("{} needs --model whitted", option[0]);
        assert!(text(&done.stderr).contains(&message), "{option:?}");
    }
    for depth in ["0", "17", "-1", "x"] {
        let option = ["--model", "whitted", "--ray-depth", depth];
        let done = oracle(folder.path(), &[&base[..], &option].concat());
        assert_eq!(done.status.code(), Some(2), "{depth}");
        assert!(text(&done.stderr).contains("--ray-depth <N>"), "{depth}");
    }
}
