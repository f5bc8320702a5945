//! Depth shading and the list of what it does not draw.

use crate::common::{parsed, scene_text};
use glam::DVec3;
use scenes::depth::{self, DepthShading, Kind};

#[test]
fn range_spans_drawn_spheres() {
    // The eye is at (0, -10, 0).
    let scene = parsed(&scene_text("s 0 0 0 1\ns 0 20 0 2\ns 0 90 0 -5\n"));
    let shading = DepthShading::of(&scene);
    assert_eq!(shading, DepthShading { near: 9.0, far: 32.0 });
    assert_eq!(shading.brightness(9.0), 1.0);
    assert_eq!(shading.brightness(32.0), 0.0);
    assert_eq!(shading.brightness(20.5), 0.5);
    assert_eq!((shading.brightness(0.0), shading.brightness(1e9)), (1.0, 0.0));
}

#[test]
fn eye_inside_sphere_has_range_from_0() {
    let scene = parsed(&scene_text("s 0 0 0 11\n"));
    assert_eq!(DepthShading::of(&scene), DepthShading { near: 0.0, far: 21.0 });
}

#[test]
fn degenerate_ranges_are_bright() {
    let none = DepthShading::of(&parsed(&scene_text("")));
    assert_eq!(none, DepthShading { near: 0.0, far: 0.0 });
    assert_eq!(none.brightness(5.0), 1.0);
    let far = DepthShading::of(&parsed(&scene_text("s 1e100 0 0 1\n")));
    assert_eq!(far.near, far.far);
    assert_eq!(far.brightness(1e100), 1.0);
}

#[test]
fn colours_round_to_bytes_and_are_clamped() {
    assert_eq!(depth::bytes(DVec3::new(0.0, 0.5, 1.0)), [0, 128, 255]);
    assert_eq!(depth::bytes(DVec3::new(-1.0, 0.25, 7.0)), [0, 64, 255]);
    assert_eq!(depth::bytes(DVec3::splat(0.5 / 255.0)), [1; 3]);
    assert_eq!(depth::bytes(DVec3::splat(0.499 / 255.0)), [0; 3]);
}

#[test]
fn undrawn_entities_are_listed_with_kind_and_first_line() {
    let text = scene_text(
        "p 3\n0 0 0\n1 0 0\n0 1 0\n\
         s 0 0 0 1\n\
         l 1 1 1\n\
         f 1 1 1 1 0.5 9 0.5 1\n\
         c\n0 0 0 1\n0 0 1 1\n\
         l 2 2 2\n\
         s 0 0 0 -1\n\
         f 1 1 1 1 0.5 9 0 1\n\
         pp 3\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n\
         f 0 0 0 1 1 1 1 1\n",
    );
    let listed: Vec<String> =
        depth::not_drawn(&parsed(&text)).iter().map(|it| it.to_string()).collect();
    assert_eq!(
        listed,
        [
            "t.nff:9: polygons are not drawn by depth shading (1 in this file)",
            "t.nff:14: lights are not drawn by depth shading (2 in this file)",
            "t.nff:15: mirrors and highlights (Ks > 0) are not drawn by depth shading (2 in this file)",
            "t.nff:15: transmitting materials (T > 0) are not drawn by depth shading (1 in this file)",
            "t.nff:16: cones and cylinders are not drawn by depth shading (1 in this file)",
            "t.nff:20: spheres seen from inside only (negative radius) are not drawn by depth shading (1 in this file)",
            "t.nff:22: patches are not drawn by depth shading (1 in this file)",
        ]
    );
    let flake = scenes::sphereflake::generate(2).expect("a scene");
    let kinds: Vec<Kind> = depth::not_drawn(&flake).iter().map(|it| it.what).collect();
    assert_eq!(kinds, [Kind::Light, Kind::Polygon, Kind::Specular]);
    assert!(depth::not_drawn(&parsed(&scene_text("s 0 0 0 1\n"))).is_empty());
}

#[test]
fn suns_and_shaders_are_left_out() {
    let used = "#cellray sun 0 0 1\n#cellray shader flat\ns 0 0 0 1\n";
    let unused = "f 1 1 1 1 0 0 0 1\n#cellray shader rings\n";
    let scene = parsed(&scene_text(&format!("{used}{unused}")));
    let left_out = depth::not_drawn(&scene);
    let messages: Vec<String> = left_out.iter().map(ToString::to_string).collect();
    assert_eq!(
        messages,
        [
            "t.nff:8: shaders (#cellray shader) are not drawn by depth shading (1 in this file)",
            "t.nff:9: lights are not drawn by depth shading (1 in this file)",
        ]
    );
}
