//! The scenes that come with the program match their comments.

use std::fs;
use std::path::{Path, PathBuf};

use oracle::whitted::{Options, trace};
use scenes::{Shape, depth};

fn file(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes").join(name)
}

#[test]
fn the_papers_scenes_cover_the_stated_share_and_leave_nothing_out() {
    for (name, spheres) in [("paper16.nff", 16), ("paper13.nff", 13)] {
        let scene = scenes::read(&file(name)).expect("a scene");
        assert_eq!(depth::drawn(&scene).count(), spheres, "{name}");
        assert_eq!(depth::not_drawn(&scene), [], "{name}");
        assert_eq!(scene.view.resolution, (1280, 720), "{name}");

        let text = fs::read_to_string(file(name)).expect("text");
        let stated = text.split_once("Spheres cover ").and_then(|(_, rest)| rest.split_once(" %"));
        let (stated, _) = stated.expect("the comment states a share");
        let covered = oracle::trace(&scene, 1280, 720).expect("a picture").covered;
        assert_eq!(format!("{:.1}", covered * 100.0), stated, "{name}");
    }
}

#[test]
fn no_two_spheres_of_the_papers_scenes_intersect() {
    for name in ["paper16.nff", "paper13.nff"] {
        let scene = scenes::read(&file(name)).expect("a scene");
        let spheres: Vec<_> = depth::drawn(&scene).collect();
        for (index, a) in spheres.iter().enumerate() {
            for b in &spheres[..index] {
                let gap = a.centre.distance(b.centre) - a.radius - b.radius;
                assert!(gap > 0.0, "{name}: {} and {} overlap by {}", a.centre, b.centre, -gap);
            }
        }
    }
}

#[test]
fn whitted16_matches_its_description() {
    let scene = scenes::read(&file("whitted16.nff")).expect("a scene");
    let is_sphere = |shape: &Shape| matches!(shape, Shape::Sphere { .. });
    let (spheres, rest): (Vec<_>, Vec<_>) =
        scene.objects.iter().map(|object| &object.shape).partition(|shape| is_sphere(shape));
    assert_eq!((spheres.len(), scene.lights.len()), (16, 2));
    assert!(matches!(rest[..], [Shape::Polygon { .. }]), "{rest:?}");
    assert_eq!(scene.view.resolution, (1280, 720));
}

#[test]
fn whitted_scenes_use_their_features() {
    let rays = |name: &str| {
        let scene = scenes::read(&file(name)).expect("a scene");
        let options = Options::default();
        let (reference, counts) = trace(&scene, 320, 180, &options).expect("a picture");
        assert!((0.5..0.95).contains(&reference.covered), "{name}");
        assert!(counts.shadow > counts.eye_hit, "{name}");
        assert!(counts.reflected > counts.eye / 2, "{name}");
        (counts, scene.objects)
    };
    for name in ["whitted16.nff", "glass.nff", "shapes.nff"] {
        assert!(rays(name).0.refracted > 2000, "{name}");
    }
    assert_eq!(rays("mirrors.nff").0.refracted, 0);
    let (_, objects) = rays("shapes.nff");
    let has = |wanted: fn(&Shape) -> bool| objects.iter().any(|object| wanted(&object.shape));
    assert!(has(|it| matches!(it, Shape::Sphere { radius, .. } if *radius < 0.0)));
    assert!(has(|it| matches!(it, Shape::Cone { .. })));
    assert!(has(|it| matches!(it, Shape::Patch { .. })));
    assert!(has(|it| matches!(it, Shape::Polygon { vertices } if vertices.len() == 10)));
}
