//! The settings that a picture carries: with them, `oracle` makes the same picture.

use oracle::{Picture, Settings, compare};

use crate::command_line::support::good;
use crate::prelude::*;

const SIZE: &str = "160x90";

/// Renders a scene, and compares the picture with the reference that its settings ask for. Returns
/// the settings as options.
fn check(scene: &str, options: &[&str]) -> Vec<String> {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("p.png");
    let arguments = ["render", scene, "--size", SIZE, "--out"];
    let out = [path.to_str().unwrap()];
    good(&[&arguments[..], &out, options].concat());
    let settings = Settings::of_png(&path).unwrap();
    compared(scene, options, &path, &settings);
    settings.followed()
}

fn compared(scene: &str, options: &[&str], path: &Path, settings: &Settings) {
    let what = format!("{scene} {options:?}: {:?}", settings.followed());
    let picture = Picture::read_png(path).unwrap();
    let version = concat!("cellray ", env!("CARGO_PKG_VERSION"));
    assert_eq!(settings.software(), Some(version), "{what}");
    assert_eq!(settings.scene(), Some(scene), "{what}");
    assert_eq!(settings.unknown(), [""; 0], "{what}");
    let name = Path::new(env!("CARGO_MANIFEST_DIR")).join(scene);
    let name = if name.is_file() { &name } else { Path::new(scene) };
    let mut of_nff = meshes::load(name).unwrap().scene;
    // Nothing is left to be assumed.
    assert_eq!(settings.assumed(&of_nff), Settings::default(), "{what}");
    settings.place(&mut of_nff.view, path).unwrap();
    let model = settings.model(path).unwrap();
    let size = (picture.width(), picture.height());
    let (reference, _) = model.trace(&of_nff, size).unwrap();
    let found = compare(&picture, &reference).unwrap();
    assert!(found.wrong_fraction < 0.003, "{what}: {found:?}");
    assert!(found.wrong_off_silhouette <= 2, "{what}: {found:?}");
}

#[test]
fn default_settings_are_stored() {
    let whitted =
        ["--antialias 4", "--colour srgb", "--contrast 32", "--model whitted", "--ray-depth 5"];
    assert_eq!(check("scenes/whitted16.nff", &[]), whitted);
    let depth = ["--antialias 4", "--colour linear", "--contrast 32", "--model depth"];
    assert_eq!(check("scenes/paper16.nff", &[]), depth);
    let corners =
        ["--antialias 1", "--colour linear", "--corners", "--model whitted", "--ray-depth 5"];
    assert_eq!(check("scenes/whitted16.nff", &["--corners"]), corners);
}

#[test]
fn settings_are_stored_for_all_scene_kinds() {
    for scene in [
        "scenes/daylight.nff",
        "scenes/shapes.nff",
        "scenes/shaders.nff",
        "scenes/chess.glb",
        "sphereflake:2",
        "tetra:3",
        "terrain:5",
        "gears:1",
        "teapot:4",
    ] {
        check(scene, &[]);
    }
}

#[test]
fn picture_options_are_stored() {
    for options in [
        &["--antialias", "1"][..],
        &["--antialias", "16", "--contrast", "8"],
        &["--contrast", "0"],
        &["--contrast", "200", "--colour", "linear"],
        &["--model", "depth"],
        &["--model", "depth", "--colour", "srgb", "--roll-off"],
        &["--model", "depth", "--corners", "--antialias", "4"],
        &["--ray-depth", "1"],
        &["--ray-depth", "9", "--fresnel"],
        &["--spd-rays", "--no-shadows"],
        &["--roll-off"],
        &["--corners", "--colour", "srgb"],
        &["--corners", "--antialias", "4", "--spd-rays"],
        &["--from=3,-9,4", "--look-at=0,0,1", "--up=0.1,0,1", "--angle=30"],
        &["--quality", "exact"],
        &["--quality", "fast"],
        &["--sphere", "paper"],
    ] {
        check("scenes/whitted16.nff", options);
    }
}

#[test]
fn numbered_pictures_store_eye_of_frame() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("f-%d.png");
    let scene = "scenes/whitted16.nff";
    let options = ["--frames", "0..3", "--turn", "8", "--angle", "35"];
    let arguments = ["render", scene, "--size", SIZE, "--out", out.to_str().unwrap()];
    good(&[&arguments[..], &options].concat());
    for number in 0..3 {
        let path = folder.path().join(format!("f-{number}.png"));
        let settings = Settings::of_png(&path).unwrap();
        compared(scene, &options, &path, &settings);
        let followed = settings.followed();
        let has = |option: &str| followed.iter().any(|set| set.starts_with(option));
        assert!(has("--angle 35"), "{followed:?}");
        assert_eq!(has("--from "), number > 0, "{followed:?}");
    }
}

#[test]
fn picture_of_inspected_frame_has_its_settings() {
    let folder = tempfile::tempdir().unwrap();
    let [page, path] = ["page.html", "p.png"].map(|name| folder.path().join(name));
    let [page, out] = [&page, &path].map(|path| path.to_str().unwrap());
    let scene = "scenes/shadows.nff";
    good(&["render", scene, "--size", SIZE, "--inspect", page, "--out", out]);
    compared(scene, &[], &path, &Settings::of_png(&path).unwrap());
}

/// What leaves the pixels as they are leaves the file as it is.
#[test]
fn other_options_are_not_stored() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("p.png");
    let out = path.to_str().unwrap();
    let file = |options: &[&str]| {
        let arguments = ["render", "scenes/whitted16.nff", "--size", SIZE, "--out", out];
        good(&[&arguments[..], options].concat());
        std::fs::read(&path).unwrap()
    };
    let plain = file(&[]);
    for options in [
        &["--spus", "3"][..],
        &["--split", "slices", "--no-skip"],
        &["--frames", "2", "--retrace", "--timeout", "99", "--verbose"],
        &["--model", "whitted", "--antialias", "4", "--colour", "srgb"],
    ] {
        assert!(file(options) == plain, "{options:?}");
    }
    assert!(file(&["--quality", "exact"]) != plain);
}
