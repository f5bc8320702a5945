//! An eye on a sphere's surface, or nearer to it than the precision of singles.

use oracle::Comparison;

use crate::prelude::*;
use crate::whitted::frame::{Frame, WHITTED, compared};

const SIZE: (u32, u32) = (96, 96);

/// Materials by which a sphere is seen from outside, or from both sides.
const OPAQUE: &str = "f 0.2 0.9 0.2 0.7 0.3 9 0 1";
const GLASS: &str = "f 1 1 1 0.05 0.1 9 0.9 1.5";

/// Ground, balls before and behind the eye, and a sphere around or beside it.
fn scene(from: &str, at: &str, material: &str, sphere: &str) -> scenes::Scene {
    let text = format!(
        "v\nfrom {from}\nat {at}\nup 0 1 0\nangle 60\nhither 0.01\nresolution 96 96\n\
         b 0.2 0.3 0.5\nl 3 5 4\nf 0.3 0.3 0.3 0.8 0.2 0 0 1\n\
         p 4\n-9 -2 -9\n9 -2 -9\n9 -2 9\n-9 -2 9\n\
         f 0.9 0.2 0.2 0.8 0.2 10 0 1\ns -0.6 0.2 -3 0.7\ns 0.9 -0.5 4 0.8\ns 1.2 0.6 -4 0.6\n\
         {material}\ns {sphere}\n"
    );
    scenes::parse(text.as_bytes(), "on.nff", &scenes::Limits::default()).unwrap()
}

fn assert_right(what: &str, result: Comparison) {
    let (off, wrong) = (result.max_error_off_silhouette, result.wrong_pixels);
    assert!(off <= 1 && wrong == 0, "{what}: {result:?}");
}

#[test]
fn picture_from_eye_on_sphere_equals_reference() {
    for (from, at, material, sphere) in [
        // Into the sphere, along its surface, and away from it.
        ("0 0 1", "0 0 0", OPAQUE, "0 0 0 1"),
        ("0 0 1", "1 0 1", OPAQUE, "0 0 0 1"),
        ("0 0 1", "0.5 0.1 2", OPAQUE, "0 0 0 1"),
        ("0 0 1", "0 0 0", GLASS, "0 0 0 1"),
        ("0 0 1", "0.3 0 0.95", GLASS, "0 0 0 1"),
        ("0 0 1", "0.6 0 1.4", GLASS, "0 0 0 1"),
        ("0 0 1", "0 0 0", OPAQUE, "0 0 0 -1"),
        ("0 0 1", "1 0 1", OPAQUE, "0 0 0 -1"),
        ("0 0 1", "0.5 0 0", GLASS, "0 0 0 -1"),
        // On it within the rounding of its own numbers.
        ("0.3 0.4 1.2", "0 0 -1", OPAQUE, "0 0 0 1.3"),
        ("0.3 0.4 1.2", "0 0 -1", GLASS, "0 0 0 1.3"),
        // Off it by a ten-millionth.
        ("0 0 1", "0.3 0 0.5", OPAQUE, "0 0 0 0.9999999"),
        ("0 0 1", "0.3 0 0.5", OPAQUE, "0 0 0 1.0000001"),
        ("0 0 1", "0.3 0 0.5", GLASS, "0 0 0 0.9999999"),
        ("0 0 1", "0.3 0 0.5", GLASS, "0 0 0 1.0000001"),
        // Where two touch, and in a shell.
        ("0 0 1", "0.2 0 0", GLASS, "0 0 0 1\ns 0 0 2 1"),
        ("0 0 1", "0 0 0", GLASS, "0 0 0 1.2\ns 0 0 0 -1"),
    ] {
        let scene = scene(from, at, material, sphere);
        let what = format!("{sphere} ({material}) from {from} to {at}");
        assert_right(&what, compared(&scene, WHITTED, SIZE));
    }
}

/// The picture of a world that was traced from elsewhere before.
fn moved(from: &scenes::Scene, to: &scenes::Scene) -> RgbImage {
    let program = Program::tracer();
    let mut world = World::from_nff(from, WHITTED).unwrap();
    let (framebuffer, shown) = Recorder::pair(SIZE.0, SIZE.1);
    let mut engine = Engine::start(Settings::default(), framebuffer).unwrap();
    for view in [&from.view, &to.view] {
        world.look_from(view.from, view.at).unwrap();
        let scene = world.scene(&program).unwrap();
        engine.render(scene, &mut |_| ()).unwrap();
    }
    shown.lock().unwrap().take().unwrap()
}

#[test]
fn eye_moved_to_or_from_sphere_gives_fresh_picture() {
    for material in [OPAQUE, GLASS] {
        let on = scene("0 0 1", "0.3 0 0.5", material, "0 0 0 1");
        let off = scene("0 0.5 6", "0 0 0", material, "0 0 0 1");
        for (from, to) in [(&off, &on), (&on, &off)] {
            let fresh = Frame::of(to, WHITTED, SIZE, Settings::default()).picture;
            assert!(moved(from, to) == fresh, "{material}");
        }
    }
}

/// By depth shading, such a sphere is as invisible as one around the eye.
#[test]
fn depth_shading_omits_sphere_under_eye() {
    for (from, sphere) in [("0 0 1", "0 0 0 1"), ("0.3 0.4 1.2", "0 0 0 1.3")] {
        for skip in [cellray::work::Skip::Misses, cellray::work::Skip::Nothing] {
            let mut scene = scene(from, "0.1 0 -1", OPAQUE, sphere);
            scene.lights.clear();
            let settings = Settings { skip, ..Settings::default() };
            let picture = crate::recorder::render(&scene, SIZE.0, SIZE.1, settings);
            let reference = oracle::trace(&scene, SIZE.0, SIZE.1).unwrap();
            let picture = crate::whitted::frame::picture(&picture);
            let result = oracle::compare(&picture, &reference).unwrap();
            assert_right(&format!("{sphere}, {skip:?}"), result);
        }
    }
}
