//! Pictures of the scenes that come with the program.

use crate::prelude::*;
use crate::whitted::frame::{WHITTED, compared};

const SIZE: (u32, u32) = (320, 180);
/// The size for scenes with many rays.
const DEEP_SIZE: (u32, u32) = (160, 90);

const ALL: [&str; 4] = ["whitted16.nff", "mirrors.nff", "glass.nff", "shapes.nff"];

/// The maximum share of wrong pixels, including those on silhouettes.
const WRONG: f64 = 0.0015;

fn scenes_are_as_the_reference_has_them(
    names: &[&str],
    render_options: RenderOptions,
    size: (u32, u32),
) {
    let mut failures = Vec::new();
    for name in names {
        let result = compared(&nff_scene(name), render_options, size);
        println!("{name}: {result:?}");
        if result.max_error_off_silhouette > 2 || result.wrong_fraction > WRONG {
            failures.push((name, result));
        }
    }
    assert!(failures.is_empty(), "{failures:#?}");
}

#[test]
fn scenes_equal_reference() {
    scenes_are_as_the_reference_has_them(&ALL, WHITTED, SIZE);
}

#[test]
fn sky_equals_reference() {
    for colour in [Colour::Linear, Colour::Srgb] {
        let render_options = RenderOptions { colour, ..WHITTED };
        scenes_are_as_the_reference_has_them(&["daylight.nff"], render_options, SIZE);
    }
}

#[test]
fn scenes_with_fresnel() {
    let render_options = RenderOptions { fresnel: true, ..WHITTED };
    scenes_are_as_the_reference_has_them(&ALL, render_options, SIZE);
}

#[test]
fn scenes_without_bounces() {
    let render_options = RenderOptions { ray_depth: 1, ..WHITTED };
    scenes_are_as_the_reference_has_them(&ALL, render_options, SIZE);
}

/// With several layers of glass, a pixel would take 2^15 rays. Such scenes use a depth of 7.
#[test]
fn scenes_of_a_great_depth() {
    for (ray_depth, names, size) in
        [(16, ["whitted16.nff", "mirrors.nff"], SIZE), (7, ["glass.nff", "shapes.nff"], DEEP_SIZE)]
    {
        let render_options = RenderOptions { ray_depth, ..WHITTED };
        scenes_are_as_the_reference_has_them(&names, render_options, size);
    }
}
