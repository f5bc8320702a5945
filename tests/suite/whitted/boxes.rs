//! Trees whose nodes are boxes along the axes.

use cellray::scene::NodeVolumes;
use cellray::statistics::Generation;

use crate::prelude::*;
use crate::whitted::frame::{Frame, WHITTED, compared};

const SIZE: (u32, u32) = (224, 126);

/// All shapes with nodes, among them triangles that are in spheres if that is faster.
const SCENES: [&str; 3] = ["mirrors.nff", "glass.nff", "still-life.nff"];

const BOXES: RenderOptions = RenderOptions { volumes: NodeVolumes::Boxes, ..WHITTED };

fn traced(name: &str, render_options: RenderOptions, skip: Skip) -> Frame {
    let settings = Settings { skip, ..Settings::default() };
    Frame::of(&nff_scene(name), render_options, SIZE, settings)
}

/// No ray loses what it hits: each frame has hundreds of thousands of rays, from surfaces, into
/// mirrors and glass and to lights, and is the same when every ray is tested with every object.
#[test]
fn boxes_change_no_byte() {
    for name in SCENES {
        let [by_boxes, by_all] =
            [Skip::Misses, Skip::Nothing].map(|skip| traced(name, BOXES, skip));
        let rays: u64 = by_all.generations().iter().map(|it| it.rays).sum();
        assert!(rays > 2 * u64::from(SIZE.0 * SIZE.1), "{name}: {rays}");
        let differ = by_boxes.picture.pixels().zip(by_all.picture.pixels());
        let differ = differ.filter(|(one, other)| one != other).count();
        assert_eq!(differ, 0, "{name}");
    }
}

#[test]
fn pictures_with_boxes_equal_reference() {
    for name in SCENES {
        let result = compared(&nff_scene(name), BOXES, SIZE);
        println!("{name}: {result:?}");
        assert!(result.max_error_off_silhouette <= 2, "{name}: {result:?}");
        assert!(result.wrong_fraction < 0.0015, "{name}: {result:?}");
    }
}

/// Where boxes are chosen, packets are tested with fewer objects; elsewhere the same tests are made
/// as with spheres.
#[test]
fn boxes_save_tests_where_they_are_chosen() {
    let spheres = RenderOptions { volumes: NodeVolumes::Spheres, ..WHITTED };
    let tests = |frame: &Frame| {
        let generations = frame.generations();
        let sum = |tests: [u64; 2], it: &Generation| [tests[0] + it.nodes, tests[1] + it.tests];
        generations.iter().fold([0; 2], sum)
    };
    for (name, has_boxes) in [("mirrors.nff", true), ("glass.nff", true), ("shapes.nff", false)] {
        let [best, plain] = [WHITTED, spheres].map(|options| traced(name, options, Skip::Misses));
        let ([nodes, objects], [plain_nodes, plain_objects]) = (tests(&best), tests(&plain));
        if has_boxes {
            assert!(4 * objects < 3 * plain_objects, "{name}: {objects} of {plain_objects}");
            assert!(nodes < plain_nodes, "{name}: {nodes} of {plain_nodes}");
        } else {
            assert_eq!((nodes, objects), (plain_nodes, plain_objects), "{name}");
        }
    }
}
