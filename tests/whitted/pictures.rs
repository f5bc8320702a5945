//! Pictures of the scenes that come with the program.

use cellray::scene::Look;

use crate::frame::{WHITTED, compared};
use crate::recorder::nff_scene;

const SIZE: (u32, u32) = (320, 180);

/// Of glass traced so deep that a hit may have 2^15 rays behind it.
const DEEP_SIZE: (u32, u32) = (80, 45);

/// Greatest share of pixels that are off, those on silhouettes among them.
const WRONG: f64 = 0.0015;

fn scenes_are_as_the_reference_has_them(look: Look, size: (u32, u32)) {
    let mut failures = Vec::new();
    for name in ["whitted16.nff", "mirrors.nff", "glass.nff", "shapes.nff"] {
        let result = compared(&nff_scene(name), look, size);
        println!("{name}: {result:?}");
        if result.max_error_off_silhouette > 2 || result.wrong_fraction > WRONG {
            failures.push((name, result));
        }
    }
    assert!(failures.is_empty(), "{failures:#?}");
}

#[test]
fn scenes_as_they_are_meant() {
    scenes_are_as_the_reference_has_them(WHITTED, SIZE);
}

#[test]
fn scenes_with_fresnel() {
    scenes_are_as_the_reference_has_them(
        Look {
            fresnel: true,
            ..WHITTED
        },
        SIZE,
    );
}

#[test]
fn scenes_without_bounces() {
    scenes_are_as_the_reference_has_them(
        Look {
            ray_depth: 1,
            ..WHITTED
        },
        SIZE,
    );
}

#[test]
fn scenes_of_the_greatest_depth() {
    scenes_are_as_the_reference_has_them(
        Look {
            ray_depth: 16,
            ..WHITTED
        },
        DEEP_SIZE,
    );
}
