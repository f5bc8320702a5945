//! The choice of formulations: those that are shipped can draw, and the output names the chosen
//! ones.

use protocol::formulation::{self, Formulations, SPHERES, TRIANGLES};

use crate::command_line::support::{bad, good};
use crate::prelude::*;

/// Renders a scene with options. Returns the picture, the formulations in the statistics, and the
/// messages.
fn rendered(scene: &str, options: &[&str]) -> (RgbImage, [String; 2], String) {
    let folder = tempfile::tempdir().unwrap();
    let picture = folder.path().join("p.png");
    let arguments = ["render", scene, "--size", "96x54", "--stats", "-", "--out"];
    let name = [picture.to_str().unwrap()];
    let (out, err) = good(&[&arguments[..], &name, options].concat());
    let stats: serde_json::Value = serde_json::from_str(&out).unwrap();
    let names = ["spheres", "triangles"].map(|role| {
        let name = &stats["formulations"][role];
        name.as_str().unwrap().to_owned()
    });
    (image::open(&picture).unwrap().into_rgb8(), names, err)
}

/// The number of pixels that differ by more than two steps of a channel.
fn different(a: &RgbImage, b: &RgbImage) -> usize {
    let far = |(a, b): (&image::Rgb<u8>, &image::Rgb<u8>)| {
        (0..3).any(|channel| a.0[channel].abs_diff(b.0[channel]) > 2)
    };
    a.pixels().zip(b.pixels()).filter(|pair| far(*pair)).count()
}

#[test]
fn formulations_draw_same_picture_within_error() {
    let standard = Formulations::standard();
    for (scene, of_scene) in
        [("scenes/paper16.nff", standard.eye), ("scenes/whitted16.nff", standard.seen)]
    {
        let (expected, names, err) = rendered(scene, &[]);
        assert_eq!(names, [of_scene.name, standard.triangle.name]);
        assert!(!err.contains("note"), "{err}");
        for name in ["interpolated", "double", "paper"] {
            let sphere = formulation::sphere(name).unwrap();
            let (picture, names, err) = rendered(scene, &["--sphere", sphere.name]);
            let has_kernel = if of_scene == standard.eye {
                sphere.eye.is_some()
            } else {
                sphere.general.is_some()
            };
            let used = if has_kernel { sphere } else { of_scene };
            assert_eq!(names[0], used.name);
            assert_eq!(err.contains("has no kernel"), !has_kernel, "{err}");
            let different = different(&picture, &expected);
            // A twentieth of the pixels, because the bare estimate has only 7 good bits.
            assert!(different < 96 * 54 / 20, "{}: {different} pixels", sphere.name);
        }
    }
}

#[test]
fn unshipped_formulation_is_refused_with_the_build_command() {
    let shipped = Formulations::shipped();
    for sphere in SPHERES {
        if !shipped.contains(&Formulations::of(sphere, &TRIANGLES[0])) {
            let named = ["kernels -- image --sphere", "--program", sphere.name];
            bad(&["render", "scenes/paper16.nff", "--sphere", sphere.name], &named);
        }
    }
    for triangle in &TRIANGLES[1..] {
        bad(
            &["render", "scenes/paper16.nff", "--triangle", triangle.name],
            &[triangle.name, "kernels -- image --sphere"],
        );
    }
}

#[test]
fn quality_is_choice_of_formulations() {
    let scene = "scenes/paper16.nff";
    let points = ["fast", "default", "exact"].map(|quality| {
        let (_, [sphere, _], _) = rendered(scene, &["--quality", quality]);
        sphere
    });
    assert_eq!(points[1], Formulations::standard().eye.name);
    assert!(points[0] != points[1] && points[1] != points[2]);
    // An option takes precedence over the quality's formulation.
    let (_, [sphere, _], _) = rendered(scene, &["--quality", "exact", "--sphere", "paper"]);
    assert_eq!(sphere, "paper");
}

#[test]
fn invalid_formulations_are_named() {
    let scene = "scenes/paper16.nff";
    bad(&["render", scene, "--sphere", "newton3"], &["newton3", "newton2"]);
    bad(&["render", scene, "--triangle", "plucker"], &["plucker", "watertight"]);
    bad(&["render", scene, "--quality", "best"], &["best", "exact"]);
    bad(&["render", scene, "--quality", "fast", "--program", "p.elf"], &["--quality", "--program"]);
}
