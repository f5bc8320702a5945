//! The options of Whitted's model, and scenes that do not fit.

use crate::command_line::support::{VIEW, bad_scene, good, pixels};
use crate::prelude::*;

#[test]
fn entities_undrawn_by_depth_shading_are_listed() {
    let arguments = ["render", "sphereflake:1", "--size", "16x16", "--out", "none"];
    let (_, err) = good(&[&arguments[..], &["--model", "depth"]].concat());
    for part in [
        "polygons are not drawn by depth shading (1",
        "lights are not drawn by depth shading (3",
        "sphereflake",
    ] {
        assert!(err.contains(part), "no {part:?} in: {err}");
    }
    for model in [&[][..], &["--model", "whitted"], &["--model", "scene"]] {
        let (_, err) = good(&[&arguments[..], model].concat());
        assert!(!err.contains("not drawn"), "{model:?}: {err}");
    }
    // A scene without lights uses the paper's model, unless the command line asks for Whitted's.
    let scene = format!("{VIEW}p 3\n0 0 0\n1 0 0\n0 1 0\n");
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("dark.nff");
    fs::write(&path, scene).unwrap();
    let path = path.to_str().unwrap();
    let (_, err) = good(&["render", path, "--out", "none"]);
    assert!(err.contains("dark.nff:9: polygons are not drawn"), "{err}");
    let (_, err) = good(&["render", path, "--out", "none", "--model", "whitted"]);
    assert!(!err.contains("not drawn"), "{err}");
}

/// Renders with options. Returns the picture and its statistics.
fn traced(scene: &str, options: &[&str]) -> (RgbImage, serde_json::Value) {
    let folder = tempfile::tempdir().unwrap();
    let picture = folder.path().join("p.png");
    let arguments = ["render", scene, "--size", "96x54", "--stats", "-", "--out"];
    let name = [picture.to_str().unwrap()];
    let (out, _) = good(&[&arguments[..], &name, options].concat());
    (pixels(&picture), serde_json::from_str(&out).unwrap())
}

/// The numbers of rays under the names of the Standard Procedural Databases. Checks their sum.
fn rays(stats: &serde_json::Value) -> [u64; 7] {
    let names = ["eye", "eye_hit", "reflected", "refracted", "shadow", "hit", "background"];
    let rays = names.map(|name| stats["rays"][name].as_u64().unwrap());
    let [eye, eye_hit, reflected, refracted, _, hit, background] = rays;
    assert_eq!(eye + reflected + refracted, hit + background);
    assert!(eye_hit <= hit && eye_hit <= eye);
    rays
}

#[test]
fn each_whitted_option_has_its_effect() {
    let scene = "scenes/whitted16.nff";
    let linear = ["--antialias", "1", "--colour", "linear"];
    let one = |options: &[&str]| traced(scene, &[&linear[..], options].concat());
    let (plain, stats) = one(&[]);
    let [eye, eye_hit, reflected, refracted, shadow, ..] = rays(&stats);
    assert_eq!(eye, 96 * 54);
    assert!(reflected > eye_hit / 2 && refracted > 100 && shadow > eye_hit);

    let (picture, stats) = one(&["--ray-depth", "1"]);
    assert_eq!(rays(&stats)[1..4], [eye_hit, 0, 0]);
    assert!(picture != plain);
    let (_, stats) = one(&["--ray-depth", "16"]);
    let deep = rays(&stats);
    assert!(deep[2] > reflected && deep[3] > refracted);
    assert!(one(&["--ray-depth", "5"]).0 == plain);

    let (picture, stats) = one(&["--no-shadows"]);
    let [_, _, bounced, _, shadows, ..] = rays(&stats);
    assert_eq!((bounced, shadows), (reflected, 0));
    assert!(picture != plain);

    let (picture, stats) = one(&["--fresnel"]);
    assert_eq!(rays(&stats)[3], refracted);
    assert!(picture != plain);

    let (picture, _) = one(&["--check-shaders"]);
    assert!(picture == plain);

    // The corners have one sample by themselves.
    let (picture, stats) = traced(scene, &["--corners"]);
    assert_eq!(rays(&stats)[0], 97 * 55);
    assert!(picture == traced(scene, &["--corners", "--colour", "linear"]).0);
    assert_eq!(picture.dimensions(), (96, 54));
    assert!(picture != plain);

    let (picture, stats) = one(&["--model", "depth"]);
    assert_eq!(rays(&stats)[2..5], [0, 0, 0]);
    assert!(picture != plain);

    // Antialiased, in sRGB.
    let (usual, stats) = traced(scene, &[]);
    assert!(rays(&stats)[0] > 96 * 54 * 11 / 10);
    assert!(usual != plain);
    let said = ["--antialias", "4", "--colour", "srgb"];
    assert!(traced(scene, &said).0 == usual);
    assert!(traced(scene, &linear[..2]).0 != plain);
}

#[test]
fn invisible_rays_are_traced_on_request() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("glass.nff");
    // This glass reflects nothing.
    let glass = "l 9 9 9\nf 1 1 1 0.2 0 0 0.8 1.1\ns 0 0 0 1\n";
    fs::write(&path, format!("{VIEW}{glass}")).unwrap();
    let path = path.to_str().unwrap();
    let (plain, seen) = traced(path, &[]);
    let (picture, all) = traced(path, &["--spd-rays"]);
    let [eye, eye_hit, reflected, refracted, ..] = rays(&seen);
    assert!(eye_hit > 0);
    let [all_eye, all_hit, all_reflected, all_refracted, ..] = rays(&all);
    assert_eq!((all_eye, all_hit), (eye, eye_hit));
    assert!(all_reflected > 2 * reflected && all_refracted > refracted);
    assert!(picture == plain);
}

#[test]
fn shapes_other_than_spheres_are_drawn() {
    let (_, stats) = traced("tetra:3", &[]);
    let [_, eye_hit, reflected, refracted, shadow, ..] = rays(&stats);
    assert!(eye_hit > 96 * 54 / 10 && shadow > eye_hit / 2);
    assert_eq!((reflected, refracted), (0, 0));
}

#[test]
fn scene_with_too_many_lights_names_first_of_them() {
    // Objects that don't fit are streamed from main memory; lights are not.
    let many = "l 0 0 9\n".repeat(65);
    bad_scene(&format!("{VIEW}{many}s 0 0 0 1\n"), &["bad.nff:73: more than 64 lights"]);
}
