//! The scenes that come with the program show what their comments say.

use std::fs;
use std::path::{Path, PathBuf};

use nff::depth;

fn file(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../scenes")
        .join(name)
}

#[test]
fn the_papers_scenes_cover_the_stated_share_and_leave_nothing_out() {
    for (name, spheres) in [("paper16.nff", 16), ("paper13.nff", 13)] {
        let scene = nff::read(&file(name)).expect("a scene");
        assert_eq!(depth::drawn(&scene).count(), spheres, "{name}");
        assert_eq!(depth::not_drawn(&scene), [], "{name}");
        assert_eq!(scene.view.resolution, (1280, 720), "{name}");

        let text = fs::read_to_string(file(name)).expect("text");
        let stated = text
            .split_once("Spheres cover ")
            .and_then(|(_, rest)| rest.split_once(" %"));
        let (stated, _) = stated.expect("the comment states a share");
        let covered = oracle::trace(&scene, 1280, 720).expect("a picture").covered;
        assert_eq!(format!("{:.1}", covered * 100.0), stated, "{name}");
    }
}

#[test]
fn no_two_spheres_of_the_papers_scenes_intersect() {
    for name in ["paper16.nff", "paper13.nff"] {
        let scene = nff::read(&file(name)).expect("a scene");
        let spheres: Vec<_> = depth::drawn(&scene).collect();
        for (index, a) in spheres.iter().enumerate() {
            for b in &spheres[..index] {
                let gap = a.centre.distance(b.centre) - a.radius - b.radius;
                assert!(
                    gap > 0.0,
                    "{name}: {} and {} overlap by {}",
                    a.centre,
                    b.centre,
                    -gap
                );
            }
        }
    }
}
